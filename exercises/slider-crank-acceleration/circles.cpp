// Sheet 2: the inflection circle by P₀, A' and B, the stationarity circle, and K where they meet again.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/fit.h"
#include "exercises/kit/sheet.h"
#include "exercises/slider-crank-acceleration/exercise.h"

namespace epure::slider_crank_acceleration {
namespace {

// A circle larger than this many times the mechanism is shown as an arc that leaves the frame.
constexpr double whole_circle_limit = 8;

void include_circle(Extent& extent, const Scale& scale, const DrawnCycle& cycle, double size) {
  if (!cycle.centre || 2 * cycle.radius > whole_circle_limit * size) return;
  const auto& [x, y] = *cycle.centre;
  const double r = cycle.radius;
  extent.include(scale, {x - r, y - r}, 5);
  extent.include(scale, {x + r, y + r}, 5);
}

drawings::Box extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  for (const Place& P : {f.at.A0, f.at.A, f.at.B, f.at.C}) extent.include(scale, P, 6);
  const double size = reach(f.at);
  include_circle(extent, scale, f.inflection, size);
  include_circle(extent, scale, f.stationarity, size);
  for (const auto& P : {f.P0, f.K}) {
    if (P && std::hypot(P->x, P->y) < whole_circle_limit * size) extent.include(scale, *P, 8);
  }
  return extent.box();
}

// A' on the ray P₀A by Euler-Savary, for the centre of curvature A₀ of A's path.
Place A_prime(const Drawn& f) { return geometry::euler_savary_point(*f.P0, f.at.A, f.at.A0); }

void draw_inflection_circle(Plot& plot, const Drawn& f) {
  plot.cycle(f.inflection, Meaning::locus, "inflection_circle");
  if (!f.P0 || !f.J) return;
  const Place A1 = A_prime(f);
  plot.long_segment(f.at.A, *f.P0, 4, Meaning::construction);
  plot.segment(f.at.A, A1, Meaning::construction);
  plot.dot(A1, Meaning::locus);
  plot.label("$A'$", A1, f.at.A, Meaning::locus);
  plot.segment(*f.P0, *f.J, Meaning::axis);
  plot.segment(f.at.B, *f.P0, Meaning::construction);
  plot.cross(*f.J);
  plot.label("$J$", *f.J, f.P0, Meaning::locus);
  plot.cross(*f.inflection.centre);
  plot.label("$F$", *f.inflection.centre, f.P0, Meaning::locus);
  plot.measures("inflection_diameter", *f.P0, *f.J);
  plot.measures_coordinates("inflection_pole", *f.J, f.at.A0);
  plot.measures_coordinates("inflection_centre", *f.inflection.centre, f.at.A0);
  plot.step(1, A1);
  plot.step(2, *f.J);
}

void draw_stationarity_circle(Plot& plot, const Drawn& f) {
  plot.cycle(f.stationarity, Meaning::second_locus, "stationarity_circle");
  if (!f.P0 || !f.stationarity.centre) return;
  const Place S = *f.stationarity.centre, opposite{2 * S.x - f.P0->x, 2 * S.y - f.P0->y};
  plot.segment(*f.P0, opposite, Meaning::axis);
  plot.cross(S, Meaning::second_locus);
  plot.label("$S$", S, f.P0, Meaning::second_locus);
  plot.cross(opposite, Meaning::second_locus);
  plot.label("$S'$", opposite, f.P0, Meaning::second_locus);
  plot.measures("stationarity_diameter", *f.P0, opposite);
  plot.measures_coordinates("stationarity_centre", S, f.at.A0);
  if (f.J) {
    plot.right_angle(*f.P0, *f.J, opposite);
    plot.segment(*f.J, opposite, Meaning::construction);
  }
  plot.step(3, opposite);
}

void draw_poles_of_motion(Plot& plot, const Drawn& f) {
  if (f.P0) {
    plot.cross(*f.P0);
    plot.label("$P_{0}$", *f.P0, f.at.A, Meaning::locus);
    plot.measures_coordinates("P0", *f.P0, f.at.A0);
  }
  if (f.K) {
    plot.cross(*f.K, Meaning::acceleration);
    plot.label("$K$", *f.K, f.at.M, Meaning::acceleration);
    plot.measures_coordinates("K", *f.K, f.at.A0);
    plot.step(4, *f.K);
  }
}

drawings::Steps steps(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  if (!f.P0) {
    return english ? drawings::Steps{{"The crank is square to the guide: $P_{0}$ is at infinity and $ω_{3}$ = 0.",
                                      "The inflection circle becomes a line through $B$, square to the guide.",
                                      "The stationarity circle becomes a line too.", "The two lines meet in $K$."}}
                   : drawings::Steps{{"La manovella è normale alla guida: $P_{0}$ è all'infinito e $ω_{3}$ = 0.",
                                      "La circonferenza dei flessi diventa una retta per $B$, normale alla guida.",
                                      "Anche la circonferenza di stazionarietà diventa una retta.",
                                      "Le due rette si incontrano in $K$."}};
  }
  if (english) {
    return {
        {"$A'$ on the ray $P_{0}A$: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, on the side of $A_{0}$.",
         "Inflection circle through $P_{0}$, $A'$ and $B$, whose path is straight. Centre $F$, diameter $P_{0}J$.",
         "Stationarity circle: through $P_{0}$, its centre $S$ on the square to $P_{0}J$, and (for $α_{2}$ = 0) "
         "through $A$, "
         "whose acceleration is all normal.",
         "$K$, where the circles meet again: the foot of the perpendicular from $P_{0}$ on $JS'$."}};
  }
  return {
      {"$A'$ sul raggio $P_{0}A$: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, dalla parte di $A_{0}$.",
       "Circonferenza dei flessi per $P_{0}$, $A'$ e $B$, la cui traiettoria è retta. Centro $F$, diametro $P_{0}J$.",
       "Circonferenza di stazionarietà: per $P_{0}$, col centro $S$ sulla normale a $P_{0}J$, e (per $α_{2}$ = 0) "
       "per $A$, la cui "
       "accelerazione è tutta normale.",
       "$K$, dove le due si incontrano ancora: il piede della normale da $P_{0}$ a $JS'$."}};
}

drawings::Table results(const Drawn& f, Language language) {
  const auto num = [&](const std::optional<Place>& P, bool x) {
    return P ? figures(x ? P->x : P->y, 4, language) : std::string("∞");
  };
  drawings::Table table{{"", "$x$ (m)", "$y$ (m)"}, {}};
  for (const auto& [name, P] : {std::pair{"$P_{0}$", f.P0}, std::pair{"$J$", f.J}, std::pair{"$K$", f.K},
                                std::pair{"$F$", f.inflection.centre}, std::pair{"$S$", f.stationarity.centre}}) {
    table.rows.push_back({name, num(P, true), num(P, false)});
  }
  return table;
}

}  // namespace

