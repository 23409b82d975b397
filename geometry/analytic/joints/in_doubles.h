// The equations solved in doubles, as they come.
#pragma once

#include <Eigen/Core>

#include "geometry/analytic/joints/equations.h"

namespace epure::geometry::analytic::joints {

Eigen::MatrixXd matrix(const std::vector<Equation<Fast>>& rows);
// J x = b.
Column<Fast> solved(const std::vector<Equation<Fast>>& rows, const Column<Fast>& b);
// Newton's iteration: until the step no longer shrinks. Throws Undecided where it comes to no end.
Column<Fast> iterated(const Linkage& linkage, Column<Fast> q);

}  // namespace epure::geometry::analytic::joints
