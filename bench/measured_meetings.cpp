#include "bench/families/cancelling_family.h"
#include "bench/families/meeting_family.h"
#include "bench/measure_family.h"
#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> meeting_jobs() { return {job<VectorPolygon>(), job<Circles>(), job<Cancelling>()}; }

}  // namespace epure::bench
