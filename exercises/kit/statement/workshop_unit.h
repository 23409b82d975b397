// The unit in which drawings and handbooks tell what is reported in SI: MPa, mm⁴.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace epure {

struct WorkshopUnit {
  std::string_view si, symbol;
  double per_si;
};

// None where drawings use the SI unit itself.
inline std::optional<WorkshopUnit> workshop_unit(std::string_view si) {
  static constexpr std::array<WorkshopUnit, 6> units{{{"Pa", "MPa", 1e-6},
                                                      {"Pa/m", "MPa/m", 1e-6},
                                                      {"m", "mm", 1e3},
                                                      {"m^2", "mm²", 1e6},
                                                      {"m^3", "mm³", 1e9},
                                                      {"m^4", "mm⁴", 1e12}}};
  for (const WorkshopUnit& unit : units)
    if (unit.si == si) return unit;
  return std::nullopt;
}

}  // namespace epure
