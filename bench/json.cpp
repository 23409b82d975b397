#include <nlohmann/json.hpp>

#include "bench/bench.h"

namespace epure::bench {

std::string json_of(const Report& report) {
  using Json = nlohmann::ordered_json;
  Json json = {{"schema", "epure.bench/1"}, {"results", Json::array()}};
  for (const FamilyResult& each : report.families)
    json["results"].push_back(
        {{"family", each.family},
         {"number", each.number},
         {"ns_per_result", each.ns_per_result},
         {"max_relative_error", each.max_relative_error},
         {"max_relative_bound", each.max_relative_bound ? Json(*each.max_relative_bound) : Json(nullptr)},
         {"handed_over", each.handed_over}});
  return json.dump(1) + "\n";
}

}  // namespace epure::bench
