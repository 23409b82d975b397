#include "exercises/four-bar-analytic/routes.h"

namespace epure::four_bar_analytic {

std::vector<RouteValue> solve(const Problem& of, Rung rung) { return settle(Routes(of), rung); }

RockerSpeed rocker_speed(const FourBarInstant& at) {
  return deeply([&]() -> RockerSpeed {
    const RatioByClosure ratio{at.analytic_lengths(), at.analytic_branch()};
    const auto stationary = stationary_ratio(at.lengths, ratio);
    RockerSpeed found{.why_no_extremes = stationary.why_not};
    for (const RatioByClosure::Stationary& one : stationary.positions)
      found.extremes.push_back({to_double(RatioByClosure::crank<geometry::Deep>(one)),
                                to_double(at.omega_2<geometry::Deep>() * one.ratio())});
    for (const geometry::Reach reach : {geometry::Reach::extended, geometry::Reach::folded}) {
      try {
        const auto dead_centre = geometry::dead_centre<geometry::Deep>(at.lengths, reach, at.side);
        if (dead_centre.branch) found.zeros.push_back(to_double(dead_centre.crank));
      } catch (const geometry::Impossible&) {
        // The rocker has no such dead centre.
      }
    }
    return found;
  });
}

}  // namespace epure::four_bar_analytic
