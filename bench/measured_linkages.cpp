#include "bench/families/four_bar_family.h"
#include "bench/families/slider_crank_family.h"
#include "bench/measure_family.h"
#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> linkage_jobs() {
  return {job<FourBarPosition>(), job<FourBarSecondOrder>(), job<SliderCrankSecondOrder>()};
}

}  // namespace epure::bench
