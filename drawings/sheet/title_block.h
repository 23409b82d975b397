// The title block in the manner of ISO 7200, with a bar that tells whether a printer has scaled the sheet.
#pragma once

#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

double title_block_height(const Sheet& sheet);
std::vector<Primitive> set_title_block(const Sheet& sheet, Box box, std::vector<std::string>* conflicts);

}  // namespace epure::drawings
