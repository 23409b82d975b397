// Polynomials with rational coefficients as sums of powers, and closed forms of what quadrature by equal strips makes
// of them: Euler and Maclaurin's series, which ends where the derivatives do.
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include "geometry/numbers/numbers.h"
#include "geometry/numbers/polynomial.h"

namespace epure::geometry::analytic {

class Powers {
 public:
  // Coefficients of 1, x, x², ...
  Powers(std::initializer_list<Rational> coefficients) : of_(coefficients) {}
  explicit Powers(std::vector<Rational> coefficients) : of_(std::move(coefficients)) {}

  template <class T>
  T at(const T& x) const {
    T sum(0);
    for (auto coefficient = of_.rbegin(); coefficient != of_.rend(); ++coefficient)
      sum = sum * x + from_rational<T>(*coefficient);
    return sum;
  }
  Powers derivative() const {
    std::vector<Rational> all;
    for (std::size_t i = 1; i < of_.size(); ++i) all.push_back(of_[i] * Rational(static_cast<int>(i)));
    return Powers(std::move(all));
  }
  // From zero.
  Powers integral() const {
    std::vector<Rational> all{0};
    for (std::size_t i = 0; i < of_.size(); ++i) all.push_back(of_[i] / Rational(static_cast<int>(i) + 1));
    return Powers(std::move(all));
  }

  // Of strips of width h from zero to x, as many as there are: the sum of trapezoids, and that of rectangles as high
  // as the ordinates in the middles; for polynomials of degree six at most.
  Powers trapezoids(const Rational& h) const {
    return with_ends(h, Rational(1, 12), Rational(-1, 720), Rational(1, 30240));
  }
  Powers middles(const Rational& h) const {
    return with_ends(h, Rational(-1, 24), Rational(7, 5760), Rational(-31, 967680));
  }

  friend Powers operator+(const Powers& a, const Powers& b) {
    std::vector<Rational> all(std::max(a.of_.size(), b.of_.size()), Rational(0));
    for (std::size_t i = 0; i < a.of_.size(); ++i) all[i] += a.of_[i];
    for (std::size_t i = 0; i < b.of_.size(); ++i) all[i] += b.of_[i];
    return Powers(std::move(all));
  }
  friend Powers operator*(const Powers& a, const Powers& b) {
    std::vector<Rational> all(a.of_.size() + b.of_.size(), Rational(0));
    for (std::size_t i = 0; i < a.of_.size(); ++i)
      for (std::size_t k = 0; k < b.of_.size(); ++k) all[i + k] += a.of_[i] * b.of_[k];
    return Powers(std::move(all));
  }
  friend Powers operator*(const Rational& factor, const Powers& a) { return Powers{factor} * a; }
  friend Powers operator-(const Powers& a, const Powers& b) { return a + Rational(-1) * b; }

 private:
  Powers from_zero() const { return *this - Powers{at(Rational(0))}; }
  // The integral, and the first, third and fifth derivative between the ends with these factors.
  Powers with_ends(const Rational& h, const Rational& first, const Rational& third, const Rational& fifth) const {
    const Powers d1 = derivative(), d3 = d1.derivative().derivative(), d5 = d3.derivative().derivative();
    const Rational h2 = h * h;
    return integral() + first * h2 * d1.from_zero() + third * h2 * h2 * d3.from_zero() +
           fifth * h2 * h2 * h2 * d5.from_zero();
  }

  std::vector<Rational> of_;
};

}  // namespace epure::geometry::analytic
