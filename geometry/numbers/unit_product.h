// Units that no given has, and of which there are too many for a list: "mm^3", "kN/m", "kg m/s", "N m s".
#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/numbers/number.h"

namespace epure::geometry {

struct UnitProduct {
  using Powers = std::array<int, 4>;
  Powers powers;    // of metre, kilogram, second, radian
  Rational factor;  // how many of their product it is
};

// Of powers of known lengths, times, masses, forces, stresses, energies and powers, of litres and of radians; they
// are parted by blanks, "*" or "·", and those after a slash divide. None for any other text. "Nm", "kgm^2", "Ns":
// what begins with more than a length or a time needs no sign between.
std::optional<UnitProduct> unit_product(const std::string& symbol);

}  // namespace epure::geometry
