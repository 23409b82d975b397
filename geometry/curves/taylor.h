// A truncated Taylor series as a number: a construction that runs on it yields its derivatives along with its result.
//
// c[k] is the k-th derivative by the parameter divided by k!, for k = 0..N. When T encloses (Bounded) and the
// parameter is an interval, c[k] contains that quotient at every parameter of the interval: each rule below is the
// exact rule for the coefficients at one parameter, carried out in T.
//
// The sign of a series is the sign of c[0], the value itself: a construction decides by values, not by slopes. Over
// an interval the decision, once taken, holds at every parameter of it, so one formula is valid throughout and may be
// differentiated. In particular `zero` says that the value vanishes identically.
//
// from_rational and pi are there for the series named at the end; constants of a turn are made in T and lifted by the
// constructor. cosine_of_angle and sine_of_angle where T has them.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

template <class T, std::size_t N>
struct Taylor {
  std::array<T, N + 1> c;

  Taylor(int constant = 0) : Taylor(T(constant)) {}
  explicit Taylor(const T& constant) {
    c.fill(T(0));
    c[0] = constant;
  }

  // The parameter itself, at `at`.
  static Taylor parameter(const T& at) {
    Taylor t(at);
    if constexpr (N > 0) t.c[1] = T(1);
    return t;
  }

  Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
  Taylor& operator-=(const Taylor& b) { return *this = *this - b; }
  Taylor& operator*=(const Taylor& b) { return *this = *this * b; }
  Taylor& operator/=(const Taylor& b) { return *this = *this / b; }

  friend Taylor operator+(Taylor a, const Taylor& b) {
    for (std::size_t k = 0; k <= N; ++k) a.c[k] = a.c[k] + b.c[k];
    return a;
  }
  friend Taylor operator-(Taylor a, const Taylor& b) {
    for (std::size_t k = 0; k <= N; ++k) a.c[k] = a.c[k] - b.c[k];
    return a;
  }
  Taylor operator-() const {
    Taylor negative;
    for (std::size_t k = 0; k <= N; ++k) negative.c[k] = -c[k];
    return negative;
  }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (std::size_t k = 0; k <= N; ++k)
      for (std::size_t i = 0; i <= k; ++i) product.c[k] = product.c[k] + a.c[i] * b.c[k - i];
    return product;
  }
  // As quotient: an enclosing T cannot tell a harmless divisor from zero in any other way.
  friend Taylor operator/(const Taylor& a, const Taylor& b) { return quotient(a, b); }

  // a/b by comparing coefficients in q b = a. Throws Undecided unless the value of b is proved different from zero.
  friend Taylor quotient(const Taylor& a, const Taylor& b) {
    Taylor q;
    for (std::size_t k = 0; k <= N; ++k) {
      T rest = a.c[k];
      for (std::size_t i = 1; i <= k; ++i) rest = rest - b.c[i] * q.c[k - i];
      q.c[k] = quotient(rest, b.c[0]);
    }
    return q;
  }

  // Each product of two different coefficients once, doubled, and squares as squares: narrower than a * a.
  friend Taylor square(const Taylor& a) {
    Taylor s;
    for (std::size_t k = 0; k <= N; ++k) s.c[k] = a.twice_mixed_products(k, 0) + a.middle_square(k);
    return s;
  }

  // The positive root y, by comparing coefficients in y y = x. Throws Undecided unless the value of x is proved
  // positive: at zero a root has no derivative.
  friend Taylor root(const Taylor& x) {
    if (sign(x.c[0]) != Sign::positive)
      throw Undecided("the derivative of a root that may vanish", "la derivata di una radice che può annullarsi");
    Taylor y(root(x.c[0]));
    const T twice = T(2) * y.c[0];
    for (std::size_t k = 1; k <= N; ++k) {
      const T inner = y.twice_mixed_products(k, 1) + y.middle_square(k);
      y.c[k] = quotient(x.c[k] - inner, twice);
    }
    return y;
  }

  friend Taylor cosine_of_angle(const Taylor& angle) { return direction(angle).cosine; }
  friend Taylor sine_of_angle(const Taylor& angle) { return direction(angle).sine; }

  friend Sign sign(const Taylor& a) { return sign(a.c[0]); }

 private:
  // By comparing coefficients in cos' = -u' sin, sin' = u' cos for the angle u.
  struct Direction;
  static Direction direction(const Taylor& u) {
    Direction d{Taylor(cosine_of_angle(u.c[0])), Taylor(sine_of_angle(u.c[0]))};
    for (std::size_t k = 1; k <= N; ++k) {
      T of_cosine(0), of_sine(0);  // the coefficients of u' sin and u' cos
      for (std::size_t i = 1; i <= k; ++i) {
        const T slope = T(static_cast<int>(i)) * u.c[i];
        of_cosine = of_cosine + slope * d.sine.c[k - i];
        of_sine = of_sine + slope * d.cosine.c[k - i];
      }
      d.cosine.c[k] = quotient(-of_cosine, T(static_cast<int>(k)));
      d.sine.c[k] = quotient(of_sine, T(static_cast<int>(k)));
    }
    return d;
  }

  // 2 Σ c[i] c[k-i] over first <= i < k-i.
  T twice_mixed_products(std::size_t k, std::size_t first) const {
    T sum(0);
    for (std::size_t i = first; 2 * i < k; ++i) sum = sum + c[i] * c[k - i];
    return T(2) * sum;
  }
  T middle_square(std::size_t k) const { return k % 2 == 0 ? square(c[k / 2]) : T(0); }
};

template <class T, std::size_t N>
struct Taylor<T, N>::Direction {
  Taylor cosine, sine;
};

// What the tracer runs on: what a cubic misses needs the fourth derivative, and to enclose that narrowly the fifth;
// its end points need the first.
using BoundedSeries = Taylor<Bounded, 5>;
using BoundedTangent = Taylor<Bounded, 1>;
using FastSeries = Taylor<Fast, 5>;
// Where doubles lose too many digits (zeros.h).
using DeepTangent = Taylor<Deep, 1>;

template <>
inline BoundedSeries from_rational<BoundedSeries>(const Rational& value) {
  return BoundedSeries(from_rational<Bounded>(value));
}
template <>
inline BoundedTangent from_rational<BoundedTangent>(const Rational& value) {
  return BoundedTangent(from_rational<Bounded>(value));
}
template <>
inline DeepTangent from_rational<DeepTangent>(const Rational& value) {
  return DeepTangent(from_rational<Deep>(value));
}
template <>
inline FastSeries from_rational<FastSeries>(const Rational& value) {
  return FastSeries(from_rational<Fast>(value));
}

template <>
inline BoundedSeries pi<BoundedSeries>() {
  return BoundedSeries(pi<Bounded>());
}
template <>
inline BoundedTangent pi<BoundedTangent>() {
  return BoundedTangent(pi<Bounded>());
}
template <>
inline DeepTangent pi<DeepTangent>() {
  return DeepTangent(pi<Deep>());
}
template <>
inline FastSeries pi<FastSeries>() {
  return FastSeries(pi<Fast>());
}

}  // namespace epure::geometry
