// What several formulas on Deep need, and is long to find.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// A function that calls `find` once for each number of bits that it is asked with. Copies share what was found, in
// one thread.
template <class Find>
auto at_each_precision(Find find) {
  using Found = decltype(find());
  return [find = std::move(find), found = std::make_shared<std::map<long, Found>>()]() -> const Found& {
    const long bits = Arithmetic<Deep>::bits();
    const auto known = found->find(bits);
    return known != found->end() ? known->second : found->emplace(bits, find()).first->second;
  };
}

}  // namespace epure::geometry
