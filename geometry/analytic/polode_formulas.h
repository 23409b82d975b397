// Curves of the slider-crank in closed form: both polodes of the coupler against the frame, and the paths of the
// coupler's points. r = A0A, l = AB, e in metres; frame and names as in slider_crank_formulas.h.
//
// Each residual below is a polynomial that vanishes on its curve. It may vanish elsewhere too: squaring also admits
// the branch with B behind A (cos η < 0), so a zero residual is necessary, not sufficient. They are written in the
// axes of the guide: origin A0, x along the guide.
#pragma once

#include "geometry/analytic/slider_crank_formulas.h"

#include <optional>

namespace epure::geometry::analytic {

// A point of the plane in the axes of the guide.
template <class T>
Complex<T> seen_from_guide(const SliderCrank& g, const Complex<T>& z) {
  return conjugate(direction_of_guide<T>(g)) * z;
}

// Fixed polode: the pole on the crank's line, as far along the guide as B, x_B e^{iφ}/cos ψ. Empty when cos ψ = 0
// (pole at infinity).
template <class T>
std::optional<Complex<T>> fixed_polode(const GuidedCrank<T>& crank, const SliderCrankPosition<T>& p) {
  const T& cos_psi = crank.from_guide.cosine;
  if (is_zero(cos_psi, {"whether the crank is square to the guide", "se la manovella sia perpendicolare alla guida"}))
    return {};
  return quotient(p.x_B, cos_psi) * Complex<T>{crank.from_x.cosine, crank.from_x.sine};
}

// Moving polode in the coupler frame (origin A, real axis along AB): l cos η/cos ψ e^{i(ψ - η)}, the law of sines in
// the triangle of A, B and pole. Empty when cos ψ = 0.
template <class T>
std::optional<Complex<T>> moving_polode(const SliderCrank& g, const GuidedCrank<T>& crank,
                                        const SliderCrankPosition<T>& p) {
  const auto& [cos_psi, sin_psi, omega, alpha] = crank.from_guide;
  if (is_zero(cos_psi, {"whether the crank is square to the guide", "se la manovella sia perpendicolare alla guida"}))
    return {};
  return quotient(from_rational<T>(g.l) * p.eta.re, cos_psi) * (Complex<T>{cos_psi, sin_psi} * conjugate(p.eta));
}

// Asymptotes of the fixed polode: where the crank is square to the guide the pole goes to infinity square to it too,
// beside B. Their abscissas in the axes of the guide: √(l² - (r - e)²) for the crank on the left of the guide's
// direction, √(l² - (r + e)²) for the crank on its right. (For e = 0 they are one line, √(l² - r²).) Empty where the
// linkage does not close.
template <class T>
std::optional<T> asymptote_of_fixed_polode(const SliderCrank& g, bool crank_on_left) {
  const Rational height = crank_on_left ? g.r - g.e : g.r + g.e;
  const Rational squared = g.l * g.l - height * height;
  if (squared < 0) return {};
  return root(from_rational<T>(squared));
}

// (x² + e² + r² - l²)² (x² + y²) - 4 r² (x² + e y)², in m⁶, for z = x + i y in the axes of the guide: from
// |x + i e - r e^{iψ}| = l with cos ψ : sin ψ = x : y.
template <class T>
T fixed_polode_residual(const SliderCrank& g, const Complex<T>& z) {
  const T x2 = square(z.re), r2 = from_rational<T>(g.r * g.r);
  const T difference = from_rational<T>(g.e * g.e + g.r * g.r - g.l * g.l);
  return square(x2 + difference) * squared_modulus(z) - T(4) * r2 * square(x2 + from_rational<T>(g.e) * z.im);
}

// In the coupler frame, w = a + i b = ρ e^{i(ψ - η)}. The pole stands square over B: cos η : sin η = b : a - l. The
// closure, times ρ √(b² + (a - l)²), is then   r q + l (a - l) ρ = ± e ρ √(b² + (a - l)²),  q = ρ² - l a; squared
// twice, until no root is left:
//   (ρ² (e² (b² + (a - l)²) - l² (a - l)²) - r² q²)² - 4 r² l² q² (a - l)² ρ²,  in m¹².
// For e = 0 this is the square of l² (a - l)² ρ² - r² q².
template <class T>
T moving_polode_residual(const SliderCrank& g, const Complex<T>& w) {
  const T l = from_rational<T>(g.l), radius2 = squared_modulus(w), beyond_B = w.re - l;
  const T first = square(from_rational<T>(g.r) * (radius2 - l * w.re)), second = square(l * beyond_B) * radius2;
  const T third = square(from_rational<T>(g.e)) * (square(w.im) + square(beyond_B)) * radius2;
  return square(third - second - first) - T(4) * first * second;
}

// Path of the coupler point with coordinate w in the coupler frame: r e^{iφ} + w e^{iθ}.
template <class T>
Complex<T> coupler_curve(const SliderCrankPosition<T>& p, const Complex<T>& w) {
  return p.A + w * p.theta;
}

// Quartic polynomial of that path, in m⁶, for z in the axes of the guide. For z on the path, |z - w e^{iη}| = r and
// Im(z + (l - w) e^{iη}) = e are linear in (cos η, sin η); solved by Cramer's rule as N/D, the residual is |N|² - D².
// For w = l, the point B, it vanishes on the guide and nothing else of it is meaningful.
template <class T>
T coupler_curve_residual(const SliderCrank& g, const Complex<T>& w, const Complex<T>& z) {
  const T l = from_rational<T>(g.l), r2 = from_rational<T>(g.r * g.r);
  const T a1 = T(2) * dot(z, w), b1 = -(T(2) * cross(z, w)), k1 = squared_modulus(z) + squared_modulus(w) - r2;
  const T a2 = w.im, b2 = w.re - l, k2 = z.im - from_rational<T>(g.e);
  const T determinant = a1 * b2 - a2 * b1;
  return square(k1 * b2 - k2 * b1) + square(a1 * k2 - a2 * k1) - square(determinant);
}

}  // namespace epure::geometry::analytic
