// The end of slip, found once for each precision; and decisions that both routes share.
#pragma once

#include "exercises/aircraft-landing/routes.h"

namespace epure::aircraft_landing {

using geometry::analytic::SpinState;
using geometry::analytic::SpinUp;

class WhenSlipEnds {
 public:
  WhenSlipEnds(SpinUp law, SpinState (*find)(const SpinUp&)) : law_(std::move(law)), find_(find) {}
  const SpinUp& law() const { return law_; }
  const SpinState& operator()() const {
    const long bits = geometry::Arithmetic<Deep>::bits();
    const auto found = found_->find(bits);
    return found != found_->end() ? found->second : found_->emplace(bits, find_(law_)).first->second;
  }

 private:
  SpinUp law_;
  SpinState (*find_)(const SpinUp&);
  std::shared_ptr<std::map<long, SpinState>> found_ = std::make_shared<std::map<long, SpinState>>();
};

// Writes what is reported in this extent; absent where the wheel does not press on the ground.
Put pressing(const Landing& of, Extent extent, const Put& put);

// After 10 ms. Throws Impossible when slip has ended by then.
SpinState before_slip_ends(const WhenSlipEnds& end, SpinState (*after)(const SpinUp&, const Deep& t));

// |F| <= f_a N?
Deep adheres(const Landing& of, const Deep& F, const Deep& N);

}  // namespace epure::aircraft_landing
