// The motion by two routes that share no formula: as sums of powers, and by quadrature and differences that are exact
// for polynomials of these degrees. And the numerical tables by two: step after step as the formulas say, and in
// closed form.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exercises/point-mass/problem.h"

namespace epure::point_mass {

using geometry::analytic::Powers;

// By the names of the kinds.
template <class T>
struct Instant {
  T F, a, v, q, E, s;
};

struct ByPowers {
  Powers F, a, v, q, E, s;
  explicit ByPowers(const Problem& of)
      : F(of.force()), a(1 / of.m * F), v(a.integral()), q(F.integral()), E((F * v).integral()), s(v.integral()) {}

  template <class T>
  Instant<T> at(const T& t) const {
    return {F.at(t), a.at(t), v.at(t), q.at(t), E.at(t), s.at(t)};
  }
};

// Velocity and momentum by Simpson's rule, space by Boole's on Cauchy's integral ∫(t - τ) a dτ, the energy from the
// momentum; acceleration and force, of given instants, as second difference of the space by five points.
struct ByQuadrature {
  const Problem& of;

  template <class T>
  T force(const T& t) const {
    const auto number = geometry::from_rational<T>;
    return t * (number(of.C) + t * (number(of.B) + t * number(of.A)));
  }
  template <class T>
  T impulse(const T& from, const T& to) const {
    const T middle = geometry::from_rational<T>(Rational(1, 2)) * (from + to);
    return geometry::from_rational<T>(Rational(1, 6)) * (to - from) *
           (force(from) + T(4) * force(middle) + force(to));
  }
  template <class T>
  T momentum(const T& t) const {
    return impulse(T(0), t);
  }
  template <class T>
  T energy(const T& t) const {
    const T q = momentum(t);
    return geometry::from_rational<T>(Rational(1) / (2 * of.m)) * q * q;
  }
  template <class T>
  T velocity(const T& t) const {
    return geometry::from_rational<T>(1 / of.m) * momentum(t);
  }
  template <class T>
  T space(const T& t) const {
    constexpr std::array<int, 5> weights{7, 32, 12, 32, 7};
    T sum(0);
    for (int i = 0; i < 5; ++i)
      sum += T(weights[i] * (4 - i)) * force<T>(geometry::from_rational<T>(Rational(i, 4)) * t);
    return geometry::from_rational<T>(Rational(1, 360) / of.m) * t * t * sum;
  }
  Rational acceleration(const Rational& t) const;
  // Of the area under the accelerations, ∫τ a dτ/∫a dτ; the second is not zero.
  Rational centroid(const Rational& t) const;

  Instant<Rational> at(const Rational& t) const;
};

// Velocity and space of a table, at a row.
struct TableRow {
  Rational v, s;
};

class BySteps {
 public:
  explicit BySteps(const Problem& of);
  TableRow at(const std::string& method, long row) const;

 private:
  struct Column {
    std::vector<Rational> v, s;
  };
  Column bezout_, simpson_;
};

// What the recursions come to, row by row.
std::vector<Rational> by_bezout(const std::vector<Rational>& ordinates, const Rational& dt);
std::vector<Rational> by_simpson(const std::vector<Rational>& ordinates, const Rational& dt);

// Bezout's sums by Euler and Maclaurin. Simpson's sums of the cubic acceleration are its integral, but in the odd
// rows, which all keep what the parabola of the first row misses; of the quartic velocity they are off by its
// derivatives, and by the velocities' own errors with the weights of their rows.
class InClosedForm {
 public:
  explicit InClosedForm(const Problem& of);
  TableRow at(const std::string& method, long row) const;

 private:
  Rational dt_;
  Powers v_, s_, v_bezout_, s_bezout_;
  Rational third_, fourth_;  // derivatives of the velocity: at zero, and everywhere
};

}  // namespace epure::point_mass
