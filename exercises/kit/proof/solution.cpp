#include "exercises/kit/proof/solution.h"

#include <cassert>
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

Solution::Solution(Givens givens, std::vector<RouteValue> values) : givens_(std::move(givens)) {
  for (RouteValue& value : values) {
    by_route_.try_emplace({value.quantity, value.route}, value.settled);
    const auto [at, is_new] = places_.try_emplace(value.quantity, values_.size());
    if (is_new)
      values_.push_back(std::move(value));
    else if (!is_known(values_[at->second].settled) && is_known(value.settled))
      values_[at->second] = std::move(value);
  }
}

const RouteValue& Solution::find(const std::string& quantity) const {
  const auto at = places_.find(quantity);
  assert(at != places_.end() && "a quantity that no route writes");
  return values_[at->second];
}

std::optional<double> Solution::value(const std::string& quantity) const { return rounded(find(quantity).settled); }

std::optional<double> Solution::value(const std::string& quantity, const std::string& route) const {
  const auto found = by_route_.find({quantity, route});
  return found == by_route_.end() ? std::nullopt : rounded(found->second);
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
