#include "geometry/analytic/integral.h"

namespace epure::geometry::analytic {

Deep integral(const Integrand& of, const Deep& from, const Deep& to) {
  const auto at = [](acb_ptr result, const acb_t x, void* integrand, slong order, slong bits) {
    (*static_cast<const Integrand*>(integrand))(result, x, order > 0, bits);
    return 0;
  };
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
  Integrand copy = of;
  acb_calc_integrate(sum.value, at, &copy, start.value, end.value, bits, tolerance, options, bits);
  mag_clear(tolerance);
  return sum.real();
}

}  // namespace epure::geometry::analytic
