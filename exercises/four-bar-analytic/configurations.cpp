// Sheet 1: B where the circles of coupler and rocker meet: both configurations, with the angles of the closure.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_analytic {
namespace {

// What compasses leave behind near B.
void draw_arc(Plot& plot, const Place& centre, const Place& B) {
  constexpr double half = 7;  // mm
  const double radius = distance(centre, B) * plot.scale().mm_per_unit, middle = direction(centre, B);
  plot.mark(drawings::Line{drawings::arc(plot.at(centre), radius, middle - half / radius, middle + half / radius),
                           Meaning::construction,
                           {}});
}

// The angle from +x to the direction PQ, in (-180°, 180°], with its letter.
void draw_angle(Plot& plot, const Place& P, const Place& Q, double radius, const std::string& letter) {
  const double angle = direction(P, Q), unit = 1 / plot.scale().mm_per_unit;
  plot.segment(P, {P.x + (radius + 5) * unit, P.y}, Meaning::construction);
  if (std::abs(angle) * radius < 1) return;  // mm: no room for an arc
  plot.mark(drawings::AngleMark{plot.at(P), radius, std::min(0.0, angle), std::max(0.0, angle)});
  const Place on_arc{P.x + radius * unit * std::cos(angle / 2), P.y + radius * unit * std::sin(angle / 2)};
  plot.label(letter, on_arc, P, Meaning::dimension);
}

void draw_both(Plot& plot, const Drawn& f) {
  const FourBarFigure &chosen = f.figure, &other = f.other;
  plot.segment(other.A, other.B, Meaning::alternative);
  plot.segment(other.B0, other.B, Meaning::alternative);
  for (const Place& centre : {chosen.A, chosen.B0})
    for (const Place& B : {chosen.B, other.B}) draw_arc(plot, centre, B);
  chosen.draw(plot);
  plot.hinge(other.B);
  plot.label("$B'$", other.B, chosen.B, Meaning::text);
  draw_angle(plot, chosen.A0, chosen.A, 13, "$θ_{2}$");
  draw_angle(plot, chosen.A, chosen.B, 11, "$θ_{3}$");
  draw_angle(plot, chosen.B, chosen.B0, 11, "$θ_{4}$");
  plot.step(1, chosen.A);
  plot.step(2, chosen.B);
  plot.step(3, other.B);
  for (const auto& [name, X] : {std::pair{"A", chosen.A}, std::pair{"B", chosen.B}, std::pair{"G2", f.G2()},
                                std::pair{"G3", f.G3()}, std::pair{"G4", f.G4()}})
    plot.measures_coordinates(name, X, chosen.A0);
}

drawings::Steps steps_to_configurations(Language language) {
  if (language == Language::english) {
    return {
        {"$A$ at $θ_{2}$ on the crank's circle.",
         "Arcs about $A$ with $AB$ and about $B_{0}$ with $B_{0}B$ meet in $B$, on the given side of $A$ → $B_{0}$.",
         "They meet again in $B'$, its mirror image in $AB_{0}$: the other configuration."}};
  }
  return {{"$A$ all'anomalia $θ_{2}$ sulla circonferenza di manovella.",
           "Gli archi intorno ad $A$ con $AB$ e a $B_{0}$ con $B_{0}B$ si incontrano in $B$, dal lato dato di $A$ → "
           "$B_{0}$.",
           "Si incontrano ancora in $B'$, simmetrico rispetto ad $AB_{0}$: l'altra configurazione."}};
}

// The source's equation for θ₄, with its coefficients; not in capitals, which are points here.
std::string equation_for_theta_4(const Drawn& f, Language language) {
  const FourBarFigure& at = f.figure;
  const double r1 = at.B0.x, r3 = distance(at.A, at.B), r4 = distance(at.B, at.B0);
  const double k1 = 2 * r4 * (at.A.x - r1), k2 = 2 * r4 * at.A.y;
  const double k3 = r1 * r1 + at.A.x * at.A.x + at.A.y * at.A.y + r4 * r4 - r3 * r3 - 2 * r1 * at.A.x;
  const auto num = [&](double x) { return figures(x, 4, language); };
  return fmt::format(
      "$k_{{1}}$ cos $θ_{{4}}$ + $k_{{2}}$ {} $θ_{{4}}$ + $k_{{3}}$ = 0, {} $k_{{1}}$ = {}, $k_{{2}}$ = {}, "
      "$k_{{3}}$ = {} m²; in $t$ = tan($θ_{{4}}$/2): ($k_{{3}}$ − $k_{{1}}$)$t^{{2}}$ + 2$k_{{2}}$$t$ + "
      "$k_{{3}}$ + $k_{{1}}$ = 0.",
      language == Language::english ? "sin" : "sen", language == Language::english ? "with" : "con", num(k1), num(k2),
      num(k3));
}

drawings::Table link_angles(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 5, language); };
  const bool english = language == Language::english;
  drawings::Table table{{"", "$B$", "$B'$"}, {}};
  const auto angle = [&](const FourBarFigure& at, bool coupler) {
    return num(coupler ? direction(at.A, at.B) : direction(at.B, at.B0));
  };
  const std::string speed = " (rad/s)", rate = " (rad/s²)";
  table.rows = {
      {english ? "side of $AB_{0}$" : "lato di $AB_{0}$",
       f.of.instant.side == geometry::Side::left ? (english ? "left" : "sinistra") : (english ? "right" : "destra"),
       f.of.instant.side == geometry::Side::left ? (english ? "right" : "destra") : (english ? "left" : "sinistra")},
      {"$θ_{3}$ (rad)", angle(f.figure, true), angle(f.other, true)},
      {"$θ_{4}$ (rad)", angle(f.figure, false), angle(f.other, false)},
      {"$ω_{3}$" + speed, num(f.omega_3), num(f.omega_3_other)},
      {"$ω_{4}$" + speed, num(f.omega_4), num(f.omega_4_other)},
      {"$α_{3}$" + rate, num(f.alpha_3), num(f.alpha_3_other)},
      {"$α_{4}$" + rate, num(f.alpha_4), num(f.alpha_4_other)}};
  return table;
}

