// Measuring what is drawn.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/proof/checked.h"

namespace epure {
namespace {

// A file moves each coordinate by at most half its resolution. Two ends are moved, so each component of the way from
// one to the other changes by at most the whole resolution, and its length by at most √2 of it.
constexpr double filing_of_component = drawings::file_resolution;
constexpr double filing_of_length = std::numbers::sqrt2 * drawings::file_resolution;

// What doubles cost in placing the ends. Coordinates stay below 2^20 mm (farthest_measured in plot.cpp), where a
// rounding is at most 2^-34 mm; a figure's point comes out of some hundred operations whose errors may grow a
// hundredfold where lines meet at a slant. 2^14 roundings make 2^-20 mm: less than a thousandth of what filing costs.
constexpr double placing = 0x1p-20;

double miss(const OnSheet& shown, double value) {
  return std::abs(shown.value - (shown.signed_value ? value : std::abs(value)));
}

}  // namespace

OnSheet measure(const Measurement& measurement, const std::string& sheet, drawings::Paper paper) {
  const drawings::Point from = as_filed(measurement.from, paper), to = as_filed(measurement.to, paper);
  const double along_x = to.x - from.x, along_y = to.y - from.y;
  const bool is_length = measurement.kind == Measurement::length;
  const double mm = is_length                                  ? std::hypot(along_x, along_y)
                    : measurement.kind == Measurement::along_x ? along_x
                                                               : along_y;
  return {.sheet = sheet,
          .value = mm * measurement.per_mm,
          .resolution = (is_length ? filing_of_length : filing_of_component) * measurement.per_mm +
                        placing * measurement.per_mm,
          .per_mm = measurement.per_mm,
          .signed_value = !is_length};
}

bool is_within_resolution(const OnSheet& shown, double value) { return miss(shown, value) <= shown.resolution; }

const OnSheet* farthest_on_sheet(const CheckedQuantity& quantity) {
  const double value = has_value(quantity.settled) ? quantity.settled.enclosure.value : 0;
  const auto found =
      std::max_element(quantity.on_sheets.begin(), quantity.on_sheets.end(), [&](const OnSheet& a, const OnSheet& b) {
        return miss(a, value) / a.resolution < miss(b, value) / b.resolution;
      });
  return found == quantity.on_sheets.end() ? nullptr : &*found;
}

}  // namespace epure
