// The least acceleration of a cam's follower over the whole turn, by interval branch and bound: the lift runs on
// truncated Taylor series over intervals of the cam's angle, parts of the turn that cannot hold the least are left
// out, until what remains is one interval in which the acceleration is convex. In it the least is where its
// derivative is zero.
#pragma once

#include <functional>

#include "geometry/numbers/accurate.h"

namespace epure::geometry {

class FollowerSweep {
 public:
  // The follower of an eccentric disc: guide along y at x = e, eccentricity r, l the sum of the radii of disc and
  // roller; r + |e| < l. Where the parts that remain do not become one, whoever asks is told Undecided.
  FollowerSweep(const Rational& r, const Rational& l, const Rational& e);

  // The angle in [0, 2π), and the second derivative of the lift by it. Undecided on exact numbers.
  template <class T>
  T angle() const {
    return on_balls<T>([this] { return angle_now(); });
  }
  template <class T>
  T least() const {
    return on_balls<T>([this] { return least_now(); });
  }

 private:
  Deep angle_now() const;
  Deep least_now() const;

  Rational r_, l_, e_;
  std::function<Deep()> found_;  // the angle, a turn less where it is negative
};

}  // namespace epure::geometry
