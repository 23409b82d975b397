// The vectors on a sheet.
#pragma once

#include <variant>
#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure::tests {

inline std::vector<drawings::Arrow> arrows_of(const DrawnSheet& drawn, drawings::Meaning meaning) {
  std::vector<drawings::Arrow> all;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark); arrow && arrow->meaning == meaning)
      all.push_back(*arrow);
  return all;
}

}  // namespace epure::tests
