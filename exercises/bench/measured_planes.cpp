#include "exercises/bench/families/coupler_curve.h"
#include "exercises/bench/families/plane_motion.h"
#include "exercises/bench/families/slider_crank.h"
#include "exercises/bench/measure_family.h"
#include "exercises/bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> plane_jobs() {
  return {job<PoleAndCircles>(), job<Curvature>(), job<PolodePoint>(), job<CouplerCurvePoint>()};
}

}  // namespace epure::bench
