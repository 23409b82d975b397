// Which step of a construction drew which marks and letters of a figure. A sheet does not say: a step has its words
// and the place of its number. It drew the marks that its number stands on; of the others, those whose letters its
// words are the first to speak of; a line, when both its ends were there; a symbol, when the lines were that it
// stands between. What the figure itself knows of a mark's step goes before all this.
#pragma once

#include <optional>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

// For each mark, label and number of a figure its step; 0: it was there before the first, or nothing tells.
struct StepsOfMarks {
  std::vector<int> marks, labels;
  std::vector<std::optional<std::size_t>> lines;  // under each number: which mark its step drew there, if any
};

StepsOfMarks steps_of_marks(const Figure& figure, const std::vector<Block>& column);

}  // namespace epure::drawings
