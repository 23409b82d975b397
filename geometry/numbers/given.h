// What a user types as a given, read exactly.
//
//   number      "0.20"  "0,20"  "-1.5e-3"  "+3"  ".5"  "1/72"  "-3/4e2"     decimal point or comma; a fraction of two
//   with unit   "0.25m"  "25 cm"  "360rpm"  "37.7rad/s"  "1/72s"  "30deg"   blanks before the unit are optional
//
// Every number is taken as the exact rational it says: "0.20" is 1/5. Any unit of one kind is taken for any other. Of
// angles, and of what turns, some units count turns and some radians; π lies between, so such a number keeps the unit
// it was typed in. Refused, with one sentence that names the text, what is wrong and what would be accepted:
// thousands separators, a word where a number should be (nan, inf), a denominator of zero, an exponent beyond ±400,
// more than 1000 characters, anything left over, an unknown unit, a unit of another kind, and 1/s where something
// turns.
#pragma once

#include "geometry/numbers/angle.h"
#include "geometry/numbers/number.h"
#include "words/words.h"

#include <optional>
#include <string>
#include <vector>

namespace epure::geometry {

struct BadGiven : Told {
  using Told::Told;
};

enum class Kind {
  pure_number,
  length,
  time,
  angle,
  angular_velocity,
  angular_acceleration,
  velocity,
  acceleration,
  force,
  moment,
  mass,
  moment_of_inertia,
  stress,
  area,
  second_moment_of_area,
  energy,
  power,
  viscosity,
  flow,
  mass_per_length,
  force_per_time,
  force_per_time_squared,
  force_per_time_cubed
};

// Of an angle, an angular velocity, an angular acceleration.
bool turns(Kind kind);
// "a length".
Words name_of(Kind kind);

struct Unit {
  std::string symbol;
  Kind kind;
  Rational factor;            // how many of the kind's SI unit it is; of turns, how many turns (per s, per s²)
  bool counts_turns = false;  // of what turns only: the factor is one of turns, not of radians
};

// The unit with this symbol, if there is one. "" and "1" are the unit of a pure number; "²" is read as "^2".
std::optional<Unit> find_unit(const std::string& symbol);

// All units, in the order in which a message lists them.
const std::vector<Unit>& known_units();

// 37.7, and rad/s.
struct InUnit {
  Rational number;
  Unit unit;
};

// With what sheets and pages print - no-break, thin and narrow no-break spaces, the true minus - as it is typed.
std::string in_plain_characters(std::string text);

// In the given's own unit; with π between, in the unit that was typed. A text without a unit is in the given's.
// Throws BadGiven; an unknown unit of the given itself is a caller's mistake (assertion).
InUnit read_given(const std::string& text, const std::string& unit_of_the_given);

// The number as it stands, in the unit that was typed; in the given's where none was. Throws as read_given.
InUnit read_as_typed(const std::string& text, const std::string& unit_of_the_given);

// The value in the given's own unit. Throws BadGiven as read_given, and where π lies between.
Rational parse_given(const std::string& text, const std::string& unit_of_the_given);

// Of an angle, of an angular velocity (the angle of one second) and of an angular acceleration.
Angle angle_of(const InUnit& number);

// In SI units. Of what turns only where it is in radians (assertion).
Rational in_si(const InUnit& number);

// How many `to` one `from` is; both must be known, of one kind, and π not between them (assertion).
Rational conversion(const std::string& from, const std::string& to);

// "1/5", "-3", "360".
std::string to_text(const Rational& value);

}  // namespace epure::geometry
