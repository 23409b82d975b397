// A linkage at one place: where its links and points are, and how they move. Metres, radians, seconds;
// counter-clockwise positive.
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "geometry/mechanisms/dyad.h"

namespace epure::geometry {

// The numbers that have the sine of an angle.
template <class T>
concept NumberWithSines = requires(const T& angle) {
  { sine_of_angle(angle) } -> std::same_as<T>;
};

namespace linkages {
// u v and u v* as complex numbers.
template <class T>
Vector<T> times(const Vector<T>& u, const Vector<T>& v) {
  return v.x * u + v.y * quarter_turn(u);
}
template <class T>
Vector<T> times_mirrored(const Vector<T>& u, const Vector<T>& v) {
  return v.x * u - v.y * quarter_turn(u);
}
}  // namespace linkages

// Where a link is: the origin of its axes, and its x axis, a unit vector.
template <class T>
struct PlacedLink {
  Point<T> O;
  Vector<T> x;
  // Of a wheel that rolls on a line, on numbers without sines: where it points is not known, nor is it needed.
  bool is_axis_known = true;

  const Vector<T>& axis() const {
    if (!is_axis_known)
      throw Undecided("which way a wheel points that has rolled: its angle is a length over a radius",
                      "dove punti una ruota che ha rotolato: il suo angolo è una lunghezza su un raggio");
    return x;
  }

  Vector<T> turned(const Vector<T>& own) const { return linkages::times(x, own); }
  Point<T> at(const Vector<T>& own) const { return O + turned(own); }
};

// One of the drives, elsewhere than the linkage says: its link's x axis in this direction, turned so many times from
// +x (wheels may make a part of its turns), or its point or cylinder so far along.
template <class T>
struct DriveAt {
  int drive;
  Vector<T> direction;
  T way;
  int times = 1;
};

// A step near its limit: the root of from_limit, which is not found there of a place that is not known exactly.
template <class T>
struct RoomTold {
  std::size_t step;
  T root_of_room;
};

// What is found of a linkage, and how.
//   links   the axes of every link; a point of several links is where the last of them to be placed puts it
//   points  of the axes only those of links that have lines; a point is where the first of its links puts it, and
//           enclosures are narrower
enum class Wanted { links, points };

template <class T>
struct LinkagePosition {
  std::vector<PlacedLink<T>> links;
  std::vector<Point<T>> points;
  std::optional<DriveAt<T>> elsewhere = {};
  Wanted wanted = Wanted::links;
};

// The two polygons of a step that has any.
template <class T>
struct StepPolygons {
  std::optional<DyadVelocity<T>> velocity;
  std::optional<DyadAcceleration<T>> acceleration;
};

template <class T>
struct LinkageMotion {
  std::vector<PlaneMotion<T>> links;
  std::vector<Pin<T>> points;
  std::vector<StepPolygons<T>> steps;  // as the steps
};

// A group of links does not close, or is at a limit: which step.
struct NotClosed : Impossible {
  NotClosed(std::size_t step_, const Words& why) : Impossible(why), step(step_) {}
  std::size_t step;
};

// A drive's rates as numbers: rad/s and rad/s², or m/s and m/s².
template <class T>
struct DriveRates {
  T first, second;
};

}  // namespace epure::geometry
