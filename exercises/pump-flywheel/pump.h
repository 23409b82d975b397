// What is given of the piston pump and its motor.
#pragma once

#include "exercises/kit/statement/givens.h"

namespace epure::pump_flywheel {

std::vector<GivenSpec> given_specs();

struct Pump {
  Rational Q, p_m, p_a, D, c, W_t, J_m, m, i;  // SI units
  Angle rated, synchronous;                    // speeds of the motor

  // Throws BadGivens: a motor faster than its synchronous speed, an irregularity that no flywheel has, a suction
  // stronger than the delivery.
  explicit Pump(const Givens& givens);

  static Rational diameter_of_the_text() { return Rational(201, 100); }
  Rational r() const { return c / 2; }
};

}  // namespace epure::pump_flywheel
