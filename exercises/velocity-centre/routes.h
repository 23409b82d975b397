// The bar on its carrier three times: by the polygons of Rivals' theorem, by poles, by complex numbers.
#pragma once

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/velocity-centre/bar.h"
#include "geometry/mechanisms/dyad.h"

namespace epure::velocity_centre {

using geometry::Point;
using geometry::Vector;

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
inline Quantity normal_slope() {
  const Words meaning{"slope of the normal to v_A", "coefficiente angolare della normale alla v_A"};
  return {"normal_slope", "$m_{1}$", "1", meaning};
}

inline constexpr Phrase no_inclination{"γ has no value: ω and dω/dt are zero",
                                       "γ non ha valore: ω e dω/dt sono zero"};
// From an acceleration to the ray to K: tan γ = (dω/dt)/ω².
inline Quantity inclination_in_degrees() {
  const Words meaning{"angle from an acceleration to its ray to K",
                      "angolo da un'accelerazione al suo raggio verso K"};
  return {"gamma_deg", "$γ$", "deg", meaning};
}

struct Routes {
  Instant instant;

  // O is the origin.
  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const Point<T> O{T(0), T(0)};
    const Vector<T> along_bar{geometry::cosine<T>(instant.angle), geometry::sine<T>(instant.angle)};
    const Point<T> A = O + number<T>(instant.L) * along_bar;
    ledger.draws_point("O", O);
    ledger.put(point("A"), A);
    by_polar_diagram(ledger, O, A);
    by_poles(ledger, O, A);
    by_analysis(ledger);
    return ledger;
  }

 private:
  template <class T>
  void put_inclination(Ledger<T>& ledger, const std::function<T()>& find) const {
    ledger.put(inclination_in_degrees(), [&]() -> T {
      if (!instant.turns() && is_zero(instant.omega_dot)) throw geometry::Impossible(no_inclination);
      return find();
    });
  }

  // v_A = v_O + v_AO, a_A = a_O + a_AO^n + a_AO^t: vector after vector.
  template <class T>
  void by_polar_diagram(Ledger<T>& ledger, const Point<T>& O, const Point<T>& A) const {
    ledger.route("polar diagram");
    const T omega = geometry::radians<T>(instant.omega), alpha = geometry::radians<T>(instant.omega_dot);
    const Vector<T> OA = A - O, v_O{number<T>(instant.V), T(0)}, a_O{number<T>(instant.a), T(0)};
    const Vector<T> v_AO = omega * geometry::quarter_turn(OA);
    const Vector<T> a_AO_n = -(geometry::square(omega) * OA), a_AO_t = alpha * geometry::quarter_turn(OA);
    ledger.put_length(velocity("O"), v_O);
    ledger.put_length(velocity("AO"), v_AO);
    ledger.put(velocity("A"), v_O + v_AO);
    ledger.put_length(acceleration("O"), a_O);
    ledger.put_length(normal_acceleration("AO"), a_AO_n);
    ledger.put_length(tangential_acceleration("AO"), a_AO_t);
    ledger.put(acceleration("A"), a_O + a_AO_n + a_AO_t);
    put_inclination<T>(ledger, [&] {  // between a_AO and its normal part
      const Vector<T> seen{-dot(a_AO_n, OA), dot(a_AO_t, geometry::quarter_turn(OA))};
      return in_degrees(slope_angle(seen));
    });
    const geometry::PlaneMotion<T> bar{O, v_O, a_O, omega, alpha};
    write_acceleration_pole<T>(ledger, bar, {{"O", O}, {"A", A}}, no_acceleration_centre(instant));
  }

  // The velocity centre by drawing, whichever way this instant allows.
  template <class T>
  geometry::ProjectivePoint<T> centre(const Point<T>& O, const Vector<T>& v_O, const Point<T>& A,
                                      const Vector<T>& v_A) const {
    const auto normal = [](const Point<T>& X, const Vector<T>& v) {
      return geometry::line(X, geometry::quarter_turn(v));
    };
    switch (centre_of(instant)) {
      case Centre::by_the_tips:
        return geometry::meet(geometry::line(O, A), geometry::line(O + v_O, A + v_A));
      case Centre::is_O:
        return geometry::projective(O);
      default:
        return geometry::meet(normal(O, v_O), normal(A, v_A));
    }
  }

  // v_A from its distance to the centre, where there is one.
  template <class T>
  void by_poles(Ledger<T>& ledger, const Point<T>& O, const Point<T>& A) const {
    ledger.route("poles");
    const T omega = geometry::radians<T>(instant.omega);
    const Vector<T> v_O{number<T>(instant.V), T(0)}, v_A = v_O + omega * geometry::quarter_turn(A - O);
    const geometry::ProjectivePoint<T> P0 = centre(O, v_O, A, v_A);
    write_pole<T>(ledger, "P0", P0, {{"O", O}, {"A", A}}, no_velocity_centre(instant));
    ledger.put(normal_slope(), [&] { return ledger.ratio(-v_A.x, v_A.y, upright_normal); });
    if (instant.turns()) ledger.put(velocity("A"), omega * geometry::quarter_turn(A - finite(P0)));
  }

  template <class T>
  void by_analysis(Ledger<T>& ledger) const {
    using geometry::analytic::Complex;
    ledger.route("analytic");
    const T L = number<T>(instant.L), V = number<T>(instant.V), a = number<T>(instant.a);
    const T omega = geometry::radians<T>(instant.omega), alpha = geometry::radians<T>(instant.omega_dot);
    const Complex<T> O{T(0), T(0)},
        A = L * Complex<T>{geometry::cosine<T>(instant.angle), geometry::sine<T>(instant.angle)};
    const geometry::analytic::PlaneMotion<T> bar{O, {V, T(0)}, {a, T(0)}, omega, alpha};
    ledger.put(point("A"), Point<T>{A.re, A.im});
    ledger.put(velocity("O").length(), [&] { return magnitude_of(V); });
    ledger.put(velocity("AO").length(), [&] { return magnitude_of(L * omega); });
    ledger.put(velocity("A"), plane(bar.velocity(A)));
    ledger.put(acceleration("O").length(), [&] { return magnitude_of(a); });
    ledger.put(normal_acceleration("AO").length(), [&] { return magnitude_of(L * geometry::square(omega)); });
    ledger.put(tangential_acceleration("AO").length(), [&] { return magnitude_of(L * alpha); });
    ledger.put(acceleration("A"), plane(bar.acceleration(A)));
    write_pole<T>(ledger, "P0", bar, {{"O", O}, {"A", A}}, no_velocity_centre(instant));
    ledger.put(normal_slope(), [&] {  // of i v_A
      const Complex<T> normal = geometry::analytic::times_i(bar.velocity(A));
      return ledger.ratio(normal.im, normal.re, upright_normal);
    });
    write_acceleration_pole<T>(ledger, bar, {{"O", O}, {"A", A}}, no_acceleration_centre(instant));
    put_inclination<T>(ledger, [&] {
      return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{geometry::square(omega), alpha}));
    });
  }
};

}  // namespace epure::velocity_centre
