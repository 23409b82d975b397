// How the quantities of a pair are called.
#pragma once

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure::gear_pair {

// "r_tip_" and 1: "r_tip_1".
inline std::string on(const std::string& name, int wheel) { return name + std::to_string(wheel); }

inline Quantity quantity(const std::string& name, const std::string& letters, const char* unit,
                         const Words& meaning) {
  return {name, "$" + letters + "$", unit, meaning};
}
inline Quantity length(const std::string& name, const std::string& letters, const Words& meaning) {
  return quantity(name, letters, "m", meaning);
}
inline Quantity pure(const std::string& name, const std::string& letters, const Words& meaning) {
  return quantity(name, letters, "1", meaning);
}
// Of wheel 1 or 2: the number stands at the end of the name, and last in the index.
inline Quantity of_wheel(int wheel, const std::string& name, const std::string& letter, const std::string& index,
                         const Words& what) {
  return length(on(name, wheel), letter + "_{" + on(index, wheel) + "}",
                what + format_words(" of wheel {}", " della ruota {}", wheel));
}

// Where along the path of contact the flanks are looked at: at its ends, or where whole flanks would begin and end.
// Velocities are along the common tangent, towards tip 1; ξ is counted from P0, as contact travels.
inline Quantity position(const std::string& at) {
  return length("xi_" + at, "ξ", {"position on the line of action", "posizione sulla retta d'azione"});
}
inline Quantity flank_velocity(int flank, const std::string& at) {
  return quantity(on("v_t", flank) + "_" + at, "v_{" + on("t", flank) + "}", "m/s",
                  {"velocity along the common tangent", "velocità lungo la tangente comune"});
}
inline Quantity specific_sliding(int flank, const std::string& at) {
  return pure(on("zeta_", flank) + "_" + at, "ζ_{" + on("", flank) + "}",
              {"specific sliding", "strisciamento specifico"});
}

}  // namespace epure::gear_pair
