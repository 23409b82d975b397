// Where a pendulum is and how fast it turns.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// θ counter-clockwise from the downward vertical, in (-π, π).
struct SwingState {
  Deep sine_of_half, cosine_of_half, rate;  // of θ/2; θ'

  Deep angle() const { return Deep(2) * arc_tangent(sine_of_half, cosine_of_half); }
  Deep sine() const { return Deep(2) * sine_of_half * cosine_of_half; }
  Deep cosine() const { return square(cosine_of_half) - square(sine_of_half); }
};

}  // namespace epure::geometry
