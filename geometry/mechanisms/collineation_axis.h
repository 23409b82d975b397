// The rocker's velocity ratio ω₄/ω₂ from the instant centres, and where it is stationary.
//
// P₂₄, where coupler and frame meet, has one velocity as a point of the crank and of the rocker, so ω₄/ω₂ is the
// ratio of its distances from A₀ and B₀ (Kennedy). It is stationary when the collineation axis, the line through P₂₄
// and the coupler's pole P₁₃, is square to the coupler (Freudenstein's theorem; Hartenberg and Denavit, Kinematic
// Synthesis of Linkages, section 12-8, where it is proved for a crank of constant speed).
#pragma once

#include "geometry/mechanisms/four_bar.h"
#include "geometry/numbers/polynomial.h"

#include <vector>

namespace epure::geometry {

// Where the lines of coupler and frame meet. At infinity when these are parallel: crank and rocker then turn alike.
template <class T>
ProjectivePoint<T> centre_of_crank_and_rocker(const FourBar<T>& at) {
  return meet(line(at.A, at.B), line(at.A0, at.B0));
}

// ω₄/ω₂. Throws Undecided when P₂₄ lies on B₀ (coupler and rocker in line) or that cannot be told.
template <class T>
T velocity_ratio_by_centres(const FourBar<T>& at) {
  const ProjectivePoint<T> P24 = centre_of_crank_and_rocker(at);
  const Vector<T> frame = at.B0 - at.A0;
  const auto from = [&](const Point<T>& O) {
    return dot(frame, Vector<T>{P24.x - P24.w * O.x, P24.y - P24.w * O.y});
  };
  return quotient(from(at.A0), from(at.B0));
}

// The linkage with its collineation axis square to its coupler, by μ = ω₄/ω₂.
//
// P₂₄ is put in the origin, the coupler on the x axis and its length to 1: A = (α, 0), B = (α + 1, 0), P₁₃ = (0, h).
// With ω = ω₃/ω₂ it is BB₀ : BP₁₃ = ω/μ = k and AA₀ : AP₁₃ = ω; that A₀, B₀ and P₂₄ are in line makes
// α = (μ - ω)/(1 - μ). The squares of crank, rocker and frame, in parts of the coupler's, then say, without h,
//   I    (crank - rocker μ²)(1 - μ) + ω²(1 + μ - 2ω) = 0
//   II   rocker μ(1 - μ)² - frame μ + (1 - ω)²(μ - 2ω) = 0,
// and I - II is  3ω² - 2eω - g = 0. That divides I but for  2mω - n, which so is zero too, and the two leave
//   3n² - 4enm - 4gm² = 0,
// of degree six in μ: and no μ has two ω. (μ = 1 and μ = 0 are never a linkage: 1 - μ and μ were multiplied in.)
template <class X>
struct AxisSquareToCoupler {
  X mu, e, g, n, m;

  AxisSquareToCoupler(const FourBarLengths& of, const X& ratio) : mu(ratio), e(X(1) + ratio) {
    const Rational b2 = of.AB * of.AB, frame2 = of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0;
    const X crank = from_rational<X>(of.A0A * of.A0A / b2), rocker = from_rational<X>(of.B0B * of.B0B / b2),
            frame = from_rational<X>(frame2 / b2), rest = X(1) - mu;
    g = (crank - rocker * mu) * rest + (frame - X(1)) * mu;
    n = X(9) * (crank - rocker * mu * mu) * rest - e * g;
    m = e * e + X(3) * g;
  }

  X sextic() const { return X(3) * n * n - X(4) * m * (e * n + g * m); }

  // ω₃/ω₂, for μ a root of the sextic and neither 0 nor 1; so are the following.
  X omega() const {
    if constexpr (std::is_same_v<X, Rational>)
      if (m == 0) return e / X(3);  // n is zero then too, and both ω of 3ω² - 2eω - g are this one
    return n / (X(2) * m);
  }
  // Of how far B₀ is from the coupler's line, (ω/μ)h. There is no such linkage where it is negative, and where it is
  // zero all hinges are in line.
  X height_squared(const FourBarLengths& of) const {
    const X w = omega(), along = w * (X(1) - w) / (mu * (X(1) - mu));
    return from_rational<X>(of.B0B * of.B0B / (of.AB * of.AB)) - along * along;
  }
  // Of the crank A₀A and the frame A₀B₀, in squares of the coupler.
  X dot_product(const FourBarLengths& of) const {
    const X w = omega(), rest = X(1) - mu;
    return w * (mu - w) * (mu - w) * (X(1) - w) / (rest * mu) - mu * rest * height_squared(of);
  }
};

// A position where the ratio is stationary.
class StationaryPosition {
 public:
  StationaryPosition(const FourBarLengths& of, Side branch, RealRoot ratio);

  // The unit vector A₀ towards A. Of the exact numbers only where the ratio is rational, else throws Undecided.
  template <class T>
  Vector<T> crank() const {
    const Rational frame2 = of_.x_B0 * of_.x_B0 + of_.y_B0 * of_.y_B0, scale = of_.AB * of_.AB / (of_.A0A * frame2);
    const T along = from_rational<T>(scale) * ratio_.into<T>([&]<class X>(const X& mu) -> X {
      return AxisSquareToCoupler<X>(of_, mu).dot_product(of_);
    });
    const T across = from_rational<T>(scale) * root(ratio_.into<T>([&]<class X>(const X& mu) -> X {
                       const AxisSquareToCoupler<X> at(of_, mu);
                       const X arm = mu - at.omega();
                       return at.height_squared(of_) * arm * arm;
                     }));
    const Vector<T> frame{from_rational<T>(of_.x_B0), from_rational<T>(of_.y_B0)};
    return along * frame + (crank_is_ == Side::left ? across : -across) * quarter_turn(frame);
  }

 private:
  FourBarLengths of_;
  RealRoot ratio_;
  Side crank_is_;  // of A₀ -> B₀
};

// All of a branch, in the order of the ratio, the least first. For a linkage whose crank turns fully and that has no
// change point.
std::vector<StationaryPosition> stationary_positions(const FourBarLengths& of, Side branch);

}  // namespace epure::geometry
