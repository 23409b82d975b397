// Four-bar linkages for tests of their special positions.
#pragma once

#include "geometry/mechanisms/four_bar_positions.h"
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"

namespace epure::tests {

inline FourBarLengths on_x(const Rational& A0A, const Rational& AB, const Rational& B0B, const Rational& A0B0) {
  return {A0A, AB, B0B, A0B0, 0};
}

// 10^-exponent.
inline Rational part(int exponent) { return Random(0).power_of_ten(-exponent, -exponent); }

inline FourBarLengths four_bar_lengths_of(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {given("A0A"), given("AB"), given("B0B"), given("x_B0"), given("y_B0")};
}

// The bars have their lengths; B is on the side of A -> B₀ that is named, or on that line.
template <class T>
bool is_closed(const FourBarLengths& of, const FourBar<T>& at) {
  const auto has_length = [](const Vector<T>& v, const Rational& length) {
    return is(length_squared(v), from_rational<T>(length * length), 1e3);
  };
  return has_length(at.A - at.A0, of.A0A) && has_length(at.B - at.A, of.AB) && has_length(at.B - at.B0, of.B0B);
}
template <class T>
bool is_on_branch(const FourBar<T>& at, std::optional<Side> branch) {
  if (!branch) return is(cross(at.B0 - at.A, at.B - at.A), T(0), 1e3);
  return side(at.B, line(at.A, at.B0)) == (*branch == Side::left ? Sign::positive : Sign::negative);
}

}  // namespace epure::tests
