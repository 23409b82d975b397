#include "drawings/text/unicode.h"

#include <fmt/format.h>

#include <stdexcept>

namespace epure::drawings {
namespace {

struct Lead {
  std::size_t length = 0;  // of the whole sequence, 0: not a first byte
  char32_t bits = 0;
  char32_t least = 0;  // smaller values have a shorter form and must use it
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if ((byte & 0xE0) == 0xC0) return {2, byte & 0x1Fu, 0x80};
  if ((byte & 0xF0) == 0xE0) return {3, byte & 0x0Fu, 0x800};
  if ((byte & 0xF8) == 0xF0) return {4, byte & 0x07u, 0x10000};
  return {};
}

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0xFFFE || c == 0xFFFF; }
bool is_surrogate(char32_t c) { return c >= 0xD800 && c < 0xE000; }

char32_t next(std::string_view text, std::size_t& at) {
  const Lead lead = lead_of(static_cast<unsigned char>(text[at]));
  char32_t c = lead.bits;
  bool sound = lead.length > 0 && at + lead.length <= text.size();
  for (std::size_t i = 1; sound && i < lead.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[at + i]);
    sound = (byte & 0xC0) == 0x80;
    c = (c << 6) | (byte & 0x3Fu);
  }
  if (!sound || c < lead.least || c > 0x10FFFF || is_surrogate(c))
    throw std::invalid_argument(
        fmt::format("text is not UTF-8: byte 0x{:02X} at position {}", static_cast<unsigned char>(text[at]), at));
  at += lead.length;
  return c;
}

}  // namespace

std::u32string characters(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t c = next(text, at);
    if (is_control(c))
      throw std::invalid_argument(fmt::format("text holds the control character U+{:04X}", static_cast<unsigned>(c)));
    result += c;
  }
  return result;
}

std::string utf8(char32_t c) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xC0 | (c >> 6)), byte(0x80 | (c & 0x3F))};
  if (c < 0x10000) return {byte(0xE0 | (c >> 12)), byte(0x80 | ((c >> 6) & 0x3F)), byte(0x80 | (c & 0x3F))};
  return {byte(0xF0 | (c >> 18)), byte(0x80 | ((c >> 12) & 0x3F)), byte(0x80 | ((c >> 6) & 0x3F)),
          byte(0x80 | (c & 0x3F))};
}

}  // namespace epure::drawings
