// An integral along the real axis with proved bounds, by Arb's adaptive quadrature.
#pragma once

#include <functional>

#include "geometry/numbers/ball.h"

namespace epure::geometry::analytic {

// Writes the integrand at a complex ball. `must_be_analytic`: what has no analytic branch on the ball must be made
// infinite there (acb_sqrt_analytic and its like do).
using Integrand = std::function<void(acb_ptr result, const acb_t x, bool must_be_analytic, long bits)>;

// With as many bits as are open, less those that are lost.
Deep integral(const Integrand& of, const Deep& from, const Deep& to);

}  // namespace epure::geometry::analytic
