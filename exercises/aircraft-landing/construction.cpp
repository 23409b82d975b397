// Force polygons and moments, with the speeds of the power series; and the tangents drawn.
#include "exercises/aircraft-landing/routes.h"
#include "exercises/aircraft-landing/when_slip_ends.h"
#include "geometry/constructions/proportion.h"
#include "geometry/constructions/vector_polygon.h"
#include "geometry/numbers/greater.h"

namespace epure::aircraft_landing {
namespace {

using Point = geometry::Point<Deep>;
using Vector = geometry::Vector<Deep>;

// All that acts on aircraft and wheel, at a speed v.
struct Body {
  const Landing& of;
  Deep v;

  Vector flaps() const { return geometry::square(v) * Vector{-number(of.c_x), -number(of.c_y)}; }
  Vector weight() const { return {Deep(0), -number(of.M() * of.g)}; }
  Point contact() const { return {number(of.f_v * of.R), -number(of.R)}; }  // seen from the hub
};

struct Slipping {
  Deep N, F, a, alpha;
};
// The reaction lies on the cone of kinetic friction, and the sum of all forces is level.
Slipping slipping(const Body& body) {
  const Landing& of = body.of;
  const Vector on_cone{-number(of.f_r), Deep(1)};
  const auto closed = geometry::close_polygon<Deep>(body.weight() + body.flaps(), on_cone, {Deep(1), Deep(0)});
  const Vector reaction = closed.of_first * on_cone;
  const Deep moment = cross(body.contact() - Point{Deep(0), Deep(0)}, reaction);  // counter-clockwise
  return {reaction.y, -reaction.x, closed.of_second / number(of.M()), -moment / number(of.J_r)};
}

struct Rolling {
  Deep N, F, a;
};
// Moments about the place of contact, about which the wheel turns; the reaction closes the polygon.
Rolling rolling(const Body& body) {
  const Landing& of = body.of;
  const Vector carried = body.weight() + body.flaps();
  const Deep N = -carried.y, resisting = N * number(of.f_v * of.R);
  const Deep alpha = (number(of.R) * carried.x - resisting) / number(of.J_r + of.M() * of.R * of.R),
             a = number(of.R) * alpha;
  const Vector reaction = closing_side(carried, Vector{number(of.M()) * a, Deep(0)});
  return {reaction.y, -reaction.x, a};
}

// Of the braking y by the force polygons, what is beside that of a standing aircraft grows as v²: v dy/dv is twice
// that. A side of the polygon of times is off at most as the chord of a parabola that bends by the steepest
// |d(1/y)/dv| throughout: in the strip's middle.
Deep sides_off_at_most(const Landing& of, const WhenSlipEnds& end) {
  if (of.law().B == 0) return Deep(0);
  const auto braking = [&](const Deep& v) { return -slipping({of, v}).a; };
  const Deep standing = braking(Deep(0)), v_0 = number(of.v_0), grown = braking(v_0) - standing;
  const auto bend_at = [&](const Deep& v) {
    const Deep y = braking(v);
    return Deep(2) * geometry::absolute(y - standing) / (v * geometry::square(y));
  };
  Deep most(0);
  SpinState begin = geometry::analytic::spun_up_by_series(of.law(), Deep(0));
  for (int i = 1; i <= Landing::strips; ++i) {
    const Deep t = end().t * Deep(i) / Deep(Landing::strips);
    const SpinState now = i == Landing::strips ? end() : geometry::analytic::spun_up_by_series(of.law(), begin, t);
    Deep bend = geometry::greater(bend_at(begin.v), bend_at(now.v));
    if (of.law().B > 0) {
      const Deep greatest_at = v_0 * geometry::root(standing / (Deep(3) * grown));
      bend = geometry::greater(bend, bend_at(geometry::within(now.v, greatest_at, begin.v)));
    }
    const auto parabola = [&](const Deep& v) { return bend * geometry::square(v) / Deep(2); };
    most = geometry::greater(most,
                             (parabola(begin.v) + parabola(now.v)) / Deep(2) - parabola((begin.v + now.v) / Deep(2)));
    begin = now;
  }
  return most;
}

}  // namespace

void by_construction(const Landing& of, Extent extent, const Put& put_all) {
  const WhenSlipEnds end(of.law(), geometry::analytic::end_of_slip_by_series);
  const Put put = pressing(of, extent, put_all);
  const auto first = [=] { return slipping({of, number(of.v_0)}); };
  const auto last = [=] { return slipping({of, end().v}); };
  const auto after = [=] { return rolling({of, end().v}); };
  put("v_0", [=] { return geometry::fourth_proportional<Deep>(Deep(36), number(of.v_0 * Rational(36)), Deep(1)); });
  put("omega_rolling_0", [=] { return geometry::fourth_proportional<Deep>(number(of.R), number(of.v_0), Deep(1)); });
  put("u", [=] { return geometry::fourth_proportional<Deep>(Deep(1), number(of.f_v), number(of.R)); });
  const auto flaps = [=] { return Body{of, number(of.v_0)}.flaps(); };
  put("F_x_0", [=] { return -flaps().x; });
  put("F_y_0", [=] { return -flaps().y; });
  put("N_0", [=] { return first().N; });
  put("F_0", [=] { return first().F; });
  put("a_0", [=] { return first().a; });
  put("omega_dot_0", [=] { return first().alpha; });
  const auto crossing = [=] {
    const Slipping now = first();
    const auto of_speed = geometry::line(Point{Deep(0), number(of.v_0)}, Vector{Deep(1), now.a});
    const auto of_rim = geometry::line(Point{Deep(0), number(of.rim_0)}, Vector{Deep(1), number(of.R) * now.alpha});
    return finite(meet(of_speed, of_rim));
  };
  put("t_s_tangents", [=] { return crossing().x; });
  put("v_s_tangents", [=] { return crossing().y; });

  put("t_s", [=] { return end().t; });
  put("v_s", [=] { return end().v; });
  put("omega_s", [=] { return end().omega; });
  put("N_s", [=] { return last().N; });
  put("a_s", [=] { return last().a; });
  put("omega_dot_s", [=] { return last().alpha; });
  put("polygon_off_at_most", [=] { return sides_off_at_most(of, end); });
  put("ground_path_s", [=] { return end().path; });
  put("wheel_angle_s", [=] { return end().angle; });
  put("rolled_path_s", [=] { return number(of.R) * end().angle; });
  put("slip_path_s", [=] { return end().path - number(of.R) * end().angle; });
  put("wheel_energy_s", [=] { return number(of.J_r / 2) * geometry::square(end().omega); });
  put("drag_work_s", [=] { return number(of.c_x) * end().cubes; });
  const auto reaction_per_turning = [=] { return number(Rational(1) / of.turning()); };
  put("rolling_work_s", [=] { return number(of.f_v * of.R) * reaction_per_turning() * end().of_wheel; });
  put("friction_work_s",
      [=] { return number(of.f_r) * reaction_per_turning() * (end().of_load - number(of.R) * end().of_wheel); });
  const auto at_10ms = [=] { return before_slip_ends(end, geometry::analytic::spun_up_by_series); };
  put("v_10ms", [=] { return at_10ms().v; });
  put("omega_10ms", [=] { return at_10ms().omega; });
  put("a_after", [=] { return after().a; });
  put("F_after", [=] { return after().F; });
  // Closes the polygon of the wheel: its weight, the ground's reaction and the force of inertia.
  const auto weight = [=] { return Vector{Deep(0), -(number(of.g) * number(of.m_r))}; };
  const auto put_hub = [=](const std::string& when, const Find& N, const Find& F, const Find& a) {
    const auto inertia = [=] { return Vector{-(number(of.m_r) * a()), Deep(0)}; };
    const auto hub = [=] { return closing_side(weight() + Vector{-F(), N()} + inertia(), Vector{Deep(0), Deep(0)}); };
    put("hub_force_" + when, [=] { return geometry::length(hub()); });
    put("hub_force_" + when + "_x", [=] { return hub().x; });
    put("hub_force_" + when + "_y", [=] { return hub().y; });
    put("wheel_inertia_" + when, [=] { return inertia().x; });
  };
  put_hub(
      "0", [=] { return first().N; }, [=] { return first().F; }, [=] { return first().a; });
  put_hub(
      "after", [=] { return after().N; }, [=] { return after().F; }, [=] { return after().a; });
  put("wheel_weight", [=] { return -weight().y; });
  put("F_after_over_N", [=] { return after().F / after().N; });
  put("adheres", [=] { return adheres(of, after().F, after().N); });
}

}  // namespace epure::aircraft_landing
