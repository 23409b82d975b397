#include "geometry/analytic/quadrature.h"

namespace epure::geometry::analytic {
namespace {

int at_point(acb_ptr result, const acb_t x, void* function, slong, slong bits) {
  (*static_cast<const ComplexFunction*>(function))(result, x, bits);
  return 0;
}

}  // namespace

Deep integral(const ComplexFunction& f, const Deep& from, const Deep& to) {
  const long bits = Arithmetic<Deep>::bits();
  ComplexFunction of = f;
  const ComplexBall begin(from), end(to);
  ComplexBall sum;
  mag_t tolerance;
  mag_init(tolerance);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->depth_limit = 8 * bits;
  options->eval_limit = 4000 * bits;
  acb_calc_integrate(sum.value, at_point, &of, begin.value, end.value, bits, tolerance, options, bits);
  mag_clear(tolerance);
  return sum.real();
}

}  // namespace epure::geometry::analytic
