// The driving crank.
#pragma once

#include <vector>

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/statement/givens.h"

namespace epure {

// Where the crank is, stated as `t` in seconds, the instant at which it has turned so far with the speed n; or as
// `phi` in degrees.
GivenSpec instant_given(const std::string& stated, Range range, const std::vector<std::string>& also = {});
GivenSpec crank_angle_given();

// Crank angles from +x, in degrees and rounded, between which a linkage closes.
struct AngleRange {
  double from, to;
};
// "; it closes from 10° to 60° and from 300° to 350°", the end of a sentence; empty without a range. Their middles
// are within a turn of the crank, which may have turned several times.
Words where_it_closes(const std::vector<AngleRange>& ranges, const Angle& crank);

// Throws BadGivens for a crank that is at rest.
void require_turning(const Angle& n, const Angle& alpha_2);

// `n`, in radians per second. The exact numbers are asked for signs only: with unit crank speed and α₂ = 0 they get
// on without π.
template <class T>
T crank_speed(const Angle& n, const Angle& alpha_2) {
  if (signs_only<T> && is_zero(alpha_2)) return T(sign_of(n));
  return geometry::radians<T>(n);
}

// The crank, turned to `crank` since it lay on +x, by the speed n.
template <class T>
struct DrivenCrank {
  Angle crank, n;
  T omega_2;

  T instant() const { return geometry::quotient_of<T>(crank, n); }
};

inline Quantity crank_angle() {
  return {"crank_angle_phi", "$φ$", "rad", {"crank angle from +x", "angolo di manovella da +x"}};
}
inline Quantity crank_angle_in_degrees() {
  return {"crank_angle_phi_deg", "$φ$", "deg", {"crank angle in degrees", "angolo di manovella in gradi"}};
}

// By construction: the angle measured at A₀, and the speed that covers it in t.
template <class T>
void write_crank(Ledger<T>& ledger, const DrivenCrank<T>& at, const geometry::Point<T>& A) {
  const T phi = crank_angle_seen(at.crank, A);
  ledger.put(angular_velocity(2),
             [&]() -> T { return is_zero(at.crank) ? at.omega_2 : geometry::quotient(phi, at.instant()); });
  ledger.put(crank_angle(), phi);
  ledger.put(crank_angle_in_degrees(), in_degrees(phi));
}

// From speed and time.
template <class T>
void write_crank(Ledger<T>& ledger, const DrivenCrank<T>& at) {
  ledger.put(angular_velocity(2), at.omega_2);
  if constexpr (signs_only<T>) {
    ledger.put(crank_angle(), T(sign_of(at.crank)));
  } else {
    ledger.put(crank_angle(), at.omega_2 * at.instant());
  }
  ledger.put(crank_angle_in_degrees(), given_in_degrees<T>(at.crank));
}

}  // namespace epure
