// The pages of a drawn sheet: several of one with a long table.
#pragma once

#include <vector>

#include "drawings/page.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

inline std::vector<drawings::Page> pages_of(const DrawnSheet& drawn) {
  std::vector<drawings::Page> pages{drawings::compose(drawn.sheet)};
  for (const drawings::Sheet& further : drawn.further) pages.push_back(drawings::compose(further));
  return pages;
}

}  // namespace epure
