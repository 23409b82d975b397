#include "geometry/analytic/joints/in_doubles.h"

#include <Eigen/LU>
#include <cmath>

namespace epure::geometry::analytic::joints {

Eigen::MatrixXd matrix(const std::vector<Equation<Fast>>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index row = 0; row < n; ++row)
    for (const auto& [column, slope] : rows[static_cast<std::size_t>(row)].slopes) J(row, column) += slope;
  return J;
}

Column<Fast> solved(const std::vector<Equation<Fast>>& rows, const Column<Fast>& b) {
  const Eigen::VectorXd x = matrix(rows).partialPivLu().solve(
      Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Eigen::Index>(b.size())));
  return {x.data(), x.data() + x.size()};
}

Column<Fast> iterated(const Linkage& linkage, Column<Fast> q) {
  constexpr int most_steps = 60;
  double last = HUGE_VAL;
  for (int k = 0; k < most_steps; ++k) {
    const std::vector<Equation<Fast>> rows = equations(linkage, q);
    Eigen::VectorXd residual(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) residual(static_cast<Eigen::Index>(i)) = rows[i].residual;
    const Eigen::VectorXd step = matrix(rows).partialPivLu().solve(residual);
    const double size = step.cwiseAbs().maxCoeff();
    if (!(size < HUGE_VAL)) break;
    if (size == 0 || (k > 3 && size >= last)) return q;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] -= step(static_cast<Eigen::Index>(i));
    last = size;
  }
  throw Undecided("Newton's iteration on the equations of all joints comes to no end",
                  "l'iterazione di Newton sulle equazioni di tutti i vincoli non ha fine");
}

}  // namespace epure::geometry::analytic::joints
