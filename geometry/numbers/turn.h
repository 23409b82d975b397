// Exact facts about rational turns that every number shares.
#pragma once

#include "geometry/numbers/number.h"

#include <optional>

namespace epure::geometry {

// The same direction as a fraction in [0, 1).
Turn within_one_turn(const Turn& turn);

// The turn whose cosine is this turn's sine: sin t = cos(t - 1/4 turn).
Turn turn_for_sine(const Turn& turn);

// The cosine when it is rational: for a rational turn only 0, ±1/2 and ±1 can be (Niven's theorem), and nullopt means
// that the cosine is irrational.
std::optional<Rational> rational_cosine(const Turn& turn);

}  // namespace epure::geometry
