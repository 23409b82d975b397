// Sections of beams in closed form, by what is cut away from a full rectangle: the second route to
// statics/section.h, which puts rectangles together.
//
// Any one unit of length throughout.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// Two flanges of width b and a web between them, all walls s thick; H over all. 0 < 2s < H, s <= b.
struct DoubleT {
  Rational H, b, s;

  Rational h() const { return H - 2 * s; }  // of the web
  Rational area() const { return b * H - (b - s) * h(); }
  Rational J_x() const { return (b * H * H * H - (b - s) * h() * h() * h()) / 12; }
  // The band between the flanges is cut out, and the web put back.
  Rational J_y() const { return (b * b * b * (H - h()) + s * s * s * h()) / 12; }
  // J_x over the distance of the outer fibre.
  Rational W_x() const { return (b * H * H * H - (b - s) * h() * h() * h()) / (6 * H); }
  // About x: of what is above the centroid, and of a flange.
  Rational S_half() const { return (b * H * H - (b - s) * h() * h()) / 8; }
  Rational S_flange() const { return b * (H * H - h() * h()) / 8; }
};

// Moment of inertia of a circle about a diameter: A²/4π.
template <class T>
T circle_J(const Rational& diameter) {
  const T area = pi<T>() * from_rational<T>(diameter * diameter / 4);
  return quotient(square(area), T(4) * pi<T>());
}

// Of a rectangle about the axis through its centre, parallel to its width: by integration of y² from the edges.
inline Rational rectangle_J(const Rational& width, const Rational& height) {
  const Rational y = height / 2;
  return 2 * width * y * y * y / 3;
}

}  // namespace epure::geometry::analytic
