// Where a number that goes with an angle is greatest and least over a whole turn of it.
//
// Proved: its derivative is enclosed over intervals until in each it has no zero, or one: where the second derivative
// keeps its sign and the first has unlike signs at the ends. That one is then closed in by interval Newton steps.
#pragma once

#include <functional>
#include <vector>

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// The number at an angle, or over an interval of angles, and its first two derivatives by the angle.
template <class T>
struct OverAngle {
  T value, first, second;
};
// Both throw what the number itself does. `is_angle`: it is one, in radians, known but for whole turns; those are
// added that make it go on without jumps, with its least value in (-π, π].
struct NumberOverAngle {
  std::function<OverAngle<Bounded>(const Bounded& angle)> bounded;
  std::function<OverAngle<Deep>(const Deep& angle)> deep;
  bool is_angle = false;
};

// Where it is greater than anywhere nearby, or less.
template <class T>
struct Stationary {
  T angle;  // radians, from 0 up to a turn; its enclosure may begin below 0
  T value;
};
struct StationaryPlace {
  Stationary<Bounded> at;
  bool is_greatest;
};

// There is no number at this angle, and so no greatest.
struct NotEverywhere : Impossible {
  NotEverywhere(const Words& why, double angle_) : Impossible(why), angle(angle_) {}
  double angle;  // radians
};

// In the order of the angles from some angle on, greatest and least in turn. In a scope of Arithmetic<Bounded>.
// Throws NotEverywhere; Impossible where it is the same everywhere, or grows or falls without end (an angle);
// Undecided where very many looks do not tell.
std::vector<StationaryPlace> stationary_places(const NumberOverAngle& number);

// Those that may be the greatest of all, or the least.
std::vector<StationaryPlace> foremost(const std::vector<StationaryPlace>& all, bool is_greatest);

// The same place, with as many bits as the scope of Arithmetic<Deep> has.
Stationary<Deep> closed_in(const NumberOverAngle& number, const StationaryPlace& place);

}  // namespace epure::geometry
