// What several quantities of a ledger need, and none when none of them is wanted: found when it is first asked for.
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace epure {

// A function that calls `find` once, and again only when that threw. Copies share what was found, and `find` itself,
// which holds much and is copied often.
template <class Find>
auto once(Find find) {
  struct Kept {
    Find find;
    std::optional<decltype(find())> found;
  };
  return [kept = std::make_shared<Kept>(Kept{std::move(find), std::nullopt})]() -> const auto& {
    if (!kept->found) kept->found.emplace(kept->find());
    return *kept->found;
  };
}

}  // namespace epure
