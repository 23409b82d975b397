#include "drawings/charts/value_span.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace epure::drawings {

double narrowest_span(double low, double high) { return 1e-7 * std::max(std::abs(low), std::abs(high)); }

ValueSpan span_of(std::vector<double> values) {
  if (values.empty()) return {0, 1};
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(std::lround(part * static_cast<double>(values.size() - 1)))];
  };
  constexpr double few = 0.05, far = 8;
  const ValueSpan all{values.front(), values.back()}, most{at(few), at(1 - few)};
  const double width = most.high - most.low;
  if (width > narrowest_span(most.low, most.high) && all.high - all.low > far * width)
    return {std::max(all.low, most.low - width / 2), std::min(all.high, most.high + width / 2)};
  if (all.high - all.low > narrowest_span(all.low, all.high)) return all;
  const double around = all.low == 0 ? 1 : std::abs(all.low) / 10;
  return {all.low - around, all.high + around};
}

}  // namespace epure::drawings