drawings::Box extent_of(const Drawn& f, const Scale& scale) {
  Extent extent;
  f.figure.include(extent, scale);
  extent.include(scale, f.other.B, 9);
  return extent.box();
}

}  // namespace

void draw_configurations(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / f.figure.reach(),
                              [&](const Scale& scale) { return extent_of(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_both(plot, f);
  add_scale_bars(onto, {plot.scale()}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_to_configurations(language));
  column.push_back(drawings::Heading{english ? "Closure equations" : "Equazioni di chiusura"});
  column.push_back(drawings::Paragraph{
      "$\\vec{r}_{2}$ + $\\vec{r}_{3}$ + $\\vec{r}_{4}$ − $\\vec{r}_{1}$ = 0,  $\\vec{r}_{2}$ = $A_{0}A$, "
      "$\\vec{r}_{3}$ = $AB$, $\\vec{r}_{4}$ = $BB_{0}$, $\\vec{r}_{1}$ = $A_{0}B_{0}$"});
  column.push_back(drawings::Paragraph{equation_for_theta_4(f, language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(link_angles(f, language));
  onto.sheet.description =
      in_words({"Both configurations of the four-bar linkage, with the angles of its closure equations",
                "Le due configurazioni del quadrilatero articolato, con le anomalie delle equazioni di chiusura"},
               {{"θ₃", direction(f.figure.A, f.figure.B), "rad"},
                {"θ₄", direction(f.figure.B, f.figure.B0), "rad"},
                {"ω₃", f.omega_3, "rad/s"},
                {"ω₄", f.omega_4, "rad/s"}},
               language);
}

}  // namespace epure::four_bar_analytic
