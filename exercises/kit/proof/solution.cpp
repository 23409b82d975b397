#include "exercises/kit/proof/solution.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <utility>

namespace epure {
namespace {

bool is_known(const geometry::Settled& settled) {
  using Kind = geometry::Settled::Kind;
  return settled.kind == Kind::certain || settled.kind == Kind::enclosed;
}

std::optional<double> rounded(const geometry::Settled& settled) {
  if (!is_known(settled)) return std::nullopt;
  const geometry::Enclosure& ends = settled.enclosure;
  return ends.lower <= 0 && ends.upper >= 0 ? 0 : ends.value;
}

}  // namespace

// Found once, when it is asked for; after that nothing of it changes.
class Solution::Part {
 public:
  explicit Part(std::vector<RouteValue> found) {
    std::call_once(once_, [&] { take(std::move(found)); });
  }
  explicit Part(FindPart part) : of_case_(std::move(part.of_case)), find_(std::move(part.find)) {}

  const std::string& of_case() const { return of_case_; }

  const std::vector<RouteValue>& values() {
    std::call_once(once_, [&] { take(find_()); });
    return values_;
  }
  const RouteValue* look_up(const std::string& quantity) {
    const std::vector<RouteValue>& all = values();
    const auto at = places_.find(quantity);
    return at == places_.end() ? nullptr : &all[at->second];
  }
  std::optional<double> value(const std::string& quantity, const std::string& route) {
    values();
    const auto found = by_route_.find({quantity, route});
    return found == by_route_.end() ? std::nullopt : rounded(found->second);
  }

 private:
  void take(std::vector<RouteValue> found) {
    for (RouteValue& value : found) {
      by_route_.try_emplace({value.quantity, value.route}, value.settled);
      const auto [at, is_new] = places_.try_emplace(value.quantity, values_.size());
      if (is_new)
        values_.push_back(std::move(value));
      else if (!is_known(values_[at->second].settled) && is_known(value.settled))
        values_[at->second] = std::move(value);
    }
  }

  std::string of_case_;
  std::function<std::vector<RouteValue>()> find_;
  std::once_flag once_;
  std::vector<RouteValue> values_;
  std::map<std::string, std::size_t> places_;  // in values_
  std::map<std::pair<std::string, std::string>, geometry::Settled> by_route_;
};

Solution::Solution(Givens givens, std::vector<RouteValue> values)
    : givens_(std::move(givens)), parts_{std::make_shared<Part>(std::move(values))} {}

Solution::Solution(Givens givens, const std::vector<FindPart>& parts) : givens_(std::move(givens)) {
  for (const FindPart& part : parts) parts_.push_back(std::make_shared<Part>(part));
  parts_.front()->values();
}

std::vector<RouteValue> Solution::values() const {
  std::vector<RouteValue> all;
  for (const auto& part : parts_) all.insert(all.end(), part->values().begin(), part->values().end());
  return all;
}

Solution::Part* Solution::part_of(const std::string& quantity) const {
  if (parts_.size() == 1) return parts_.front().get();
  const std::size_t point = quantity.find('.');
  const std::string of_case = point == std::string::npos ? "" : quantity.substr(0, point);
  const auto at =
      std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part->of_case() == of_case; });
  return at == parts_.end() ? nullptr : at->get();
}

const RouteValue* Solution::look_up(const std::string& quantity) const {
  Part* part = part_of(quantity);
  return part ? part->look_up(quantity) : nullptr;
}

const RouteValue& Solution::find(const std::string& quantity) const {
  const RouteValue* found = look_up(quantity);
  assert(found && "a quantity that no route writes");
  return *found;
}

std::optional<double> Solution::value(const std::string& quantity) const { return rounded(find(quantity).settled); }

std::optional<double> Solution::value(const std::string& quantity, const std::string& route) const {
  Part* part = part_of(quantity);
  return part ? part->value(quantity, route) : std::nullopt;
}

std::optional<geometry::Enclosure> Solution::enclosure(const std::string& quantity) const {
  const geometry::Settled& settled = find(quantity).settled;
  return is_known(settled) ? std::optional(settled.enclosure) : std::nullopt;
}

double Solution::operator[](const std::string& quantity) const {
  const std::optional<double> known = value(quantity);
  if (known) return *known;
  const geometry::Settled& settled = find(quantity).settled;
  if (settled.kind == geometry::Settled::Kind::absent) throw geometry::Impossible(settled.reason);
  throw geometry::Undecided(settled.reason);
}

const Quantity& Solution::described(const std::string& quantity) const {
  const RouteValue& value = find(quantity);
  assert(value.described && "a quantity that is not reported");
  return *value.described;
}

std::optional<Place> Solution::point(const std::string& name) const {
  const std::optional<double> x = value(name + "_x"), y = value(name + "_y");
  return x && y ? std::optional(Place{*x, *y}) : std::nullopt;
}

Place Solution::place(const std::string& name) const { return {(*this)[name + "_x"], (*this)[name + "_y"]}; }

Arrow2 Solution::vector(const std::string& name) const { return {(*this)[name + "_x"], (*this)[name + "_y"]}; }

}  // namespace epure
