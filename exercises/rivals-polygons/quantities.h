// Rivals' theorem three times: by the polygons of the polar diagram, by the method of poles, by analysis.
#pragma once

#include "exercises/kit/linkages/slider_crank_routes.h"
#include "exercises/rivals-polygons/exercise.h"
#include "geometry/mechanisms/dyad.h"
#include "geometry/motion/euler_savary.h"

namespace epure::rivals_polygons {

// The dyad RRP: the coupler is a bar on the crank's pin A, its joint B slides on the fixed guide.
template <class T>
struct Polygons {
  geometry::SliderCrank<T> at;
  geometry::PlaneMotion<T> crank, coupler;
  geometry::DyadVelocity<T> velocity;          // v_A + v_BA = v_B
  geometry::DyadAcceleration<T> acceleration;  // a_A + a_BA^n + a_BA^t = a_B
  geometry::Vector<T> a_A_n, a_A_t;

  geometry::Vector<T> AG() const { return at.C - at.A; }
  geometry::Vector<T> v_GA() const { return coupler.omega * geometry::quarter_turn(AG()); }
  geometry::Vector<T> a_GA_n() const { return -(geometry::square(coupler.omega) * AG()); }
  geometry::Vector<T> a_GA_t() const { return coupler.alpha * geometry::quarter_turn(AG()); }
  geometry::Vector<T> v_G() const { return velocity.first.known + v_GA(); }
  geometry::Vector<T> a_G() const { return a_A_n + a_A_t + a_GA_n() + a_GA_t(); }

  // a_B of equation (1) as it is printed, with a_A besides a_A^n + a_A^t: the polygon drawn from a_A twice.
  geometry::Vector<T> a_B_as_printed() const {
    const geometry::Vector<T> along = at.guide.direction(), a_A = a_A_n + a_A_t;
    const geometry::Vector<T> known = a_A + a_A + acceleration.first.normal;
    return geometry::close_polygon(known, geometry::quarter_turn(at.B - at.A), along).of_second * along;
  }
};

template <class T>
Polygons<T> polygons(const Instant& instant) {
  const geometry::SliderCrank<T> at = instant.crank.position<T>();
  const T omega_2 = instant.crank.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.crank.alpha_2);
  const geometry::PlaneMotion<T> crank = geometry::turning_about(at.A0, omega_2, alpha_2);
  const geometry::PlaneMotion<T> frame = geometry::turning_about(at.A0, T(0), T(0));
  const geometry::Bar<T> coupler{geometry::pin_on(crank, at.A)};
  const geometry::Slide<T> slider{frame, at.guide.direction()};
  const auto v = geometry::dyad_velocity(coupler, slider, at.B);
  const auto a = geometry::dyad_acceleration(coupler, slider, at.B, v);
  const geometry::Vector<T> A0A = at.A - at.A0;
  return {at,
          crank,
          coupler.motion(v.first_rate, a.first_rate),
          v,
          a,
          -(geometry::square(omega_2) * A0A),
          alpha_2 * geometry::quarter_turn(A0A)};
}

template <class T>
void by_polar_diagram(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("polar diagram");
  ledger.put("v_A", [&] { return size(found.velocity.first.known); });
  ledger.put("v_BA", [&] { return size(found.velocity.first.closing); });
  ledger.put("v_B_x", found.velocity.v_X.x);
  ledger.put("v_B", [&] { return size(found.velocity.v_X); });
  ledger.put("omega_3", found.velocity.first_rate);
  ledger.put("v_GA", [&] { return size(found.v_GA()); });
  ledger.vector("v_G", found.v_G());
  ledger.put("a_A_n", [&] { return size(found.a_A_n); });
  ledger.put("a_A_t", [&] { return size(found.a_A_t); });
  ledger.put("a_A", [&] { return size(found.a_A_n + found.a_A_t); });
  ledger.put("a_BA_n", [&] { return size(found.acceleration.first.normal); });
  ledger.put("a_BA_t", [&] { return size(found.acceleration.first.closing); });
  ledger.put("a_B_x", found.acceleration.a_X.x);
  ledger.put("a_B", [&] { return size(found.acceleration.a_X); });
  ledger.put("alpha_3", found.acceleration.first_rate);
  ledger.put("a_GA_n", [&] { return size(found.a_GA_n()); });
  ledger.put("a_GA_t", [&] { return size(found.a_GA_t()); });
  ledger.vector("a_G", found.a_G());
  ledger.put("a_B_as_printed", [&] { return size(found.a_B_as_printed()); });
}

// ω₃ from v_A and P₀A; every velocity square to its ray from P₀, which may be at infinity.
template <class T>
void velocities_by_poles(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("poles");
  const geometry::SliderCrank<T>& at = found.at;
  const geometry::Vector<T> v_A = found.crank.velocity(at.A);
  const geometry::RotationAboutPole<T> coupler(at.pole(), at.A, v_A);
  const geometry::Vector<T> v_B = coupler.velocity(at.B), v_G = coupler.velocity(at.C);
  ledger.put("v_A", [&] { return size(coupler.velocity(at.A)); });
  ledger.put("v_BA", [&] { return size(v_B - v_A); });
  ledger.put("v_B_x", v_B.x);
  ledger.put("v_B", [&] { return size(v_B); });
  ledger.put("omega_3", coupler.omega());
  ledger.put("v_GA", [&] { return size(v_G - v_A); });
  ledger.vector("v_G", v_G);
}

