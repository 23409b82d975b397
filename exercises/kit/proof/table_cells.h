// A long table as its pages show it and as a spreadsheet reads it, held against another route.
#pragma once

#include <optional>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// What is wrong with the table that the pages of an English sheet show, in one sentence that begins with the sheet's
// name; none: every row stands on them, every cell is the other route's value rounded to the digits it is printed
// with, and of the values themselves, which a spreadsheet reads, none is farther from the other route's than the next
// double: the nearest one of a true value midway between two is either.
std::optional<Words> wrong_table(const std::string& sheet, const DrawnSheet& drawn, const LongTable& table);

}  // namespace epure
