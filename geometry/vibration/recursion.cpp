#include "geometry/vibration/recursion.h"

namespace epure::geometry {
namespace {

constexpr long guard = 32;  // bits

}  // namespace

std::vector<Deep> row_by_row(const PendulumTable& table, long n) {
  const Arithmetic<Deep> more(Arithmetic<Deep>::bits() + 3 * n / 2 + guard);
  const auto number = from_rational<Deep>;
  const Deep I = number(table.inertia_of_G), m_r2 = number(table.m * table.r * table.r),
             weight = number(table.m * table.r * table.g * table.dt * table.dt);
  std::vector<Deep> theta(2, radians<Deep>(table.theta_0));
  for (std::size_t i = 0; theta.size() <= static_cast<std::size_t>(n); ++i)
    theta.push_back(-(weight * sine_of_angle(theta[i]) - Deep(2) * I * theta[i + 1] + I * theta[i] -
                      Deep(2) * m_r2 * theta[i + 1] + m_r2 * theta[i]) /
                    (I + m_r2));
  return theta;
}

SummedUp summed_up(const PendulumTable& table, long n) {
  const Arithmetic<Deep> more(Arithmetic<Deep>::bits() + guard);
  const Rational I = table.inertia_of_G + table.m * table.r * table.r;
  const Deep step = from_rational<Deep>(table.m * table.g * table.r / I * table.dt * table.dt);
  SummedUp all;
  Deep theta = radians<Deep>(table.theta_0), sum(0);
  for (long i = 0; i <= n; ++i) {
    all.theta.push_back(theta);
    all.sums.push_back(sum);
    all.sines.push_back(sine_of_angle(theta));
    theta -= step * sum;
    sum += all.sines.back();
  }
  return all;
}

}  // namespace epure::geometry
