#include "bench/sweep.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "bench/sweeping/second_order_sweep.h"
#include "bench/timing.h"

namespace epure::bench {

using namespace geometry;

SweepTimes time_sweep(double budget) {
  constexpr std::size_t positions = 10000;
  // The crank turns fully: 0.15 + 0.45 < 0.37 + 0.4.
  const DrivenFourBar driven{{Rational(3, 20), Rational(37, 100), Rational(9, 20), Rational(2, 5), Rational(0)},
                             Side::left,
                             Rational(10),
                             Rational(3),
                             Rational(1, 2),
                             Rational(1, 5)};
  std::vector<Vector<Fast>> cranks;
  for (std::size_t k = 0; k < positions; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / positions;
    cranks.push_back({std::cos(angle), std::sin(angle)});
  }
  std::vector<SecondOrder<Fast>> loop(positions);
  std::vector<Swept> sweep(positions);
  const double fast = seconds_per_call(
      [&] {
        second_order_one_by_one<Fast>(driven, std::span<const Vector<Fast>>(cranks),
                                      std::span<SecondOrder<Fast>>(loop));
      },
      budget / 2);
  const double bounded = seconds_per_call([&] { sweep_second_order(driven, sweep, 1); }, budget / 2);
  return {1e9 * fast / positions, 1e9 * bounded / positions};
}

}  // namespace epure::bench
