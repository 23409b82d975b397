// Which step of a construction drew which marks and letters of a figure. Given is what the sheet to be solved shows
// too. Of the rest a sheet does not say: a step has its words and the place of its number. It drew the marks that its
// number stands on; of the others, those whose letters its words are the first to speak of; a line, when both its
// ends were there; a symbol, when the lines were that it stands between. Where nothing tells, a mark comes late
// rather than early.
#pragma once

#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

// For each mark and label of a figure its step; 0: it is given, or there are no steps.
struct StepsOfMarks {
  std::vector<int> marks, labels;
};

// `given`: the figure of the sheet to be solved.
StepsOfMarks steps_of_marks(const Figure& figure, const std::vector<Block>& column, const Figure& given);

}  // namespace epure::drawings
