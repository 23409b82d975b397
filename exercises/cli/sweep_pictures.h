// The mechanism at each position of a sweep: pages that lie over each other, at one standard scale.
#pragma once

#include <optional>
#include <vector>

#include "drawings/page.h"
#include "exercises/cli/sweep_study.h"

namespace epure {

struct SweepPictures {
  std::vector<std::optional<drawings::Page>> positions;  // by row; none: there is no mechanism
  drawings::Page scales;                                 // what lies under all of them: the bars of their scales
};

// Of the sheet that draws most of the quantities (vectors, points); of several the first. None: no sheet shows a
// mechanism.
std::optional<SweepPictures> sweep_pictures(const SweepStudy& study, Language language);

}  // namespace epure
