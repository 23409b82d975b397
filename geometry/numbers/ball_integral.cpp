#include "geometry/numbers/ball_integral.h"

#include "geometry/numbers/ball.h"

namespace epure::geometry {

Deep ball_integral(acb_calc_func_t of, void* parameters, const Deep& from, const Deep& to) {
  const long bits = Arithmetic<Deep>::bits();
  const ComplexBall start(from), end(to);
  ComplexBall sum;
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->depth_limit = 8 * bits;
  options->eval_limit = 4000 * bits;
  acb_calc_integrate(sum.value, of, parameters, start.value, end.value, bits, tolerance, options, bits);
  mag_clear(tolerance);
  return sum.real();
}

}  // namespace epure::geometry
