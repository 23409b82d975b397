// Equations solved with proof: a step of Krawczyk's on boxes, and enclosures of what linear ones have for solution.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/analytic/inverse.h"
#include "geometry/analytic/joints/equations.h"

namespace epure::geometry::analytic::joints {

// A matrix beside the inverse of the equations' one.
template <class T>
class Preconditioner {
 public:
  explicit Preconditioner(const std::vector<Equation<T>>& rows) {
    std::vector<Column<T>> J(rows.size(), Column<T>(rows.size(), T(0)));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [column, slope] : rows[i].slopes) J[i][static_cast<std::size_t>(column)] += slope;
    std::optional<std::vector<Column<T>>> near = inverse_near(J);
    if (!near)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
    Y_ = std::move(*near);
  }
  Column<T> times(const Column<T>& b) const {
    Column<T> product;
    for (const Column<T>& row : Y_) {
      T sum(0);
      for (std::size_t k = 0; k < b.size(); ++k) sum += row[k] * b[k];
      product.push_back(sum);
    }
    return product;
  }
  // 1 - Y J, row by row.
  std::vector<Column<T>> defect(const std::vector<Equation<T>>& rows) const {
    std::vector<Column<T>> E(Y_.size(), Column<T>(Y_.size(), T(0)));
    for (std::size_t i = 0; i < Y_.size(); ++i) {
      E[i][i] = T(1);
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (const auto& [column, slope] : rows[k].slopes) E[i][static_cast<std::size_t>(column)] -= Y_[i][k] * slope;
    }
    return E;
  }

 private:
  std::vector<Column<T>> Y_;
};

template <class T>
T size_of(const T& x) {
  return root(square(x));
}
// At least twice the upper end of what is not negative; an enclosure may reach down to zero.
template <class T>
T twice_the_most(const T& x) {
  return midpoint(T(4) * x);
}
template <class T>
bool may_be_zero_all(const Column<T>& b) {
  for (const T& x : b)
    if (const Sign decided = sign(x); decided == Sign::positive || decided == Sign::negative) return false;
  return true;
}
template <class T>
Column<T> residuals(const std::vector<Equation<T>>& rows) {
  Column<T> all;
  for (const Equation<T>& row : rows) all.push_back(row.residual);
  return all;
}

// As many equations as unknowns, at a place or over a box.
template <class T>
using System = std::function<std::vector<Equation<T>>(const Column<T>&)>;

// Each step with the inverse at its place, until what is left of the equations cannot be told from zero, or a step is
// no shorter than the one before, and so but rounding.
template <class T>
Column<T> refined(const System<T>& system, Column<T> q) {
  constexpr int most_steps = 40;
  std::optional<T> last;
  for (int k = 0; k < most_steps; ++k) {
    const std::vector<Equation<T>> rows = system(q);
    if (may_be_zero_all(residuals(rows))) break;
    const Column<T> step = Preconditioner<T>(rows).times(residuals(rows));
    T length(0);
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = midpoint(q[i] - step[i]);
      length = midpoint(length + size_of(step[i]));
    }
    if (last && sign(*last - length) != Sign::positive) break;
    last = length;
  }
  return q;
}

// E x for x in ±size.
template <class T>
T spread(const Column<T>& row_of_E, const Column<T>& size) {
  T sum(0);
  for (std::size_t k = 0; k < size.size(); ++k) sum += size_of(row_of_E[k]) * size[k];
  return sum;
}

// Whatever place of the box the slopes are of, they are independent.
template <class T>
void demand_regular(const Preconditioner<T>& Y, const std::vector<Equation<T>>& rows) {
  const Column<T> ones(rows.size(), T(1));
  for (const Column<T>& row : Y.defect(rows))
    if (sign(T(1) - spread(row, ones)) != Sign::positive)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
}

