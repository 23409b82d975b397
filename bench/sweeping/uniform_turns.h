// The directions of a sweep, cheaply: cosine and sine of k/n of a turn for k = 0, 1, ... n - 1, two at a time.
//
// k = row · width + column, and the direction is that of the row turned by that of the column (addition theorem), so
// that two tables of about √n directions give all n. A cosine or sine put together from two entries is enclosed
// to within 1.3e-15.
#pragma once

#include "bench/sweeping/two_bounded.h"

#include <cstddef>
#include <vector>

namespace epure::geometry {

class UniformTurns {
 public:
  struct Direction {
    TwoBounded cosine, sine;
  };

  // n >= 1 directions. Needs no open scope.
  explicit UniformTurns(std::size_t n);

  std::size_t width() const { return 2 * pairs_.size(); }
  std::size_t rows() const { return rows_.size(); }

  // Directions k and k + 1, k = row · width + 2 pair, inside an Arithmetic<Bounded> scope. In the last row k may run
  // past n: the turns go on.
  Direction operator()(std::size_t row, std::size_t pair) const {
    const Direction &a = rows_[row], &b = pairs_[pair];
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }

 private:
  std::vector<Direction> rows_, pairs_;
};

}  // namespace epure::geometry
