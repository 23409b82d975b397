// Integrals by Arb's quadrature: with as many bits as are open, less those that are lost.
#pragma once

#include <functional>

#include "geometry/numbers/ball.h"

namespace epure::geometry::analytic {

// result = f(x), to so many bits, of a function without a branch cut; infinite where it has a pole.
using ComplexFunction = std::function<void(acb_ptr result, acb_srcptr x, long bits)>;

// From `from` to `to` along the real line.
Deep integral(const ComplexFunction& f, const Deep& from, const Deep& to);

}  // namespace epure::geometry::analytic
