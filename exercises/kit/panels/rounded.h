// From the numbers of a construction to the doubles of a drawing: found with many bits, rounded once.
#pragma once

#include <optional>

#include "exercises/kit/panels/plot.h"
#include "geometry/numbers/deep.h"

namespace epure {

// A double inside the ball: zero when that may pass for it (zero_for_drawing.h), else the nearest to the middle.
// Throws Undecided when it may be zero, and may as well not.
double to_double(const geometry::Deep& x);
Place to_double(const geometry::Point<geometry::Deep>& P);
Arrow2 to_double(const geometry::Vector<geometry::Deep>& v);

// None for a point at infinity, or one of which the bits cannot tell.
std::optional<Place> to_double(const geometry::ProjectivePoint<geometry::Deep>& P);

// A circle, or the line it has become; neither when every point or none satisfies it.
struct DrawnCycle {
  std::optional<Place> centre = {};  // of a circle
  double radius = 0;
  // The point nearest to the origin and the direction there: of the line, or of a circle too large to tell from one.
  std::optional<Place> on_line = {};
  Arrow2 along{0, 0};
};
DrawnCycle to_double(const geometry::Cycle<geometry::Deep>& cycle);

// Runs `find`, which works on Deep, at the precision drawings are made with: 256 bits, and up to 2048 while these
// leave something undecided.
template <class Find>
auto deeply(const Find& find) {
  constexpr long most_bits = 2048;
  for (long bits = 256;; bits *= 2) {
    const geometry::Arithmetic<geometry::Deep> scope(bits);
    try {
      return find();
    } catch (const geometry::Undecided&) {
      if (bits == most_bits) throw;
    }
  }
}

}  // namespace epure
