#include "geometry/mechanisms/collineation_axis.h"

namespace epure::geometry {

// A₀B₀ x A₀A = -(μ - ω) η with B₀ on height η over the coupler's x axis: B, to the right of B₀'s foot or left of it,
// is on the left of A -> B₀ when η is negative. Where μ = ω the crank lies on the frame's line.
StationaryPosition::StationaryPosition(const FourBarLengths& of, Side branch, RealRoot ratio)
    : of_(of), ratio_(std::move(ratio)) {
  const Sign arm =
      ratio_.sign_of([&]<class X>(const X& mu) -> X { return mu - AxisSquareToCoupler<X>(of, mu).omega(); });
  crank_is_ = (arm == Sign::positive) == (branch == Side::left) ? Side::left : Side::right;
}

std::vector<StationaryPosition> stationary_positions(const FourBarLengths& of, Side branch) {
  std::vector<StationaryPosition> found;
  const auto sextic = AxisSquareToCoupler<Polynomial>(of, Polynomial::indeterminate()).sextic();
  for (const RealRoot& ratio : sextic.real_roots()) {
    if (ratio.rational() && (*ratio.rational() == 0 || *ratio.rational() == 1)) continue;
    const Sign height =
        ratio.sign_of([&]<class X>(const X& mu) -> X { return AxisSquareToCoupler<X>(of, mu).height_squared(of); });
    if (height == Sign::positive) found.emplace_back(of, branch, ratio);
  }
  return found;
}

}  // namespace epure::geometry
