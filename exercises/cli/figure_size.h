// Figures no larger than a document has room for.
#pragma once

#include <functional>
#include <optional>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// mm; none: as the paper has it.
struct FigureSize {
  std::optional<double> width = {}, height = {};
  bool is_asked() const { return width || height; }
};

// A bare figure in a room of this size.
using DrawnIn = std::function<DrawnSheet(const FigureSize& room)>;

// The largest that is no larger than `most`. Throws DoesNotFit, with the least size that would do.
DrawnSheet drawn_within(const FigureSize& most, const DrawnIn& draw);

// Of such a figure, why it is hard to read, and from which size on it is not; none: it reads well.
std::optional<Words> hard_to_read(const DrawnSheet& figure, const FigureSize& most, const DrawnIn& draw);

}  // namespace epure
