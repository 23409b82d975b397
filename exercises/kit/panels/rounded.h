// From the numbers of a construction to the doubles of a drawing: found with many bits, rounded once.
#pragma once

#include <optional>

#include "exercises/kit/panels/plot.h"
#include "geometry/numbers/deep.h"

namespace epure {

// A double inside the ball: zero when it may be zero, else the nearest to the middle.
double to_double(const geometry::Deep& x);
Place to_double(const geometry::Point<geometry::Deep>& P);
Arrow2 to_double(const geometry::Vector<geometry::Deep>& v);

// None for a point at infinity, or one of which 256 bits cannot tell.
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

// Runs `find`, which works on Deep, at the precision drawings are made with.
template <class Find>
auto deeply(const Find& find) {
  const geometry::Arithmetic<geometry::Deep> bits(256);
  return find();
}

}  // namespace epure
