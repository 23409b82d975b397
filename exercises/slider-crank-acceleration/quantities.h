// The slider-crank's accelerations, circles and centres of curvature, found by polar diagram, by poles and by
// analysis.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/linkages/slider_crank_routes.h"

namespace epure::slider_crank_acceleration {

// All that follows from the coupler's motion, whoever found it, and from the inflection pole J.
template <class T>
void second_order(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion, const geometry::Vector<T>& a_B,
                  const geometry::ProjectivePoint<T>& J, const geometry::SliderCrank<T>& at) {
  const auto a = [&](const geometry::Point<T>& X) { return motion.acceleration(X); };
  const geometry::Vector<T> a_A = motion.a_A, AB = at.B - at.A;
  ledger.put("a_A", [&] { return size(a_A); });
  ledger.put("alpha_3", motion.alpha);
  ledger.vector("a_B", a_B);
  ledger.vector("a_C", a(at.C));
  ledger.vector("a_M", a(at.M));
  ledger.put("a_BA_n", [&] { return size(geometry::square(motion.omega) * AB); });
  ledger.put("a_BA_t", [&] { return size(motion.alpha * AB); });
  ledger.put("a_BA", [&] { return size(a_B - a_A); });
  ledger.put("a_CA", [&] { return size(a(at.C) - a_A); });
  ledger.put("a_MA", [&] { return size(a(at.M) - a_A); });
  ledger.put("gamma", [&] { return slope_angle(geometry::Vector<T>{geometry::square(motion.omega), motion.alpha}); });

  write_acceleration_pole(ledger, motion, {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}});
  write_circles(ledger, motion, J);
  write_curvature(ledger, motion, {"C", at.C});
  write_curvature(ledger, motion, {"M", at.M});
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant);

struct AccelerationRoutes {
  SliderCrankInstant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    construct_level(ledger, instant);
    const geometry::SliderCrank<T> at = instant.level_position<T>();
    write_pole<T>(ledger, "P0", at.pole(), {{"C", at.C}, {"M", at.M}}, pole_at_infinity);
    const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
    ledger.route("polar diagram");
    const geometry::SliderCrankMotion<T> found = geometry::slider_crank_motion(at, omega_2, alpha_2);
    second_order(ledger, found.coupler, found.a_B(), found.coupler.inflection_pole(), at);
    if (!instant.pole_at_infinity) {
      ledger.route("poles");
      const geometry::PlaneMotion<T> coupler = geometry::motion_by_poles(at, omega_2, alpha_2);
      second_order(ledger, coupler, coupler.acceleration(at.B),
                   geometry::inflection_pole_by_poles(at, geometry::finite(at.pole())), at);
    }
    ledger.usual_axes();
    by_analysis(ledger, instant);
    return ledger;
  }
};

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  const auto coupler = geometry::analytic::coupler(p, m);
  ledger.route("analytic");
  write_pole<T>(ledger, "P0", coupler, {{"C", p.C}, {"M", p.M}}, pole_at_infinity);
  ledger.put("a_A", [&] { return size(plane(m.a_A)); });
  ledger.put("alpha_3", m.alpha_3);
  ledger.vector("a_B", plane(m.a_B));
  ledger.vector("a_C", plane(m.a_C));
  ledger.vector("a_M", plane(m.a_M));
  const geometry::Vector<T> AB = plane(p.B - p.A);
  ledger.put("a_BA_n", [&] { return size(geometry::square(m.omega_3) * AB); });
  ledger.put("a_BA_t", [&] { return size(m.alpha_3 * AB); });
  ledger.put("a_BA", [&] { return size(plane(m.a_B - m.a_A)); });
  ledger.put("a_CA", [&] { return size(plane(m.a_C - m.a_A)); });
  ledger.put("a_MA", [&] { return size(plane(m.a_M - m.a_A)); });
  ledger.put("gamma", [&] { return slope_angle(geometry::Vector<T>{geometry::square(m.omega_3), m.alpha_3}); });
  write_acceleration_pole<T>(ledger, coupler, {{"A", p.A}, {"B", p.B}, {"C", p.C}, {"M", p.M}});
  write_circles(ledger, coupler);
  write_curvature<T>(ledger, coupler, {"C", p.C});
  write_curvature<T>(ledger, coupler, {"M", p.M});
}

}  // namespace epure::slider_crank_acceleration
