#include "geometry/analytic/inverse.h"

#include <Eigen/LU>
#include <cmath>

#include "geometry/numbers/enclosure.h"

namespace epure::geometry::analytic {
namespace {

class SquareOfBalls {
 public:
  explicit SquareOfBalls(std::size_t size) {
    arb_mat_init(balls_, static_cast<slong>(size), static_cast<slong>(size));
  }
  SquareOfBalls(const SquareOfBalls&) = delete;
  SquareOfBalls& operator=(const SquareOfBalls&) = delete;
  ~SquareOfBalls() { arb_mat_clear(balls_); }

  arb_mat_struct* get() { return balls_; }
  arb_ptr at(std::size_t row, std::size_t column) {
    return arb_mat_entry(balls_, static_cast<slong>(row), static_cast<slong>(column));
  }

 private:
  arb_mat_t balls_;
};

}  // namespace

std::optional<std::vector<std::vector<Bounded>>> inverse_near(const std::vector<std::vector<Bounded>>& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  Eigen::MatrixXd A(n, n);
  for (Eigen::Index row = 0; row < n; ++row)
    for (Eigen::Index column = 0; column < n; ++column)
      A(row, column) = enclosure(matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]).value;
  const Eigen::MatrixXd inverse = A.partialPivLu().inverse();
  std::vector<std::vector<Bounded>> near;
  for (Eigen::Index row = 0; row < n; ++row) {
    near.emplace_back();
    for (Eigen::Index column = 0; column < n; ++column) {
      if (!std::isfinite(inverse(row, column))) return {};
      near.back().emplace_back(inverse(row, column));
    }
  }
  return near;
}

std::optional<std::vector<std::vector<Deep>>> inverse_near(const std::vector<std::vector<Deep>>& matrix) {
  const std::size_t n = matrix.size();
  SquareOfBalls A(n), inverse(n);
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column) arb_set(A.at(row, column), matrix[row][column].ball());
  if (!arb_mat_approx_inv(inverse.get(), A.get(), Arithmetic<Deep>::bits())) return {};
  std::vector<std::vector<Deep>> near;
  for (std::size_t row = 0; row < n; ++row) {
    near.emplace_back();
    for (std::size_t column = 0; column < n; ++column)
      near.back().push_back(midpoint(Deep::from_ball(inverse.at(row, column))));
  }
  return near;
}

}  // namespace epure::geometry::analytic
