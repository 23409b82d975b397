// Whether a number stands without a unit.
#pragma once

#include <string>
#include <string_view>

#include "geometry/numbers/given.h"

namespace epure {

// Of "4,5", "1/72" and "≈ 4.5 ± 0.1", or an expression of such numbers.
inline bool has_no_unit(std::string text) {
  for (const std::string_view sign : {"≈", "±"})
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign)) text.erase(at, sign.size());
  return geometry::in_plain_characters(text).find_first_not_of("0123456789.,+-/eE ()~") == std::string::npos;
}

}  // namespace epure
