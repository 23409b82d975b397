// De Saint-Venant's torsion constant of a full rectangle by Prandtl's double sine series (the membrane's own
// vibrations), of which the sum across the thickness is known: the second route to statics/rectangle_torsion.h.
//
//   J_t = 256/π⁶ · a³b³ Σ Σ 1/(m²n² (m²b² + n²a²))            m, n = 1, 3, 5 ...
//       = 32/π⁴ · a³b Σ (1/m⁴) (1 - tanh(y m)/(y m)),         y = π b/(2a)
//
// Every term is positive; those of statics/ run along the other side, and are taken from 1/3.
#pragma once

#include "geometry/numbers/accurate.h"

namespace epure::geometry::analytic {

Deep torsion_series(const Rational& a, const Rational& b);

template <class T>
T torsion_series(const Rational& a, const Rational& b) {
  return on_balls<T>([&] { return torsion_series(a, b); });
}

}  // namespace epure::geometry::analytic
