// What a drawing is to be like in a document, understood.
#pragma once

#include <optional>

#include "drawings/marks/background.h"
#include "drawings/page.h"
#include "exercises/cli/figure_size.h"
#include "exercises/cli/options.h"

namespace epure {

struct Looks {
  FigureSize size = {};        // of a bare figure, at most
  double dots_per_inch = 150;  // of a picture
  std::optional<drawings::Background> background =
      {};  // none: the drawing as it is, white paper or nothing behind it
};

// --bare, or what implies it.
bool is_bare(const Options& options);

// Throws WrongUsage.
Looks looks_asked(const Options& options);

// Throws WrongUsage for a page that would be too large a picture.
void demand_paintable(const drawings::Page& page, double dots_per_inch);

}  // namespace epure
