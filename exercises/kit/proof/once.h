// What several quantities of a ledger need, and none when none of them is wanted: found when it is first asked for.
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace epure {

// A function that calls `find` once, and again only when that threw. Copies share what was found.
template <class Find>
auto once(Find find) {
  using Found = decltype(find());
  return [find = std::move(find), found = std::make_shared<std::optional<Found>>()]() -> const Found& {
    if (!*found) found->emplace(find());
    return **found;
  };
}

}  // namespace epure
