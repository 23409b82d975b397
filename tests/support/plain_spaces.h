// Letters as the eye has them.
#pragma once

#include <string>

namespace epure::tests {

// Spaces that do not break are spaces.
inline std::string with_plain_spaces(std::string text) {
  const std::string unbroken = "\u00a0";
  for (auto at = text.find(unbroken); at != std::string::npos; at = text.find(unbroken, at))
    text.replace(at, unbroken.size(), " ");
  return text;
}

}  // namespace epure::tests
