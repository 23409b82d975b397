// Both dead centres of the rocker in one picture: the ends of its swing.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/four-bar/figure.h"

namespace epure::four_bar {
namespace {

// One of the two, with its number at its letters.
void draw_position(Plot& plot, const Drawn& f, const char* number, Meaning meaning) {
  const FourBarFigure& m = f.mechanism;
  for (const auto& [P, Q] : {std::pair{m.A0, m.A}, std::pair{m.A, m.B}, std::pair{m.B, *m.C}, std::pair{m.A, *m.C},
                             std::pair{m.B0, m.B}}) {
    plot.segment(P, Q, meaning);
  }
  plot.area({m.A, m.B, *m.C}, Meaning::plate);
  const Place inside{(m.A.x + m.B.x + m.C->x) / 3, (m.A.y + m.B.y + m.C->y) / 3};
  for (const auto& [letter, P] : {std::pair{"A", m.A}, std::pair{"B", m.B}, std::pair{"C", *m.C}}) {
    plot.label(fmt::format("${}_{{{}}}$", letter, number), P, letter[0] == 'A' ? m.A0 : inside);
    plot.measures_coordinates(f.coupler.prefix + letter, P, m.A0);
  }
  plot.hinge(m.A);
  plot.hinge(m.B);
  plot.dot(*m.C, Meaning::link);
}

// From one direction at `vertex` to the other, the short way.
void mark_angle(Plot& plot, const Place& vertex, const Place& P, const Place& Q, double radius,
                const std::string& label) {
  const double from = direction(vertex, P), turn = std::remainder(direction(vertex, Q) - from, 2 * std::numbers::pi);
  const drawings::Point at = plot.at(vertex);
  plot.mark(drawings::AngleMark{at, radius, turn > 0 ? from : from + turn, turn > 0 ? from + turn : from,
                                Meaning::dimension});
  const double middle = from + turn / 2;
  plot.label(label, plot.from_paper({at.x + radius * std::cos(middle), at.y + radius * std::sin(middle)}), vertex);
}

drawings::Box extent_of(const Drawn& one, const Drawn& other, const Scale& scale) {
  Extent extent;
  one.mechanism.include(extent, scale);
  other.mechanism.include(extent, scale);
  return extent.box();
}

drawings::Steps steps_to_dead_centres(Language language) {
  if (language == Language::english) {
    return {
        {"The arc about $A_{0}$ with radius $AB$ + $A_{0}A$ cuts the arc of the rocker in $B_{1}$: crank and "
         "coupler extended.",
         "The arc with radius $AB$ − $A_{0}A$ cuts it in $B_{2}$: crank and coupler folded.",
         "$A_{1}$ on $A_{0}B_{1}$, $A_{2}$ on its line $A_{0}B_{2}$ beyond $A_{0}$. The pole $P_{31}$ is $B$: "
         "$v_{B}$ = 0, $ω_{4}$ = 0, and $\\vec{a}_{B}$ is all tangential."}};
  }
  return {
      {"L'arco di centro $A_{0}$ e raggio $AB$ + $A_{0}A$ taglia l'arco del bilanciere in $B_{1}$: manovella e "
       "biella in prolungamento.",
       "L'arco di raggio $AB$ − $A_{0}A$ lo taglia in $B_{2}$: manovella e biella sovrapposte.",
       "$A_{1}$ su $A_{0}B_{1}$, $A_{2}$ sulla retta $A_{0}B_{2}$ oltre $A_{0}$. Il polo $P_{31}$ è $B$: $v_{B}$ = "
       "0, $ω_{4}$ = 0, e la $\\vec{a}_{B}$ è tutta tangenziale."}};
}

double within_turn(double radians) {
  const double degrees = radians * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}

drawings::Table angles_and_rates(const Drawn& one, const Drawn& other, Language language) {
  drawings::Table table{{"", "$φ$ (°)", "$ϑ_{4}$ (°)", "$ω_{3}$", "$α_{3}$", "$α_{4}$"}, {}};
  const char* number = "1";
  for (const Drawn* f : {&one, &other}) {
    const FourBarFigure& m = f->mechanism;
    const auto num = [&](double x) { return figures(x, 4, language); };
    table.rows.push_back({number, num(within_turn(direction(m.A0, m.A))), num(within_turn(direction(m.B0, m.B))),
                          num(f->coupler.omega_3), num(f->coupler.alpha_3), num(f->alpha_4)});
    number = "2";
  }
  return table;
}

// The compasses' arcs that find B₁ and B₂, a little to both sides.
void draw_arcs(Plot& plot, const Drawn& one, const Drawn& other) {
  constexpr double half = 0.16;  // radians
  for (const Drawn* f : {&one, &other}) {
    const FourBarFigure& m = f->mechanism;
    const double middle = direction(m.A0, m.B), radius = distance(m.A0, m.B) * plot.scale().mm_per_unit;
    plot.mark(drawings::Line{
        drawings::arc(plot.at(m.A0), radius, middle - half, middle + half), Meaning::construction, {}});
  }
  const FourBarFigure& m = one.mechanism;
  const double from = direction(m.B0, m.B);
  const double turn = std::remainder(direction(m.B0, other.mechanism.B) - from, 2 * std::numbers::pi);
  const double low = std::min(from, from + turn) - half, high = std::max(from, from + turn) + half;
  plot.mark(drawings::Line{
      drawings::arc(plot.at(m.B0), distance(m.B0, m.B) * plot.scale().mm_per_unit, low, high), Meaning::axis, {}});
}

}  // namespace

void say_that_there_is_none(DrawnSheet& onto, Language language) {
  onto.sheet.column.push_back(drawings::Paragraph{language == Language::english
                                                      ? "This rocker has not both dead centres: crank and coupler "
                                                        "cannot come in line, or do so at a change point."
                                                      : "Questo bilanciere non ha entrambi i punti morti: manovella "
                                                        "e biella non possono allinearsi, o lo fanno in "
                                                        "un punto di passaggio."});
  onto.sheet.description = in_words({"No dead centres", "Nessun punto morto"}, {}, language);
}

void draw_dead_centres(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const auto one = at_dead_centre(of, geometry::Reach::extended), other = at_dead_centre(of, geometry::Reach::folded);
  if (!one || !other) return say_that_there_is_none(onto, language);
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / one->mechanism.reach(),
                              [&](const Scale& scale) { return extent_of(*one, *other, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  const FourBarFigure &m = one->mechanism, &n = other->mechanism;
  plot.circle(m.A0, distance(m.A0, m.A), Meaning::axis);
  plot.long_segment(m.A0, m.B0, 8, Meaning::axis);
  draw_arcs(plot, *one, *other);
  draw_position(plot, *other, "2", Meaning::alternative);
  draw_position(plot, *one, "1", Meaning::link);
  for (const auto& [hinge, pin] : {std::pair{m.A0, m.A}, std::pair{m.B0, m.B}}) {
    plot.mark(drawings::FixedHinge{plot.at(hinge), direction_of_support(hinge, pin)});
  }
  plot.label("$A_{0}$", m.A0, m.A);
  plot.label("$B_{0}$", m.B0, m.B);
  mark_angle(plot, m.B0, m.B, n.B, 16, "$Δϑ_{4}$");
  plot.step(1, m.B);
  plot.step(2, n.B);
  plot.step(3, n.A);
  add_scale_bars(onto, {plot.scale()}, request);
  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_to_dead_centres(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(angles_and_rates(*one, *other, language));
  column.push_back(drawings::Paragraph{english ? "$ω$ in rad/s, $α$ in rad/s²; $ω_{4}$ = 0 in both."
                                               : "$ω$ in rad/s, $α$ in rad/s²; $ω_{4}$ = 0 in entrambi."});
  onto.sheet.description =
      in_words({"The four-bar linkage in both dead centres of its rocker",
                "Il quadrilatero articolato nei due punti morti del bilanciere"},
               {{"α₄ (1)", one->alpha_4, "rad/s²"}, {"α₄ (2)", other->alpha_4, "rad/s²"}}, language);
}

}  // namespace epure::four_bar
