#include "bench/families/coupler_curve_family.h"
#include "bench/families/plane_motion_family.h"
#include "bench/families/slider_crank_family.h"
#include "bench/measure_family.h"
#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> plane_jobs() {
  return {job<PoleAndCircles>(), job<Curvature>(), job<PolodePoint>(), job<CouplerCurvePoint>()};
}

}  // namespace epure::bench
