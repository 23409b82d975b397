// The bar on its carrier three times: by the polygons of Rivals' theorem, by poles, by complex numbers.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/velocity-centre/exercise.h"
#include "geometry/mechanisms/dyad.h"

namespace epure::velocity_centre {

// Why there is none, when there is none.
inline Phrase no_velocity_centre(const Instant& instant) {
  return instant.V == 0 ? Phrase{"the bar rests: no point of it is the velocity centre more than another",
                                 "l'asta è in quiete: nessun suo punto è centro delle velocità più di un altro"}
                        : Phrase{"the velocity centre is at infinity: the bar translates, ω is zero",
                                 "il centro delle velocità è all'infinito: l'asta trasla, ω è zero"};
}
inline Phrase no_acceleration_centre(const Instant& instant) {
  return instant.a == 0 ? Phrase{"no point is accelerated: none is the acceleration centre more than another",
                                 "nessun punto è accelerato: nessuno è centro delle accelerazioni più di un altro"}
                        : Phrase{"the acceleration centre is at infinity: ω and dω/dt are zero",
                                 "il centro delle accelerazioni è all'infinito: ω e dω/dt sono zero"};
}
inline constexpr Phrase upright_normal{"the normal to v_A has no slope: v_A is horizontal, or zero",
                                       "la normale a v_A non ha pendenza: v_A è orizzontale, o zero"};

// The bar as a moving plane. O is the origin.
template <class T>
struct MovingBar {
  geometry::Point<T> O, A;
  geometry::PlaneMotion<T> motion;

  geometry::Vector<T> OA() const { return A - O; }
  geometry::Vector<T> v_O() const { return motion.v_A; }
  geometry::Vector<T> a_O() const { return motion.a_A; }
  geometry::Vector<T> v_AO() const { return motion.omega * geometry::quarter_turn(OA()); }
  geometry::Vector<T> a_AO_n() const { return -(geometry::square(motion.omega) * OA()); }
  geometry::Vector<T> a_AO_t() const { return motion.alpha * geometry::quarter_turn(OA()); }
  geometry::Vector<T> v_A() const { return v_O() + v_AO(); }
  geometry::Vector<T> a_A() const { return a_O() + a_AO_n() + a_AO_t(); }
};

template <class T>
MovingBar<T> moving_bar(const Instant& instant) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const geometry::Point<T> O{T(0), T(0)};
  const geometry::Vector<T> along_bar{geometry::cosine<T>(instant.angle), geometry::sine<T>(instant.angle)};
  return {O,
          O + number(instant.L) * along_bar,
          {O,
           {number(instant.V), T(0)},
           {number(instant.a), T(0)},
           geometry::radians<T>(instant.omega),
           geometry::radians<T>(instant.omega_dot)}};
}

template <class T>
void by_polar_diagram(Ledger<T>& ledger, const MovingBar<T>& bar, const Instant& instant) {
  ledger.route("polar diagram");
  ledger.put("v_O", [&] { return size(bar.v_O()); });
  ledger.put("v_AO", [&] { return size(bar.v_AO()); });
  ledger.vector("v_A", bar.v_A());
  ledger.put("a_O", [&] { return size(bar.a_O()); });
  ledger.put("a_AO_n", [&] { return size(bar.a_AO_n()); });
  ledger.put("a_AO_t", [&] { return size(bar.a_AO_t()); });
  ledger.vector("a_A", bar.a_A());
  write_acceleration_pole<T>(ledger, bar.motion, {{"O", bar.O}, {"A", bar.A}}, no_acceleration_centre(instant));
}

// The velocity centre by drawing, whichever way this instant allows.
template <class T>
geometry::ProjectivePoint<T> drawn_centre(const MovingBar<T>& bar, Centre found) {
  const auto normal = [](const geometry::Point<T>& X, const geometry::Vector<T>& v) {
    return geometry::line(X, geometry::quarter_turn(v));
  };
  switch (found) {
    case Centre::by_the_tips:
      return geometry::meet(geometry::line(bar.O, bar.A), geometry::line(bar.O + bar.v_O(), bar.A + bar.v_A()));
    case Centre::is_O:
      return geometry::projective(bar.O);
    default:
      return geometry::meet(normal(bar.O, bar.v_O()), normal(bar.A, bar.v_A()));
  }
}

// v_A from its distance to the centre, where there is one.
template <class T>
void by_poles(Ledger<T>& ledger, const MovingBar<T>& bar, const Instant& instant) {
  ledger.route("poles");
  const geometry::ProjectivePoint<T> P0 = drawn_centre(bar, centre_of(instant));
  write_pole<T>(ledger, "P0", P0, {{"O", bar.O}, {"A", bar.A}}, no_velocity_centre(instant));
  const geometry::Vector<T> v_A = bar.v_A();
  ledger.put("normal_slope", [&] { return ledger.ratio(-v_A.x, v_A.y, upright_normal); });
  if (instant.turns()) {
    ledger.vector("v_A", bar.motion.omega * geometry::quarter_turn(bar.A - geometry::finite(P0)));
  }
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Instant& instant) {
  using geometry::analytic::Complex;
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T L = number(instant.L);
  const Complex<T> O{T(0), T(0)},
      A = L * Complex<T>{geometry::cosine<T>(instant.angle), geometry::sine<T>(instant.angle)};
  const geometry::analytic::PlaneMotion<T> bar{O,
                                               {number(instant.V), T(0)},
                                               {number(instant.a), T(0)},
                                               geometry::radians<T>(instant.omega),
                                               geometry::radians<T>(instant.omega_dot)};
  const Complex<T> v_A = bar.velocity(A), a_A = bar.acceleration(A);
  const auto magnitude = [](const T& x) { return size(geometry::Vector<T>{x, T(0)}); };
  ledger.route("analytic");
  ledger.put("A_x", A.re);
  ledger.put("A_y", A.im);
  ledger.put("v_O", [&] { return magnitude(bar.v_A.re); });
  ledger.put("v_AO", [&] { return magnitude(L * bar.omega); });
  ledger.vector("v_A", plane(v_A));
  ledger.put("a_O", [&] { return magnitude(bar.a_A.re); });
  ledger.put("a_AO_n", [&] { return magnitude(L * geometry::square(bar.omega)); });
  ledger.put("a_AO_t", [&] { return magnitude(L * bar.alpha); });
  ledger.vector("a_A", plane(a_A));
  write_pole<T>(ledger, "P0", bar, {{"O", O}, {"A", A}}, no_velocity_centre(instant));
  // The slope of i v_A.
  ledger.put("normal_slope", [&] {
    const Complex<T> normal = geometry::analytic::times_i(v_A);
    return ledger.ratio(normal.im, normal.re, upright_normal);
  });
  write_acceleration_pole<T>(ledger, bar, {{"O", O}, {"A", A}}, no_acceleration_centre(instant));
}

struct Routes {
  Instant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const MovingBar<T> bar = moving_bar<T>(instant);
    ledger.point("A", bar.A);
    by_polar_diagram(ledger, bar, instant);
    by_poles(ledger, bar, instant);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::velocity_centre
