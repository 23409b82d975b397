// Sheet 6: the path of the coupler point P, its circuit traced within a stated distance, with the circle that
// osculates it.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/curves/four_bar_loci.h"
#include "geometry/mechanisms/grashof.h"

namespace epure::four_bar_analytic {
namespace {

using geometry::Deep;

constexpr int crank_positions = 12;

geometry::FourBarCouplerCurve curve_of(const Problem& of, geometry::Side side) {
  return {of.instant.lengths, side, of.AP_along, of.AP_across};
}

struct Position {
  int number;
  Place A, B, P;
};

// The crank's circle divided; a division in which the linkage does not close is left out.
std::vector<Position> divided_positions(const Problem& of) {
  return deeply([&] {
    std::vector<Position> found;
    for (int k = 0; k < crank_positions; ++k) {
      FourBarInstant there = of.instant;
      there.crank = Angle{Rational(k, crank_positions)};
      try {
        const auto at = there.position<Deep>();
        found.push_back({k, to_double(at.A), to_double(at.B), to_double(coupler_point(of, at))});
      } catch (const geometry::Impossible&) {
      } catch (const geometry::Undecided&) {
        // Flat, or at a limit position.
      }
    }
    return found;
  });
}

drawings::Box extent_of(const Drawn& f, const std::vector<Position>& all, const Scale& scale) {
  Extent extent;
  f.figure.include(extent, scale);
  for (const Position& at : all) {
    extent.include(scale, at.P, 7);
    extent.include(scale, at.B, 5);
  }
  extent.include(scale, f.P, 9);
  return extent.box();
}

bool is_on_AB(const Problem& of) {
  return of.AP_across == 0 && of.AP_along >= 0 && of.AP_along <= of.instant.lengths.AB;
}

// The bar AB in each; of a plate only AP, for twelve triangles hide what they show.
void draw_positions(Plot& plot, const Drawn& f, const std::vector<Position>& all) {
  for (const Position& at : all) {
    plot.segment(at.A, is_on_AB(f.of) ? at.B : at.P, Meaning::construction);
    plot.dot(at.B, Meaning::construction);
    plot.dot(at.A, Meaning::construction);
    plot.dot(at.P, Meaning::locus);
    plot.small_label(std::to_string(at.number), at.A, f.figure.A0);
    plot.small_label(std::to_string(at.number), at.B, f.figure.B0);
    plot.small_label(std::to_string(at.number), at.P, Place{(at.A.x + at.B.x) / 2, (at.A.y + at.B.y) / 2});
  }
}

struct Curvature {
  std::optional<Place> centre;
  Arrow2 v = {}, a = {};
  bool is_at_pole() const { return v.x == 0 && v.y == 0; }
};
Curvature curvature_of_P(const Problem& of) {
  return deeply([&]() -> Curvature {
    const auto at = of.instant.position<Deep>();
    const auto motion =
        geometry::four_bar_motion(at, of.instant.omega_2<Deep>(), geometry::radians<Deep>(of.instant.alpha_2));
    const auto P = coupler_point(of, at);
    return {to_double(motion.coupler.centre_of_curvature(P)), to_double(motion.coupler.velocity(P)),
            to_double(motion.coupler.acceleration(P))};
  });
}

// The figure is the path's: a circle too large for it is drawn as far as it reaches.
void draw_curvature_of_P(Plot& plot, const Drawn& f, const Curvature& of, const drawings::Box& room,
                         Language language) {
  if (!of.centre) return;
  plot.cycle(circle_through(f.P, *of.centre), Meaning::construction);
  if (!is_in(room, plot, *of.centre))
    return plot.step(4, draw_towards(plot, room, f.P, *of.centre, "$Ω_{P}$", language));
  plot.segment(*of.centre, f.P, Meaning::dimension);
  plot.cross(*of.centre);
  plot.label("$Ω_{P}$", *of.centre, f.P, Meaning::locus);
  plot.measures("rho_P", *of.centre, f.P);
  plot.measures_coordinates("curvature_centre_P", *of.centre, f.figure.A0);
  plot.step(4, *of.centre);
}

std::string left_out(const Plot& plot, const Drawn& f, const Curvature& of, const drawings::Box& room,
                     Language language) {
  OffSheet off(plot, room);
  off.point("$Ω_{P}$", of.centre);
  if (of.centre)
    off.circle({"part of the osculating circle", "parte del cerchio osculatore"}, circle_through(f.P, *of.centre));
  return off.sentence(language);
}

void draw_mechanism(Plot& plot, const Drawn& f, const std::vector<Position>& all) {
  FourBarFigure figure = f.figure;
  for (const Position& at : all) figure.other_B.push_back(at.B);
  figure.points = {{"$P$", f.P}};
  if (!is_on_AB(f.of)) {
    plot.area({figure.A, figure.B, f.P}, Meaning::plate);
    plot.segment(figure.A, f.P, Meaning::link);
    plot.segment(figure.B, f.P, Meaning::link);
  }
  figure.draw(plot);
  plot.measures_coordinates("P", f.P, figure.A0);
}

Words where_the_centre_is(const Curvature& of) {
  if (of.centre)
    return {"$Ω_{P}$, by Euler-Savary as for $G_{3}$; thin: the circle that osculates the path now.",
            "$Ω_{P}$, con Euler-Savary come per $G_{3}$; sottile: il cerchio osculatore."};
  if (of.is_at_pole())
    return {"Now $P$ is the pole $P_{0}$ and at rest: the path has a cusp, and no $Ω_{P}$.",
            "Ora $P$ è il polo $P_{0}$, fermo: la traiettoria ha una cuspide, e non c'è $Ω_{P}$."};
  return {"Now the path is straight: $Ω_{P}$ is at infinity.",
          "Ora la traiettoria è diritta: $Ω_{P}$ è all'infinito."};
}

drawings::Steps steps_to_coupler_curve(const Curvature& of, Language language) {
  const std::vector<Words> steps{
      {fmt::format("The crank's circle in {} parts from +x: positions of $A$.", crank_positions),
       fmt::format("La circonferenza di manovella in {} parti da +x: le posizioni di $A$.", crank_positions)},
      {"$B$ about $A$ and $B_{0}$; on tracing paper $P$ goes with $AB$ and marks a point.",
       "$B$ da $A$ e $B_{0}$; su carta da lucido $P$ va con $AB$ e segna un punto."},
      {"The curve through the points: the path of $P$.", "La curva per i punti: la traiettoria di $P$."},
      where_the_centre_is(of)};
  drawings::Steps written;
  for (const Words& step : steps) written.lines.push_back(step.in(language));
  return written;
}

}  // namespace

void draw_coupler_curve(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const std::vector<Position> all = divided_positions(f.of);
  const Fit fit = fit_lengths(room, request, 1000 / f.figure.reach(),
                              [&](const Scale& scale) { return extent_of(f, all, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_positions(plot, f, all);
  const geometry::Side side = f.of.instant.side;
  const geometry::Trace path = draw_locus(plot, curve_of(f.of, side), room, Meaning::locus, "path_of_P");
  const bool turns_fully = geometry::crank_turns_fully(f.of.instant.lengths);
  // Past a limit position, where the crank turns back, B goes on to the other side: one circuit of two parts.
  if (!turns_fully)
    draw_locus(plot, curve_of(f.of, geometry::opposite(side)), room, Meaning::second_locus, "path_of_P_other_side");
  draw_mechanism(plot, f, all);
  const Curvature curvature = curvature_of_P(f.of);
  draw_curvature_of_P(plot, f, curvature, room, language);
  const auto place = [&](std::size_t share) { return all[all.size() * share / crank_positions]; };
  if (!all.empty()) {
    plot.step(1, place(7).A);
    plot.step(2, place(2).B);
    plot.step(3, place(5).P);
  }
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {fit.scale}, request);

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_to_coupler_curve(curvature, language));
  if (const std::string off = left_out(plot, f, curvature, room, language); !off.empty())
    column.push_back(drawings::Paragraph{off});
  column.push_back(drawings::Heading{english ? "The curve" : "La curva"});
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(english ? "{} Bezier arcs, at most {} mm on this sheet from the true path."
                           : "{} archi di Bézier, su questo foglio a non più di {} mm dalla traiettoria vera."),
      path.arcs(), figures(path.deviation() * fit.scale.mm_per_unit, 1, language))});
  if (!turns_fully)
    column.push_back(drawings::Paragraph{
        english
            ? "The crank cannot turn fully: at its limit positions the path goes on with $B$ on the other side of "
              "$AB_{0}$ (second line type)."
            : "La manovella non fa il giro completo: alle posizioni limite la traiettoria continua con $B$ "
              "dall'altro "
              "lato di $AB_{0}$ (secondo tipo di linea)."});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const auto num = [&](double x) { return figures(x, 4, language); };
  const char* no_centre = curvature.is_at_pole() ? "–" : "∞";
  column.push_back(drawings::Table{{"", "$x$", "$y$"},
                                   {{"$P$ (m)", num(f.P.x), num(f.P.y)},
                                    {"$v_{P}$ (m/s)", num(curvature.v.x), num(curvature.v.y)},
                                    {"$a_{P}$ (m/s²)", num(curvature.a.x), num(curvature.a.y)},
                                    {"$Ω_{P}$ (m)", curvature.centre ? num(curvature.centre->x) : no_centre,
                                     curvature.centre ? num(curvature.centre->y) : no_centre}}});
  onto.sheet.description =
      in_words({"The path of the coupler point P, in twelve positions of the crank; P now",
                "La traiettoria del punto di biella P, in dodici posizioni della manovella; P ora"},
               {{"x_P", f.P.x, "m"}, {"y_P", f.P.y, "m"}}, language);
}

}  // namespace epure::four_bar_analytic
