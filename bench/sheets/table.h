// A table inside a figure, letters and rules alone.
#pragma once

#include <string>
#include <vector>

#include "drawings/picture.h"

namespace epure::bench {

struct SheetColumn {
  double width = 10;  // mm
  bool to_the_right = true;
};

// What draw_table needs from its upper corner to its foot.
double height_of_table(const std::vector<std::vector<std::string>>& rows, double size);

// Draws `rows`, the first of them the head, from the upper left corner on, with letters of `size` mm, and returns the
// y of its foot. What is wider than its column is cut, with three dots.
double draw_table(drawings::Figure& figure, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<SheetColumn>& columns, drawings::Point corner, double size);

}  // namespace epure::bench
