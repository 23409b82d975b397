// The sheet of one instant: velocity and acceleration of M with its parts, the inflection circle, and the centre of
// curvature by Euler and Savary.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/roulette/exercise.h"

namespace epure::roulette {
namespace {

constexpr double longest_velocity = 38, longest_acceleration = 46;  // mm
constexpr double far = 3.2;  // times the bodies beside M: a circle still whole, a centre still shown

double size_of_bodies(const Drawn& f) { return std::max(f.C ? 2 * f.r : f.R, f.P0M()); }

// Inside a circle hardly larger than the rolling one the inflection circle is many times as large as both.
bool is_inflection_circle_small(const Drawn& f) { return f.diameter <= far * size_of_bodies(f); }

// How large the figure is without the centre of curvature.
double reach(const Drawn& f) {
  return is_inflection_circle_small(f) ? std::max(size_of_bodies(f), f.diameter) : size_of_bodies(f);
}

bool is_near(const Drawn& f, const Place& P) { return distance(P, f.M) <= far * reach(f); }

Place middle_of_inflection_circle(const Drawn& f) { return {(f.P0.x + f.J.x) / 2, (f.P0.y + f.J.y) / 2}; }
DrawnCycle inflection_circle(const Drawn& f) { return circle_through(f.P0, middle_of_inflection_circle(f)); }

struct Scales {
  Scale velocities, accelerations;
};

drawings::Box extent_of(const Drawn& f, const Scale& scale, const Scales& vectors) {
  Extent extent;
  const auto include_circle = [&](const Place& centre, double radius) {
    extent.include(scale, {centre.x - radius, centre.y - radius}, letters / 2);
    extent.include(scale, {centre.x + radius, centre.y + radius}, letters / 2);
  };
  const auto include_tip = [&](const Arrow2& v, const Scale& of) {
    const double mm = of.mm_per_unit;
    const double x = scale.mm_per_unit * f.M.x + mm * v.x, y = scale.mm_per_unit * f.M.y + mm * v.y;
    extent.include(x - letters, y - letters);
    extent.include(x + letters, y + letters);
  };
  if (f.C) include_circle(*f.C, f.r);
  if (is_inflection_circle_small(f)) include_circle(middle_of_inflection_circle(f), f.diameter / 2);
  for (const Place& P : {f.M, f.P0}) extent.include(scale, P, letters);
  for (const std::optional<Place>& P : {std::optional{f.M_prime}, f.centre})
    if (P && is_near(f, *P)) extent.include(scale, *P, letters);
  include_tip(f.v, vectors.velocities);
  for (const Arrow2& a : {f.a, f.a_n}) include_tip(a, vectors.accelerations);
  return extent.box();
}

void draw_circle_of_inflections(Plot& plot, const Drawn& f) {
  plot.cycle(inflection_circle(f), Meaning::second_locus, "inflection_circle");
  plot.segment(f.P0, f.J, Meaning::axis);
  plot.cross(f.J, Meaning::second_locus);
  plot.label("$J$", f.J, f.P0, Meaning::second_locus);
  plot.measures("inflection_diameter", f.P0, f.J);
  plot.step(1, f.J);
}

void draw_ray(Plot& plot, const Drawn& f) {
  if (f.is_at_cusp) return;
  plot.long_segment(f.P0, f.M, 5, Meaning::construction);
  plot.segment(f.M, f.M_prime, Meaning::construction);
  plot.segment(f.J, f.M_prime, Meaning::construction);
  plot.measures("P0M", f.P0, f.M);
  plot.step(3, f.M_prime);
  if (f.runs_straight) return;
  plot.right_angle(f.M_prime, f.J, f.M);
  plot.dot(f.M_prime, Meaning::second_locus);
  plot.label("$M'$", f.M_prime, f.M, Meaning::second_locus);
  plot.measures("Mprime_M", f.M_prime, f.M);
}

void draw_curvature(Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  if (f.is_at_cusp) return plot.step(3, f.M);
  if (!f.centre) return;
  const Place centre = *f.centre;
  if (!is_in(room, plot, centre)) return plot.step(5, draw_towards(plot, room, f.M, centre, "$Ω$", language));
  plot.segment(f.M, centre, Meaning::construction);
  plot.circle(centre, distance(centre, f.M), Meaning::construction, "osculating_circle");
  plot.cross(centre);
  plot.label("$Ω$", centre, f.M, Meaning::locus);
  plot.measures("rho_M", centre, f.M);
  plot.step(5, centre);
}

constexpr double least_part = 1.5;  // mm: a part of the acceleration that can be seen

// Where a_M sets off: from M, unless it lies along v_M and in its sense, so that one would hide the other. Then from
// beside M, joined to it.
Place start_of_acceleration(Plot& plot, const Drawn& f, const Scales& scales) {
  constexpr double beside = 3;  // mm
  const bool in_the_sense_of_v = f.a.x * f.v.x + f.a.y * f.v.y > 0;
  if (!in_the_sense_of_v || magnitude(f.a_n) * scales.accelerations.mm_per_unit >= least_part) return f.M;
  const double off = beside / (plot.scale().mm_per_unit * f.P0M());
  const Place start{f.M.x + off * (f.M.x - f.P0.x), f.M.y + off * (f.M.y - f.P0.y)};
  plot.segment(f.M, start, Meaning::construction);
  return start;
}

// The parts are drawn only where there are two. The tangential one follows the normal one to the tip of their sum:
// set off from M it would lie on v_M.
void draw_acceleration(Plot& plot, const Drawn& f, const Scales& scales) {
  plot.vectors_at(scales.accelerations);
  const double mm = scales.accelerations.mm_per_unit;
  if (magnitude(f.a) > 0) {
    const Place start = start_of_acceleration(plot, f, scales);
    plot.vector_on("a_M", start, f.a, Meaning::acceleration, "$\\vec{a}_{M}$");
  }
  plot.step(f.is_at_cusp ? 2 : 4, plot.tip(f.M, f.a));
  if (magnitude(f.a_n) * mm < least_part || magnitude(f.a_t) * mm < least_part) return;
  plot.vector_on("a_M_n", f.M, f.a_n, Meaning::acceleration, "$\\vec{a}^{n}_{M}$");
  plot.vector_on("", plot.tip(f.M, f.a_n), f.a_t, Meaning::acceleration, "$\\vec{a}^{t}_{M}$");
}

void draw_velocity(Plot& plot, const Drawn& f, const Scales& scales) {
  plot.vectors_at(scales.velocities);
  if (magnitude(f.v) > 0) plot.vector_on("v_M", f.M, f.v, Meaning::velocity, "$\\vec{v}_{M}$");
  if (!f.is_at_cusp) plot.step(2, plot.tip(f.M, f.v));
}

std::string first_step(const Drawn& f, Language language) {
  const Words end{" $δ$ = $P_{0}J$.", " $δ$ = $P_{0}J$."};
  switch (f.problem.rolling.how) {
    case Rolls::circle_on_line:
      return Words{"The contact $P_{0}$ is the pole. $C$ runs straight: it is the inflection pole, $J$ = $C$.",
                   "Il contatto $P_{0}$ è il polo. $C$ va diritto: è il polo dei flessi, $J$ = $C$."}
                 .in(language) +
             end.in(language);
    case Rolls::line_on_circle:
      return Words{
                 "The contact $P_{0}$ is the pole. Seen from the line $O$ runs straight: the inflection pole $J$ "
                 "lies "
                 "opposite it.",
                 "Il contatto $P_{0}$ è il polo. Visto dalla retta $O$ va diritto: il polo dei flessi $J$ gli sta di "
                 "fronte."}
                 .in(language) +
             end.in(language);
    default:
      return Words{
                 "The contact $P_{0}$ is the pole. $C$ goes about $O$: by Euler and Savary $P_{0}C^{2}$ = $CO$·$CJ$ "
                 "gives the inflection pole $J$.",
                 "Il contatto $P_{0}$ è il polo. $C$ ruota intorno a $O$: per Eulero e Savary $P_{0}C^{2}$ = "
                 "$CO$·$CJ$ "
                 "dà "
                 "il polo dei flessi $J$."}
                 .in(language) +
             end.in(language);
  }
}

// ω² P0J at the pole carried over to M: ω² MJ, and what α adds. MJ = MM' + M'J, along the ray and square to it.
Words acceleration_step(const Drawn& f) {
  const bool angular = !is_zero(f.problem.alpha);
  const std::string of_alpha = " + $α$·$P_{0}M$", parts = "$\\vec{a}_{M}$ = $\\vec{a}^{n}_{M}$ + $\\vec{a}^{t}_{M}$";
  const std::string tangential = "$a^{t}_{M}$ = $ω^{2}$·$M'J$" + (angular ? of_alpha : "");
  if (is_zero(f.problem.omega))
    return {"$ω$ = 0: $a_{M}$ = $α$·$P_{0}M$, square to the ray.",
            "$ω$ = 0: $a_{M}$ = $α$·$P_{0}M$, normale al raggio."};
  if (angular)
    return {tangential + ", square to the ray, each with its sense. " + parts + ".",
            tangential + ", normali al raggio, ciascuno col suo verso. " + parts + "."};
  return {tangential + ", square to the ray. " + parts + " = $ω^{2}$·$MJ$: it points at $J$.",
          tangential + ", normale al raggio. " + parts + " = $ω^{2}$·$MJ$: è diretta verso $J$."};
}

std::vector<Words> steps_at_cusp(const Drawn& f) {
  return {
      {"$M$ is on the pole: $\\vec{v}_{M}$ = 0. All of $\\vec{a}_{M}$ = $ω^{2}$·$P_{0}J$ is along the path: against "
       "the motion before, with it after.",
       "$M$ è sul polo: $\\vec{v}_{M}$ = 0. Tutta la $\\vec{a}_{M}$ = $ω^{2}$·$P_{0}J$ è lungo la traiettoria: "
       "contro "
       "il moto prima, concorde dopo."},
      f.runs_straight
          ? Words{"The path is straight: $M$ turns back.", "La traiettoria è diritta: $M$ torna indietro."}
          : Words{"The path has a cusp: $ρ$ = 0, the centre of curvature is $M$.",
                  "La traiettoria ha una cuspide: $ρ$ = 0, il centro di curvatura è $M$."}};
}

Words curvature_step(const Drawn& f) {
  if (!f.centre)
    return {"$M$ is on the inflection circle: the path is straight here, $Ω$ is at infinity.",
            "$M$ è sul cerchio dei flessi: la traiettoria qui è diritta, $Ω$ è all'infinito."};
  return {"$P_{0}M^{2}$ = $M$$Ω$·$MM'$: centre of curvature $Ω$, on the side of $M'$.",
          "$P_{0}M^{2}$ = $M$$Ω$·$MM'$: centro di curvatura $Ω$, dalla parte di $M'$."};
}

// Every step but the first.
std::vector<Words> steps_after_the_pole(const Drawn& f) {
  if (f.is_at_cusp) return steps_at_cusp(f);
  const std::string velocity = "$\\vec{v}_{M}$ ⊥ $P_{0}M$, $v_{M}$ = $ω$·$P_{0}M$.";
  std::vector<Words> steps{{velocity, velocity}};
  if (f.runs_straight) {
    steps.push_back(
        {"$M$ is on the inflection circle, always: $M'$ = $M$, its path is a diameter, $\\vec{a}^{n}_{M}$ = 0.",
         "$M$ è sempre sul cerchio dei flessi: $M'$ = $M$, la traiettoria è un diametro, $\\vec{a}^{n}_{M}$ = "
         "0."});
    steps.push_back(acceleration_step(f));
    return steps;
  }
  steps.push_back(
      {"The foot of $J$ on the ray $P_{0}M$ is $M'$, on the inflection circle: $a^{n}_{M}$ = $ω^{2}$·$MM'$.",
       "Il piede della normale da $J$ sul raggio $P_{0}M$ è $M'$, sul cerchio dei flessi: $a^{n}_{M}$ = "
       "$ω^{2}$·$MM'$."});
  steps.push_back(acceleration_step(f));
  steps.push_back(curvature_step(f));
  return steps;
}

std::vector<std::string> steps_at_instant(const Drawn& f, Language language) {
  std::vector<std::string> lines{first_step(f, language)};
  for (const Words& step : steps_after_the_pole(f)) lines.push_back(step.in(language));
  return lines;
}

std::string left_out(const Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  OffSheet off(plot, room);
  off.point("$J$", f.J);
  off.point("$M'$", f.M_prime);
  off.point("$Ω$", f.centre);
  off.circle({"part of the inflection circle", "parte del cerchio dei flessi"}, inflection_circle(f));
  return off.sentence(language);
}

void fill_column(DrawnSheet& onto, const Drawn& f, const std::string& left_out, Language language) {
  const bool english = language == Language::english;
  const auto num = [&](double x) { return figures(x, 4, language); };
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(drawings::Steps{steps_at_instant(f, language)});
  if (!left_out.empty()) column.push_back(drawings::Paragraph{left_out});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const auto line = [&](const std::string& text) { column.push_back(drawings::Paragraph{text}); };
  line(fmt::format("$P_{{0}}M$ = {} m,  $v_{{M}}$ = {} m/s", num(f.P0M()), num(magnitude(f.v))));
  line(fmt::format("$a_{{M}}$ = {} m/s²,  $a^{{n}}_{{M}}$ = {} m/s²", num(magnitude(f.a)), num(magnitude(f.a_n))));
  if (f.along_before && f.is_at_cusp)
    line(fmt::format("$a^{{t}}_{{M}}$ = {} m/s² {}, {} m/s² {}", num(*f.along_before), english ? "before" : "prima",
                     num(*f.along_after), english ? "after" : "dopo"));
  else if (f.along_before)
    line(fmt::format("$a^{{t}}_{{M}}$ = {} m/s²", num(*f.along_before)));
  line(fmt::format("$δ$ = {} m,  $ρ_{{M}}$ = {}", num(f.diameter),
                   f.centre ? num(distance(*f.centre, f.M)) + " m" : std::string("∞")));
}

}  // namespace

void draw_instant_sheet(DrawnSheet& onto, const Problem& problem, const SheetRequest& request) {
  const Drawn f = drawn(problem);
  const Language language = request.language;
  const drawings::Box room = room_above_scale_bars(request);
  const auto scale_for = [&](double longest_mm, double value, const std::string& unit) {
    return largest_vector_scale(longest_mm / (value > 0 ? value : 1), unit, language);
  };
  const Scales vectors{scale_for(longest_velocity, magnitude(f.v), "m/s"),
                       scale_for(longest_acceleration, magnitude(f.a), "m/s²")};
  const Fit fit =
      fit_lengths(room, request, 1000 / reach(f), [&](const Scale& s) { return extent_of(f, s, vectors); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_ground(plot, f, room);
  draw_path(plot, f, way_of(f, 1));
  draw_circle_of_inflections(plot, f);
  draw_body(plot, f);
  draw_ray(plot, f);
  draw_curvature(plot, f, room, language);
  draw_velocity(plot, f, vectors);
  draw_acceleration(plot, f, vectors);
  plot.dot(f.M, Meaning::locus);
  plot.label(f.is_at_cusp ? "$M$ = $P_{0}$" : "$M$", f.M, f.C ? *f.C : f.P0, Meaning::locus);
  if (!f.is_at_cusp) {
    plot.cross(f.P0);
    plot.label("$P_{0}$", f.P0, f.J, Meaning::locus);
  }
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  std::vector<Scale> scales{fit.scale};
  if (magnitude(f.v) > 0) scales.push_back(vectors.velocities);
  if (magnitude(f.a) > 0) scales.push_back(vectors.accelerations);
  add_scale_bars(onto, scales, request);
  fill_column(onto, f, left_out(plot, f, room, language), language);
  std::vector<Value> values{{"v_M", magnitude(f.v), "m/s"}, {"a_M", magnitude(f.a), "m/s²"}};
  if (f.centre) values.push_back({"ρ_M", distance(*f.centre, f.M), "m"});
  onto.sheet.description =
      in_words({"The bodies, the path, velocity and acceleration of M, the inflection circle and the "
                "centre of curvature",
                "I corpi, la traiettoria, velocità e accelerazione di M, il cerchio dei flessi e il "
                "centro di curvatura"},
               values, language);
}

}  // namespace epure::roulette
