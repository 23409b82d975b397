// Rich text (see Label in picture.h) taken apart: what is set in which style, raised or lowered, under an arrow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace epure::drawings {

// Either letters of one style or a group, perhaps under an arrow, with what is lowered and raised beside it.
struct Node {
  std::string letters = {};
  bool italic = false;
  std::vector<Node> group = {};
  bool arrow = false;
  std::vector<Node> below = {}, above = {};
};

// Throws std::invalid_argument, quoting the text, when a dollar sign or a brace has no partner, a command is unknown,
// a script is empty or given twice, or the text is too long or not UTF-8.
std::vector<Node> parse(std::string_view rich_text);

// A label is a line: longer ones are a mistake of the caller, and would be set at any cost.
inline constexpr std::size_t longest_label = 2000;  // bytes

}  // namespace epure::drawings
