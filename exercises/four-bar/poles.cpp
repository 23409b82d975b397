// Velocities by the poles: P₃₁ where the normals to the paths of A and B meet, P₄₂ by Aronhold and Kennedy.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar/figure.h"
#include "exercises/kit/panels/edge.h"

namespace epure::four_bar {
namespace {

constexpr double shown = 2.5;  // times the mechanism's reach: a pole farther away is not drawn

// P₄₂, unless it is far away.
std::optional<Place> relative_pole(const Drawn& f) { return f.coupler.is_near(f.P42, shown) ? f.P42 : std::nullopt; }

drawings::Box extent_of(const Drawn& f, const std::optional<Place>& P42, const Scale& lengths, const Scale& speeds) {
  Extent extent;
  f.mechanism.include(extent, lengths);
  for (const auto& P : {f.coupler.P0, P42}) {
    if (f.coupler.is_near(P, shown)) extent.include(lengths, *P, 9);
  }
  for (const CouplerPoint& X : f.coupler.points) {
    const double x = lengths.mm_per_unit * X.at.x + speeds.mm_per_unit * X.v.x;
    const double y = lengths.mm_per_unit * X.at.y + speeds.mm_per_unit * X.v.y;
    extent.include(x - 8, y - 8);
    extent.include(x + 8, y + 8);
  }
  return extent.box();
}

void draw_pole(Plot& plot, const Drawn& f) {
  const Place P31 = *f.coupler.P0;
  for (const CouplerPoint& X : f.coupler.points) {
    plot.segment(X.at, P31, Meaning::construction);
    plot.measures("P31" + X.letter, P31, X.at);
  }
  plot.segment(f.mechanism.A0, P31, Meaning::construction);
  plot.segment(f.mechanism.B0, P31, Meaning::construction);
  plot.cross(P31);
  plot.label("$P_{31}$", P31, f.coupler.middle(), Meaning::locus);
  plot.measures_coordinates("P31", P31, f.mechanism.A0);
  plot.step(1, P31);
}

// The rays leave the sheet towards P₃₁, parallel when it is at infinity.
void draw_far_pole(Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  const FourBarFigure& m = f.mechanism;
  const auto beyond = [&](const Place& X) { return f.coupler.P0.value_or(X + (m.A - m.A0)); };
  for (const CouplerPoint& X : f.coupler.points)
    if (X.letter != "A" && X.letter != "B")
      plot.segment(X.at, at_edge(plot, room, X.at, beyond(X.at) - X.at), Meaning::construction);
  for (const Place& X : {m.A, m.B}) plot.step(1, draw_towards(plot, room, X, beyond(X), "$P_{31}$", language));
}

void draw_relative_pole(Plot& plot, const Drawn& f, const Place& P42) {
  const FourBarFigure& m = f.mechanism;
  for (const Place& P : {m.A, m.B, m.A0, m.B0}) plot.segment(P, P42, Meaning::construction);
  plot.cross(P42);
  plot.label("$P_{42}$", P42, f.coupler.middle(), Meaning::locus);
  plot.step(f.coupler.P0 ? 5 : 3, P42);
}

drawings::Steps steps(const Drawn& f, bool with_P42, Language language) {
  drawings::Steps written;
  const bool english = language == Language::english;
  if (!f.coupler.P0) {
    written.lines = english ? std::vector<std::string>{"Crank and rocker are parallel: $P_{31}$ is at infinity and the "
                                                       "coupler does not turn, $ω_{3}$ = 0.",
                                                       "$\\vec{v}_{A}$ = $\\vec{v}_{B}$ = $\\vec{v}_{C}$, and $ω_{4}$ = "
                                                       "$v_{B}$ / $B_{0}B$."}
                            : std::vector<std::string>{"Manovella e bilanciere sono paralleli: $P_{31}$ è all'infinito "
                                                       "e la biella non ruota, $ω_{3}$ = 0.",
                                                       "$\\vec{v}_{A}$ = $\\vec{v}_{B}$ = $\\vec{v}_{C}$, e $ω_{4}$ = "
                                                       "$v_{B}$ / $B_{0}B$."};
  } else if (english) {
    written.lines = {"$P_{31}$ where the lines $A_{0}A$ and $B_{0}B$ meet: the normals to the paths of $A$ and $B$.",
                     "$v_{A}$ = $ω_{2}$·$A_{0}A$, square to the crank; $ω_{3}$ = $v_{A}$ / $P_{31}A$.",
                     "$v_{B}$ = $ω_{3}$·$P_{31}B$, square to $P_{31}B$; $ω_{4}$ = $v_{B}$ / $B_{0}B$.",
                     "$v_{C}$ = $ω_{3}$·$P_{31}C$, square to $P_{31}C$."};
  } else {
    written.lines = {
        "$P_{31}$ dove si incontrano le rette $A_{0}A$ e $B_{0}B$: le normali alle traiettorie di $A$ e $B$.",
        "$v_{A}$ = $ω_{2}$·$A_{0}A$, normale alla manovella; $ω_{3}$ = $v_{A}$ / $P_{31}A$.",
        "$v_{B}$ = $ω_{3}$·$P_{31}B$, normale a $P_{31}B$; $ω_{4}$ = $v_{B}$ / $B_{0}B$.",
        "$v_{C}$ = $ω_{3}$·$P_{31}C$, normale a $P_{31}C$."};
  }
  if (with_P42)
    written.lines.push_back(english ? "Aronhold-Kennedy: $P_{42}$ on $AB$ and on $A_{0}B_{0}$; "
                                      "$ω_{4}$ / $ω_{2}$ = $A_{0}P_{42}$ / $B_{0}P_{42}$."
                                    : "Aronhold-Kennedy: $P_{42}$ su $AB$ e su $A_{0}B_{0}$; "
                                      "$ω_{4}$ / $ω_{2}$ = $A_{0}P_{42}$ / $B_{0}P_{42}$.");
  return written;
}

drawings::Table results(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  drawings::Table table{{"$X$", "$P_{31}X$ (m)", "$v_{X}$ (m/s)"}, {}};
  for (const CouplerPoint& X : f.coupler.points) {
    const auto& P = f.coupler.P0;
    table.rows.push_back({"$" + X.letter + "$", P ? num(std::hypot(P->x - X.at.x, P->y - X.at.y)) : "∞",
                          num(std::hypot(X.v.x, X.v.y))});
  }
  return table;
}

}  // namespace

void draw_poles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  constexpr double longest_vector = 60;  // mm
  const Language language = request.language;
  const bool english = language == Language::english;
  const std::optional<Place> P42 = relative_pole(f);
  const Scale speeds = largest_vector_scale(longest_vector / f.coupler.greatest_velocity(), "m/s", language);
  const drawings::Box room = room_above_scale_bars(request);
  const Fit fit = fit_lengths(room, request, 1000 / f.mechanism.reach(),
                              [&](const Scale& lengths) { return extent_of(f, P42, lengths, speeds); });
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(speeds);
  const bool shows_pole = f.coupler.P0 && is_in(room, plot, *f.coupler.P0);
  shows_pole ? draw_pole(plot, f) : draw_far_pole(plot, f, room, language);
  if (P42) draw_relative_pole(plot, f, *P42);
  f.mechanism.draw(plot);
  int step = 2;
  for (const CouplerPoint& X : f.coupler.points) {
    plot.vector_on("v_" + X.letter, X.at, X.v, Meaning::velocity, fmt::format("$\\vec{{v}}_{{{}}}$", X.letter));
    if (f.coupler.P0) plot.right_angle(X.at, plot.tip(X.at, X.v), *f.coupler.P0);
    if (f.coupler.P0 || step == 2) plot.step(step++, plot.tip(X.at, X.v));
  }
  add_scale_bars(onto, {plot.scale(), speeds}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(f, P42.has_value(), language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(results(f, language));
  column.push_back(
      drawings::Paragraph{fmt::format("$ω_{{3}}$ = {} rad/s,  $ω_{{4}}$ = {} rad/s",
                                      figures(f.coupler.omega_3, 4, language), figures(f.omega_4, 4, language))});
  onto.sheet.description =
      in_words({"The four-bar linkage with the poles P31 and P42 and the velocities of A, B and C",
                "Il quadrilatero articolato con i poli P31 e P42 e le velocità di A, B e C"},
               {{"ω₃", f.coupler.omega_3, "rad/s"}, {"ω₄", f.omega_4, "rad/s"}}, language);
}

}  // namespace epure::four_bar
