#include "exercises/kit/rolling/rolling_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/curves/roulettes.h"

namespace epure {
namespace {

// So many radians along the fixed circle from the contact: written from there, so that a centre kilometres away costs
// no digits.
Place along_circle(const Rolled& f, double angle) {
  const double half = std::sin(angle / 2);
  const Arrow2 tangent{-f.n.y, f.n.x}, inwards = (1 / f.R) * (*f.O() - f.P0);
  return f.P0 + (f.R * std::sin(angle)) * tangent + (2 * f.R * half * half) * inwards;
}

// Beside the contact, on the side that M leaves free.
void name_fixed_circle(Plot& plot, const Rolled& f) {
  constexpr double from_contact = 24, farthest = 2.2;  // mm, radians
  const double angle = std::min(from_contact / (f.R * plot.scale().mm_per_unit), farthest);
  const bool M_on_left = f.n.x * f.M.y - f.n.y * f.M.x > 0;
  plot.label("$p$", along_circle(f, M_on_left ? -angle : angle), *f.O());
}

}  // namespace

void draw_ground(Plot& plot, const Rolled& f, const drawings::Box& room) {
  if (f.given.rolls_on_line()) {
    const double y = plot.at(f.P0).y;
    plot.mark(drawings::Ground{{room.low.x, y}, {room.high.x, y}});
    plot.label("$p$", plot.from_paper({room.low.x + 4, y}), plot.from_paper({room.low.x + 4, y - 9}));
    return;
  }
  const Place O = *f.O();
  plot.cycle(circle_through(f.P0, O), Meaning::ground, "fixed_polode");
  name_fixed_circle(plot, f);
  if (!is_in(room, plot, O)) return;
  constexpr double arm = 3;  // mm
  const drawings::Point o = plot.at(O);
  plot.mark(drawings::Line{drawings::segment({o.x - arm, o.y}, {o.x + arm, o.y}), Meaning::axis, {}});
  plot.mark(drawings::Line{drawings::segment({o.x, o.y - arm}, {o.x, o.y + arm}), Meaning::axis, {}});
  // Off the arms of the cross, away from the bodies.
  const double x = f.n.x > 0 ? -arm : arm, y = f.n.y > 0 ? -arm : arm;
  plot.label("$O$", plot.from_paper({o.x + x / 2, o.y + y / 2}), O);
}

// Behind the contact far enough to be seen to touch there.
std::pair<Place, Place> ends_of_line(const Rolled& f, const Scale& scale) {
  constexpr double seen_to_touch = 10;    // mm
  const Arrow2 unwinding{f.n.y, -f.n.x};  // from P0 to the foot of M, for φ > 0
  const double beyond = f.R / 4, behind = std::max(beyond, std::min(f.R, seen_to_touch / scale.mm_per_unit)),
               foot = f.R * to_double(f.given.phi);
  const auto along = [&](double t) { return f.P0 + t * unwinding; };
  return foot < 0 ? std::pair{along(behind), along(foot - beyond)} : std::pair{along(-behind), along(foot + beyond)};
}

void draw_body(Plot& plot, const Rolled& f, const drawings::Box& room) {
  if (f.given.is_line()) {
    const auto [behind, ahead] = ends_of_line(f, plot.scale());
    plot.segment(behind, ahead, Meaning::link, "moving_polode");
    plot.label("$π$", is_in(room, plot, ahead) ? ahead : ray_to_edge(plot, room, f.P0, ahead - f.P0), f.P0);
    if (f.d != 0) plot.segment(f.M + f.d * f.n, f.M, Meaning::link);
    return;
  }
  const Place C = *f.C();
  plot.circle(C, f.r, Meaning::link, "moving_polode");
  plot.segment(C, f.M, Meaning::link);
  plot.dot(C, Meaning::link);
  // Opposite the contact, beside the line of centres, on the side that M leaves free.
  const bool M_on_left = f.n.x * (f.M.y - C.y) - f.n.y * (f.M.x - C.x) > 0;
  const double aside = M_on_left ? -0.6 : 0.6, x = f.n.x * std::cos(aside) - f.n.y * std::sin(aside),
               y = f.n.x * std::sin(aside) + f.n.y * std::cos(aside);
  plot.label("$π$", {C.x + f.r * x, C.y + f.r * y}, C);
}

void draw_sense(Plot& plot, const Rolled& f) {
  if (f.turning() == 0) return;
  if (f.C()) {
    if (f.d > 0) draw_sense_of_turning(plot, *f.C(), f.M, f.turning(), "$" + f.names.omega + "$");
    return;
  }
  draw_sense_of_line(plot, f.P0, ends_of_line(f, plot.scale()).second,
                     {.sense = static_cast<double>(f.turning()),
                      .is_behind = f.given.unwinds() && f.P0M() > f.R,
                      .omega = f.names.omega});
}

void draw_sense_of_line(Plot& plot, const Place& P0, const Place& end, const SenseOfLine& turning) {
  constexpr double least = 11, gap = 2, gap_behind = 5, length = 14;  // mm
  const double radius = std::max(least, turning.share * distance(P0, end) * plot.scale().mm_per_unit);
  const double way = turning.sense > 0 ? 1 : -1, by = way * length / radius,
               from = direction(P0, end) + way * (turning.is_behind ? -gap_behind - length : gap) / radius;
  const drawings::Point centre = plot.at(P0);
  plot.mark(drawings::Rotation{centre, radius, from, from + by});
  const double middle = from + by / 2;
  plot.label("$" + turning.omega + "$",
             plot.from_paper({centre.x + radius * std::cos(middle), centre.y + radius * std::sin(middle)}), P0);
}

double draw_path(Plot& plot, const RollingGivens& given, const Way& way, Meaning ink) {
  const double tolerance = curve_tolerance_mm / plot.scale().mm_per_unit;
  const geometry::Arithmetic<geometry::Bounded> scope;
  const geometry::RouletteSince<geometry::Bounded> path(given.rolling, given.phi);
  const geometry::SpanTrace traced = geometry::trace_span(path, way.from, way.to, tolerance);
  geometry::Branch branch;
  branch.arcs = traced.arcs;
  branch.closed = way.closed;
  geometry::Trace trace;
  trace.branches = {branch};
  draw_branches(plot, trace, ink, ink == Meaning::locus ? "path" : "");
  return traced.deviation * plot.scale().mm_per_unit;
}

std::vector<Place> samples_of_path(const RollingGivens& given, const Way& way) {
  const geometry::RouletteSince<double> path(given.rolling, given.phi);
  const int count =
      60 + static_cast<int>(60 * std::max<double>(way.arches, (way.to - way.from) / (2 * std::numbers::pi)));
  std::vector<Place> points;
  for (int i = 0; i <= count; ++i) points.push_back(path(way.from + (way.to - way.from) * i / count));
  return points;
}

std::vector<drawings::Block> told_of_curve(const Words& name, const Words& equation, double deviation,
                                           Language language) {
  const Words proved{
      "The line through the points is the true {}; as drawn it is nowhere more than {} mm of paper off it.",
      "La linea per i punti è la vera {}; così disegnata non se ne scosta in alcun punto più di {} mm sul foglio."};
  return {drawings::Heading{Words{"The curve", "La curva"}.in(language)}, drawings::Paragraph{equation.in(language)},
          drawings::Paragraph{
              fmt::format(fmt::runtime(proved.in(language)), name.in(language), figures(deviation, 1, language))}};
}

void include_circle(Extent& extent, const Scale& scale, const Place& centre, double radius) {
  extent.include(scale, {centre.x - radius, centre.y - radius}, letters_room / 2);
  extent.include(scale, {centre.x + radius, centre.y + radius}, letters_room / 2);
}

}  // namespace epure
