#include "exercises/bench/families/four_bar.h"
#include "exercises/bench/families/slider_crank.h"
#include "exercises/bench/measure_family.h"
#include "exercises/bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> linkage_jobs() {
  return {job<FourBarPosition>(), job<FourBarSecondOrder>(), job<SliderCrankSecondOrder>()};
}

}  // namespace epure::bench
