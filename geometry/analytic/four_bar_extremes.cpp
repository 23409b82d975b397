#include "geometry/analytic/four_bar_extremes.h"

#include <algorithm>

namespace epure::geometry::analytic {

namespace {

// No two are alike: at most one position of a branch has a given ratio and is stationary.
bool is_less(const StationaryCrank& a, const StationaryCrank& b) {
  return with_enough_bits([&] {
    return decided_sign(b.ratio() - a.ratio(),
                        {"which of two extremes of the rocker's speed is the greater",
                         "quale di due estremi della velocità del bilanciere sia il maggiore"}) == Sign::positive;
  });
}

}  // namespace

// Where M = 0 the crank lies on the frame, and so on either side.
StationaryCrank::StationaryCrank(const FourBar& g, Branch branch, RealRoot squared_diagonal)
    : g_(g), squared_diagonal_(std::move(squared_diagonal)) {
  const Sign sign_of_sigma = squared_diagonal_.sign_of([&]<class X>(const X& s) -> X {
    const DiagonalTriangles<X> at(g, s);
    return at.M * at.twice_lead;
  });
  is_apart_ = sign_of_sigma == Sign::positive;
  crank_is_ = is_apart_ == (branch == Branch::left) ? Side::right : Side::left;
}

Deep StationaryCrank::ratio() const {
  const DiagonalTriangles<Deep> at(g_, squared_diagonal_.value());
  const Deep swing = at.beyond * root(quotient(at.crank_area, at.rocker_area));
  const Deep twice = at.s * Deep(2) - at.twice_lead;
  return quotient(is_apart_ ? twice - Deep(2) * swing : twice + Deep(2) * swing, Deep(4) * at.s);
}

std::vector<StationaryCrank> stationary_cranks(const FourBar& g, Branch branch) {
  std::vector<StationaryCrank> found;
  const auto condition = DiagonalTriangles<Polynomial>(g, Polynomial::indeterminate()).squared_condition();
  for (const RealRoot& s : condition.real_roots()) {
    const Sign area = s.sign_of([&]<class X>(const X& x) -> X { return DiagonalTriangles<X>(g, x).crank_area; });
    if (area == Sign::negative) continue;
    const StationaryCrank one(g, branch, s);
    found.insert(std::upper_bound(found.begin(), found.end(), one, is_less), one);
  }
  return found;
}

}  // namespace epure::geometry::analytic
