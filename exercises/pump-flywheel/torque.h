// A half turn of the crank, and of what drives it: mean torque less the resisting one,
//   M - C sin α - K sin 2α,   0 <= α <= π,   0 < M < C,   C, K >= 0 (or C <= M, where it may have no zero).
// C sin α + K sin 2α rises to its greatest value, before π/2, and then stays below M once it has passed it: so there
// are two zeros, or none.
#pragma once

#include <optional>

#include "geometry/numbers/numbers.h"

namespace epure::pump_flywheel {

using geometry::Deep;

struct HalfTurn {
  Deep M, C, K;

  bool has_zeros() const;  // throws Undecided
};

// By the torque itself, the zeros proved by its signs, and its primitive.
namespace closed {
Deep first_zero(const HalfTurn& of);
Deep second_zero(const HalfTurn& of);
Deep energy(const HalfTurn& of, const Deep& to);  // gained from 0
}  // namespace closed

// By the zeros of the polynomial in tan(α/2), and quadrature.
namespace summed {
Deep first_zero(const HalfTurn& of);
Deep second_zero(const HalfTurn& of);
Deep energy(const HalfTurn& of, const Deep& from, const Deep& to);
// The integral of sin α cos kα over the half turn, and of sin² α.
Deep sine_times_cosine(int k);
Deep sine_squared();
}  // namespace summed

}  // namespace epure::pump_flywheel
