// The slider-crank by its closure equation, in complex numbers:
//   r e^{iφ} + l e^{iθ} = e^{iδ} (x_B + i e).
// Seen from the guide (divided by e^{iδ}; ψ = φ - δ, η = θ - δ):   r e^{iψ} + l e^{iη} = x_B + i e,
// whose imaginary part is   r sin ψ + l sin η = e,
// and whose first and second derivatives with respect to time give ω₃ = η' and α₃ = η''.
// Source of the formulas: differentiation of these lines; any text on the crank gear gives the same ones for e = 0.
//
// A0 is the origin, φ is counter-clockwise from the real axis, A = r e^{iφ}. The guide has the direction e^{iδ} and
// passes A0 at the distance e, on the left when e > 0. B lies ahead of A (cos η >= 0; for e = δ = 0 the branch that
// passes x_B = r + l). The plate's C lies on the left of A to B, M halves AB.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/crank_state.h"
#include "geometry/analytic/decide.h"
#include "geometry/analytic/digits.h"
#include "geometry/analytic/plane_motion_formulas.h"

#include <string>

namespace epure::geometry::analytic {

// Lengths in metres: crank A0A = r > 0, coupler AB = l > 0, plate sides AC > 0 and BC > 0, the guide's offset e of
// either sign; its direction δ.
struct SliderCrank {
  Rational r, l, AC, BC;
  Rational e{0};
  Angle delta = {};
};

// e^{iδ}.
template <class T>
Complex<T> direction_of_guide(const SliderCrank& g) {
  return {cosine<T>(g.delta), sine<T>(g.delta)};
}

// The crank at φ, and as it is seen from the guide, at ψ: a difference of exact angles, so that a crank along the
// guide or square to it is exactly that.
template <class T>
struct GuidedCrank {
  CrankState<T> from_x, from_guide;
};

template <class T>
GuidedCrank<T> guided_crank(const SliderCrank& g, const Angle& angle, const T& omega, const T& alpha) {
  return {crank_at<T>(angle, omega, alpha), crank_at<T>(angle - g.delta, omega, alpha)};
}

// Points in metres; e^{iη}, the direction from A to B seen from the guide, and e^{iθ}; x_B, how far B is along the
// guide.
template <class T>
struct SliderCrankPosition {
  Complex<T> A, B, C, M;
  Complex<T> eta, theta;
  T x_B;
};

// Angular in rad/s and rad/s², counter-clockwise positive; velocities in m/s, accelerations in m/s².
template <class T>
struct SliderCrankMotion {
  T omega_3, alpha_3;
  Complex<T> v_A, v_B, v_C, v_M;
  Complex<T> a_A, a_B, a_C, a_M;
};

// Coordinate of C in the coupler frame (origin A, real axis along AB): real part by the law of cosines, imaginary
// part >= 0 by Heron's formula. The decision is on rationals, so a flat plate (AC + BC = AB) has height exactly 0.
// Throws Impossible when the three sides close no triangle.
template <class T>
Complex<T> plate_point(const SliderCrank& g) {
  const Rational along = (g.AC * g.AC + g.l * g.l - g.BC * g.BC) / (2 * g.l);
  const Rational sixteen_areas_squared =
      (g.l + g.AC + g.BC) * (-g.l + g.AC + g.BC) * (g.l - g.AC + g.BC) * (g.l + g.AC - g.BC);
  if (sixteen_areas_squared < 0)
    throw Impossible("the sides AB, AC and BC close no triangle: the longest exceeds the other two together",
                     "i lati AB, AC e BC non chiudono un triangolo: il maggiore supera la somma degli altri due");
  const T height = quotient(root(from_rational<T>(sixteen_areas_squared)), from_rational<T>(2 * g.l));
  return {from_rational<T>(along), height};
}

// cos η = √((1 - sin η)(1 + sin η)), the product so that no digits are lost where the coupler is almost square to the
// guide; of equal links on a centred guide |cos ψ|, since then sin η = -sin ψ: a root of sines of many turns would
// hide its zeros from every exact number. Errors as position.
template <class T>
T cosine_of_coupler(const SliderCrank& g, const T& cos_psi, const T& cos2) {
  if (g.r != g.l || g.e != 0) return root(cos2);
  return decided_sign(cos_psi, {"whether the crank points ahead", "se la manovella sia rivolta in avanti"}) ==
                 Sign::negative
             ? -cos_psi
             : cos_psi;
}

// The whole position. Throws Impossible when the linkage does not close, saying by how much; Undecided when T cannot
// tell whether it closes. Where the coupler stands square to the guide (|r sin ψ - e| = l) the position exists.
template <class T>
SliderCrankPosition<T> position(const SliderCrank& g, const GuidedCrank<T>& crank) {
  const T sin_eta = from_rational<T>(g.e / g.l) - from_rational<T>(g.r / g.l) * crank.from_guide.sine;
  const T cos2 = (T(1) - sin_eta) * (T(1) + sin_eta);
  if (decided_sign(cos2, {"whether the coupler reaches the guide", "se la biella raggiunga la guida"}) ==
      Sign::negative) {
    const T height = from_rational<T>(g.l) * root(square(sin_eta));
    throw Impossible(Words{"the slider-crank does not close: A is ", "il manovellismo non si chiude: A dista "} +
                     digits(height) + Words{" m away from the guide and AB is ", " m dalla guida e AB è lunga "} +
                     digits(from_rational<T>(g.l)) + Words{" m long, short by ", " m: mancano "} +
                     digits(height - from_rational<T>(g.l)) + " m");
  }
  const T r = from_rational<T>(g.r), l = from_rational<T>(g.l);
  const Complex<T> guide = direction_of_guide<T>(g),
                   eta{cosine_of_coupler(g, crank.from_guide.cosine, cos2), sin_eta}, theta = guide * eta;
  const T x_B = r * crank.from_guide.cosine + l * eta.re;
  const Complex<T> A = r * Complex<T>{crank.from_x.cosine, crank.from_x.sine},
                   B = guide * Complex<T>{x_B, from_rational<T>(g.e)};
  return {A, B, A + plate_point<T>(g) * theta, A + from_rational<T>(g.l / 2) * theta, eta, theta, x_B};
}

// Velocities and accelerations at a position of `position`. Throws Impossible when the coupler stands square to the
// guide: the closure then fixes neither ω₃ nor v_B. Undecided when T cannot tell.
template <class T>
SliderCrankMotion<T> motion(const SliderCrank& g, const GuidedCrank<T>& crank, const SliderCrankPosition<T>& p) {
  if (is_zero(p.eta.re, {"whether the coupler is square to the guide", "se la biella sia perpendicolare alla guida"}))
    throw Impossible("the coupler is square to the guide: the velocities of B and of the coupler are not defined",
                     "la biella è perpendicolare alla guida: le velocità di B e della biella non sono definite");
  const T r = from_rational<T>(g.r), l = from_rational<T>(g.l), cos_eta = p.eta.re, sin_eta = p.eta.im;
  const auto& [cos_psi, sin_psi, omega_2, alpha_2] = crank.from_guide;
  SliderCrankMotion<T> m;
  // First derivative: r ω₂ cos ψ + l ω₃ cos η = 0. Second: its derivative, solved for α₃ likewise.
  m.omega_3 = -quotient(r * omega_2 * cos_psi, l * cos_eta);
  m.alpha_3 =
      quotient(r * (square(omega_2) * sin_psi - alpha_2 * cos_psi) + l * square(m.omega_3) * sin_eta, l * cos_eta);
  // (i ω) and (i α - ω²) are what d/dt and d²/dt² make of e^{iφ}.
  const Complex<T> first_2{T(0), omega_2}, second_2{-square(omega_2), alpha_2};
  const Complex<T> first_3{T(0), m.omega_3}, second_3{-square(m.omega_3), m.alpha_3};
  const Complex<T> to_C = plate_point<T>(g) * p.theta, to_M = from_rational<T>(g.l / 2) * p.theta;
  m.v_A = first_2 * p.A;
  m.a_A = second_2 * p.A;
  m.v_C = m.v_A + first_3 * to_C;
  m.a_C = m.a_A + second_3 * to_C;
  m.v_M = m.v_A + first_3 * to_M;
  m.a_M = m.a_A + second_3 * to_M;
  // The real part of the closure, differentiated: B moves along the guide and in no other way.
  const Complex<T> guide = direction_of_guide<T>(g);
  m.v_B = (-(r * omega_2 * sin_psi) - l * m.omega_3 * sin_eta) * guide;
  m.a_B = (-(r * (square(omega_2) * cos_psi + alpha_2 * sin_psi)) -
           l * (square(m.omega_3) * cos_eta + m.alpha_3 * sin_eta)) *
          guide;
  return m;
}

// The coupler as a moving plane.
template <class T>
PlaneMotion<T> coupler(const SliderCrankPosition<T>& p, const SliderCrankMotion<T>& m) {
  return {p.A, m.v_A, m.a_A, m.omega_3, m.alpha_3};
}

}  // namespace epure::geometry::analytic
