// Rivals' theorem three times: by the polygons of the polar diagram, by the method of poles, by analysis.
#pragma once

#include "exercises/kit/linkages/slider_crank_routes.h"

namespace epure::rivals_polygons {

// G is the corner of a coupler plate that is flat: AC = |AG|, BC = |l - AG|.
struct Instant {
  SliderCrankInstant crank;
  Rational AG;  // from A towards B; negative: beyond A

  // Throws BadGivens, in one sentence with the values, as require_drivable.
  explicit Instant(const Givens& givens)
      : crank{.lengths = {givens["r"], givens["l"], CGAL::abs(givens["AG"]), CGAL::abs(givens["l"] - givens["AG"])},
              .n = givens.angle("n"),
              .crank = givens.angle("phi"),
              .alpha_2 = givens.angle("alpha_2")},
        AG(givens["AG"]) {
    require_drivable(crank);
  }
  bool crank_speeds_up() const { return !is_zero(crank.alpha_2); }
};

inline Quantity a_B_as_printed() {
  return {"a_B_as_printed",
          "$a^{(1)}_{B}$",
          "m/s^2",
          {"what the source's equation (1) makes of B's: with a_A besides its two parts",
           "quella di B secondo la (1) della fonte: con a_A oltre alle sue due parti"}};
}

// The polygons of B, of the dyad RRP; and what they make of G.
template <class T>
struct Polygons {
  geometry::SliderCrank<T> at;
  geometry::SliderCrankMotion<T> of_B;  // v_A + v_BA = v_B, a_A + a_BA^n + a_BA^t = a_B
  geometry::Vector<T> a_A_n, a_A_t;

  geometry::Vector<T> AG() const { return at.C - at.A; }
  geometry::Vector<T> v_GA() const { return of_B.relative_velocity(AG()); }
  geometry::Vector<T> a_GA_n() const { return -(geometry::square(of_B.coupler.omega) * AG()); }
  geometry::Vector<T> a_GA_t() const { return of_B.coupler.alpha * geometry::quarter_turn(AG()); }

