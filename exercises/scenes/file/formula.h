// What a scene says of a number: "120 mm", "-75 deg", "1/3", "AB/2 + 5 mm". Sums, products and quotients of numbers
// with units and of givens, exact; nothing that could run for ever.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "exercises/kit/statement/givens.h"
#include "exercises/scenes/file/text_tree.h"

namespace epure::scenes {

// Of what a number is: m^a s^b, an angle (over s^b), or of a kind of its own (a force).
struct Dimension {
  int metres = 0, seconds = 0;
  bool turns = false;
  std::optional<geometry::Kind> own = {};
  bool operator==(const Dimension&) const = default;
};

// In SI units, or of what turns the angle (of one second, of one second squared).
struct Amount {
  Dimension dimension = {};
  Rational value = 0;
  Angle angle = {};
  bool is_bare = false;  // typed without a unit, not a ratio: it may be taken in any
};

// The names that a formula may use.
using Amounts = std::map<std::string, Amount>;

// What is wrong with a formula, without its place.
struct BadFormula : Told {
  using Told::Told;
};

// The number that the text says, which must be of the kind `wanted`; a number without a unit is taken in
// `unit_of_bare` (empty: refused). Throws BadFormula.
Amount read_amount(const std::string& text, geometry::Kind wanted, const std::string& unit_of_bare,
                   const Amounts& known);

// The same of whatever kind it is.
Amount read_any_amount(const std::string& text, const Amounts& known);

// Of a given, as it stands now.
Amount amount_of(const Givens& givens, const GivenSpec& spec);

// That this is no unit, and which are.
Words no_unit(std::string_view text);

// The unit in which a kind is told: "m".
std::string unit_of(geometry::Kind kind);

}  // namespace epure::scenes
