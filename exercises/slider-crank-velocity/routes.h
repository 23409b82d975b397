// The slider-crank's velocities found four times: constructed points, method of poles, polar diagram, analysis.
#pragma once

#include "exercises/kit/linkages/slider_crank_routes.h"

namespace epure::slider_crank_velocity {

// The method of poles: ω₃ from v_A and P₀A, every velocity square to its ray from P₀.
template <class T>
void velocities_by_poles(Ledger<T>& ledger, const SliderCrankInstant& instant, const geometry::SliderCrank<T>& at) {
  ledger.route("poles");
  const geometry::Vector<T> v_A = instant.omega_2<T>() * geometry::quarter_turn(at.A - at.A0);
  const geometry::RotationAboutPole<T> coupler(at.pole(), at.A, v_A);
  const geometry::Vector<T> v_B = coupler.velocity(at.B), v_C = coupler.velocity(at.C), v_M = coupler.velocity(at.M);
  ledger.put_length(velocity("A"), coupler.velocity(at.A));
  ledger.put(angular_velocity(3), coupler.omega());
  ledger.put(velocity("B"), v_B);
  ledger.put(velocity("C"), v_C);
  ledger.put(velocity("M"), v_M);
  ledger.put_length(velocity("BA"), v_B - v_A);
  ledger.put_length(velocity("CA"), v_C - v_A);
  ledger.put_length(velocity("MA"), v_M - v_A);
}

// The polar diagram: the polygon of v_B = v_A + v_BA, then C and M by their images.
template <class T>
void velocities_by_polar_diagram(Ledger<T>& ledger, const SliderCrankInstant& instant,
                                 const geometry::SliderCrank<T>& at) {
  ledger.route("polar diagram");
  const T alpha_2 = geometry::radians<T>(instant.alpha_2);
  const geometry::SliderCrankMotion<T> motion = geometry::slider_crank_motion(at, instant.omega_2<T>(), alpha_2);
  const geometry::Vector<T> v_A = motion.velocity.first.known;
  const geometry::Vector<T> v_CA = motion.relative_velocity(at.C - at.A),
                            v_MA = motion.relative_velocity(at.M - at.A);
  ledger.put_length(velocity("A"), v_A);
  ledger.put(angular_velocity(3), motion.coupler.omega);
  ledger.put(velocity("B"), motion.v_B());
  ledger.put(velocity("C"), v_A + v_CA);
  ledger.put(velocity("M"), v_A + v_MA);
  ledger.put_length(velocity("BA"), motion.velocity.first.closing);
  ledger.put_length(velocity("CA"), v_CA);
  ledger.put_length(velocity("MA"), v_MA);
}

inline Quantity coupler_angle() {
  return {
      "coupler_angle", "$θ_{3}$", "rad", {"direction of AB from the guide", "direzione di AB rispetto alla guida"}};
}

// Points of the drawing, and the coupler's direction from the guide, which is level.
template <class T>
void points_by_construction(Ledger<T>& ledger, const geometry::SliderCrank<T>& at) {
  ledger.draws_point("A0", at.A0);
  ledger.put(point("A"), at.A);
  ledger.put(point("B"), at.B);
  ledger.put(point("C"), at.C);
  ledger.put(point("M"), at.M);
  ledger.put(coupler_angle(), [&] { return slope_angle(at.B - at.A); });
}

template <class T>
DrivenCrank<T> driven_crank(const SliderCrankInstant& instant) {
  return {instant.crank, instant.n, instant.omega_2<T>()};
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  ledger.route("analytic");
  write_crank(ledger, driven_crank<T>(instant));
  ledger.put(point("A"), geometry::Point<T>{p.A.re, p.A.im});
  ledger.put(point("B"), geometry::Point<T>{p.B.re, p.B.im});
  ledger.put(point("C"), geometry::Point<T>{p.C.re, p.C.im});
  ledger.put(point("M"), geometry::Point<T>{p.M.re, p.M.im});
  ledger.put(coupler_angle(), [&] { return slope_by_its_half(p.eta); });
  write_pole<T>(ledger, "P0", geometry::analytic::coupler(p, found.motion),
                {{"A", p.A}, {"B", p.B}, {"C", p.C}, {"M", p.M}}, pole_at_infinity);
  ledger.put(velocity("A").length(), [&] { return size(plane(m.v_A)); });
  ledger.put(angular_velocity(3), m.omega_3);
  ledger.put(velocity("B"), plane(m.v_B));
  ledger.put(velocity("C"), plane(m.v_C));
  ledger.put(velocity("M"), plane(m.v_M));
  ledger.put(velocity("BA").length(), [&] { return size(plane(m.v_B - m.v_A)); });
  ledger.put(velocity("CA").length(), [&] { return size(plane(m.v_C - m.v_A)); });
  ledger.put(velocity("MA").length(), [&] { return size(plane(m.v_M - m.v_A)); });
}

struct VelocityRoutes {
  SliderCrankInstant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    write_crank(ledger, driven_crank<T>(instant), instant.crank_pin<T>());
    construct_level(ledger, instant);
    const geometry::SliderCrank<T> at = instant.level_position<T>();
    points_by_construction(ledger, at);
    tell_crank_limits(ledger, instant);
    write_pole<T>(ledger, "P0", at.pole(), {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}}, pole_at_infinity);
    velocities_by_poles(ledger, instant, at);
    velocities_by_polar_diagram(ledger, instant, at);
    ledger.usual_axes();
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::slider_crank_velocity
