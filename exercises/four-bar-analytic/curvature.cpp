// Sheet 4: the inflection circle by P₀, A' and B', then G₃' on it and the centre of curvature of G₃'s path.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_analytic {
namespace {

// What is farther off than this many times the mechanism leaves the frame.
constexpr double far_off = 2;

bool is_near(const Drawn& f, const std::optional<Place>& P) {
  return P && std::hypot(P->x, P->y) < far_off * f.figure.reach();
}
bool is_small(const Drawn& f, const DrawnCycle& circle) {
  return circle.centre && is_near(f, circle.centre) && 2 * circle.radius < far_off * f.figure.reach();
}

// What osculates the path of G₃ now; nothing where that is straight, or G₃ at rest.
DrawnCycle osculating(const Drawn& f) {
  return f.centre_of_G3 ? circle_through(f.G3(), *f.centre_of_G3) : DrawnCycle{};
}

drawings::Box extent_of_curvature(const Drawn& f, const Scale& scale) {
  Extent extent;
  for (const Place& P : {f.figure.A0, f.figure.A, f.figure.B, f.figure.B0}) extent.include(scale, P, 9);
  for (const auto& P : {f.P0, f.A_prime, f.B_prime, f.G3_prime, f.centre_of_G3})
    if (is_near(f, P)) extent.include(scale, *P, 9);
  for (const DrawnCycle& circle : {f.inflection, osculating(f)}) {
    if (!is_small(f, circle)) continue;
    const auto& [x, y] = *circle.centre;
    extent.include(scale, {x - circle.radius, y - circle.radius}, 4);
    extent.include(scale, {x + circle.radius, y + circle.radius}, 4);
  }
  return extent.box();
}

// A point found on a ray, with its letters.
void draw_found(Plot& plot, const std::optional<Place>& P, const std::string& letters, const Place& from, int step) {
  if (!P || !plot.shows(*P)) return;
  plot.dot(*P, Meaning::locus);
  plot.label(letters, *P, from, Meaning::locus);
  plot.step(step, *P);
}

void draw_rays(Plot& plot, const Drawn& f) {
  if (!f.P0) return;
  for (const auto& [X, X_prime] :
       {std::pair{f.figure.A, f.A_prime}, std::pair{f.figure.B, f.B_prime}, std::pair{f.G3(), f.G3_prime}}) {
    plot.segment(*f.P0, X, Meaning::construction);
    if (X_prime) plot.segment(X, *X_prime, Meaning::construction);
  }
}

void draw_inflection_circle(Plot& plot, const Drawn& f) {
  plot.cycle(f.inflection, Meaning::locus, "inflection_circle");
  draw_found(plot, f.A_prime, "$A'$", f.figure.A, 2);
  draw_found(plot, f.B_prime, "$B'$", f.figure.B, 2);
  draw_found(plot, f.G3_prime, "$G'_{3}$", f.G3(), 4);
  if (!f.P0) return;
  plot.cross(*f.P0);
  plot.label("$P_{0}$", *f.P0, f.G3(), Meaning::locus);
  plot.step(1, *f.P0);
  plot.measures_coordinates("P0", *f.P0, f.figure.A0);
  plot.measures("P0A", *f.P0, f.figure.A);
  plot.measures("P0B", *f.P0, f.figure.B);
  plot.measures("P0G3", *f.P0, f.G3());
  if (f.inflection.centre) {
    const Place F = *f.inflection.centre;
    plot.cross(F);
    plot.label("$F$", F, f.P0, Meaning::locus);
    plot.step(3, F);
    plot.measures_coordinates("inflection_centre", F, f.figure.A0);
  }
  if (f.J) {
    plot.segment(*f.P0, *f.J, Meaning::axis);
    plot.cross(*f.J);
    plot.label("$J$", *f.J, f.P0, Meaning::locus);
    plot.measures("inflection_diameter", *f.P0, *f.J);
    plot.measures_coordinates("inflection_pole", *f.J, f.figure.A0);
  }
  if (f.G3_prime) {
    plot.measures("G3prime_G3", *f.G3_prime, f.G3());
    plot.measures_coordinates("G3prime", *f.G3_prime, f.figure.A0);
  }
}

void draw_centre(Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  if (!f.centre_of_G3) return;
  const Place centre = *f.centre_of_G3;
  const int step = f.P0 ? 5 : 2;
  plot.cycle(osculating(f), Meaning::construction);
  if (!is_in(room, plot, centre))
    return plot.step(step, draw_towards(plot, room, f.G3(), centre, "$Ω_{G3}$", language));
  plot.segment(centre, f.G3(), Meaning::dimension, "rho_G3");
  plot.cross(centre);
  plot.label("$Ω_{G3}$", centre, f.G3(), Meaning::locus);
  plot.step(step, centre);
  plot.measures("rho_G3", centre, f.G3());
  plot.measures_coordinates("curvature_centre_G3", centre, f.figure.A0);
}

std::string left_out(const Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  OffSheet off(plot, room);
  for (const auto& [letters, P] :
       {std::pair{"$P_{0}$", f.P0}, std::pair{"$A'$", f.A_prime}, std::pair{"$B'$", f.B_prime},
        std::pair{"$F$", f.inflection.centre}, std::pair{"$J$", f.J}, std::pair{"$G'_{3}$", f.G3_prime},
        std::pair{"$Ω_{G3}$", f.centre_of_G3}})
    off.point(letters, P);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, f.inflection);
  off.circle({"part of the osculating circle", "parte del cerchio osculatore"}, osculating(f));
  return off.sentence(language);
}

