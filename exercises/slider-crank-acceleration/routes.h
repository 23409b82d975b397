// The slider-crank's accelerations, circles and centres of curvature, found by polar diagram, by poles and by
// analysis.
#pragma once

#include "exercises/kit/linkages/slider_crank_routes.h"

namespace epure::slider_crank_acceleration {

// What every construction writes: the vectors it found, and what follows from the coupler's motion and from the
// inflection pole J.
template <class T>
struct Found {
  geometry::PlaneMotion<T> coupler;
  geometry::ProjectivePoint<T> J;
  geometry::Vector<T> a_A_n, a_A_t, a_B, a_BA_n, a_BA_t, a_CA, a_MA;
  geometry::Vector<T> gamma;  // in the direction of γ from the x axis

  void write(Ledger<T>& ledger, const geometry::SliderCrank<T>& at) const {
    const geometry::Vector<T> a_A = a_A_n + a_A_t;
    ledger.put_length(acceleration("A"), a_A);
    ledger.draws_vector("a_A_n", a_A_n);
    ledger.draws_vector("a_A_t", a_A_t);
    ledger.tells(angular_velocity(3), [&] { return coupler.omega; });
    ledger.put(angular_acceleration(3), coupler.alpha);
    ledger.put(acceleration("B"), a_B);
    ledger.put(acceleration("C"), a_A + a_CA);
    ledger.put(acceleration("M"), a_A + a_MA);
    ledger.put_length(normal_acceleration("BA"), a_BA_n);
    ledger.put_length(tangential_acceleration("BA"), a_BA_t);
    ledger.put_length(acceleration("BA"), a_B - a_A);
    ledger.put_length(acceleration("CA"), a_CA);
    ledger.put_length(acceleration("MA"), a_MA);
    ledger.put(inclination(), [&] { return slope_angle(gamma); });
    ledger.tells(inclination_in_degrees(), [&] { return in_degrees(slope_angle(gamma)); });
    write_acceleration_pole(ledger, coupler, {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}});
    write_circles(ledger, coupler, J);
    write_curvature(ledger, coupler, {"C", at.C});
    write_curvature(ledger, coupler, {"M", at.M});
  }
};

// The polygon's own sides; γ stands between a_BA and its normal part.
template <class T>
Found<T> by_polar_diagram(const geometry::SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const geometry::SliderCrankMotion<T> found = geometry::slider_crank_motion(at, omega_2, alpha_2);
  const auto& sides = found.acceleration.first;
  const geometry::Vector<T> A0A = at.A - at.A0, BA = at.A - at.B;
  return {.coupler = found.coupler,
          .J = found.coupler.inflection_pole(),
          .a_A_n = -(geometry::square(omega_2) * A0A),
          .a_A_t = alpha_2 * geometry::quarter_turn(A0A),
          .a_B = found.a_B(),
          .a_BA_n = sides.normal,
          .a_BA_t = sides.closing,
          .a_CA = found.relative_acceleration(at.C - at.A),
          .a_MA = found.relative_acceleration(at.M - at.A),
          .gamma = {geometry::dot(sides.normal, BA), geometry::dot(sides.closing, -geometry::quarter_turn(BA))}};
}

// For a finite pole: a_BA resolved along and across AB; γ measured at A, from its acceleration to its ray from K.
template <class T>
Found<T> by_poles(const geometry::SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const geometry::PlaneMotion<T> coupler = geometry::motion_by_poles(at, omega_2, alpha_2);
  const auto a = [&](const geometry::Point<T>& X) { return coupler.acceleration(X); };
  const auto along = [](const geometry::Vector<T>& v, const geometry::Vector<T>& u) {
    return geometry::quotient(geometry::dot(v, u), geometry::length_squared(u)) * u;
  };
  const geometry::Vector<T> A0A = at.A - at.A0, AB = at.B - at.A, a_A = a(at.A), a_BA = a(at.B) - a_A;
  const geometry::ProjectivePoint<T> K = coupler.acceleration_pole();
  const geometry::Vector<T> ray{K.x - K.w * at.A.x, K.y - K.w * at.A.y};
  return {.coupler = coupler,
          .J = geometry::inflection_pole_by_poles(at, geometry::finite(at.pole())),
          .a_A_n = along(a_A, A0A),
          .a_A_t = along(a_A, geometry::quarter_turn(A0A)),
          .a_B = a(at.B),
          .a_BA_n = along(a_BA, AB),
          .a_BA_t = along(a_BA, geometry::quarter_turn(AB)),
          .a_CA = a(at.C) - a_A,
          .a_MA = a(at.M) - a_A,
          .gamma = {geometry::dot(a_A, ray), geometry::cross(a_A, ray)}};
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  const auto coupler = geometry::analytic::coupler(p, m);
  const auto put_length = [&](const VectorQuantity& of, const geometry::analytic::Complex<T>& z) {
    ledger.put(of.length(), [&] { return size(plane(z)); });
  };
  const T omega_3_squared = geometry::square(m.omega_3);
  const geometry::analytic::Complex<T> inclined{omega_3_squared, m.alpha_3};
  ledger.route("analytic");
  write_pole<T>(ledger, "P0", coupler, {{"C", p.C}, {"M", p.M}}, pole_at_infinity);
  put_length(acceleration("A"), m.a_A);
  ledger.put(angular_acceleration(3), m.alpha_3);
  ledger.put(acceleration("B"), plane(m.a_B));
  ledger.put(acceleration("C"), plane(m.a_C));
  ledger.put(acceleration("M"), plane(m.a_M));
  put_length(normal_acceleration("BA"), omega_3_squared * (p.B - p.A));
  put_length(tangential_acceleration("BA"), m.alpha_3 * (p.B - p.A));
  put_length(acceleration("BA"), m.a_B - m.a_A);
  put_length(acceleration("CA"), m.a_C - m.a_A);
  put_length(acceleration("MA"), m.a_M - m.a_A);
  ledger.put(inclination(), [&] { return slope_by_its_half(inclined); });
  write_acceleration_pole<T>(ledger, coupler, {{"A", p.A}, {"B", p.B}, {"C", p.C}, {"M", p.M}});
  write_circles(ledger, coupler);
  write_curvature<T>(ledger, coupler, {"C", p.C});
  write_curvature<T>(ledger, coupler, {"M", p.M});
}

struct AccelerationRoutes {
  SliderCrankInstant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    construct_level(ledger, instant);
    const geometry::SliderCrank<T> at = instant.level_position<T>();
    for (const auto& [name, P] : {std::pair{"A0", at.A0}, {"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}})
      ledger.draws_point(name, P);
    write_pole<T>(ledger, "P0", at.pole(), {{"C", at.C}, {"M", at.M}}, pole_at_infinity);
    const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
    ledger.route("polar diagram");
    const Found<T> found = by_polar_diagram(at, omega_2, alpha_2);
    found.write(ledger, at);
    draws_builder<T>(ledger, at.pole(), {"A", at.A}, at.A0);
    draws_builder(ledger, found.coupler);
    if (!instant.pole_at_infinity) {
      ledger.route("poles");
      by_poles(at, omega_2, alpha_2).write(ledger, at);
    }
    ledger.usual_axes();
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::slider_crank_acceleration
