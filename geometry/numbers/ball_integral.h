// Proved integrals of analytic functions.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/flint.h"

namespace epure::geometry {

// ∫ of dx over the straight way from `from` to `to`, as near as the bits of today's Arithmetic<Deep>; the enclosure
// is wide, or infinite, where they do not do. `of` and its `parameters` are as acb_calc_integrate asks: a ball of
// values for a ball of complex arguments, infinite where the function is not analytic on it and `order` is not 0. The
// way is halved around what is nearly singular until it is as short as that is near.
Deep ball_integral(acb_calc_func_t of, void* parameters, const Deep& from, const Deep& to);

}  // namespace epure::geometry
