// Laws of motion in doubles, for curves alone: what is reported is found elsewhere, and lies on them.
#pragma once

#include <functional>
#include <vector>

#include "exercises/kit/proof/solution.h"

namespace epure::oscillator_pendulum {

// Of either, x and x' or θ and θ' at an instant.
struct Moving {
  double t, position, rate;
};

// From 0 to `to` in so many steps.
std::vector<Moving> oscillation(const Givens& givens, double to, int steps);
std::vector<Moving> euler_polygon(const Givens& givens, double to);
// As the oscillator, by Runge and Kutta's method with many steps.
std::vector<Moving> swing(const Givens& givens, double Omega, double to, int steps);
// Rows of the printed recursion.
std::vector<Moving> swing_of_table(const Givens& givens, double Omega, double to);

// What a run of these rows does: over the top, or to and fro, gaining energy with every step or not.
struct RunOfTable {
  bool goes_over, gains_always;
};
RunOfTable run_of_table(const std::vector<Moving>& rows, double Omega);

// For how long the oscillator is shown: as long as Euler's table, or a few of its own times where that is less.
double time_shown(const Givens& givens);

}  // namespace epure::oscillator_pendulum
