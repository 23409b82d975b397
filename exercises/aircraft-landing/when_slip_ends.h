// The end of slip, found once for each precision; and decisions that both routes share.
#pragma once

#include "exercises/aircraft-landing/routes.h"
#include "geometry/numbers/at_each_precision.h"

namespace epure::aircraft_landing {

using geometry::analytic::SpinState;
using geometry::analytic::SpinUp;

class WhenSlipEnds {
 public:
  WhenSlipEnds(const SpinUp& law, SpinState (*find)(const SpinUp&))
      : law_(law), found_(geometry::at_each_precision([=] { return find(law); })) {}
  const SpinUp& law() const { return law_; }
  const SpinState& operator()() const { return found_(); }

 private:
  SpinUp law_;
  std::function<const SpinState&()> found_;
};

// Writes what is reported in this extent; absent where the wheel does not press on the ground.
Put pressing(const Landing& of, Extent extent, const Put& put);

// After 10 ms. Throws Impossible when slip has ended by then.
SpinState before_slip_ends(const WhenSlipEnds& end, SpinState (*after)(const SpinUp&, const Deep& t));

// |F| <= f_a N?
Deep adheres(const Landing& of, const Deep& F, const Deep& N);

}  // namespace epure::aircraft_landing
