// How a sheet is divided: frame, drawing area on the left, column and title block on the right.
#pragma once

#include "drawings/picture.h"

namespace epure::drawings {

struct Layout {
  Box paper, frame, drawing;
  Box column;       // where the column's text stands; its foot is the top of the title block
  Box title_block;  // its right and lower borders are the frame's
};

Layout layout(Paper paper, double title_block_height);
double title_block_width(Paper paper);
Box paper_box(Paper paper);

inline constexpr double margin = 10;  // mm from the paper's edge to the frame
inline constexpr double inset =
    2.5;  // mm from the title block's rules to its letters; the column keeps the same edges

}  // namespace epure::drawings
