// Text in columns.
#pragma once

#include <string>
#include <vector>

namespace epure {

// Each row a line, its cells padded to the widest of their column (in characters, not bytes) and set two blanks
// apart, after `indent` blanks. No blanks at the end of a line.
std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t indent = 0);

}  // namespace epure
