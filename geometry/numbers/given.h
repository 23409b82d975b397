// What a user types as a given, read exactly.
//
//   number      "0.20"  "-1.5e-3"  "+3"  ".5"  "1/72"  "-3/4e2"     decimal point; a fraction of two such numbers
//   with unit   "0.25m"  "25 cm"  "360rpm"  "1/72s"  "30deg"        blanks before the unit are optional
//
// Every number is taken as the exact rational it says: "0.20" is 1/5. Refused, with one sentence that names the text,
// what is wrong and what would be accepted: a decimal comma, a thousands separator, a word where a number should be
// (nan, inf), a denominator of zero, an exponent beyond ±400, more than 1000 characters, anything left over, an
// unknown unit, a unit of another dimension, and rad/s where turns are counted (2π is irrational: state the speed in
// rpm).
#pragma once

#include "geometry/numbers/number.h"
#include "words/words.h"

#include <optional>
#include <string>
#include <vector>

namespace epure::geometry {

struct BadGiven : Told {
  using Told::Told;
};

struct Unit {
  std::string symbol;
  Rational factor;        // how many of the dimension's own unit it is
  std::string dimension;  // "length", "time", "turns per time", ...; units of one dimension convert into each other
};

// The unit with this symbol, if there is one. "" and "1" are the unit of a pure number.
std::optional<Unit> find_unit(const std::string& symbol);

// All units, in the order in which a message lists them.
const std::vector<Unit>& known_units();

// The value in the given's own unit. A text without a unit is in that unit. Throws BadGiven; an unknown unit of the
// given itself is a caller's mistake (assertion).
Rational parse_given(const std::string& text, const std::string& unit_of_the_given);

// How many `to` one `from` is; both must be known and of one dimension (assertion).
Rational conversion(const std::string& from, const std::string& to);

// "1/5", "-3", "360".
std::string to_text(const Rational& value);

}  // namespace epure::geometry
