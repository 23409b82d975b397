// The drawings' own words in both languages, and numbers as each language writes them.
#pragma once

#include <string>

#include "drawings/picture.h"

namespace epure::drawings {

struct SheetWords {
  // title block
  std::string scale, scales, source, paper, sheet;
  std::string check_bar;  // beside a bar of 50 mm
  // column
  std::string construction, results, given, direction, magnitude;
  // table heads
  std::string quantity, value, on_sheet, printed;
};
const SheetWords& words(Language language);

// `significant` figures, trailing zeros kept: 5.30 or 5,30; a true minus sign. Beyond 10^6 and below 10^-3 as a
// power of ten in mathematics: "$1.50·10^{-5}$". Throws std::invalid_argument for what is not finite, or fewer than
// one or more than fifteen figures.
std::string number(double value, int significant, Language language);

}  // namespace epure::drawings
