// The slider-crank's velocities found four times: constructed points, method of poles, polar diagram, analysis.
#pragma once

#include "exercises/kit/slider_crank_routes.h"

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
  ledger.put("v_B_x", v_B.x);
  ledger.put("v_B", [&] { return size(v_B); });
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
  const geometry::VelocityDiagram<T> diagram = geometry::velocity_diagram(at, instant.omega_2<T>());
  const geometry::Vector<T> v_CA = diagram.relative(at.C - at.A), v_MA = diagram.relative(at.M - at.A);
  ledger.put("v_A", [&] { return size(diagram.v_A); });
  ledger.put("omega_3", diagram.omega_3);
  ledger.put("v_B_x", diagram.v_B.x);
  ledger.put("v_B", [&] { return size(diagram.v_B); });
  ledger.vector("v_C", diagram.v_A + v_CA);
  ledger.vector("v_M", diagram.v_A + v_MA);
  ledger.put("v_BA", [&] { return size(diagram.v_BA); });
  ledger.put("v_CA", [&] { return size(v_CA); });
  ledger.put("v_MA", [&] { return size(v_MA); });
}

// Points of the drawing, and the coupler's direction.
template <class T>
void points_by_construction(Ledger<T>& ledger, const geometry::SliderCrank<T>& at) {
  ledger.point("A", at.A);
  ledger.point("B", at.B);
  ledger.point("C", at.C);
  ledger.point("M", at.M);
  ledger.put("coupler_angle", [&] { return slope_angle(at.B - at.A); });
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  ledger.route("analytic");
  write_crank(ledger, instant);
  ledger.put("A_x", p.A.re);
  ledger.put("A_y", p.A.im);
  ledger.put("B_x", p.B.re);
  ledger.put("B_y", p.B.im);
  ledger.put("C_x", p.C.re);
  ledger.put("C_y", p.C.im);
  ledger.put("M_x", p.M.re);
  ledger.put("M_y", p.M.im);
  ledger.put("coupler_angle", [&] { return slope_angle(geometry::Vector<T>{p.cos_theta, p.sin_theta}); });
  write_pole(ledger, found);
  ledger.put("v_A", [&] { return size(plane(m.v_A)); });
  ledger.put("omega_3", m.omega_3);
  ledger.put("v_B_x", m.v_B.re);
  ledger.put("v_B", [&] { return size(plane(m.v_B)); });
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
    const geometry::SliderCrank<T> at = instant.position<T>();
    write_crank(ledger, instant, at);
    points_by_construction(ledger, at);
    write_pole(ledger, at);
    velocities_by_poles(ledger, instant, at);
    velocities_by_polar_diagram(ledger, instant, at);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::slider_crank_velocity
