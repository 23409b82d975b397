// A beam on two supports with a load at the end of its overhang: equilibrium solved, the equation of the elastic line
// integrated, and the energy. Second route to statics/funicular.h.
//
// ξ from the first support (hinge B); second support (C) at ξ = L; the load P, downwards, at D, ξ = L + a. Moments
// positive where the lower fibres are in tension, v upwards, θ = dv/dξ. EJ constant; shear neglected. The column is
// rigid but where the text says otherwise.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

template <class T>
struct OverhangingBeam {
  T L, a, P, EJ;

  // About B and about C; upwards on the beam.
  T Y_C() const { return quotient(P * (L + a), L); }
  T Y_B() const { return -quotient(P * a, L); }

  T moment_between(const T& xi) const { return Y_B() * xi; }
  T moment_beyond(const T& xi) const { return -(P * (L + a - xi)); }
  // ∫ M dξ
  T area_between() const { return quotient(Y_B() * square(L), T(2)); }
  T area_beyond() const { return -quotient(P * square(a), T(2)); }

  // EJ v = Y_B ξ³/6 + c ξ, v(L) = 0; beyond C with η = ξ − L: EJ v = P (η³/6 − a η²/2) + θ_C EJ η.
  T theta_B() const { return -quotient(Y_B() * square(L), T(6) * EJ); }
  T theta_between(const T& xi) const { return theta_B() + quotient(Y_B() * square(xi), T(2) * EJ); }
  T v_between(const T& xi) const { return xi * (theta_B() + quotient(Y_B() * square(xi), T(6) * EJ)); }
  T theta_C() const { return theta_between(L); }
  T theta_D() const { return theta_C() - quotient(P * square(a), T(2) * EJ); }
  T v_D() const { return a * theta_C() - quotient(P * a * square(a), T(3) * EJ); }
  // Where θ = 0 between the supports.
  T xi_of_greatest_v() const { return quotient(L, root(T(3))); }

  // ½ ∫ M²/EJ dξ
  T energy() const { return quotient(square(Y_B()) * L * square(L) + square(P) * a * square(a), T(6) * EJ); }
};

}  // namespace epure::geometry::analytic
