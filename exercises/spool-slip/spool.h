// The givens of the exercise, when they are impossible, and which of three regimes holds: all decided on rationals.
#pragma once

#include <vector>

#include "exercises/kit/statement/givens.h"

namespace epure::spool_slip {

std::vector<GivenSpec> stated_givens();

enum class Regime { at_rest, rolling, slipping };

// The spool a on its plane, pulled through a rope by the counterweight b. In SI units.
struct Spool {
  Rational m_a, R, r, f_a, f_r, f_v, g;

  Rational height() const { return R - r; }  // of the rope above the plane
  // With this counterweight it does not stay where it is: the rope turns it over the offset of the normal reaction,
  // which is f_v R at most, if it does not slip first.
  bool rolls_off(const Rational& m_b) const;
  // What must be held against sliding, over the normal reaction: at rest, or else while rolling.
  Rational friction_needed(const Rational& m_b) const;
  Regime regime(const Rational& m_b) const;
  // While it slips the normal reaction stands so far to the right of the foot of G: f_v R against the turning, and
  // less where the spool is then carried along without turning.
  Rational offset_while_slipping(const Rational& m_b) const;
  // Whether rolling ever comes to the edge of the cone, and not before it begins.
  bool slips_from_rest() const;
  bool always_rolls() const;
};

// Throws BadGivens, in one sentence with the values.
Spool spool(const Givens& givens);

}  // namespace epure::spool_slip
