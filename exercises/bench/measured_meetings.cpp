#include "exercises/bench/families/cancelling.h"
#include "exercises/bench/families/meeting.h"
#include "exercises/bench/measure_family.h"
#include "exercises/bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> meeting_jobs() { return {job<VectorPolygon>(), job<Circles>(), job<Cancelling>()}; }

}  // namespace epure::bench
