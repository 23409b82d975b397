// One part of a text for another.
#pragma once

#include <string>
#include <string_view>

namespace epure {

// Wherever it stands, from the front on; what is put in is not looked through again. `from` is not empty.
inline void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace epure
