// Forces as quantities: R_ij of body i on body j, and what is applied from outside under a letter of its own.
#pragma once

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure {

// "R_13"; a place tells two of them apart: "R_13_upper", with a prime for its letter.
inline VectorQuantity force_between(int i, int j, const std::string& place = {}, const std::string& prime = {},
                                    const Words& where = {}) {
  const std::string ij = std::to_string(i) + std::to_string(j);
  const Words meaning = format_words("force of body {} on body {}", "forza del corpo {} sul corpo {}", i, j) + where;
  return {"R_" + ij + (place.empty() ? "" : "_" + place), "\\it{{R}}" + prime + "_{{{}}}", ij, "N", meaning, meaning};
}
// An applied force, along the direction that was given to it.
inline VectorQuantity applied_force(const std::string& letter, const Words& meaning) {
  return {letter, "\\it{{" + letter + "}}{}", "", "N", meaning, meaning};
}
inline Quantity applied_couple(const std::string& letter, const Words& meaning) {
  return {letter, "$\\it{" + letter + "}$", "N*m", meaning};
}

}  // namespace epure