// Krawczyk: K = m - Y Φ(m) + (1 - Y J(box)) (box - m). Where K lies inside the box there is a solution in it, and one
// only where the equations are independent all over it, which `solved` demands.
// (Krawczyk 1969; Neumaier, Interval Methods for Systems of Equations, section 5.1.) Of those `given` nothing is
// sought: the system takes them for what they are, whatever stands in m, and so does what is said of the others.
template <class T>
Column<T> proved_box(const System<T>& system, const Preconditioner<T>& Y, const Column<T>& m,
                     const std::vector<bool>& given) {
  Column<T> newton = Y.times(residuals(system(m)));
  for (std::size_t i = 0; i < m.size(); ++i)
    if (given[i]) newton[i] = T(0);
  Column<T> radius;
  for (const T& x : newton) radius.push_back(twice_the_most(size_of(x)));
  constexpr int most_boxes = 30;
  for (int k = 0; k < most_boxes; ++k) {
    Column<T> box;
    for (std::size_t i = 0; i < m.size(); ++i) box.push_back(widened(m[i], radius[i]));
    const std::vector<Column<T>> E = Y.defect(system(box));
    Column<T> needed, inside;
    bool is_inside = true;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const T around = given[i] ? T(0) : spread(E[i], radius);
      needed.push_back(size_of(newton[i]) + around);
      // An unknown that stands right already, whatever the others are, has a box without width.
      is_inside = is_inside && (sign(radius[i] - needed[i]) == Sign::positive || sign(needed[i]) == Sign::zero);
      inside.push_back(widened(m[i] - newton[i], around));
    }
    if (is_inside) return inside;
    for (std::size_t i = 0; i < m.size(); ++i) radius[i] = twice_the_most(needed[i]);
  }
  throw Undecided("no box around the last iterate is proved to hold one solution of the equations of all joints",
                  "di nessun intorno dell'ultima iterata è dimostrato che contenga una soluzione delle equazioni di "
                  "tutti i vincoli");
}

// Which unknowns are zero whatever the slopes are, by which of the right sides are: each equation takes an unknown of
// its own; where it and all that it hangs on, by the unknowns in it, have a right side of zero, those unknowns are in
// no more equations than they are, and so all zero.
template <class T>
class ZeroByStructure {
 public:
  explicit ZeroByStructure(const std::vector<Equation<T>>& rows)
      : takes_(rows.size(), none), taken_by_(rows.size(), none) {
    for (const Equation<T>& row : rows) {
      std::vector<std::size_t>& in = unknowns_.emplace_back();
      for (const auto& [column, slope] : row.slopes)
        if (sign(slope) != Sign::zero) in.push_back(static_cast<std::size_t>(column));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<bool> is_asked(rows.size());
      takes_one(i, is_asked);
    }
  }
  std::vector<bool> of(const Column<T>& b) const {
    std::vector<bool> all(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      std::vector<bool> hangs_on(b.size());
      if (takes_[i] != none && is_idle(i, b, hangs_on)) all[takes_[i]] = true;
    }
    return all;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool takes_one(std::size_t row, std::vector<bool>& is_asked) {
    for (const std::size_t unknown : unknowns_[row]) {
      if (is_asked[unknown]) continue;
      is_asked[unknown] = true;
      if (taken_by_[unknown] != none && !takes_one(taken_by_[unknown], is_asked)) continue;
      taken_by_[unknown] = row;
      takes_[row] = unknown;
      return true;
    }
    return false;
  }
  bool is_idle(std::size_t row, const Column<T>& b, std::vector<bool>& hangs_on) const {
    hangs_on[row] = true;
    return sign(b[row]) == Sign::zero &&
           std::all_of(unknowns_[row].begin(), unknowns_[row].end(), [&](std::size_t unknown) {
             const std::size_t next = taken_by_[unknown];
             return next != none && (hangs_on[next] || is_idle(next, b, hangs_on));
           });
  }

  std::vector<std::vector<std::size_t>> unknowns_;
  std::vector<std::size_t> takes_, taken_by_;
};

// J x = b, enclosed: x0 by the preconditioner until that brings no more, then what may be left.
template <class T>
Column<T> solved(const std::vector<Equation<T>>& rows, const Preconditioner<T>& Y, const Column<T>& b) {
  const std::vector<Column<T>> E = Y.defect(rows);
  Column<T> x;
  for (const T& y : Y.times(b)) x.push_back(midpoint(y));
  const auto left = [&] {
    Column<T> r = b;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [column, slope] : rows[i].slopes) r[i] -= slope * x[static_cast<std::size_t>(column)];
    return Y.times(r);
  };
  Column<T> step = left();
  constexpr int most_steps = 400;
  for (int k = 0; k < most_steps && !may_be_zero_all(step); ++k) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = midpoint(x[i] + step[i]);
    step = left();
  }
  // |x - x0| <= |step| + |E| |x - x0|, and each row of |E| has a sum below a half.
  T most(0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (sign(from_rational<T>(Rational(1, 2)) - spread(E[i], Column<T>(x.size(), T(1)))) != Sign::positive)
      throw Undecided("whether the equations of all joints are independent",
                      "se le equazioni di tutti i vincoli siano indipendenti");
    most += T(2) * size_of(step[i]);
  }
  const Column<T> off(x.size(), most);
  const std::vector<bool> is_zero = ZeroByStructure<T>(rows).of(b);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = is_zero[i] ? T(0) : widened(x[i] + step[i], spread(E[i], off));
  return x;
}

}  // namespace epure::geometry::analytic::joints
