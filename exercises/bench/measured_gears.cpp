#include "exercises/bench/families/gears.h"
#include "exercises/bench/families/roulette.h"
#include "exercises/bench/measure_family.h"
#include "exercises/bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> gear_jobs() { return {job<RoulettePoint>(), job<GearFlankPoint>()}; }

}  // namespace epure::bench
