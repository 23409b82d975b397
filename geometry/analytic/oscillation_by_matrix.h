// The oscillator of vibration/free_oscillation.h by other formulas: the exponential of its matrix, and times as
// quadratures along its path in the phase plane. No exponential function of a number, no logarithm, no root of the
// characteristic equation.
//
// State (ω x, x'), τ = ω t:  d/dτ = A with A = ((0, 1), (-1, -2ζ)).
// With u = ω x/x':  dτ = du/(1 + 2ζu + u²);  with p = x'/(ω x):  dτ = -dp/(p² + 2ζp + 1). At the start u = 0, where
// x' = 0 is p = 0, where x'' = 0 is p = -1/(2ζ).
#pragma once

#include "geometry/numbers/angle.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

class OscillationByMatrix {
 public:
  OscillationByMatrix(Rational zeta, Angle omega) : zeta_(std::move(zeta)), omega_(std::move(omega)) {}

  // Of the motion that begins with ω x = 0, x' = 1, or with ω x = 1, x' = 0.
  struct State {
    Deep omega_x, velocity;
  };
  State after_push(const Deep& t) const { return {entry(t, 0, 1), entry(t, 1, 1)}; }
  State after_release(const Deep& t) const { return {entry(t, 0, 0), entry(t, 1, 0)}; }

  Deep time_of_extreme() const;
  Deep time_of_inflection() const;

 private:
  Deep entry(const Deep& t, int row, int column) const;

  Rational zeta_;
  Angle omega_;
};

// Powers of the matrix ((1, h), (-h, 1 - 2ζh)), h = ω Δt, by repeated squaring: what n steps of Euler's method do to
// (ω x, x') = (0, 1).
struct StepsOfEuler {
  Deep omega_x, velocity;
};
StepsOfEuler steps_of_euler(const Rational& zeta, const Angle& step, long n);

}  // namespace epure::geometry::analytic
