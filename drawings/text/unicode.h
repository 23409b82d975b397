// UTF-8 taken apart strictly, because Cairo, HarfBuzz and browsers all do something else with broken text.
#pragma once

#include <string>
#include <string_view>

namespace epure::drawings {

// Throws std::invalid_argument for text that is not UTF-8 or holds control characters.
std::u32string characters(std::string_view utf8);
std::string utf8(char32_t character);

}  // namespace epure::drawings
