// A mechanism in equilibrium, and its motion, by one system of linear equations: for each body two sums of components
// and one of moments about the origin, all bodies at once, by Gauss's elimination. No line of action is met with
// another, and no body solved before another.
//
// The same joints that give the forces bind the velocities: a hinge lets two bodies have one velocity in its place, a
// guide keeps them from turning against each other and from leaving it, a contact keeps them from moving along its
// force. What remains free is driven by the effort.
//
// Body 1 is the frame. Metres, newtons; counter-clockwise positive.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/analytic/complex.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry::analytic {

// M x = r. Any proved nonzero entry serves as a pivot, so that a singular system is told from one that only looks it.
// Throws Impossible when it is singular, Undecided when the number cannot tell.
template <class T>
std::vector<T> solve_linear(std::vector<std::vector<T>> M, std::vector<T> r) {
  const std::size_t n = r.size();
  std::vector<std::size_t> unknown_of_row(n), rows_left;
  std::vector<bool> is_used(n, false);
  for (std::size_t row = 0; row < n; ++row) rows_left.push_back(row);
  const auto is_nonzero = [](const T& x) {
    const Sign decided = sign(x);
    return decided == Sign::positive || decided == Sign::negative;
  };
  const auto is_zero = [](const T& x) { return sign(x) == Sign::zero; };
  std::vector<std::size_t> order;
  while (!rows_left.empty()) {
    bool is_open = false, has_pivot = false;
    for (std::size_t k = 0; k < rows_left.size() && !has_pivot; ++k)
      for (std::size_t c = 0; c < n && !has_pivot; ++c) {
        if (is_used[c] || is_zero(M[rows_left[k]][c])) continue;
        if (!is_nonzero(M[rows_left[k]][c])) {
          is_open = true;
          continue;
        }
        has_pivot = is_used[c] = true;
        unknown_of_row[rows_left[k]] = c;
        order.push_back(rows_left[k]);
        rows_left.erase(rows_left.begin() + static_cast<std::ptrdiff_t>(k));
      }
    if (!has_pivot) {
      if (is_open)
        throw Undecided("whether the equations of equilibrium are independent",
                        "se le equazioni di equilibrio siano indipendenti");
      throw Impossible("the equations of equilibrium are not independent",
                       "le equazioni di equilibrio non sono indipendenti");
    }
    const std::size_t pivot = order.back(), column = unknown_of_row[pivot];
    for (const std::size_t row : rows_left) {
      if (is_zero(M[row][column])) continue;
      const T factor = quotient(M[row][column], M[pivot][column]);
      for (std::size_t c = 0; c < n; ++c)
        if (!is_zero(M[pivot][c])) M[row][c] = M[row][c] - factor * M[pivot][c];
      M[row][column] = T(0);
      r[row] = r[row] - factor * r[pivot];
    }
  }
  std::vector<T> x(n, T(0));
  for (auto row = order.rbegin(); row != order.rend(); ++row) {
    T left = r[*row];
    for (std::size_t c = 0; c < n; ++c)
      if (c != unknown_of_row[*row] && !is_zero(M[*row][c])) left = left - M[*row][c] * x[c];
    x[unknown_of_row[*row]] = quotient(left, M[*row][unknown_of_row[*row]]);
  }
  return x;
}

template <class T>
class Equilibrium {
 public:
  explicit Equilibrium(int bodies) : bodies_(bodies) {}

  void load(const std::string& name, int j, const T& x, const T& y, const T& fx, const T& fy) {
    loads_.insert_or_assign(name, Load{j, wrench({x, y}, {fx, fy})});
  }
  void effort(const std::string& name, int j, const T& x, const T& y, const T& ux, const T& uy) {
    contact(name, 0, j, x, y, ux, uy);
  }
  void contact(const std::string& name, int i, int j, const T& x, const T& y, const T& ux, const T& uy) {
    unknowns_.push_back({name, i, j, wrench({x, y}, {ux, uy})});
  }
  void hinge(const std::string& name, int i, int j, const T& x, const T& y) {
    unknowns_.push_back({name, i, j, wrench({x, y}, {T(1), T(0)})});
    unknowns_.push_back({name, i, j, wrench({x, y}, {T(0), T(1)})});
  }
  void guide(const std::string& name, int i, int j, const T& ux, const T& uy) {
    unknowns_.push_back({name, i, j, wrench({T(0), T(0)}, {ux, uy})});
    unknowns_.push_back({name, i, j, {T(0), T(0), T(1)}});
  }
  void couple(const std::string& name, int j) { unknowns_.push_back({name, 0, j, {T(0), T(0), T(1)}}); }