// By Euler and Savary, for a finite pole: A turns about A₀, and the path of B is straight, so B lies on the
// inflection circle itself.
template <class T>
geometry::PlaneMotion<T> coupler_by_poles(const Polygons<T>& found) {
  const geometry::SliderCrank<T>& at = found.at;
  const geometry::Point<T> P0 = geometry::finite(at.pole());
  const geometry::Line<T> ray_of_A = geometry::line(at.A0, at.A);
  const geometry::Line<T> ray_of_B = geometry::perpendicular(at.guide, at.B);
  const auto J =
      geometry::inflection_pole_by_poles(ray_of_A, geometry::euler_savary_point(P0, at.A, at.A0), ray_of_B, at.B);
  return geometry::motion_by_poles(P0, geometry::finite(J), at.A, found.crank.velocity(at.A),
                                   found.crank.acceleration(at.A));
}

template <class T>
void accelerations_by_poles(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("poles");
  const geometry::SliderCrank<T>& at = found.at;
  const geometry::PlaneMotion<T> coupler = coupler_by_poles(found);
  const geometry::Vector<T> AB = at.B - at.A, AG = at.C - at.A, a_B = coupler.acceleration(at.B);
  ledger.put("a_A", [&] { return size(coupler.acceleration(at.A)); });
  ledger.put("a_BA_n", [&] { return size(geometry::square(coupler.omega) * AB); });
  ledger.put("a_BA_t", [&] { return size(coupler.alpha * AB); });
  ledger.put("a_B_x", a_B.x);
  ledger.put("a_B", [&] { return size(a_B); });
  ledger.put("alpha_3", coupler.alpha);
  ledger.put("a_GA_n", [&] { return size(geometry::square(coupler.omega) * AG); });
  ledger.put("a_GA_t", [&] { return size(coupler.alpha * AG); });
  ledger.vector("a_G", coupler.acceleration(at.C));
}

// The closure equation differentiated. The imaginary part of the printed equation, which must vanish because B stays
// on the guide, gives its α₃; the real part its a_B.
template <class T>
T a_B_as_printed(const AnalyticSliderCrank<T>& found, const T& l) {
  const auto& [p, m] = found;
  const T normal = l * geometry::square(m.omega_3);
  const T alpha_3 = geometry::quotient(normal * p.eta.im - T(2) * m.a_A.im, l * p.eta.re);
  return T(2) * m.a_A.re - normal * p.eta.re - l * alpha_3 * p.eta.im;
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Instant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant.crank);
  const auto& m = found.motion;
  const auto magnitude = [](const T& x) { return size(geometry::Vector<T>{x, T(0)}); };
  const T r = geometry::from_rational<T>(instant.crank.lengths.r),
          l = geometry::from_rational<T>(instant.crank.lengths.l);
  const T AG = geometry::from_rational<T>(instant.AG), omega_2 = instant.crank.omega_2<T>();
  const T alpha_2 = geometry::radians<T>(instant.crank.alpha_2), omega_3_squared = geometry::square(m.omega_3);
  ledger.route("analytic");
  ledger.put("v_A", [&] { return magnitude(r * omega_2); });
  ledger.put("v_BA", [&] { return magnitude(l * m.omega_3); });
  ledger.put("v_B_x", m.v_B.re);
  ledger.put("v_B", [&] { return magnitude(m.v_B.re); });
  ledger.put("omega_3", m.omega_3);
  ledger.put("v_GA", [&] { return magnitude(AG * m.omega_3); });
  ledger.vector("v_G", plane(m.v_C));
  ledger.put("a_A_n", [&] { return magnitude(r * geometry::square(omega_2)); });
  ledger.put("a_A_t", [&] { return magnitude(r * alpha_2); });
  ledger.put("a_A", [&] { return size(plane(m.a_A)); });
  ledger.put("a_BA_n", [&] { return magnitude(l * omega_3_squared); });
  ledger.put("a_BA_t", [&] { return magnitude(l * m.alpha_3); });
  ledger.put("a_B_x", m.a_B.re);
  ledger.put("a_B", [&] { return magnitude(m.a_B.re); });
  ledger.put("alpha_3", m.alpha_3);
  ledger.put("a_GA_n", [&] { return magnitude(AG * omega_3_squared); });
  ledger.put("a_GA_t", [&] { return magnitude(AG * m.alpha_3); });
  ledger.vector("a_G", plane(m.a_C));
  ledger.put("a_B_as_printed", [&] { return magnitude(a_B_as_printed(found, l)); });
}

struct Routes {
  Instant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("polar diagram");
    const Polygons<T> found = polygons<T>(instant);
    by_polar_diagram(ledger, found);
    velocities_by_poles(ledger, found);
    if (!instant.crank.pole_at_infinity) accelerations_by_poles(ledger, found);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::rivals_polygons
