// Positions of the four-bar linkage with all four hinges in line, and the two motions that leave such a change point.
#pragma once

#include "geometry/mechanisms/grashof.h"

#include <array>
#include <optional>
#include <vector>

namespace epure::geometry {

// All hinges in line: the bars as signed lengths in the direction A₀ -> B₀.  A₀A + AB - B₀B = A₀B₀. The frame then
// has a rational length too.
struct FlatPosition {
  Rational A0A, AB, B0B;
  Rational frame() const { return A0A + AB - B0B; }
};

// All of them: none unless one link is as long as it takes, and up to three (four equal links).
inline std::vector<FlatPosition> flat_positions(const FourBarLengths& of) {
  std::vector<FlatPosition> found;
  if (frame_squared(of) == 0) return found;
  for (const int crank : {1, -1})
    for (const int coupler : {1, -1})
      for (const int rocker : {1, -1}) {
        const FlatPosition flat{crank * of.A0A, coupler * of.AB, rocker * of.B0B};
        if (sign_of(LinkSum{-flat.frame(), 1}, of) == Sign::zero) found.push_back(flat);
      }
  return found;
}

// The crank's unit vector.
template <class T>
Vector<T> crank_direction(const FourBarLengths& of, const FlatPosition& flat) {
  const Rational share = (flat.A0A > 0 ? 1 : -1) / flat.frame();
  return {from_rational<T>(share * of.x_B0), from_rational<T>(share * of.y_B0)};
}

template <class T>
FourBar<T> position(const FourBarLengths& of, const FlatPosition& flat) {
  const Point<T> A0{T(0), T(0)}, B0 = rocker_hinge<T>(of);
  const auto along = [&](const Rational& length) { return from_rational<T>(length / flat.frame()) * (B0 - A0); };
  return {A0, A0 + along(flat.A0A), B0 + along(flat.B0B), B0};
}

// Angular velocities of crank, coupler and rocker in one of the motions that leave a change point, up to a common
// factor: ω₂ = 1, or ω₂ = 0 and ω₃ = ω₄ = 1 when crank and frame cover each other and A rests on B₀.
template <class T>
struct ChangePointMotion {
  T omega_2, omega_3, omega_4;
  // While the crank turns counter-clockwise B crosses the line A B₀ and leaves to this side of A -> B₀, having come
  // from the other. None when A rests on B₀.
  std::optional<Side> leaves_to;
};

// Both motions; where both have a side, first the one that leaves to the left.
//
// With r₂, r₃, r₄, d for the signed lengths, the closure r₂ e^{iθ₂} + r₃ e^{iθ₃} - r₄ e^{iθ₄} = d, differentiated at
// θ = 0, says across the line, to the first order, and along it, to the second:
//   r₂ ω₂ + r₃ ω₃ - r₄ ω₄ = 0,      r₂ ω₂² + r₃ ω₃² - r₄ ω₄² = 0
// (along the line the first order is empty: this is what makes the position singular, and why ω₃, ω₄ satisfy a
// quadratic). Without ω₃, and with r₃ = d + r₄ - r₂, for ω₂ = 1:
//   r₄ (r₂ - d) ω₄² - 2 r₂ r₄ ω₄ + r₂ (r₄ + d) = 0,      a quarter of the discriminant: S² = r₂ r₃ r₄ d
// The side: d/dt of (AB₀ x AB) is r₃ r₄ (ω₄ - ω₃) = ∓S for ω₄ = (r₂ r₄ ± S)/(r₄ (r₂ - d)): never zero, so in both
// motions B crosses the line, and staying on one side would be a kink.
//
// Throws Impossible when r₂ r₃ r₄ < 0: one link is then as long as the other three together, and nothing moves.
template <class T>
std::array<ChangePointMotion<T>, 2> change_point_motions(const FlatPosition& flat) {
  const Rational r2 = flat.A0A, r3 = flat.AB, r4 = flat.B0B, d = flat.frame();
  const Rational S2 = r2 * r3 * r4 * d;
  if (S2 <= 0)
    throw Impossible("the linkage is stretched and cannot move", "il meccanismo è disteso e non può muoversi");
  const auto with_rocker = [&](const T& omega_4, Side leaves_to) {
    const T omega_3 = from_rational<T>(r4 / r3) * omega_4 - from_rational<T>(r2 / r3);
    return ChangePointMotion<T>{T(1), omega_3, omega_4, leaves_to};
  };
  if (r2 == d) {  // A on B₀, r₃ = r₄: the quadratic has one root less, which is ω₄ infinite against ω₂
    const T omega_4 = from_rational<T>((r4 + d) / (2 * r4));
    return {with_rocker(omega_4, r2 * r3 > 0 ? Side::left : Side::right),
            ChangePointMotion<T>{T(0), T(1), T(1), std::nullopt}};
  }
  const Rational divisor = r4 * (r2 - d);
  const T middle = from_rational<T>(r2 * r4 / divisor);
  const T half = root(from_rational<T>(S2 / (divisor * divisor)));
  const T left = divisor > 0 ? middle - half : middle + half, right = divisor > 0 ? middle + half : middle - half;
  return {with_rocker(left, Side::left), with_rocker(right, Side::right)};
}

}  // namespace epure::geometry
