// All zeros of a function of a direction over a full turn: found, proved, and then enclosed as narrowly as asked.
//
// A function of a turn is anything callable as
//   template <class X> X operator()(const Vector<X>& direction) const
// with a unit vector, as a locus is (see trace.h): the rocker's angular acceleration, by the direction of the crank.
#pragma once

#include "geometry/curves/trace.h"
#include "geometry/curves/turn_arcs.h"
#include "geometry/numbers/climb.h"
#include "geometry/numbers/enclosure.h"

#include <functional>
#include <vector>

namespace epure::geometry {

// In `t` on arc `arc` of turn_arcs.h the function vanishes exactly once, and crosses zero.
struct Zero {
  int arc;
  Bounded t;
  Bounded slope;  // encloses the derivative by t, over t and as far again beyond its ends; does not contain zero
  Vector<Bounded> direction() const { return direction_on_turn(arc, t); }
};

struct Zeros {
  std::vector<Zero> found;  // in the order of the turn, which begins at the direction (3/5, -4/5)
  // Parts of the turn where the function does not exist, as far as that was proved.
  std::vector<Gap> absent;
  // Parts on which it stayed open whether there are zeros, and how many: where the function touches zero without
  // crossing it, is zero throughout, or ends.
  std::vector<Gap> open;
};

// The function and its derivative by t, enclosed over the t of an arc, as the search calls it: so that the search is
// compiled once.
using TurnFunction = std::function<BoundedTangent(int arc, const Bounded& t)>;

// The turn is halved, piece by piece. A piece is settled when the function is proved not to vanish on it, not to
// exist on it, or to be monotone and of unlike signs at the ends; interval Newton steps then narrow the zero down.
// What is not settled after `most_looks` pieces is open: nothing is dropped.
Zeros search_zeros(const TurnFunction& function, int most_looks);

namespace searching {

// A simple zero takes some dozen looks; near the change point of a linkage, the more the nearer, some ten thousand; a
// stretch on which nothing can be decided would take any number. A fraction of a second in intervals of doubles, a
// second with many bits.
inline constexpr int most_looks = 65536, most_deep_looks = 4096;
inline constexpr long bits = 256;

inline double total(const std::vector<Gap>& gaps) {
  double sum = 0;
  for (const Gap& gap : gaps) sum += gap.width;
  return sum;
}

}  // namespace searching

// All zeros of the function. Searched for in intervals of doubles; where these leave something open (their roundings
// drown it), with many bits.
template <class Function>
Zeros zeros(const Function& function) {
  Zeros found = search_zeros(
      [&](int arc, const Bounded& t) { return function(direction_on_turn(arc, BoundedTangent::parameter(t))); },
      searching::most_looks);
  if (found.open.empty()) return found;
  const Arithmetic<Deep> scope(searching::bits);
  Zeros deeper = search_zeros(
      [&](int arc, const Bounded& t) {
        const DeepTangent value = function(direction_on_turn(arc, DeepTangent::parameter(Deep::from_bounded(t))));
        BoundedTangent enclosed(to_bounded(value.c[0]));
        enclosed.c[1] = to_bounded(value.c[1]);
        return enclosed;
      },
      searching::most_deep_looks);
  return searching::total(deeper.open) < searching::total(found.open) ? deeper : found;
}

// The parameter t of a zero of `function` with the bits of the scope that is open. As narrow as these bits allow: the
// zero lies in m - f(m)/slope for every m near it (mean value theorem), which each step makes narrower by as much as
// the slope is known. The function must be the one the zero was found with.
Deep refined_parameter(const std::function<Deep(const Vector<Deep>&)>& function, const Zero& zero);

// The direction of a zero in the number T: Fast in the middle of the enclosure; Bounded the enclosure; Deep as above.
// For the exact numbers, which cannot construct it, throws Undecided, unless it lies on an axis.
template <class T, class Function>
Vector<T> direction_of(const Function& function, const Zero& zero) {
  if constexpr (std::is_same_v<T, Fast>) {
    return direction_on_turn(zero.arc, enclosure(zero.t).value);
  } else if constexpr (std::is_same_v<T, Bounded>) {
    return zero.direction();
  } else if constexpr (std::is_same_v<T, Deep>) {
    return direction_on_turn(zero.arc, refined_parameter(function, zero));
  } else {
    if (!zero.t.is_point())
      throw Undecided("an exact number for a zero that is only enclosed",
                      "un numero esatto per uno zero di cui è noto solo l'intervallo");
    return direction_on_turn(zero.arc, T(static_cast<int>(zero.t.inf())));
  }
}

// A zero that may lie on an axis of the plane (in the middle of its arc) is asked for there exactly: where the exact
// numbers prove it, its t becomes 0, and its direction is known to every number.
template <class Function>
void place_on_axes(const Function& function, Zeros& zeros) {
  for (Zero& zero : zeros.found) {
    if (!zero.t.do_overlap(Bounded(0))) continue;
    const Decision there = decide([&]<class T>() -> T { return function(direction_on_turn(zero.arc, T(0))); });
    if (there.sign == Sign::zero) zero.t = Bounded(0);
  }
}

}  // namespace epure::geometry
