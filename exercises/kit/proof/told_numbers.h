// The numbers that a sheet tells in words, held against what is known.
#pragma once

#include <string>
#include <vector>

#include "drawings/picture.h"

namespace epure {

// A quantity that has a value, under its letters.
struct KnownNumber {
  std::string name;    // "v_B"
  std::string symbol;  // rich text: "$v_{B}$"
  double value;
};

// A number that a sheet tells and that it should not, with the words it stands in.
struct WrongNumber {
  std::string number, text;
};

// Looks at every number with a decimal sign in the column and in the description of a sheet in English (whole ones
// count things): it must be the rounding of a known one, of the very one where its letters stand before it ("v_B =
// 5.103", or its row and column in a table), and of a pair "(x; y)" both of one point or vector. Not looked at: what
// is given; how near a curve is to the true one, which depends on the scale; and what a ruler reads, which is
// compared with its quantity as a length of the sheet.
// Numbers in `quoted` may stand anywhere: what the source printed, what is wrong with the mechanism.
std::vector<WrongNumber> wrong_numbers(const drawings::Sheet& sheet, const std::vector<KnownNumber>& known,
                                       const std::vector<std::string>& quoted = {});

// Whether a cell of a table, as an English sheet writes it ("−12.3", "5", "$1.2·10^{−7}$"), is the value rounded to
// its digits.
bool is_rounding_of(const std::string& cell, double value);

}  // namespace epure
