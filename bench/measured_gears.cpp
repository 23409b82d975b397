#include "bench/families/gears_family.h"
#include "bench/families/roulette_family.h"
#include "bench/measure_family.h"
#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> gear_jobs() { return {job<RoulettePoint>(), job<GearFlankPoint>()}; }

}  // namespace epure::bench