drawings::Steps steps_to_curvature(const Drawn& f, Language language) {
  const bool english = language == Language::english;
  if (!f.P0) {
    return english ? drawings::Steps{{"Crank and rocker are parallel: $P_{0}$ is at infinity, the rays are parallel "
                                      "and the inflection circle is a line.",
                                      "$Ω_{G3}$ on the normal to $\\vec{v}_{G3}$, at $ρ$ = $v^{2}_{G3}$ / "
                                      "$a^{n}_{G3}$."}}
                   : drawings::Steps{{"Manovella e bilanciere sono paralleli: $P_{0}$ è all'infinito, i raggi sono "
                                      "paralleli e la circonferenza dei flessi è una retta.",
                                      "$Ω_{G3}$ sulla normale a $\\vec{v}_{G3}$, a $ρ$ = $v^{2}_{G3}$ / "
                                      "$a^{n}_{G3}$."}};
  }
  if (english) {
    return {{"$P_{0}$, where crank and rocker meet.",
             "$A'$ and $B'$ on their rays: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, $P_{0}B^{2}$ = $B_{0}B$·$B'B$.",
             "Inflection circle through $P_{0}$, $A'$, $B'$: centre $F$, diameter $P_{0}J$.",
             "$G'_{3}$, where the ray $P_{0}G_{3}$ meets it again.",
             "Euler-Savary: $P_{0}G^{2}_{3}$ = $Ω_{G3}G_{3}$·$G'_{3}G_{3}$ gives $Ω_{G3}$, on the side of $G'_{3}$. "
             "Thin: the osculating circle."}};
  }
  return {{"$P_{0}$, all'incontro di manovella e bilanciere.",
           "$A'$ e $B'$ sui loro raggi: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, $P_{0}B^{2}$ = $B_{0}B$·$B'B$.",
           "Circonferenza dei flessi per $P_{0}$, $A'$, $B'$: centro $F$, diametro $P_{0}J$.",
           "$G'_{3}$, dove il raggio $P_{0}G_{3}$ la incontra ancora.",
           "Euler-Savary: $P_{0}G^{2}_{3}$ = $Ω_{G3}G_{3}$·$G'_{3}G_{3}$ dà $Ω_{G3}$, dalla parte di $G'_{3}$. "
           "Sottile: il cerchio osculatore."}};
}

drawings::Table points_and_radii(const Drawn& f, Language language) {
  const auto num = [&](const std::optional<Place>& P, double Place::*coordinate) {
    return P ? figures((*P).*coordinate, 4, language) : std::string("∞");
  };
  drawings::Table table{{"", "$x$ (m)", "$y$ (m)"}, {}};
  for (const auto& [name, P] :
       {std::pair{"$P_{0}$", f.P0}, std::pair{"$A'$", f.A_prime}, std::pair{"$B'$", f.B_prime},
        std::pair{"$G'_{3}$", f.G3_prime}, std::pair{"$Ω_{G3}$", f.centre_of_G3},
        std::pair{"$F$", f.inflection.centre}, std::pair{"$J$", f.J}})
    table.rows.push_back({name, num(P, &Place::x), num(P, &Place::y)});
  return table;
}

}  // namespace

void draw_curvature(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const Fit fit = fit_lengths(room, request, 1000 / f.figure.reach(),
                              [&](const Scale& scale) { return extent_of_curvature(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_rays(plot, f);
  draw_inflection_circle(plot, f);
  f.figure.sketch(plot);
  draw_centre(plot, f, room, language);
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {plot.scale()}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_to_curvature(f, language));
  if (const std::string off = left_out(plot, f, room, language); !off.empty())
    column.push_back(drawings::Paragraph{off});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(points_and_radii(f, language));
  const std::string radius = f.centre_of_G3 ? figures(distance(*f.centre_of_G3, f.G3()), 4, language) : "∞";
  const std::string diameter = f.inflection.centre ? figures(2 * f.inflection.radius, 4, language) : "∞";
  column.push_back(drawings::Paragraph{fmt::format("$ρ_{{G3}}$ = {} m,  $δ_{{F}}$ = {} m", radius, diameter)});
  std::vector<Value> values;
  if (f.centre_of_G3)
    values = {{"ρ_G3", distance(*f.centre_of_G3, f.G3()), "m"},
              {"x_Ω", f.centre_of_G3->x, "m"},
              {"y_Ω", f.centre_of_G3->y, "m"}};
  onto.sheet.description =
      in_words({"The inflection circle of the coupler and the centre of curvature of the path of its midpoint",
                "La circonferenza dei flessi della biella e il centro di curvatura della traiettoria della mezzeria"},
               values, language);
}

}  // namespace epure::four_bar_analytic
