// The motions of a mechanism with friction, and what its quantities are called in each.
#pragma once

#include <array>
#include <string>

#include "exercises/kit/statement/forces.h"

namespace epure::friction_efficiency {

enum class Motion { ideal, direct, retrograde };
inline constexpr std::array<Motion, 3> motions{Motion::ideal, Motion::direct, Motion::retrograde};
inline constexpr std::array<Motion, 2> with_friction{Motion::direct, Motion::retrograde};
inline std::string suffix(Motion motion) { return motion == Motion::direct ? "_direct" : "_retrograde"; }
inline Words name_of(Motion motion) {
  return motion == Motion::direct ? Words{"direct motion", "moto diretto"}
                                  : Words{"retrograde motion", "moto retrogrado"};
}
inline Words words_of(Motion motion) { return ", " + name_of(motion); }
// In the retrograde motion with a prime, as the source writes P'; beside what stands above already.
inline std::string primed(std::string letters) {
  const std::string above = "}}^{{";
  const auto at = letters.find(above);
  if (at == std::string::npos) return letters.insert(letters.find("}}") + 2, "^{{'}}");
  return letters.insert(letters.find("}}", at + above.size()), "'");
}
inline VectorQuantity in(Motion motion, VectorQuantity quantity) {
  quantity.name += suffix(motion);
  if (motion == Motion::retrograde) quantity.letters = primed(quantity.letters);
  quantity.meaning = quantity.meaning + words_of(motion);
  quantity.size = quantity.size + words_of(motion);
  return quantity;
}
inline Quantity in(Motion motion, const Quantity& quantity) {
  std::string symbol = quantity.symbol;
  if (motion == Motion::retrograde) symbol.insert(symbol.size() - 1, "'");
  return {quantity.name + suffix(motion), symbol, quantity.unit, quantity.meaning + words_of(motion)};
}
inline PointQuantity in(Motion motion, const PointQuantity& P) {
  const std::string prime = motion == Motion::retrograde ? "'" : "";
  return {P.name + suffix(motion), P.of + words_of(motion), point_letters(P.name) + prime};
}

}  // namespace epure::friction_efficiency
