// The empty sheet an exercise starts from, and the phrases sheets share.
#pragma once

#include <set>
#include <string>

#include "exercises/kit/panels/scale.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

// Names, title block, language and paper filled in; the column begins with the givens but for those that have no part
// in this case, and what is given beside them; the source says when these are not its own. The figure is
// empty.
DrawnSheet blank_sheet(const Description& about, const std::string& sheet, const Givens& givens,
                       const SheetRequest& request, const std::set<std::string>& without_part = {});

// Where the panels may draw: the drawing area of the paper, or as much of it, at its lower left corner, as the
// request has room for.
drawings::Box figure_area(const SheetRequest& request);

// The part of it above the strip in which the scale bars stand.
drawings::Box room_above_scale_bars(const SheetRequest& request);

// Puts the bars side by side at the foot of the drawing area (of a bare figure they move up to it), and their
// captions into the title block.
void add_scale_bars(DrawnSheet& onto, const std::vector<Scale>& scales, const SheetRequest& request);

// A number as the sheet writes it, with `figures` significant figures.
std::string figures(double value, int figures, Language language);

// To a thousandth, which is about what a file's resolution leaves of a difference.
std::string percent(double value, Language language);

// What a reader who does not see the sheet is told: a sentence, then the values. Plain text.
struct Value {
  std::string name;
  double value;
  std::string unit;
};
std::string in_words(const Words& sentence, const std::vector<Value>& values, Language language);

}  // namespace epure
