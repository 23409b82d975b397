// What is given of the body on a straight line: its mass, the force F = A t³ + B t² + C t, three instants, the step
// of the tables, and the strips and scales of the graphical integration. SI units.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/powers.h"
#include "geometry/numbers/polynomial.h"

namespace epure::point_mass {

std::vector<GivenSpec> given_specs();

struct Problem {
  Rational m, A, B, C;
  std::array<Rational, 3> t;
  Rational dt, strip;
  Rational cm_t, cm_a, cm_v, cm_s;  // what a centimetre of the diagrams is worth

  // Throws BadGivens, in one sentence: instants out of order, a step that does not divide the interval, tables or
  // diagrams too long.
  explicit Problem(const Givens& givens);

  const Rational& end() const { return t[2]; }
  bool has_force() const { return A != 0 || B != 0 || C != 0; }
  geometry::analytic::Powers force() const { return {0, C, B, A}; }
  long rows() const;                                  // of the tables, without the first
  std::optional<long> row(const Rational& at) const;  // none between two rows, or beyond the end
  std::vector<Rational> strip_ends() const;
};

// Where a·t² + b·t + c is zero inside of the interval, and is falling or rising there; none: nowhere.
struct Crossing {
  geometry::RealRoot at;
  bool falls;
};
struct Quadratic {
  Rational a, b, c;
  std::optional<Crossing> falling, rising;
  Quadratic(const Rational& a, const Rational& b, const Rational& c, const Rational& end);

  // By the formula, for a crossing that exists.
  template <class T>
  T surd(bool falls) const {
    using geometry::from_rational;
    const T slope = geometry::root(from_rational<T>(b * b - 4 * a * c));  // of the parabola there, but for the sign
    const T minus_b = from_rational<T>(-b), signed_slope = falls ? -slope : slope;
    return a != 0 ? geometry::quotient(minus_b + signed_slope, from_rational<T>(2 * a))
                  : geometry::quotient(from_rational<T>(2 * c), minus_b - signed_slope);
  }
};

}  // namespace epure::point_mass
