// Curves of the centred slider-crank in closed form: both polodes of the coupler against the frame, and the paths of
// the coupler's points. r = A0A, l = AB in metres; frame and names as in slider_crank.h.
//
// Each residual below is a polynomial that vanishes on its curve. It may vanish elsewhere too: squaring also admits
// the branch with B behind A (cos θ < 0), so a zero residual is necessary, not sufficient.
#pragma once

#include "geometry/analytic/slider_crank.h"

#include <optional>

namespace epure::geometry::analytic {

// Fixed polode: the pole on the crank's line above B, x_B e^{iφ}/cos φ. Empty when cos φ = 0 (pole at infinity).
template <class T>
std::optional<Complex<T>> fixed_polode(const CrankState<T>& crank, const SliderCrankPosition<T>& p) {
  if (is_zero(crank.cosine, "whether the crank is square to the guide")) return {};
  return quotient(p.B.re, crank.cosine) * Complex<T>{crank.cosine, crank.sine};
}

// Moving polode in the coupler frame (origin A, real axis along AB): l cos θ/cos φ e^{i(φ - θ)}, the law of sines in
// the triangle of A, B and pole. Empty when cos φ = 0.
template <class T>
std::optional<Complex<T>> moving_polode(const SliderCrank& g, const CrankState<T>& crank,
                                        const SliderCrankPosition<T>& p) {
  if (is_zero(crank.cosine, "whether the crank is square to the guide")) return {};
  const Complex<T> direction = Complex<T>{crank.cosine, crank.sine} * Complex<T>{p.cos_theta, -p.sin_theta};
  return quotient(from_rational<T>(g.l) * p.cos_theta, crank.cosine) * direction;
}

// (x² + r² - l²)² (x² + y²) - 4 r² x⁴, in m⁶: from (x - r cos φ)² = l² - r² sin² φ with tan φ = y/x.
template <class T>
T fixed_polode_residual(const SliderCrank& g, const Complex<T>& z) {
  const T x2 = square(z.re), r2 = from_rational<T>(g.r * g.r);
  const T difference = from_rational<T>(g.r * g.r - g.l * g.l);
  return square(x2 + difference) * squared_modulus(z) - T(4) * r2 * square(x2);
}

// l² (x - l)² (x² + y²) - r² (x² + y² - l x)², in m⁶, in the coupler frame: with ψ = φ - θ the closure gives
// tan θ = -r sin ψ/(l + r cos ψ), and the distance ρ of the pole from A obeys ρ (l cos ψ + r) = l (l + r cos ψ).
template <class T>
T moving_polode_residual(const SliderCrank& g, const Complex<T>& w) {
  const T l = from_rational<T>(g.l), radius2 = squared_modulus(w);
  return square(l * (w.re - l)) * radius2 - square(from_rational<T>(g.r) * (radius2 - l * w.re));
}

// Path of the coupler point with coordinate w in the coupler frame: r e^{iφ} + w e^{iθ}.
template <class T>
Complex<T> coupler_curve(const SliderCrankPosition<T>& p, const Complex<T>& w) {
  return p.A + w * Complex<T>{p.cos_theta, p.sin_theta};
}

// Quartic polynomial of that path, in m⁶. For z on the path, |z - w e^{iθ}| = r and Im(z + (l - w) e^{iθ}) = 0 are
// linear in (cos θ, sin θ); solved by Cramer's rule as N/D, the residual is |N|² - D². For w = l, the point B, it
// vanishes on the guide and nothing else of it is meaningful.
template <class T>
T coupler_curve_residual(const SliderCrank& g, const Complex<T>& w, const Complex<T>& z) {
  const T l = from_rational<T>(g.l), r2 = from_rational<T>(g.r * g.r);
  const T a1 = T(2) * dot(z, w), b1 = -(T(2) * cross(z, w)), k1 = squared_modulus(z) + squared_modulus(w) - r2;
  const T a2 = w.im, b2 = w.re - l, k2 = z.im;
  const T determinant = a1 * b2 - a2 * b1;
  return square(k1 * b2 - k2 * b1) + square(a1 * k2 - a2 * k1) - square(determinant);
}

}  // namespace epure::geometry::analytic
