// De Saint-Venant's torsion constant J_t of a full rectangle: its twist is M/(G J_t).
#pragma once

#include "geometry/numbers/accurate.h"

namespace epure::geometry {

// Beyond this ratio of its sides the series takes more terms than it is worth.
inline constexpr int slenderest_rectangle = 1000;

// The stress function as a cosine series across `thickness`: with x = π width/(2 thickness)
//   J_t = width·thickness³ (1/3 - 64/π⁵ · thickness/width · Σ tanh(k x)/k⁵),  k = 1, 3, 5 ...
Deep rectangle_torsion(const Rational& width, const Rational& thickness);

template <class T>
T rectangle_torsion(const Rational& width, const Rational& thickness) {
  return on_balls<T>([&] { return rectangle_torsion(width, thickness); });
}

}  // namespace epure::geometry
