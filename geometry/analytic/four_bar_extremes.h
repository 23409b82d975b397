// Where the rocker's speed is stationary while the crank turns steadily, by the closure equation.
//
// The diagonal A B0, of square s, cuts the linkage into two triangles, and the rocker's angle is a sum of one angle
// of each at B0. Differentiated by the crank's angle, with d² = |A0B0|²,
//   ω₄/ω₂ = (s + A0A² - d² - σ (s + AB² - B0B²) √(E/F)) / 2s,
//   E = 4 A0A² d² - (A0A² + d² - s)²,   F = 4 AB² B0B² - (AB² + B0B² - s)²,
// E and F being 16 squared areas of the triangles, and σ = 1 when crank and rocker's hinge B lie on different sides:
// the crank on the right of A0 -> B0 and B on the left of A -> B0, or the other way round; else -1. Its derivative by
// s vanishes where
//   σ M = 2 (d² - A0A²) F √(E F),   M = 2 (B0B² - AB²) E F + (s + AB² - B0B²) s (E'F - E F').
// Squared, this is a polynomial of degree eight; s = 0 is a double root of it and no position of the crank.
#pragma once

#include "geometry/analytic/four_bar_formulas.h"
#include "geometry/numbers/polynomial.h"

#include <vector>

namespace epure::geometry::analytic {

// Of the squared diagonal s.
template <class X>
struct DiagonalTriangles {
  X s, crank_area, rocker_area;  // E and F
  X beyond;                      // s + AB² - B0B²
  X M, twice_lead;               // the latter 2 (d² - A0A²)

  DiagonalTriangles(const FourBar& g, const X& square) : s(square) {
    const Rational a2 = g.A0A * g.A0A, b2 = g.AB * g.AB, c2 = g.B0B * g.B0B, d2 = g.squared_frame();
    const X crank_side = from_rational<X>(a2 + d2) - s, rocker_side = from_rational<X>(b2 + c2) - s;
    crank_area = from_rational<X>(4 * a2 * d2) - crank_side * crank_side;
    rocker_area = from_rational<X>(4 * b2 * c2) - rocker_side * rocker_side;
    beyond = s + from_rational<X>(b2 - c2);
    M = from_rational<X>(2 * (c2 - b2)) * crank_area * rocker_area +
        X(2) * beyond * s * (crank_side * rocker_area - crank_area * rocker_side);
    twice_lead = from_rational<X>(2 * (d2 - a2));
  }

  X squared_condition() const {
    return M * M - twice_lead * twice_lead * rocker_area * rocker_area * rocker_area * crank_area;
  }
};

// A direction of the crank in which the ratio is stationary.
class StationaryCrank {
 public:
  StationaryCrank(const FourBar& g, Branch branch, RealRoot squared_diagonal);

  // A unit vector. Of the exact numbers only where the squared diagonal is rational, else throws Undecided.
  template <class T>
  Complex<T> direction() const {
    const Rational d2 = g_.squared_frame();
    const T along = squared_diagonal_.into<T>(
        [&]<class X>(const X& s) -> X { return from_rational<X>(g_.A0A * g_.A0A + d2) - s; });
    const T across = root(
        squared_diagonal_.into<T>([&]<class X>(const X& s) -> X { return DiagonalTriangles<X>(g_, s).crank_area; }));
    const T scale = from_rational<T>(1 / (2 * g_.A0A * d2));
    return g_.B0<T>() * Complex<T>{scale * along, scale * (crank_is_ == Side::left ? across : -across)};
  }

  // ω₄/ω₂, for Deep.
  Deep ratio() const;

 private:
  FourBar g_;
  RealRoot squared_diagonal_;
  Side crank_is_;  // of A0 -> B0
  bool is_apart_;  // σ = 1
};

// All of a branch, in the order of the ratio, the least first. For a linkage whose crank turns fully and that has no
// change point: its diagonal is never zero, nor its frame as long as its crank, and both areas stay positive, but for
// the first where the crank lies on the frame.
std::vector<StationaryCrank> stationary_cranks(const FourBar& g, Branch branch);

}  // namespace epure::geometry::analytic