  // a_B of equation (1) as it is printed, with a_A besides a_A^n + a_A^t: the polygon drawn from a_A twice.
  geometry::Vector<T> a_B_as_printed() const {
    const geometry::Vector<T> along = at.guide.direction(), a_A = a_A_n + a_A_t;
    const geometry::Vector<T> known = a_A + a_A + of_B.acceleration.first.normal;
    return geometry::close_polygon(known, geometry::quarter_turn(at.B - at.A), along).of_second * along;
  }
};

template <class T>
Polygons<T> polygons(const geometry::SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const geometry::Vector<T> A0A = at.A - at.A0;
  return {at, geometry::slider_crank_motion(at, omega_2, alpha_2), -(geometry::square(omega_2) * A0A),
          alpha_2 * geometry::quarter_turn(A0A)};
}

template <class T>
void by_polar_diagram(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("polar diagram");
  for (const auto& [name, P] :
       {std::pair{"A0", found.at.A0}, {"A", found.at.A}, {"B", found.at.B}, {"G", found.at.C}})
    ledger.draws_point(name, P);
  ledger.put(angular_velocity(2), found.of_B.crank.omega);
  ledger.put_length(velocity("A"), found.of_B.velocity.first.known);
  ledger.put_length(velocity("BA"), found.of_B.velocity.first.closing);
  ledger.put(velocity("B").x(), found.of_B.v_B().x);
  ledger.put_length(velocity("B"), found.of_B.v_B());
  ledger.put(angular_velocity(3), found.of_B.coupler.omega);
  ledger.put_length(velocity("GA"), found.v_GA());
  ledger.put(velocity("G"), found.of_B.velocity.first.known + found.v_GA());
  ledger.put_length(normal_acceleration("A"), found.a_A_n);
  ledger.put_length(tangential_acceleration("A"), found.a_A_t);
  ledger.put_length(acceleration("A"), found.a_A_n + found.a_A_t);
  ledger.put_length(normal_acceleration("BA"), found.of_B.acceleration.first.normal);
  ledger.put_length(tangential_acceleration("BA"), found.of_B.acceleration.first.closing);
  ledger.put(acceleration("B").x(), found.of_B.a_B().x);
  ledger.put_length(acceleration("B"), found.of_B.a_B());
  ledger.put(angular_acceleration(3), found.of_B.coupler.alpha);
  ledger.put_length(normal_acceleration("GA"), found.a_GA_n());
  ledger.put_length(tangential_acceleration("GA"), found.a_GA_t());
  ledger.put(acceleration("G"), found.a_A_n + found.a_A_t + found.a_GA_n() + found.a_GA_t());
  ledger.put(a_B_as_printed(), [&] { return size(found.a_B_as_printed()); });
}

// ω₃ from v_A and P₀A; every velocity square to its ray from P₀, which may be at infinity.
template <class T>
void velocities_by_poles(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("poles");
  const geometry::SliderCrank<T>& at = found.at;
  const geometry::Vector<T> v_A = found.of_B.crank.velocity(at.A);
  const geometry::RotationAboutPole<T> coupler(at.pole(), at.A, v_A);
  const geometry::Vector<T> v_B = coupler.velocity(at.B), v_G = coupler.velocity(at.C);
  ledger.put(velocity("A").length(), [&] { return size(coupler.velocity(at.A)); });
  ledger.put(velocity("BA").length(), [&] { return size(v_B - v_A); });
  ledger.put(velocity("B").x(), v_B.x);
  ledger.put(velocity("B").length(), [&] { return size(v_B); });
  ledger.put(angular_velocity(3), coupler.omega());
  ledger.put(velocity("GA").length(), [&] { return size(v_G - v_A); });
  ledger.put(velocity("G"), v_G);
}

// By Euler and Savary, for a finite pole.
template <class T>
void accelerations_by_poles(Ledger<T>& ledger, const Polygons<T>& found) {
  ledger.route("poles");
  const geometry::SliderCrank<T>& at = found.at;
  const geometry::PlaneMotion<T>& crank = found.of_B.crank;
  const geometry::PlaneMotion<T> coupler = geometry::motion_by_poles(at, crank.omega, crank.alpha);
  const geometry::Vector<T> AB = at.B - at.A, a_A = coupler.acceleration(at.A), a_B = coupler.acceleration(at.B),
                            a_G = coupler.acceleration(at.C);
  // What of an acceleration relative to A is along AB or across it.
  const auto part = [&](const geometry::Vector<T>& a, const geometry::Vector<T>& u) {
    return size(geometry::quotient(geometry::dot(a - a_A, u), geometry::length_squared(u)) * u);
  };
  const geometry::Vector<T> across = geometry::quarter_turn(AB);
  ledger.put(acceleration("A").length(), [&] { return size(a_A); });
  ledger.put(normal_acceleration("BA").length(), [&] { return part(a_B, AB); });
  ledger.put(tangential_acceleration("BA").length(), [&] { return part(a_B, across); });
  ledger.put(acceleration("B").x(), a_B.x);
  ledger.put(acceleration("B").length(), [&] { return size(a_B); });
  ledger.put(angular_acceleration(3), coupler.alpha);
  ledger.put(normal_acceleration("GA").length(), [&] { return part(a_G, AB); });
  ledger.put(tangential_acceleration("GA").length(), [&] { return part(a_G, across); });
  ledger.put(acceleration("G"), a_G);
}

// The closure equation differentiated. The imaginary part of the printed equation, which must vanish because B stays
// on the guide, gives its α₃; the real part its a_B.
template <class T>
T printed_a_B(const AnalyticSliderCrank<T>& found, const T& l) {
  const auto& [p, m] = found;
  const T normal = l * geometry::square(m.omega_3);
  const T alpha_3 = geometry::quotient(normal * p.eta.im - T(2) * m.a_A.im, l * p.eta.re);
  return T(2) * m.a_A.re - normal * p.eta.re - l * alpha_3 * p.eta.im;
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Instant& instant) {
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant.crank);
  const auto& m = found.motion;
  const T r = geometry::from_rational<T>(instant.crank.lengths.r),
          l = geometry::from_rational<T>(instant.crank.lengths.l);
  const T AG = geometry::from_rational<T>(instant.AG), omega_2 = instant.crank.omega_2<T>();
  const T alpha_2 = geometry::radians<T>(instant.crank.alpha_2), omega_3_squared = geometry::square(m.omega_3);
  ledger.route("analytic");
  ledger.put(angular_velocity(2), [&] {  // v_A = i ω₂ A
    return geometry::quotient(geometry::analytic::cross(found.position.A, m.v_A),
                              geometry::analytic::squared_modulus(found.position.A));
  });
  ledger.put(velocity("A").length(), [&] { return magnitude_of(r * omega_2); });
  ledger.put(velocity("BA").length(), [&] { return magnitude_of(l * m.omega_3); });
  ledger.put(velocity("B").x(), m.v_B.re);
  ledger.put(velocity("B").length(), [&] { return magnitude_of(m.v_B.re); });
  ledger.put(angular_velocity(3), m.omega_3);
  ledger.put(velocity("GA").length(), [&] { return magnitude_of(AG * m.omega_3); });
  ledger.put(velocity("G"), plane(m.v_C));
  ledger.put(normal_acceleration("A").length(), [&] { return magnitude_of(r * geometry::square(omega_2)); });
  ledger.put(tangential_acceleration("A").length(), [&] { return magnitude_of(r * alpha_2); });
  ledger.put(acceleration("A").length(), [&] { return size(plane(m.a_A)); });
  ledger.put(normal_acceleration("BA").length(), [&] { return magnitude_of(l * omega_3_squared); });
  ledger.put(tangential_acceleration("BA").length(), [&] { return magnitude_of(l * m.alpha_3); });
  ledger.put(acceleration("B").x(), m.a_B.re);
  ledger.put(acceleration("B").length(), [&] { return magnitude_of(m.a_B.re); });
  ledger.put(angular_acceleration(3), m.alpha_3);
  ledger.put(normal_acceleration("GA").length(), [&] { return magnitude_of(AG * omega_3_squared); });
  ledger.put(tangential_acceleration("GA").length(), [&] { return magnitude_of(AG * m.alpha_3); });
  ledger.put(acceleration("G"), plane(m.a_C));
  ledger.put(a_B_as_printed(), [&] { return magnitude_of(printed_a_B(found, l)); });
}

struct Routes {
  Instant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("polar diagram");
    const Polygons<T> found = polygons(instant.crank.position<T>(), instant.crank.omega_2<T>(),
                                       geometry::radians<T>(instant.crank.alpha_2));
    by_polar_diagram(ledger, found);
    velocities_by_poles(ledger, found);
    if (!instant.crank.pole_at_infinity) accelerations_by_poles(ledger, found);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::rivals_polygons
