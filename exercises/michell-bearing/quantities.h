// What is reported, by name; the names of stations say where they are: "p_at_0p15" is p at x = 0.15 m.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/statement/quantity.h"
#include "geometry/numbers/number.h"

namespace epure::michell_bearing {

using geometry::Rational;

// A cross section of which the film is reported: "0p15" or "x_1".
struct Station {
  std::string name;
  Rational x;
};
// Those of the source's table.
const std::vector<Station>& stations();

// Depths at which the velocities of the source's table are reported: "0p05mm".
struct Depth {
  std::string name;
  Rational z;
};
const std::vector<Depth>& depths();

Quantity film_quantity(const std::string& name);
Quantity pad_quantity(const std::string& name);
// Of "h", "dp_dx", "p", "p_bezout", "tau_0", "tau_h" at a station, and the velocity at a depth or in mid film.
Quantity at_station(const std::string& of, const std::string& station);
Quantity velocity_at(const std::string& station, const std::string& depth);
inline constexpr const char* mid_film = "mid_film";

}  // namespace epure::michell_bearing
