// The pendulum's equation of motion on a grid of instants, θ'' taken for the second difference:
//   θ_{i+2} - 2 θ_{i+1} + θ_i = -Ω² Δt² sin θ_i,     θ_1 = θ_0
// as the table is made, row by row, and summed up: θ_{n+1} - θ_n = -Ω² Δt² Σ_{j<n} sin θ_j.
#pragma once

#include <vector>

#include "geometry/numbers/angle.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// The coefficients with which the free bodies give θ_{i+2}:  inertia (θ_{i+2} - 2 θ_{i+1} + θ_i) = -moment Δt² sin
// θ_i.
struct PendulumTable {
  Angle theta_0;
  Rational inertia_of_G, m, r, g, dt;
};

// θ_0 to θ_n. The row-by-row form loses 1.3 bits a row (its errors grow by 1 + √2), and works with that many more.
std::vector<Deep> row_by_row(const PendulumTable& table, long n);
// The same sums; and what is added at each step.
struct SummedUp {
  std::vector<Deep> theta, sines;  // sin θ_j
  std::vector<Deep> sums;          // Σ_{i<j} sin θ_i
};
SummedUp summed_up(const PendulumTable& table, long n);

}  // namespace epure::geometry
