// The centred slider-crank by its closure equation, in complex numbers:
//   r e^{iφ} + l e^{iθ} = x_B,   whose imaginary part is   r sin φ + l sin θ = 0,
// and whose first and second derivatives with respect to time give ω₃ = θ' and α₃ = θ''.
// Source of the formulas: differentiation of these lines; any text on the crank gear gives the same ones.
//
// A0 is the origin, the guide is the real axis, φ is counter-clockwise from it, A = r e^{iφ}. B lies ahead of A
// (cos θ >= 0, the branch that passes x_B = r + l). The plate's C lies on the left of A to B, M halves AB.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/decide.h"
#include "geometry/analytic/digits.h"
#include "geometry/analytic/plane_motion.h"

#include <string>

namespace epure::geometry::analytic {

// Lengths in metres: crank A0A = r > 0, coupler AB = l > 0, plate sides AC > 0 and BC > 0.
struct SliderCrank {
  Rational r, l, AC, BC;
};

// cos φ and sin φ; φ' = ω₂ in rad/s and φ'' = α₂ in rad/s², counter-clockwise positive. With ω₂ = 1, α₂ = 0 no π
// enters, and Exact can run everything below.
template <class T>
struct CrankState {
  T cosine, sine;
  T omega, alpha;
};

template <class T>
CrankState<T> crank_at(const Turn& turn, const T& omega, const T& alpha) {
  return {cosine<T>(turn), sine<T>(turn), omega, alpha};
}

// Points in metres; cos θ >= 0 and sin θ give the direction from A to B.
template <class T>
struct SliderCrankPosition {
  Complex<T> A, B, C, M;
  T cos_theta, sin_theta;
};

// Angular in rad/s and rad/s², counter-clockwise positive; velocities in m/s, accelerations in m/s².
template <class T>
struct SliderCrankMotion {
  T omega_3, alpha_3;
  Complex<T> v_A, v_B, v_C, v_M;
  Complex<T> a_A, a_B, a_C, a_M;
};

// Coordinate of C in the coupler frame (origin A, real axis along AB): real part by the law of cosines, imaginary
// part
// >= 0 by Heron's formula. The decision is on rationals, so a flat plate (AC + BC = AB) has height exactly 0.
// Throws Impossible when the three sides close no triangle.
template <class T>
Complex<T> plate_point(const SliderCrank& g) {
  const Rational along = (g.AC * g.AC + g.l * g.l - g.BC * g.BC) / (2 * g.l);
  const Rational sixteen_areas_squared =
      (g.l + g.AC + g.BC) * (-g.l + g.AC + g.BC) * (g.l - g.AC + g.BC) * (g.l + g.AC - g.BC);
  if (sixteen_areas_squared < 0)
    throw Impossible("the sides AB, AC and BC close no triangle: the longest exceeds the other two together");
  const T height = quotient(root(from_rational<T>(sixteen_areas_squared)), from_rational<T>(2 * g.l));
  return {from_rational<T>(along), height};
}

// The whole position. Throws Impossible when the linkage does not close, saying by how much; Undecided when T cannot
// tell whether it closes. Where the coupler stands square to the guide (r |sin φ| = l) the position exists.
template <class T>
SliderCrankPosition<T> position(const SliderCrank& g, const CrankState<T>& crank) {
  // With sin θ = -λ sin φ, cos² θ as a product: no digits are lost where the coupler is almost square to the guide.
  const T lambda_sine = from_rational<T>(g.r / g.l) * crank.sine;
  const T cos2 = (T(1) - lambda_sine) * (T(1) + lambda_sine);
  if (decided_sign(cos2, "whether the coupler reaches the guide") == Sign::negative) {
    const T height = from_rational<T>(g.r) * root(square(crank.sine));
    throw Impossible("the slider-crank does not close: A is " + digits(height) + " m away from the guide and AB is " +
                     digits(from_rational<T>(g.l)) + " m long, short by " + digits(height - from_rational<T>(g.l)) +
                     " m");
  }
  const T r = from_rational<T>(g.r), l = from_rational<T>(g.l);
  const Complex<T> theta{root(cos2), -lambda_sine};
  const Complex<T> A = r * Complex<T>{crank.cosine, crank.sine};
  const Complex<T> B{r * crank.cosine + l * theta.re, T(0)};
  const Complex<T> half = from_rational<T>(g.l / 2) * theta;
  return {A, B, A + plate_point<T>(g) * theta, A + half, theta.re, theta.im};
}

// Velocities and accelerations at a position of `position`. Throws Impossible when the coupler stands square to the
// guide: the closure then fixes neither ω₃ nor v_B. Undecided when T cannot tell.
template <class T>
SliderCrankMotion<T> motion(const SliderCrank& g, const CrankState<T>& crank, const SliderCrankPosition<T>& p) {
  if (is_zero(p.cos_theta, "whether the coupler is square to the guide"))
    throw Impossible("the coupler is square to the guide: the velocities of B and of the coupler are not defined");
  const T r = from_rational<T>(g.r), l = from_rational<T>(g.l), omega_2 = crank.omega, alpha_2 = crank.alpha;
  SliderCrankMotion<T> m;
  // First derivative: r ω₂ cos φ + l ω₃ cos θ = 0. Second: its derivative, solved for α₃ likewise.
  m.omega_3 = -quotient(r * omega_2 * crank.cosine, l * p.cos_theta);
  m.alpha_3 =
      quotient(r * (square(omega_2) * crank.sine - alpha_2 * crank.cosine) + l * square(m.omega_3) * p.sin_theta,
               l * p.cos_theta);
  // (i ω) and (i α - ω²) are what d/dt and d²/dt² make of e^{iφ}.
  const Complex<T> first_2{T(0), omega_2}, second_2{-square(omega_2), alpha_2};
  const Complex<T> first_3{T(0), m.omega_3}, second_3{-square(m.omega_3), m.alpha_3};
  const Complex<T> theta{p.cos_theta, p.sin_theta};
  const Complex<T> to_C = plate_point<T>(g) * theta, to_M = from_rational<T>(g.l / 2) * theta;
  m.v_A = first_2 * p.A;
  m.a_A = second_2 * p.A;
  m.v_C = m.v_A + first_3 * to_C;
  m.a_C = m.a_A + second_3 * to_C;
  m.v_M = m.v_A + first_3 * to_M;
  m.a_M = m.a_A + second_3 * to_M;
  // The real part of the closure, differentiated; B's imaginary parts are exactly zero.
  m.v_B = {-(r * omega_2 * crank.sine) - l * m.omega_3 * p.sin_theta, T(0)};
  m.a_B = {-(r * (square(omega_2) * crank.cosine + alpha_2 * crank.sine)) -
               l * (square(m.omega_3) * p.cos_theta + m.alpha_3 * p.sin_theta),
           T(0)};
  return m;
}

// The coupler as a moving plane.
template <class T>
PlaneMotion<T> coupler(const SliderCrankPosition<T>& p, const SliderCrankMotion<T>& m) {
  return {p.A, m.v_A, m.a_A, m.omega_3, m.alpha_3};
}

}  // namespace epure::geometry::analytic
