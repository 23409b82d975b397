#include "bench/families/gears.h"
#include "bench/families/roulette.h"
#include "bench/measure_family.h"
#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> gear_jobs() { return {job<RoulettePoint>(), job<GearFlankPoint>()}; }

}  // namespace epure::bench