void draw_circles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / reach(f.at),
                              [&](const Scale& scale) { return extent(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_inflection_circle(plot, f);
  draw_stationarity_circle(plot, f);
  sketch_slider_crank(plot, f.at);
  draw_poles_of_motion(plot, f);
  add_scale_bars(onto, {plot.scale()}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(f, language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(results(f, language));
  if (f.inflection.centre) {
    column.push_back(drawings::Paragraph{
        fmt::format("$δ_{{F}}$ = {} m", figures(2 * f.inflection.radius, 4, language)) +
        (f.stationarity.centre ? fmt::format(",  $δ_{{S}}$ = {} m", figures(2 * f.stationarity.radius, 4, language))
                               : "")});
  }
  std::vector<Value> values;
  for (const auto& [name, P] : {std::pair{"P0", f.P0}, std::pair{"J", f.J}, std::pair{"K", f.K}}) {
    if (P)
      values.insert(values.end(), {{fmt::format("x_{}", name), P->x, "m"}, {fmt::format("y_{}", name), P->y, "m"}});
  }
  onto.sheet.description =
      in_words({"Inflection and stationarity circle of the coupler, which meet in P₀ and K",
                "Circonferenze dei flessi e di stazionarietà della biella, che si incontrano in P₀ e K"},
               values, language);
}

}  // namespace epure::slider_crank_acceleration
