// The driving crank.
#pragma once

#include "exercises/kit/angles.h"

namespace epure {

// 2 π n. The exact numbers are asked for signs only: with unit crank speed and α₂ = 0 they get on without π.
template <class T>
T crank_speed(const Rational& turns_per_second, const Rational& alpha_2) {
  if (signs_only<T> && alpha_2 == 0) return T(turns_per_second > 0 ? 1 : -1);
  return geometry::from_rational<T>(2 * turns_per_second) * geometry::pi<T>();
}

// The crank at the instant t, turned to `crank` since it lay on +x.
template <class T>
struct DrivenCrank {
  geometry::Turn crank;
  Rational t;
  T omega_2;
};

// By construction: the angle measured at A₀, and the speed that covers it in t.
template <class T>
void write_crank(Ledger<T>& ledger, const DrivenCrank<T>& at, const geometry::Point<T>& A) {
  const T phi = crank_angle_seen(at.crank, A);
  ledger.put("omega_2", [&]() -> T {
    return at.t == 0 ? at.omega_2 : geometry::quotient(phi, geometry::from_rational<T>(at.t));
  });
  ledger.put("crank_angle_phi", phi);
  ledger.put("crank_angle_phi_deg", in_degrees(phi));
}

// From speed and time.
template <class T>
void write_crank(Ledger<T>& ledger, const DrivenCrank<T>& at) {
  ledger.put("omega_2", at.omega_2);
  if constexpr (signs_only<T>) {
    ledger.put("crank_angle_phi", geometry::from_rational<T>(at.crank.fraction));
  } else {
    ledger.put("crank_angle_phi", at.omega_2 * geometry::from_rational<T>(at.t));
  }
  ledger.put("crank_angle_phi_deg", geometry::from_rational<T>(360 * at.crank.fraction));
}

}  // namespace epure
