// A chain of bars, each at right angles to the left of the one before, clamped where it begins and loaded upright
// where it ends, by the matrix of its stiffness: rise and two rotations of each node are the unknowns. No moment is
// found, and no diagram. A third route to statics/frame_across.h.
#pragma once

#include <array>
#include <vector>

#include "geometry/analytic/equilibrium.h"

namespace epure::geometry::analytic {

template <class T>
struct ElasticBar {
  T length, bending, torsion;  // EJ, GJ_t
};

template <class T>
struct NodeDisplacement {
  T rise, theta_x, theta_y;
};

template <class T>
struct ElasticChain {
  std::vector<NodeDisplacement<T>> nodes;  // ends of the bars
  std::vector<T> energies;                 // of the bars
};

// Its six coordinates: rise, slope along the bar and turn about it, at both ends.
template <class T>
using BarMatrix = std::array<std::array<T, 6>, 6>;

template <class T>
BarMatrix<T> bar_matrix(const ElasticBar<T>& bar) {
  const T &L = bar.length, unit = quotient(bar.bending, L * L * L), twist = quotient(bar.torsion, L);
  BarMatrix<T> k;
  for (auto& row : k) row.fill(T(0));
  const T shear = T(12) * unit, mixed = T(6) * unit * L, near = T(4) * unit * L * L, far = T(2) * unit * L * L;
  k[0] = {shear, mixed, T(0), -shear, mixed, T(0)};
  k[1] = {mixed, near, T(0), -mixed, far, T(0)};
  k[2] = {T(0), T(0), twist, T(0), T(0), -twist};
  k[3] = {-shear, -mixed, T(0), shear, -mixed, T(0)};
  k[4] = {mixed, far, T(0), -mixed, near, T(0)};
  k[5] = {T(0), T(0), -twist, T(0), T(0), twist};
  return k;
}

// Which unknown of a node (rise, θ_x, θ_y) a coordinate of bar i is, and with which sign. Along x: slope -θ_y, turn
// θ_x; each corner to the left turns the axes with the bar.
struct Coordinate {
  std::size_t unknown;
  int sign;
};
inline Coordinate coordinate(std::size_t bar, std::size_t which) {
  if (which == 0) return {0, 1};
  const int back = bar % 4 < 2 ? 1 : -1;
  if (bar % 2 == 0) return which == 1 ? Coordinate{2, -back} : Coordinate{1, back};
  return which == 1 ? Coordinate{1, back} : Coordinate{2, back};
}

template <class T>
ElasticChain<T> elastic_chain(const std::vector<ElasticBar<T>>& bars, const T& upwards_at_end) {
  const std::size_t n = 3 * bars.size();
  std::vector<std::vector<T>> K(n, std::vector<T>(n, T(0)));
  std::vector<BarMatrix<T>> matrices;
  // The place among all unknowns; that of the clamp is none.
  const auto place = [&](std::size_t bar, std::size_t c) {
    return 3 * (bar + c / 3) - 3 + coordinate(bar, c % 3).unknown;
  };
  const auto is_free = [](std::size_t bar, std::size_t c) { return bar > 0 || c >= 3; };
  const auto sign_of = [](std::size_t bar, std::size_t c) { return T(coordinate(bar, c % 3).sign); };
  for (std::size_t bar = 0; bar < bars.size(); ++bar) {
    const BarMatrix<T>& k = matrices.emplace_back(bar_matrix(bars[bar]));
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = 0; c < 6; ++c)
        if (is_free(bar, r) && is_free(bar, c))
          K[place(bar, r)][place(bar, c)] += sign_of(bar, r) * sign_of(bar, c) * k[r][c];
  }
  std::vector<T> f(n, T(0));
  f[n - 3] = upwards_at_end;
  const std::vector<T> d = solve_linear(std::move(K), std::move(f));
  ElasticChain<T> chain;
  for (std::size_t bar = 0; bar < bars.size(); ++bar) {
    chain.nodes.push_back({d[3 * bar], d[3 * bar + 1], d[3 * bar + 2]});
    std::array<T, 6> of_bar;
    for (std::size_t c = 0; c < 6; ++c) of_bar[c] = is_free(bar, c) ? sign_of(bar, c) * d[place(bar, c)] : T(0);
    T twice(0);
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = 0; c < 6; ++c) twice += of_bar[r] * matrices[bar][r][c] * of_bar[c];
    chain.energies.push_back(from_rational<T>(Rational(1, 2)) * twice);
  }
  return chain;
}

}  // namespace epure::geometry::analytic
