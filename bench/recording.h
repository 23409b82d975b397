// The calls of Cairo and Pango that draw pages, written down, for the bare program in floor/ to make them again. What
// that takes is what epure is held against, which sets its letters without Pango.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

// Calls one after the other: a byte that names it, then its numbers as doubles of this machine.
//   p width height            a page begins (points)
//   ( )                       save, restore
//   n m x y l x y c 6 z       new path, move, line, curve, close
//   k                         clip to the path
//   i red green blue opacity  ink
//   w width                   d count dashes...
//   S F                       stroke, fill
//   t face size x y bytes     letters of one face (see Face) from (x, y) on, followed by their UTF-8
// Throws what measuring text throws.
std::string record(const std::vector<Page>& pages);

}  // namespace epure::drawings
