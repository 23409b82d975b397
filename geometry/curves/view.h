// Where a piece of a locus lies with respect to the frame: proved statements about enclosures of projective points.
#pragma once

#include "geometry/curves/trace.h"

namespace epure::geometry {

// Needs an Arithmetic<Bounded> scope.
class View {
 public:
  // A frame without an inside is a caller's mistake.
  explicit View(const Frame& frame);

  // True when every point enclosed, also one at infinity, lies outside the frame. False says nothing.
  bool is_outside(const ProjectivePoint<Bounded>& P) const;
  // True when every point enclosed lies in the frame or within its width beside it and its height above or below it.
  bool is_near(const Point<Bounded>& P) const;

 private:
  Point<Bounded> centre_;
  Vector<Bounded> half_;  // of width and height
};

}  // namespace epure::geometry
