// Sheet 1: the mechanism at t1, its pole by two lines, and the velocities square to their rays.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-velocity/exercise.h"

namespace epure::slider_crank_velocity {
namespace {

struct Named {
  const char *point, *symbol, *distance, *velocity;
  Place at;
  Arrow2 v;
};

std::vector<Named> points(const Drawn& f) {
  return {{"$A$", "A", "P0A", "v_A", f.at.A, f.v_A},
          {"$B$", "B", "P0B", "v_B", f.at.B, f.v_B},
          {"$C$", "C", "P0C", "v_C", f.at.C, f.v_C},
          {"$M$", "M", "P0M", "v_M", f.at.M, f.v_M}};
}

double greatest_speed(const Drawn& f) {
  double greatest = 0;
  for (const Named& X : points(f)) greatest = std::max(greatest, std::hypot(X.v.x, X.v.y));
  return greatest;
}

drawings::Box extent(const Drawn& f, const Scale& lengths, const Scale& velocities, bool with_pole) {
  Extent extent;
  include_slider_crank(extent, lengths, f.at);
  if (with_pole) extent.include(lengths, *f.P0, 11);
  for (const Named& X : points(f)) {
    const double x = lengths.mm_per_unit * X.at.x + velocities.mm_per_unit * X.v.x;
    const double y = lengths.mm_per_unit * X.at.y + velocities.mm_per_unit * X.v.y;
    extent.include(x - 4, y - 6);
    extent.include(x + 4, y + 6);
  }
  return extent.box();
}

void draw_pole(Plot& plot, const Drawn& f) {
  const Place P0 = *f.P0;
  plot.long_segment(f.at.A0, P0, 6, Meaning::construction);
  plot.long_segment(f.at.B, P0, 6, Meaning::construction);
  plot.segment(f.at.C, P0, Meaning::construction);
  plot.segment(f.at.M, P0, Meaning::construction);
  plot.right_angle(f.at.B, P0, f.at.A0);
  plot.cross(P0);
  plot.label("$P_{0}$", P0, f.at.M, Meaning::locus);
  const double sense = f.omega_3 > 0 ? 1 : -1;
  const double down = std::atan2(f.at.M.y - P0.y, f.at.M.x - P0.x);
  plot.mark(drawings::Rotation{plot.at(P0), 8, down - 2.2 * sense, down - 1.0 * sense});
  const double middle = down - 1.6 * sense, out = 9 / plot.scale().mm_per_unit;
  plot.label("$ω_{3}$", {P0.x + out * std::cos(middle), P0.y + out * std::sin(middle)}, P0);
  plot.measures_coordinates("P0", P0, f.at.A0);
  for (const Named& X : points(f)) plot.measures(X.distance, P0, X.at);
}

// The rays leave the sheet towards P₀: parallel when it is at infinity. (The dead centre, where P₀ is B, is none of
// this.)
void draw_far_pole(Plot& plot, const Drawn& f, const drawings::Box& room, Language language) {
  const GuideAxes guide(f.at);
  for (const Named& X : points(f)) {
    const Place beyond = f.P0.value_or(X.at + guide.left);
    // On the lines of A and B it is found.
    if (X.symbol[0] == 'A' || X.symbol[0] == 'B')
      plot.step(X.symbol[0] == 'A' ? 3 : 4, draw_towards(plot, room, X.at, beyond, "$P_{0}$", language));
    else
      plot.segment(X.at, at_edge(plot, room, X.at, beyond - X.at), Meaning::construction);
  }
  if (f.P0) plot.step(5, plot.tip(f.at.A, f.v_A));
  plot.step(f.P0 ? 6 : 5, plot.tip(f.at.C, f.v_C));
}

drawings::Steps steps(const Drawn& f, Language language) {
  const std::string phi = short_number(degrees(f.instant.crank), language);
  const std::vector<Words> lines{
      {fmt::format("Crank at $φ$ = {}°. $A$ on its circle, $B$ on the guide by the arc of radius $l$ about $A$.",
                   phi),
       fmt::format(
           "Manovella a $φ$ = {}°. $A$ sulla sua circonferenza, $B$ sulla guida con l'arco di raggio $l$ da $A$.",
           phi)},
      {"$C$ by the arcs $AC$ and $BC$, on the left of $AB$. $M$ halves $AB$.",
       "$C$ con gli archi $AC$ e $BC$, a sinistra di $AB$. $M$ è il punto medio di $AB$."},
      {"$A$ moves square to the crank: $P_{0}$ lies on the line $A_{0}A$.",
       "$A$ si muove normalmente alla manovella: $P_{0}$ sta sulla retta $A_{0}A$."}};
  const std::vector<Words> finite_pole{
      {"$B$ moves along the guide: $P_{0}$ lies on the perpendicular to it through $B$.",
       "$B$ si muove lungo la guida: $P_{0}$ sta sulla normale alla guida per $B$."},
      {"$v_{A}$ = $ω_{2}$·$A_{0}A$, $ω_{3}$ = $v_{A}$ / $P_{0}A$.",
       "$v_{A}$ = $ω_{2}$·$A_{0}A$, $ω_{3}$ = $v_{A}$ / $P_{0}A$."},
      {"$v_{X}$ = $ω_{3}$·$P_{0}X$, square to the ray $P_{0}X$.",
       "$v_{X}$ = $ω_{3}$·$P_{0}X$, normale al raggio $P_{0}X$."}};
  const std::vector<Words> pole_at_infinity{
      {"The perpendicular to the guide through $B$ is parallel to it: $P_{0}$ is at infinity.",
       "La normale alla guida per $B$ le è parallela: $P_{0}$ è all'infinito."},
      {"The coupler translates: $ω_{3}$ = 0, and every point has the velocity of $A$.",
       "La biella trasla: $ω_{3}$ = 0, e ogni punto ha la velocità di $A$."}};
  drawings::Steps all;
  for (const Words& line : lines) all.lines.push_back(line.in(language));
  for (const Words& line : f.P0 ? finite_pole : pole_at_infinity) all.lines.push_back(line.in(language));
  return all;
}

void write_column(DrawnSheet& onto, const Drawn& f, Language language) {
  const bool english = language == Language::english;
  const auto num = [&](double x) { return figures(x, 4, language); };
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(f, language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const double omega_2 = geometry::to_double(f.instant.n);
  column.push_back(
      drawings::Paragraph{fmt::format("$ω_{{2}}$ = {} rad/s,  $ω_{{3}}$ = {} rad/s", num(omega_2), num(f.omega_3))});
  drawings::Table table{{"$X$", "$P_{0}X$ (m)", "$v_{X}$ (m/s)"}, {}};
  for (const Named& X : points(f)) {
    const double d = f.P0 ? std::hypot(f.P0->x - X.at.x, f.P0->y - X.at.y) : 0;
    table.rows.push_back({X.point, f.P0 ? num(d) : "∞", num(std::hypot(X.v.x, X.v.y))});
  }
  column.push_back(table);
  if (const std::string swing = swing_in_words(f.instant, language); !swing.empty())
    column.push_back(drawings::Paragraph{swing});
}

// With the pole when it fits the scale that is asked for, or else takes no more than the next smaller one.
Fit fit_of(const Drawn& f, const drawings::Box& room, const Scale& velocities, const SheetRequest& request) {
  const auto fit = [&](bool with_pole, const SheetRequest& wish) {
    return fit_lengths(room, wish, 1000 / reach(f.at),
                       [&](const Scale& lengths) { return extent(f, lengths, velocities, with_pole); });
  };
  const auto largest = [&](bool with_pole) {
    SheetRequest any_scale = request;
    any_scale.scale.reset();
    return fit(with_pole, any_scale).scale.mm_per_unit;
  };
  constexpr double far = 5, next = 2.6;  // standard scales differ by 2 or 2.5
  const bool is_near = f.P0 && std::abs(GuideAxes(f.at).ordinate(*f.P0)) <= far * reach(f.at);
  const auto least = [&] { return request.scale ? length_scale(*request.scale).mm_per_unit : largest(false) / next; };
  return fit(is_near && largest(true) >= least(), request);
}

}  // namespace

void draw_poles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  constexpr double longest_vector = 32;  // mm: reads well and stays clear of the other points
  const Scale velocities = largest_vector_scale(longest_vector / greatest_speed(f), "m/s", request.language);
  const drawings::Box room = room_above_scale_bars(request);
  const Fit fit = fit_of(f, room, velocities, request);
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(velocities);
  const bool shows_pole = f.P0 && is_in(room, plot, *f.P0);
  shows_pole ? draw_pole(plot, f) : draw_far_pole(plot, f, room, request.language);
  draw_slider_crank(plot, f.at, sign_of(f.instant.n));
  for (const Named& X : points(f)) {
    plot.vector_on(X.velocity, X.at, X.v, Meaning::velocity, fmt::format("$\\vec{{v}}_{{{}}}$", X.symbol));
    plot.measures_coordinates(X.symbol, X.at, f.at.A0);
    if (shows_pole && X.symbol[0] != 'B') plot.right_angle(X.at, *f.P0, plot.tip(X.at, X.v));
  }
  plot.step(1, f.at.A);
  plot.step(2, f.at.C);
  if (shows_pole) {
    const auto between = [](const Place& P, const Place& Q) {
      return Place{(P.x + 2 * Q.x) / 3, (P.y + 2 * Q.y) / 3};
    };
    plot.step(3, between(f.at.A, *f.P0));
    plot.step(4, between(f.at.B, *f.P0));
    plot.step(5, *f.P0);
    plot.step(6, plot.tip(f.at.C, f.v_C));
  }
  add_scale_bars(onto, {plot.scale(), velocities}, request);
  write_column(onto, f, request.language);
  std::vector<Value> values{{"φ", degrees(f.instant.crank), "°"}, {"ω₃", f.omega_3, "rad/s"}};
  if (f.P0) values.insert(values.end(), {{"x_P0", f.P0->x, "m"}, {"y_P0", f.P0->y, "m"}});
  for (const Named& X : points(f)) values.push_back({X.velocity, std::hypot(X.v.x, X.v.y), "m/s"});
  onto.sheet.description = in_words(
      {"The slider-crank, its pole P₀ by two lines, and the velocities of A, B, C and M square to their rays",
       "Il manovellismo, il polo P₀ con due rette, e le velocità di A, B, C e M normali ai loro raggi"},
      values, request.language);
}

}  // namespace epure::slider_crank_velocity
