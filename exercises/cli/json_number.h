// Numbers as JSON for programs.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace epure {

using Json = nlohmann::ordered_json;

// Numbers are written with the fewest digits that read back as the same double; what is not finite is null, and a
// negative zero (the lower end of a point interval) is zero.
inline Json json_number(double value) {
  return std::isfinite(value) ? Json(value == 0 ? 0.0 : value) : Json(nullptr);
}
inline Json json_number(const std::optional<double>& value) { return value ? json_number(*value) : Json(nullptr); }

}  // namespace epure
