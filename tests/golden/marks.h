// What stands on a page, a line a mark in the order of painting: what a golden file holds. Lengths in tenths of a
// millimetre, which is less than the finest pen; the width and the dashes of a pen in millimetres. Not the version of
// the program.
//
//   page low.x low.y high.x high.y
//   told DESCRIPTION
//   stroke WIDTH COLOUR DASHES CLIP NAME PATH     dashes and clip: numbers with commas, or -; name: of the mark, or -
//   fill COLOUR CLIP NAME PATH                    path: M x y, then L x y, C x y x y x y, at last Z where it is
//   closed text SIZE regular|bold COLOUR x y RICH TEXT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::golden {

using Lines = std::vector<std::string>;

// The line of a mark.
std::string line_of(const drawings::Primitive& primitive);
Lines lines_of(const drawings::Page& page);

// What a line says of a mark; none: it is of the page. The same line again when it is written. Throws
// std::runtime_error with a line that none of these is.
std::optional<drawings::Primitive> primitive_of(const std::string& line);

}  // namespace epure::golden
