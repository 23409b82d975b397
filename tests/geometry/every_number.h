// One test body for all five numbers: their scopes, and what it means that a result is the expected one.
#pragma once

#include "geometry/constructions/cycle.h"
#include "geometry/constructions/transport.h"
#include "geometry/constructions/vector_polygon.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace epure::tests {

using namespace geometry;

// Deep takes its bits.
template <class T>
struct Scope {
  Arithmetic<T> arithmetic{};
};
template <>
struct Scope<Deep> {
  Arithmetic<Deep> arithmetic{128};
};

template <class T>
T number(int p, int q = 1) {
  return from_rational<T>(Rational(p, q));
}

// x is what was expected, as surely as its number can say it: Exact and Calcium prove it; the enclosing numbers
// contain it and are narrow; Fast is off by a thousand roundings at most. `size` is the size of the figure.
inline bool is(Fast x, Fast expected, double size = 10) { return std::abs(x - expected) <= 1e-13 * size; }

inline bool is_narrow_zero(const Enclosure& difference, double most) {
  return -most <= difference.lower && difference.lower <= 0 && 0 <= difference.upper && difference.upper <= most;
}
inline bool is(const Bounded& x, const Bounded& expected, double size = 10) {
  return is_narrow_zero(enclosure(x - expected), 1e-13 * size);
}
inline bool is(const Deep& x, const Deep& expected, double size = 10) {
  return is_narrow_zero(enclosure(x - expected), 1e-34 * size);
}
inline bool is(const Exact& x, const Exact& expected, double = 10) { return sign(x - expected) == Sign::zero; }
inline bool is(const Calcium& x, const Calcium& expected, double = 10) { return sign(x - expected) == Sign::zero; }

template <class T>
bool is(const Point<T>& P, const Point<T>& expected, double size = 10) {
  return is(P.x, expected.x, size) && is(P.y, expected.y, size);
}
template <class T>
bool is(const Vector<T>& v, const Vector<T>& expected, double size = 10) {
  return is(v.x, expected.x, size) && is(v.y, expected.y, size);
}

// u runs the way of v, not against it.
template <class T>
bool runs_along(const Vector<T>& u, const Vector<T>& v) {
  return is(cross(u, v), T(0), 100) && sign(dot(u, v)) == Sign::positive;
}

template <class T>
bool is_on(const Point<T>& P, const Line<T>& l, double size = 10) {
  return is(l.a * P.x + l.b * P.y + l.c, T(0), size * size);
}

// The start of a random test: EPURE_SEED=n repeats a run or tries another.
inline std::uint64_t seed() {
  const char* chosen = std::getenv("EPURE_SEED");
  return chosen ? std::strtoull(chosen, nullptr, 10) : 20091012;
}

// Random input whose sizes lie on a logarithmic scale, where the hard cases are.
class Random {
 public:
  explicit Random(std::uint64_t start) : source_(start) {}
  int up_to(int n) { return static_cast<int>(source_() % static_cast<std::uint64_t>(n)); }
  // p/q in [-1, 1], never 0.
  Rational fraction() {
    const int p = 1 + up_to(999);
    return Rational(up_to(2) == 0 ? p : -p, 999);
  }
  Rational power_of_ten(int from, int to) {
    const int exponent = from + up_to(to - from + 1);
    Rational power(1);
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? Rational(Rational(1) / power) : power;
  }

 private:
  std::mt19937_64 source_;
};

}  // namespace epure::tests
