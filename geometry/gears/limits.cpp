#include "geometry/gears/limits.h"

#include <functional>

namespace epure::geometry {
namespace {

bool is_room(const Decision& room) {
  if (room.sign == Sign::undecided) throw Undecided(room.reason);
  return room.sign != Sign::negative;
}

// The smallest whole n >= 1 for which there is room, when there is room for every larger one too.
long smallest_with_room(const std::function<Decision(long)>& room) {
  constexpr long most = 1L << 50;
  long with = 1;
  while (!is_room(room(with))) {
    if (with >= most) throw Undecided("more than 10¹⁵ teeth", "più di 10¹⁵ denti");
    with *= 2;
  }
  long without = with / 2;
  while (with - without > 1) {
    const long middle = without + (with - without) / 2;
    (is_room(room(middle)) ? with : without) = middle;
  }
  return with;
}

// |O2T1|² - r_tip2² over m² (of a ring its negative) when wheel 1 has z teeth and the ratio is as given.
template <class T>
T room_for_mate(const PairData& of, long z) {
  const PressureAngle<T> alpha = pressure_angle<T>(of.alpha);
  if (of.kind == PairKind::rack) return depth_of_tangent_point<T>(of, z, of.x1) - from_rational<T>(of.ha - of.k);
  const int outwards = of.kind == PairKind::internal ? -1 : 1;
  const Rational ratio = Rational(of.z2) / Rational(of.z1), r2 = ratio * Rational(z) / 2;
  const Rational r_tip2 = r2 + of.x2 + outwards * (of.ha - of.k);
  const PressureAngle<T> alpha_w =
      working_pressure_angle(alpha, Rational(shift_per_tooth(of) * Rational(of.z1) / Rational(z)));
  if (r_tip2 <= 0) return T(outwards);  // no wheel 2 is left to interfere; of a ring all is tooth
  // O2T1 is the hypotenuse over r_b2 and T1T2 = (r_w2 ± r_w1) sin α_w.
  const Rational centres = r2 + outwards * Rational(z) / 2;
  const T squares = square(from_rational<T>(r2) * alpha.cosine) +
                    square(from_rational<T>(centres) * alpha.cosine * alpha_w.tangent) -
                    from_rational<T>(r_tip2 * r_tip2);
  return outwards > 0 ? squares : -squares;
}

}  // namespace

Decision room_above_undercut(const PairData& of, int wheel) {
  return decide([&]<class T>() -> T {
    return depth_of_tangent_point<T>(of, teeth_of(of, wheel), shift_of(of, wheel)) - from_rational<T>(of.ha);
  });
}

Decision room_above_cutter_edge(const PairData& of, int wheel) {
  return decide([&]<class T>() -> T {
    return depth_of_tangent_point<T>(of, teeth_of(of, wheel), shift_of(of, wheel)) - depth_of_straight_edge<T>(of);
  });
}

long minimum_teeth_against_rack(const PairData& of, const Rational& x) {
  return smallest_with_room([&](long z) {
    return decide([&]<class T>() -> T { return depth_of_tangent_point<T>(of, z, x) - from_rational<T>(of.ha); });
  });
}

// That there is room for every larger number too: with w = 1/z and t = tan α_w, room over z²/4 is, external,
//   F(w) = (u + 1)² cos²α t² - u² sin²α - 4 u h w - 4 h² w²,   F(0) > 0.
// From inv α_w = inv α + c w follows d(t²)/dw = 2 c (1 + t²)/t and the second derivative 2 c² (1 - 1/t⁴): F is
// concave where α_w <= 45°, and everywhere when |x1 + x2| sin α <= h; then F >= 0 holds on an interval from 0. In a
// ring,
//   F(w) = u² sin²α - 4 u h w + 4 h² w² - (u - 1)² cos²α t²
// is convex where α_w <= 45°, positive at 0 and negative at u/2h, where r_tip2 vanishes.
long minimum_teeth_of_pinion(const PairData& of) {
  return smallest_with_room([&](long z) -> Decision {
    try {
      return decide([&]<class T>() -> T { return room_for_mate<T>(of, z); });
    } catch (const Impossible& no_working_angle) {
      return {.sign = Sign::negative, .reason = no_working_angle.words()};
    }
  });
}

// The squares of what is compared: T1 lies on the same side of T2 as A.
Decision room_in_approach(const PairData& of) {
  return decide([&]<class T>() -> T {
    const GearPair<T> pair = gear_pair<T>(of);
    if (!pair.O2) return from_rational<T>(rack_lines(of).tip) - pair.T1.y;
    const T beyond = length_squared(pair.T1 - *pair.O2) - square(pair.wheel2->r_tip);
    return of.kind == PairKind::internal ? -beyond : beyond;
  });
}

Decision room_in_recess(const PairData& of) {
  if (of.kind != PairKind::external) return {.sign = Sign::positive};
  return decide([&]<class T>() -> T {
    const GearPair<T> pair = gear_pair<T>(of);
    return length_squared(*pair.T2 - pair.O1) - square(pair.wheel1.r_tip);
  });
}

}  // namespace epure::geometry
