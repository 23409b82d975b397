#include "exercises/kit/statement/dimension.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

#include "geometry/numbers/given.h"

namespace epure {
namespace {

// "m^2" and "s".
std::optional<Dimension> dimension_of_factor(std::string_view factor) {
  static const std::map<std::string_view, Dimension> known = {
      {"1", {}},         {"rad", {}},       {"deg", {}},         {"rpm", {0, 0, -1}}, {"Hz", {0, 0, -1}},
      {"m", {1, 0, 0}},  {"kg", {0, 1, 0}}, {"s", {0, 0, 1}},    {"N", {1, 1, -2}},   {"Nm", {2, 1, -2}},
      {"J", {2, 1, -2}}, {"W", {2, 1, -3}}, {"Pa", {-1, 1, -2}},
  };
  const std::size_t raised = factor.find('^');
  const auto found = known.find(factor.substr(0, raised));
  if (found == known.end()) return std::nullopt;
  if (raised == std::string_view::npos) return found->second;
  int power = 0;
  const std::string_view digits = factor.substr(raised + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), power);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return power * found->second;
}

// The unit that stands first among those of its kind, which is one of SI or counts turns.
std::string first_of_its_kind(const std::string& unit) {
  const auto typed = geometry::find_unit(unit);
  if (!typed) return unit;
  const auto& all = geometry::known_units();
  return std::find_if(all.begin(), all.end(), [&](const geometry::Unit& each) { return each.kind == typed->kind; })
      ->symbol;
}

}  // namespace

std::optional<Dimension> dimension_of(const std::string& unit) {
  const std::string product = first_of_its_kind(unit);
  Dimension dimension;
  int power = 1;
  for (std::size_t begin = 0;;) {
    const std::size_t end = std::min(product.find_first_of("* /", begin), product.size());
    const auto factor = dimension_of_factor(std::string_view(product).substr(begin, end - begin));
    if (!factor) return std::nullopt;
    dimension = dimension + power * *factor;
    if (end == product.size()) return dimension;
    if (product[end] == '/') power = -1;  // of all that follows: "N*s/m" has one stroke at most
    begin = end + 1;
  }
}

}  // namespace epure
