// A plane truss by the equations of all its joints at once: at each, the pulls of its bars, what its support answers
// and its load have the sum zero along x and along y. 2j linear equations in the b bars and three components of
// reaction, by Gauss's elimination; no joint is solved before another, and no figure is drawn.
//
// The unknown of a bar is its force for each unit of its length, so that no length, and no root, is in the equations.
// Metres, newtons; tension positive.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/analytic/equilibrium.h"

namespace epure::geometry::analytic {

template <class T>
class TrussEquations {
 public:
  explicit TrussEquations(std::vector<Complex<T>> joints)
      : joints_(std::move(joints)), loads_(joints_.size(), Complex<T>{T(0), T(0)}) {}

  void load(std::size_t joint, const Complex<T>& f) { loads_[joint] = loads_[joint] + f; }
  void bar(std::size_t i, std::size_t k) {
    const Complex<T> pull = joints_[k] - joints_[i];
    unknowns_.push_back({{i, pull}, {k, T(-1) * pull}});
  }
  // A force of unknown size along u.
  void support(std::size_t joint, const Complex<T>& u) { unknowns_.push_back({{joint, u}}); }

  // The unknowns in the order they were described: of a bar its force over its length, of a support its force over
  // the length of u. Throws Impossible when there is not one answer to any load: unstable, or undetermined.
  std::vector<T> solve() const {
    const std::size_t rows = 2 * joints_.size();
    if (unknowns_.size() != rows)
      throw Impossible("the joints have not as many equations of equilibrium as there are unknown forces",
                       "le equazioni di equilibrio dei nodi non sono tante quante le forze incognite");
    std::vector<std::vector<T>> M(rows, std::vector<T>(rows, T(0)));
    std::vector<T> r(rows, T(0));
    for (std::size_t c = 0; c < rows; ++c)
      for (const auto& [joint, f] : unknowns_[c]) {
        M[2 * joint][c] = f.re;
        M[2 * joint + 1][c] = f.im;
      }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      r[2 * i] = -loads_[i].re;
      r[2 * i + 1] = -loads_[i].im;
    }
    return solve_linear(M, r);
  }

 private:
  struct AtJoint {
    std::size_t joint;
    Complex<T> f;
  };

  std::vector<Complex<T>> joints_, loads_;
  std::vector<std::vector<AtJoint>> unknowns_;
};

}  // namespace epure::geometry::analytic
