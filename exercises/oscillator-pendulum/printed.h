// What the source printed, and the chain of its mistakes and rounded numbers.
#pragma once

#include <vector>

#include "exercises/kit/statement/description.h"

namespace epure::oscillator_pendulum {

std::vector<Printed> printed_by_the_source();
// Every entry of its two tables.
std::vector<TableAudit> audited_tables();

// The source's tables as it made them, of which every printed digit follows.
struct SourceOscillatorRow {
  double x_ddot, x_dot, x;  // by Euler's method, every half second
  double analytic;          // of the row's number in seconds, with rounded constants
  double error;             // of one against the other
};
SourceOscillatorRow oscillator_row_of_source(int i);
struct SourcePendulumRow {
  double theta, theta_dot, theta_ddot, R_x, R_y;
};
SourcePendulumRow pendulum_row_of_source(int i);

}  // namespace epure::oscillator_pendulum
