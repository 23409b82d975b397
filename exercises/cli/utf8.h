// Characters of UTF-8, one after another.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace epure {

// The character that begins at `at`, and how many bytes it takes; 0 bytes when none does.
std::pair<char32_t, std::size_t> character(std::string_view text, std::size_t at);

// In the middle of one, of more than a byte.
inline bool continues_a_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t count_characters(std::string_view text);

}  // namespace epure
