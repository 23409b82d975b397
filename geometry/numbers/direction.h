// Sine, cosine and arc tangent at doubles, enclosed with doubles alone. They need an Arithmetic<Bounded>.
#pragma once

#include "geometry/numbers/number.h"

#include <optional>

namespace epure::geometry {

// near + rest, where rest is small beside near, or near is 0: so about twice as many digits as a double has.
struct Split {
  double near = 0;
  Bounded rest = 0;

  Split operator-() const { return {-near, -rest}; }
  Bounded value() const { return Bounded(near) + rest; }
};

// An angle as a number of right angles and what is left, an eighth of a turn at most (and a little).
struct SplitAngle {
  long right_angles = 0;
  Split left;
};

struct SplitDirection {
  Split cosine, sine;
};

// Of an angle in radians. None when it is too large to be split with doubles, or too small to be squared.
std::optional<SplitAngle> split_angle(double radians);
// Of a fraction of a turn.
std::optional<SplitAngle> split_angle(const Turn& turn);

SplitDirection direction(const SplitAngle& angle);

// The angle of (x, y), (0, 0) excepted, in (-π, π]. None when x or y is too large or too small to be multiplied.
std::optional<Bounded> split_arc_tangent(double y, double x);

// Around π/2; the lower end is the double nearest to it.
Bounded right_angle();

}  // namespace epure::geometry
