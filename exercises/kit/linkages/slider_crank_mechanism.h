// The slider-crank as its sheets draw it, from the places that the solution found.
#pragma once

#include <memory>

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// An arc arrow at A for how the coupler turns, or how its rotation grows; none when the sense is 0.
struct CouplerTurning {
  double sense = 0;
  std::string symbol = {};
  bool marks_phi = true;  // the angle of the crank
  bool marks_M = true;
};
// A0, A, B, C and M must be in the solution.
std::shared_ptr<const Mechanism> slider_crank_mechanism(const Solution& solution, const SliderCrankInstant& instant,
                                                        const CouplerTurning& coupler = {});

// Between which crank angles the linkage closes; empty when the crank turns fully. Of tell_crank_limits.
std::string swing_in_words(const Solution& solution, Language language);

// How a direction is named in a polygon: "∥ A₀B", or by the guide when it does not pass A₀.
std::string parallel_to_guide(const SliderCrankInstant& at, Language language);

}  // namespace epure
