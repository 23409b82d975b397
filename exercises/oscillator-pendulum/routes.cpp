#include "exercises/oscillator-pendulum/routes.h"

namespace epure::oscillator_pendulum {

Deep within_doubles(Deep x) {
  constexpr long most = 996;  // 2^996 is 10^300
  const arb_struct* ball = x.ball();
  const bool is_tiny = !arb_is_zero(ball) && arf_cmpabs_2exp_si(arb_midref(ball), -most) < 0 &&
                       mag_cmp_2exp_si(arb_radref(ball), -most) < 0;
  const bool is_huge = arf_cmpabs_2exp_si(arb_midref(ball), most) > 0;
  if (is_huge || (is_tiny && !arb_contains_zero(ball))) throw geometry::Impossible(beyond_doubles);
  return x;
}

long steps_to(const Rational& t, const Rational& dt) {
  const Rational steps = t / dt;
  if (steps.denominator() != 1) throw geometry::Impossible(between_steps);
  return static_cast<long>(CGAL::to_double(steps));
}

}  // namespace epure::oscillator_pendulum
