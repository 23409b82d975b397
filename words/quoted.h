// What a user typed, in a sentence.
#pragma once

#include <string>

namespace epure {

// In quotes, cut to 60 bytes, with question marks for what a terminal would obey.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 60)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return result + (text.size() > 60 ? "...\"" : "\"");
}

}  // namespace epure
