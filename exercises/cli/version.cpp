#include "exercises/cli/version.h"

#include <fmt/format.h>
#include <CLI/Version.hpp>

#include "drawings/libraries.h"
#include "exercises/cli/columns.h"
#include "geometry/numbers/libraries.h"

namespace epure {
namespace {

std::string dotted(int major, int minor, int patch) { return fmt::format("{}.{}.{}", major, minor, patch); }

Libraries all_libraries() {
  Libraries all = geometry::libraries();
  for (const Library& each : drawings::libraries()) all.push_back(each);
  all.push_back({"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)});
  all.push_back({"CLI11", CLI11_VERSION});
  all.push_back({"nlohmann-json",
                 dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)});
  return all;
}

}  // namespace

std::string version_for_people() {
  std::vector<std::string> libraries;
  for (const Library& each : all_libraries()) libraries.push_back(each.name + "\u00a0" + each.version);
  return "epure " EPURE_VERSION "\n" + wrapped(fmt::format("{}", fmt::join(libraries, ", ")));
}

Json version_for_programs() {
  Json libraries;
  for (const Library& each : all_libraries()) libraries[each.name] = each.version;
  return {{"version", EPURE_VERSION}, {"libraries", libraries}};
}

}  // namespace epure
