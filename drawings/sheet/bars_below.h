// The scale bars of a bare figure, which stand right under it instead of at the foot of a sheet.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

// The scale bars among the marks of a figure, in their order; the other marks stay, each with its window.
std::vector<ScaleBar> taken_out(Figure& figure);

// The bars in rows below what is drawn, from its left edge on: as many in a row as it is wide, at least one.
// `conflicts`, when given, receives a sentence for letters of a bar that touch others.
std::vector<Primitive> bars_below(Box drawn, std::vector<ScaleBar> bars, std::vector<std::string>* conflicts);

}  // namespace epure::drawings
