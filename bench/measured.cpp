#include "bench/measured.h"

namespace epure::bench {

std::vector<FamilyJob> family_jobs() {
  std::vector<FamilyJob> all;
  for (const auto& some : {linkage_jobs(), plane_jobs(), gear_jobs(), meeting_jobs()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace epure::bench
