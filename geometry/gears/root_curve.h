// What the generating rack leaves of a wheel below its flanks.
//
// The rack's tooth ends in a rounding of the radius rho whose centre lies c beside the tooth's middle and d below the
// pitch line, which rolls on the pitch circle r. While the wheel turns by φ the centre moves on to c + r φ beside the
// pitch point, and the rounding touches its envelope where the normal through the pitch point meets it. With ψ the
// angle of that normal against the line of centres,
//   c + r φ = d tan ψ,
// and the point lies d tan ψ + rho sin ψ beside and r - d - rho cos ψ above the wheel's centre; turned back by φ, and
// by half a pitch from the middle of the space to the middle of the tooth. ψ = 0 touches the root circle, ψ = 90° - α
// is the end of the rack's straight edge. The parameter is p = tan(45° + ψ/2), from 1 to cot(α/2): tangent, sine and
// cosine of ψ are then rational, and its steps suit the curve.
#pragma once

#include "geometry/gears/gear_pair.h"

namespace epure::geometry {

// The end of the rack's tooth that cuts a wheel.
template <class T>
struct CutterTip {
  T c, d, rho;
};

// A cutter whose roundings do not fit side by side has one as large as fits. `wider` is by how much each edge lies
// farther out than on the reference profile, along the pitch line: the cutter of wheels with backlash.
// Throws Impossible when the cutter is pointed before it reaches its depth.
template <class T>
CutterTip<T> cutter_tip(const PairData& of, const Rational& x, const PressureAngle<T>& alpha, const T& wider) {
  const T edge = quotient(pi<T>() * from_rational<T>(of.m), T(4)) + wider;
  const T rounding = from_rational<T>(of.rho * of.m), depth = from_rational<T>(of.hf * of.m);
  const T flat = edge - (depth - rounding) * alpha.tangent - quotient(rounding, alpha.cosine);
  if (sign(flat) == Sign::positive || sign(flat) == Sign::zero)
    return {flat, from_rational<T>((of.hf - of.rho - x) * of.m), rounding};
  const T tip = edge - depth * alpha.tangent;
  if (sign(tip) != Sign::positive)
    throw Impossible("the cutter is pointed before it reaches the root circle",
                     "l'utensile finisce a punta prima della circonferenza di piede");
  const T largest = quotient(tip * alpha.cosine, T(1) - alpha.sine);
  return {T(0), from_rational<T>((of.hf - x) * of.m) - largest, largest};
}

// On the right of a tooth whose middle lies on +y, by p.
template <class T>
struct RootCurve {
  T r, half_pitch;  // pitch circle; half the angle from tooth to tooth
  CutterTip<T> tip;

  template <class X>
  Point<X> operator()(const X& p) const {
    const X inverse = quotient(X(1), p), tangent = quotient(p - inverse, X(2)), cosine = quotient(X(2), p + inverse);
    const X d = X(tip.d), rho = X(tip.rho), rolled = d * tangent;
    const X beside = rolled + rho * tangent * cosine, above = X(r) - d - rho * cosine;
    const X turned = quotient(rolled - X(tip.c), X(r)) + X(half_pitch);
    const X c = cosine_of_angle(turned), s = sine_of_angle(turned);
    return {above * s - beside * c, above * c + beside * s};
  }
};

}  // namespace epure::geometry
