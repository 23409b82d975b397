#include "exercises/cli/windows_1252.h"

#include <array>

#include "exercises/cli/utf8.h"

namespace epure {
namespace {

// Of 0x80 to 0x9F; the others are as in Unicode. 0: stands for nothing.
constexpr std::array<char16_t, 32> from_0x80{u'€', 0,    u'‚', u'ƒ', u'„', u'…', u'†', u'‡', u'ˆ', u'‰', u'Š',
                                             u'‹', u'Œ', 0,    u'Ž', 0,    0,    u'‘', u'’', u'“', u'”', u'•',
                                             u'–', u'—', u'˜', u'™', u'š', u'›', u'œ', 0,    u'ž', u'Ÿ'};

char16_t character_of(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code >= 0x80 && code < 0xA0 ? from_0x80.at(code - 0x80U) : code;
}

void append_in_utf8(std::string& text, char16_t code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
    return;
  }
  if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
  } else {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
  }
  text += static_cast<char>(0x80 | (code & 0x3F));
}

}  // namespace

std::optional<std::string> from_windows_1252(std::string_view bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const char16_t code = character_of(bytes[at]);
    if (code == 0 || character(bytes, at).second > 1) return std::nullopt;
    append_in_utf8(text, code);
  }
  return text;
}

}  // namespace epure
