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
  ledger.put("v_A", [&] { return size(coupler.velocity(at.A)); });
  ledger.put("omega_3", coupler.omega());
  ledger.vector("v_B", v_B);
  ledger.vector("v_C", v_C);
  ledger.vector("v_M", v_M);
  ledger.put("v_BA", [&] { return size(v_B - v_A); });
  ledger.put("v_CA", [&] { return size(v_C - v_A); });
  ledger.put("v_MA", [&] { return size(v_M - v_A); });
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
  ledger.put("v_A", [&] { return size(v_A); });
  ledger.put("omega_3", motion.coupler.omega);
  ledger.vector("v_B", motion.v_B());
  ledger.vector("v_C", v_A + v_CA);
  ledger.vector("v_M", v_A + v_MA);
  ledger.put("v_BA", [&] { return size(motion.velocity.first.closing); });
  ledger.put("v_CA", [&] { return size(v_CA); });
  ledger.put("v_MA", [&] { return size(v_MA); });
}

// Points of the drawing, and the coupler's direction from the guide, which is level.
template <class T>
void points_by_construction(Ledger<T>& ledger, const geometry::SliderCrank<T>& at) {
  ledger.point("A", at.A);
  ledger.point("B", at.B);
  ledger.point("C", at.C);
  ledger.point("M", at.M);
  ledger.put("coupler_angle", [&] { return slope_angle(at.B - at.A); });
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
  ledger.put("A_x", p.A.re);
  ledger.put("A_y", p.A.im);
  ledger.put("B_x", p.B.re);
  ledger.put("B_y", p.B.im);
  ledger.put("C_x", p.C.re);
  ledger.put("C_y", p.C.im);
  ledger.put("M_x", p.M.re);
  ledger.put("M_y", p.M.im);
  ledger.put("coupler_angle", [&] { return slope_angle(plane(p.eta)); });
  write_pole<T>(ledger, "P0", geometry::analytic::coupler(p, found.motion),
                {{"A", p.A}, {"B", p.B}, {"C", p.C}, {"M", p.M}}, pole_at_infinity);
  ledger.put("v_A", [&] { return size(plane(m.v_A)); });
  ledger.put("omega_3", m.omega_3);
  ledger.vector("v_B", plane(m.v_B));
  ledger.vector("v_C", plane(m.v_C));
  ledger.vector("v_M", plane(m.v_M));
  ledger.put("v_BA", [&] { return size(plane(m.v_B - m.v_A)); });
  ledger.put("v_CA", [&] { return size(plane(m.v_C - m.v_A)); });
  ledger.put("v_MA", [&] { return size(plane(m.v_M - m.v_A)); });
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
    write_pole<T>(ledger, "P0", at.pole(), {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}}, pole_at_infinity);
    velocities_by_poles(ledger, instant, at);
    velocities_by_polar_diagram(ledger, instant, at);
    ledger.usual_axes();
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::slider_crank_velocity