  // The equations do not need to know what is known of a line.
  void directed(const std::string&, const Angle&) {}
  void through(const std::string&, const std::string&) {}

  // What acts on a body: force, and moment about the origin. Of velocities: that of the origin, and the rate.
  struct Wrench {
    T x, y, m;
  };

  // By the name of each unknown, as it acts on the second body of its name.
  std::map<std::string, Wrench> forces() const {
    const std::size_t rows = 3 * static_cast<std::size_t>(bodies_ - 1);
    std::vector<std::vector<T>> M(rows, std::vector<T>(rows, T(0)));
    std::vector<T> r(rows, T(0));
    if (unknowns_.size() != rows)
      throw Impossible("the bodies have not as many equations of equilibrium as unknown forces",
                       "le equazioni di equilibrio dei corpi non sono tante quante le forze incognite");
    for (std::size_t c = 0; c < rows; ++c) {
      add_to_column(M, c, unknowns_[c].j, unknowns_[c].unit, T(1));
      if (unknowns_[c].i > 1) add_to_column(M, c, unknowns_[c].i, unknowns_[c].unit, T(-1));
    }
    for (const auto& [name, load] : loads_) {
      const std::size_t first = row_of(load.j);
      r[first] = r[first] - load.unit.x;
      r[first + 1] = r[first + 1] - load.unit.y;
      r[first + 2] = r[first + 2] - load.unit.m;
    }
    const std::vector<T> sizes = solve_linear(M, r);
    std::map<std::string, Wrench> found;
    for (std::size_t c = 0; c < rows; ++c) {
      Wrench& sum = found.try_emplace(unknowns_[c].name, Wrench{T(0), T(0), T(0)}).first->second;
      const Wrench& unit = unknowns_[c].unit;
      sum = {sum.x + sizes[c] * unit.x, sum.y + sizes[c] * unit.y, sum.m + sizes[c] * unit.m};
    }
    return found;
  }

  // Of each body from 2 on, when the effort of this name does one watt for each newton (or newton metre) of it.
  std::map<int, Wrench> velocities(const std::string& driven) const {
    const std::size_t columns = 3 * static_cast<std::size_t>(bodies_ - 1);
    std::vector<std::vector<T>> M;
    std::vector<T> r;
    for (const Unknown& each : unknowns_) {
      if (each.i == 0 && each.name != driven) continue;
      std::vector<T> row(columns, T(0));
      add_to_row(row, each.j, each.unit, T(1));
      if (each.i > 1) add_to_row(row, each.i, each.unit, T(-1));
      M.push_back(row);
      r.push_back(each.i == 0 ? T(1) : T(0));
    }
    if (M.size() != columns)
      throw Impossible("the joints do not bind the velocities of all bodies",
                       "le coppie non vincolano le velocità di tutti i corpi");
    const std::vector<T> v = solve_linear(M, r);
    std::map<int, Wrench> found;
    for (int j = 2; j <= bodies_; ++j) found.emplace(j, Wrench{v[row_of(j)], v[row_of(j) + 1], v[row_of(j) + 2]});
    return found;
  }

  // Of a load, in these velocities.
  T power(const std::string& load, const std::map<int, Wrench>& velocities) const {
    const Load& on = loads_.at(load);
    const Wrench& v = velocities.at(on.j);
    return on.unit.x * v.x + on.unit.y * v.y + on.unit.m * v.m;
  }

 private:
  struct Load {
    int j;
    Wrench unit;
  };
  struct Unknown {
    std::string name;
    int i, j;
    Wrench unit;
  };

  static Wrench wrench(const Complex<T>& at, const Complex<T>& f) { return {f.re, f.im, cross(at, f)}; }
  static std::size_t row_of(int j) { return 3 * static_cast<std::size_t>(j - 2); }
  static void add_to_column(std::vector<std::vector<T>>& M, std::size_t c, int j, const Wrench& unit,
                            const T& sense) {
    M[row_of(j)][c] = sense * unit.x;
    M[row_of(j) + 1][c] = sense * unit.y;
    M[row_of(j) + 2][c] = sense * unit.m;
  }
  static void add_to_row(std::vector<T>& row, int j, const Wrench& unit, const T& sense) {
    row[row_of(j)] = sense * unit.x;
    row[row_of(j) + 1] = sense * unit.y;
    row[row_of(j) + 2] = sense * unit.m;
  }

  int bodies_;
  std::map<std::string, Load> loads_;
  std::vector<Unknown> unknowns_;
};

template <class T>
Complex<T> velocity_at(const typename Equilibrium<T>::Wrench& body, const Complex<T>& P) {
  return Complex<T>{body.x, body.y} + body.m * times_i(P);
}

}  // namespace epure::geometry::analytic
