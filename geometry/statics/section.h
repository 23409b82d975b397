// Sections of beams as rectangles put together: area and moments of inertia by Steiner's theorem, static moments of
// their parts. The axes are the principal ones through the centroid, x across and y upwards.
//
// Any one unit of length throughout. Everything is rational in its input, but for the circle's π.
#pragma once

#include <vector>

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// A rectangle with its sides along the axes and its centre on y, so far above x.
template <class T>
struct Strip {
  T width, height, above;
};

template <class T>
struct SectionProperties {
  T area, J_x, J_y;
  T J_p() const { return J_x + J_y; }
};

// That x passes through the centroid of all is the caller's promise.
template <class T>
SectionProperties<T> properties(const std::vector<Strip<T>>& strips) {
  const T twelve = T(12);
  SectionProperties<T> all{T(0), T(0), T(0)};
  for (const Strip<T>& strip : strips) {
    const T area = strip.width * strip.height;
    all.area += area;
    all.J_x += quotient(area * square(strip.height), twelve) + area * square(strip.above);
    all.J_y += quotient(area * square(strip.width), twelve);
  }
  return all;
}

// About x, of a part of a section.
template <class T>
T static_moment(const std::vector<Strip<T>>& part) {
  T moment(0);
  for (const Strip<T>& strip : part) moment += strip.width * strip.height * strip.above;
  return moment;
}

template <class T>
SectionProperties<T> rectangle(const T& width, const T& height) {
  return properties<T>({{width, height, T(0)}});
}

// π d²/4, and π d⁴/64 about every diameter.
template <class T>
SectionProperties<T> circle(const T& diameter) {
  const T area = quotient(pi<T>() * square(diameter), T(4));
  const T J = quotient(area * square(diameter), T(16));
  return {area, J, J};
}

// Two flanges of width b and a web between them, all walls s thick; H over all. 0 < 2s < H and s <= b are the
// caller's promise.
template <class T>
struct DoubleT {
  T H, b, s;

  T web_height() const { return H - s - s; }
  Strip<T> flange() const { return {b, s, half(H - s)}; }  // the upper one
  std::vector<Strip<T>> strips() const { return {flange(), {s, web_height(), T(0)}, {b, s, -flange().above}}; }
  // Above the centroid: a flange and half of the web.
  std::vector<Strip<T>> upper_half() const { return {flange(), {s, half(web_height()), half(half(web_height()))}}; }

 private:
  static T half(const T& x) { return from_rational<T>(Rational(1, 2)) * x; }
};

}  // namespace epure::geometry
