// Stresses in closed form: second route to statics/mohr_circle.h and to the sums of statics/section.h.
#pragma once

#include "geometry/analytic/decide.h"
#include "geometry/analytic/section_formulas.h"

namespace epure::geometry::analytic {

// The eigenvalues of (σ τ; τ 0).
template <class T>
struct PrincipalStresses {
  T greater, lesser;
};
template <class T>
PrincipalStresses<T> principal_stresses(const T& sigma, const T& tau) {
  const T spread = root(square(sigma) + square(T(2) * tau)), half = from_rational<T>(Rational(1, 2));
  return {half * (sigma + spread), half * (sigma - spread)};
}

// von Mises.
template <class T>
T equivalent_stress(const T& sigma, const T& tau) {
  return root(square(sigma) + T(3) * square(tau));
}

// Shear over static moment and wall: T/(8 J s)·(b (H² − h²) + s h²) on the axis of a double T.
template <class T>
T greatest_web_shear(const DoubleT& of, const T& shear) {
  const Rational h = of.h();
  return shear * from_rational<T>((of.b * (of.H * of.H - h * h) + of.s * h * h) / (8 * of.J_x() * of.s));
}

// Soderberg: Δσ / (1 − σ_m/σ_S). Throws Impossible with this sentence when nothing is left of the yield stress.
template <class T>
T soderberg(const T& range, const T& mean, const T& yield, const Phrase& nothing_left) {
  const T left = T(1) - quotient(mean, yield);
  if (decided_sign(left, nothing_left) != Sign::positive) throw Impossible(nothing_left);
  return quotient(range, left);
}

// π² E J/l², of a bar hinged at both ends.
template <class T>
T euler_load(const Rational& E, const Rational& J, const Rational& length) {
  return square(pi<T>()) * from_rational<T>(E * J / (length * length));
}

}  // namespace epure::geometry::analytic
