#include "geometry/numbers/unit_product.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "geometry/numbers/given.h"
#include "geometry/numbers/unit_symbol.h"

namespace epure::geometry {
namespace {

constexpr int largest_power = 9;

std::optional<UnitProduct::Powers> powers_of(const Unit& unit) {
  switch (unit.kind) {
    case Kind::length:
      return {{1, 0, 0, 0}};
    case Kind::mass:
      return {{0, 1, 0, 0}};
    case Kind::time:
      return {{0, 0, 1, 0}};
    case Kind::force:
      return {{1, 1, -2, 0}};
    case Kind::stress:
      return {{-1, 1, -2, 0}};
    case Kind::energy:
      return {{2, 1, -2, 0}};
    case Kind::power:
      return {{2, 1, -3, 0}};
    case Kind::angle:
      if (!unit.counts_turns) return {{0, 0, 0, 1}};
      return {};
    default:
      return {};
  }
}

UnitProduct times(UnitProduct product, const UnitProduct& other, int power) {
  for (std::size_t i = 0; i < product.powers.size(); ++i) product.powers[i] += power * other.powers[i];
  for (int i = 0; i < std::abs(power); ++i)
    product.factor = power < 0 ? product.factor / other.factor : product.factor * other.factor;
  return product;
}

std::optional<UnitProduct> simple(const std::string& name) {
  if (name == "1") return UnitProduct{{}, 1};
  if (name == "l" || name == "L") return UnitProduct{{3, 0, 0, 0}, Rational(1, 1000)};
  const auto& units = known_units();
  const auto known = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return unit.symbol == name; });
  if (known == units.end()) return {};
  const auto powers = powers_of(*known);
  return powers ? std::optional(UnitProduct{*powers, known->factor}) : std::nullopt;
}

// "mm^3", "mm3"; "Nm^2" is N times m^2, but "mN" is no metre times a newton.
std::optional<UnitProduct> factor(const std::string& text) {
  std::size_t end = text.size();
  while (end > 0 && text[end - 1] >= '0' && text[end - 1] <= '9') --end;
  int power = 1;
  if (end > 0 && end < text.size()) {
    std::from_chars(text.data() + end, text.data() + text.size(), power);
    if (text.size() - end > 1 || power > largest_power) return {};
    if (text[end - 1] == '^') --end;
  } else {
    end = text.size();
  }
  const std::string name = text.substr(0, end);
  const UnitProduct one{{}, 1};
  if (const auto whole = simple(name)) return times(one, *whole, power);
  for (std::size_t i = 1; i < name.size(); ++i) {
    const auto first = simple(name.substr(0, i)), second = simple(name.substr(i));
    if (first && second && first->powers[1] != 0) return times(times(one, *first, 1), *second, power);
  }
  return {};
}

}  // namespace

std::optional<UnitProduct> unit_product(const std::string& symbol) {
  UnitProduct product{{}, 1};
  std::string rest = spelled_unit(symbol);
  int side = 1;
  bool has_factor = false;
  if (rest.ends_with('/')) return {};
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(" */"), rest.size());
    if (end > 0) {
      const auto next = factor(rest.substr(0, end));
      if (!next) return {};
      product = times(product, *next, side);
      has_factor = true;
    }
    if (end < rest.size() && rest[end] == '/') {
      if (side < 0) return {};  // what a/b/c or a/b·c/d is, nobody is sure of
      side = -1;
    }
    rest.erase(0, std::min(end + 1, rest.size()));
  }
  return has_factor ? std::optional(product) : std::nullopt;
}

}  // namespace epure::geometry
