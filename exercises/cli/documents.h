// What a drawing is to be like in a document, understood.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "drawings/marks/background.h"
#include "exercises/cli/options.h"

namespace epure {

struct Looks {
  std::optional<double> width_mm = {};  // of a bare figure, at most
  double dots_per_inch = 150;           // of a picture
  std::optional<drawings::Background> background =
      {};  // none: the drawing as it is, white paper or nothing behind it
};

// --bare, or what implies it.
bool is_bare(const Options& options);

// Throws WrongUsage.
Looks looks_asked(const Options& options);

// The pages of a bare figure, drawn by `draw` in a room as wide as it is told: the largest that are not wider than
// `width_mm`. Throws DoesNotFit.
std::vector<drawings::Page> pages_within(double width_mm,
                                         const std::function<std::vector<drawings::Page>(double room_mm)>& draw);

// Throws WrongUsage for a page that would be too large a picture.
void demand_paintable(const drawings::Page& page, double dots_per_inch);

}  // namespace epure
