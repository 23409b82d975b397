// A half turn of the crank, and of what drives it: mean torque less the resisting one,
//   M - C sin α - K sin 2α,   0 <= α <= π,   0 < M < C,   C, K >= 0 (or C <= M, where it may have no zero).
// C sin α + K sin 2α rises to its greatest value, before π/2, and then stays below M once it has passed it: so there
// are two zeros, or none.
#pragma once

#include <optional>
#include <vector>

#include "geometry/numbers/numbers.h"

namespace epure::pump_flywheel {

using geometry::Deep;

struct HalfTurn {
  Deep M, C, K;

  bool has_zeros() const;  // throws Undecided
};

// Where the strips of the graphical integration end: in suction, in sixths; in delivery, from its start, at the
// angles of greatest and least energy and at quarters between them.
template <class T>
std::vector<T> strips_of_suction(const T& half_turn) {
  std::vector<T> ends;
  for (int i = 0; i <= 6; ++i) ends.push_back(T(i) * half_turn / T(6));
  return ends;
}
template <class T>
std::vector<T> strips_of_delivery(const T& first, const T& second, const T& half_turn) {
  const T quarter = (second - first) / T(4);
  return {T(0), first, first + quarter, first + T(2) * quarter, second - quarter, second, half_turn};
}

// By the torque itself, the zeros proved by its signs, and its primitive.
namespace closed {
Deep first_zero(const HalfTurn& of);
Deep second_zero(const HalfTurn& of);
Deep energy(const HalfTurn& of, const Deep& to);  // gained from 0
// As much at most a chord of the energy over one of these strips is off: width²/8 times the steepest slope of the
// torque there.
Deep chords_off_at_most(const HalfTurn& of, const std::vector<Deep>& ends);
}  // namespace closed

// By the zeros of the polynomial in tan(α/2), and quadrature.
namespace summed {
Deep first_zero(const HalfTurn& of);
Deep second_zero(const HalfTurn& of);
Deep energy(const HalfTurn& of, const Deep& from, const Deep& to);
Deep chords_off_at_most(const HalfTurn& of, const std::vector<Deep>& ends);
// The integral of sin α cos kα over the half turn, and of sin² α.
Deep sine_times_cosine(int k);
Deep sine_squared();
}  // namespace summed

}  // namespace epure::pump_flywheel
