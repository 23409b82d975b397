// The bodies and the path as they are drawn, and the instant in doubles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/roulette/exercise.h"

namespace epure::roulette {
namespace {

using geometry::Deep;

constexpr double turn = 2 * std::numbers::pi;

double number(const Rational& q) { return geometry::from_rational<double>(q); }
double number(const Angle& angle) { return geometry::radians<double>(angle); }

constexpr double most_arches = 40, most_turns = 24;  // what a drawing can show of a path

// From the first arch to that of φ; when this is not one of the first few, it and its neighbours.
Way arches_around(double arch, double per_arch, double overhang) {
  constexpr double first_few = 3;
  const bool near_start = std::abs(arch) < first_few;
  const double from = near_start ? std::min(arch, 0.0) : arch - 1,
               to = near_start ? std::max(arch + 1, 1.0) : arch + 2;
  return {(from - arch - overhang) * per_arch, (to - arch + overhang) * per_arch, static_cast<int>(to - from) + 1,
          false};
}

Way unwound(const Drawn& f) {
  constexpr double far = 2 * turn, beyond = turn / 12;
  if (std::abs(f.phi) > far) return {-turn / 2, beyond, 0, false};
  return {std::min(0.0, f.phi) - beyond - f.phi, std::max(turn / 4, f.phi) + beyond - f.phi, 0, false};
}

}  // namespace

Drawn drawn(const Problem& problem) {
  return deeply([&] {
    const geometry::Rolling& g = problem.rolling;
    const auto at = geometry::rolling_instant<Deep>(g, problem.phi, geometry::radians<Deep>(problem.omega),
                                                    geometry::radians<Deep>(problem.alpha));
    const geometry::Point<Deep> contact = geometry::contact_point<Deep>(g, problem.phi);
    const Angle psi = geometry::rolled_angle(g, problem.phi);
    Drawn f{.problem = problem,
            .path = {g, problem.phi},
            .r = number(g.r),
            .R = number(g.R),
            .d = number(g.d),
            .phi = number(problem.phi),
            .psi = number(psi),
            .beta = number(geometry::contact_angle(g, problem.phi)),
            .arches = number(geometry::whole_turns(psi)),
            .in_arch = to_double(geometry::radians<Deep>(geometry::within_one_turn(psi))),
            .M = to_double(at.M),
            .O = to_double(at.motion.A + (geometry::Point<Deep>{Deep(0), Deep(0)} - contact)),
            .J = to_double(at.J),
            .M_prime = to_double(at.M_prime()),
            .M_in_plane = to_double(contact + (at.M - at.motion.A)),
            .n = to_double(at.n),
            .v = to_double(at.velocity()),
            .a = to_double(at.acceleration()),
            .a_n = to_double(at.normal_acceleration()),
            .a_t = to_double(at.tangential_acceleration()),
            .diameter = to_double(at.diameter),
            .s = to_double(geometry::arc_length<Deep>(g, problem.phi)),
            .is_at_cusp = at.is_at_cusp,
            .runs_straight = at.runs_straight};
    if (!problem.is_line()) f.C = Place{f.r * f.n.x, f.r * f.n.y};
    f.centre = to_double(at.centre_of_curvature());
    if (!is_zero(problem.omega)) {
      const auto along = at.tangential_component();
      f.along_before = to_double(along.before);
      f.along_after = to_double(along.after);
    }
    return f;
  });
}

double Drawn::P0M() const { return distance(P0, M); }

Way way_of(const Drawn& f, double overhang) {
  if (f.problem.is_line()) return unwound(f);
  const double per_arch = turn / number(geometry::rolled_per_turned(f.problem.rolling));
  Way way = [&]() -> Way {
    if (!f.problem.rolls_on_line()) {
      // R/r = p/q: the path closes after p arches, in q turns of the contact.
      const Rational ratio = f.problem.rolling.R / f.problem.rolling.r;
      const double arches = number(Rational(ratio.numerator())), around = number(Rational(ratio.denominator()));
      if (arches <= most_arches && around <= most_turns)
        return {0, arches * per_arch, static_cast<int>(arches), true};
    }
    return arches_around(f.arches, per_arch, overhang);
  }();
  const double since_arch = f.in_arch / turn * per_arch;
  way.from -= since_arch;
  way.to -= since_arch;
  if (way.closed) return way;
  way.from = std::max(way.from, -most_turns / 2 * turn);
  way.to = std::min(way.to, most_turns / 2 * turn);
  return way;
}

void draw_ground(Plot& plot, const Drawn& f, const drawings::Box& room) {
  if (f.problem.rolls_on_line()) {
    const double y = plot.at(f.P0).y;
    plot.mark(drawings::Ground{{room.low.x, y}, {room.high.x, y}});
    plot.label("$p$", plot.from_paper({room.low.x + 4, y}), plot.from_paper({room.low.x + 4, y - 9}));
    return;
  }
  plot.cycle(circle_through(f.P0, f.O), Meaning::ground, "fixed_polode");
  if (!plot.shows(f.O)) return;
  constexpr double arm = 3;  // mm
  const drawings::Point o = plot.at(f.O);
  plot.mark(drawings::Line{drawings::segment({o.x - arm, o.y}, {o.x + arm, o.y}), Meaning::axis, {}});
  plot.mark(drawings::Line{drawings::segment({o.x, o.y - arm}, {o.x, o.y + arm}), Meaning::axis, {}});
  plot.label("$O$", f.O, f.P0);
  // Where the circle is farthest from the contact.
  plot.label("$p$", f.O + (f.O - f.P0), f.O);
}

std::pair<Place, Place> ends_of_line(const Drawn& f) {
  const Arrow2 unwinding{f.n.y, -f.n.x};  // from P0 to the foot of M, for φ > 0
  const double beyond = f.R / 4, foot = f.R * f.phi;
  const auto along = [&](double t) { return Place{f.P0.x + t * unwinding.x, f.P0.y + t * unwinding.y}; };
  return foot < 0 ? std::pair{along(beyond), along(foot - beyond)} : std::pair{along(-beyond), along(foot + beyond)};
}

void draw_body(Plot& plot, const Drawn& f) {
  if (f.problem.is_line()) {
    const auto [behind, ahead] = ends_of_line(f);
    plot.segment(behind, ahead, Meaning::link, "moving_polode");
    plot.label("$π$", ahead, f.P0);
    plot.segment({f.M.x + f.d * f.n.x, f.M.y + f.d * f.n.y}, f.M, Meaning::link);
    return;
  }
  plot.circle(*f.C, f.r, Meaning::link, "moving_polode");
  plot.segment(*f.C, f.M, Meaning::link);
  plot.dot(*f.C, Meaning::link);
  plot.label("$C$", *f.C, f.M);
  // Opposite the contact, beside the line of centres, on the side that M leaves free.
  const bool M_on_left = f.n.x * (f.M.y - f.C->y) - f.n.y * (f.M.x - f.C->x) > 0;
  const double aside = M_on_left ? -0.6 : 0.6, x = f.n.x * std::cos(aside) - f.n.y * std::sin(aside),
               y = f.n.x * std::sin(aside) + f.n.y * std::cos(aside);
  plot.label("$π$", {f.C->x + f.r * x, f.C->y + f.r * y}, *f.C);
}

void draw_path(Plot& plot, const Drawn& f, const Way& way) {
  const double tolerance = curve_tolerance_mm / plot.scale().mm_per_unit;
  const geometry::Arithmetic<geometry::Bounded> scope;
  const geometry::RouletteSince<geometry::Bounded> path(f.problem.rolling, f.problem.phi);
  const auto traced = geometry::trace_span(path, way.from, way.to, tolerance);
  geometry::Branch branch;
  branch.arcs = traced.arcs;
  branch.closed = way.closed;
  geometry::Trace trace;
  trace.branches = {branch};
  draw_branches(plot, trace, Meaning::locus, "path");
}

}  // namespace epure::roulette
