#include "exercises/friction-efficiency/rod_in_collar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/numbers/climb.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::friction_efficiency {
namespace {

using geometry::Deep;
using geometry::Sign;
using geometry::square;

// c[0] + c[1] μ + c[2] μ² + c[3] μ³.
template <class T>
using Cubic = std::array<T, 4>;

// The cubic that has the room's values at 0, 1, -1 and 2.
template <class T>
Cubic<T> cubic_of_room(const Wedge& of) {
  const auto room = [&](int mu) { return room_of_rod<T>(of, T(mu)); };
  const T at_0 = room(0), at_1 = room(1), at_minus_1 = room(-1), half = geometry::from_rational<T>(Rational(1, 2));
  const T even = half * (at_1 + at_minus_1) - at_0, odd = half * (at_1 - at_minus_1);
  const T third = geometry::from_rational<T>(Rational(1, 6)) * (room(2) - at_0 - T(4) * even - T(2) * odd);
  return {at_0, odd - third, even, third};
}

template <class T>
T discriminant(const Cubic<T>& of) {
  const auto& [d, c, b, a] = of;
  return T(18) * a * b * c * d - T(4) * b * b * b * d + b * b * c * c - T(4) * a * c * c * c - T(27) * a * a * d * d;
}

double log2_of(const Deep& x) { return std::log2(geometry::enclosure(x).value); }

[[noreturn]] void throw_undecided() {
  throw geometry::Undecided("how many friction angles jam the rod",
                            "quanti angoli d'attrito facciano impuntare l'asta");
}
bool is_positive(const Deep& x) {
  const Sign sign = geometry::sign(x);
  if (sign == Sign::undecided) throw_undecided();
  return sign == Sign::positive;
}

// Where the cubic is lowest to the right of its highest place; throws Impossible when there is none, or at no
// friction.
Deep lowest_place(const Cubic<Deep>& of) {
  const Deep bend = square(of[2]) - Deep(3) * of[3] * of[1];
  if (!is_positive(bend)) throw geometry::Impossible(never_jams);
  const Deep lowest = (geometry::root(bend) - of[2]) / (Deep(3) * of[3]);
  if (!is_positive(lowest)) throw geometry::Impossible(never_jams);
  return lowest;
}

}  // namespace

bool jams_at_one_coefficient(const Wedge& of) {
  const geometry::Decision decision = geometry::decide([&]<class T>() { return discriminant(cubic_of_room<T>(of)); });
  if (decision.sign == Sign::undecided) throw_undecided();
  return decision.sign == Sign::zero;
}

// Of the two places where the room ends, the first. From no friction on it is sought upwards; where it is nearer to
// the lowest place, downwards from there, as there the cubic is too flat to be told from zero.
Deep jamming_coefficient(const Wedge& of) {
  const Cubic<Deep> cubic = cubic_of_room<Deep>(of);
  const Deep lowest = lowest_place(cubic), least = room_of_rod<Deep>(of, lowest);
  const Sign room = geometry::sign(least);
  if (room == Sign::positive) throw geometry::Impossible(never_jams);
  if (room != Sign::negative) {
    if (jams_at_one_coefficient(of)) return lowest;
    throw_undecided();
  }
  const double farthest = log2_of(lowest) - 0.5;
  if (geometry::sign(room_of_rod<Deep>(of, lowest / Deep(2))) == Sign::negative) {
    // |c0| / (|c0| + the greatest of the others): nearer to 0 no cubic has a zero.
    Deep others(0);
    for (std::size_t i = 1; i < cubic.size(); ++i) others = others + geometry::absolute(cubic[i]);
    const double nearest = log2_of(cubic[0] / (cubic[0] + others));
    return geometry::increasing_root([&](const Deep& mu) { return -room_of_rod<Deep>(of, mu); },
                                     std::min(nearest, farthest) - 1, farthest);
  }
  // room(lowest - x) <= least + (c2 + 3 c3 lowest) x².
  const double nearest = log2_of(-least / (cubic[2] + Deep(3) * cubic[3] * lowest)) / 2;
  return lowest - geometry::increasing_root([&](const Deep& x) { return room_of_rod<Deep>(of, lowest - x); },
                                            std::min(nearest, farthest) - 1, farthest);
}

}  // namespace epure::friction_efficiency
