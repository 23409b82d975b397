// The torques of the solution as curves of doubles.
#pragma once

#include <cmath>
#include <numbers>

#include "drawings/charts/chart.h"
#include "exercises/kit/proof/solution.h"

namespace epure::pump_flywheel {

struct DrawnPump {
  double mean, suction, delivery, K;

  // K: of the reciprocating mass.
  explicit DrawnPump(const Solution& s, double of_mass = 0)
      : mean(s["M_r_mean"]),
        suction(s["M_r_suction_coefficient"]),
        delivery(-s["M_r_delivery_coefficient"]),
        K(of_mass) {}

  double coefficient(double alpha) const { return alpha <= std::numbers::pi ? suction : delivery; }
  double resisting(double alpha) const {
    return coefficient(alpha) * std::abs(std::sin(alpha)) + K * std::sin(2 * alpha);
  }
  // ∫(mean - resisting) from 0.
  double energy(double alpha) const {
    const bool late = alpha > std::numbers::pi;
    const double turned = late ? alpha - std::numbers::pi : alpha, sine = std::sin(turned);
    return (late ? mean * std::numbers::pi - 2 * suction : 0) + mean * turned -
           coefficient(alpha) * (1 - std::cos(turned)) - K * sine * sine;
  }
};

constexpr double degree = std::numbers::pi / 180;

template <class Function>
std::vector<drawings::Datum> over_the_turn(const Function& y) {
  std::vector<drawings::Datum> points;
  for (int i = 0; i <= 360; ++i) points.push_back({static_cast<double>(i), y(i * degree)});
  return points;
}

}  // namespace epure::pump_flywheel
