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

// As much at most the polygon of times is off, of strips that end at these falling speeds: width²/8 times the
// steepest slope of 1/|a| there. `slope`: its size at a speed; `steepest_at`: the speed beside which it falls on both
// sides.
Deep chords_off_at_most(const std::vector<Deep>& speeds, const std::function<Deep(const Deep& v)>& slope,
                        const std::optional<Deep>& steepest_at);
// At the ends of the strips, by a law of the speed.
std::vector<Deep> speeds_of_strips(const WhenSlipEnds& end, SpinState (*after)(const SpinUp&, const Deep& t));

// |F| <= f_a N?
Deep adheres(const Landing& of, const Deep& F, const Deep& N);

}  // namespace epure::aircraft_landing
