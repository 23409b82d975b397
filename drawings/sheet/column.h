// The column beside the figure: headings, paragraphs, numbered steps, vector equations, tables.
#pragma once

#include <string>
#include <vector>

#include "drawings/sheet/galley.h"

namespace epure::drawings {

// Set in the room from its top down. When it does not fit, first the white space shrinks, then the letters, to no
// less than 2.2 mm; what still does not fit is said in `conflicts`. The
// lines of a step belong to it.
std::vector<Primitive> set_column(const std::vector<Block>& blocks, Box room, Language language,
                                  std::vector<std::string>* conflicts);

inline constexpr double column_size = 3.2, smallest_size = 2.2;  // mm

void set_block(Galley& galley, const VectorEquation& equation, Language language);
void set_block(Galley& galley, const Table& table, Language language);

}  // namespace epure::drawings
