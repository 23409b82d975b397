#include "exercises/cli/printable.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace epure {
namespace {

// Longer words are nobody's words, longer sentences nobody reads: what is kept of both ends, in characters.
struct Keep {
  std::size_t longest, beginning, end;
};
constexpr Keep of_word{120, 60, 20}, of_sentence{1200, 800, 300};

std::size_t length_of_sequence(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

// The character that begins at `at`, and how many bytes it takes; 0 bytes when none does.
std::pair<char32_t, std::size_t> character(const std::string& text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t length = length_of_sequence(lead);
  if (length < 2) return {lead, length};
  if (at + length > text.size()) return {0, 0};
  char32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[at + i]);
    if ((next & 0xC0) != 0x80) return {0, 0};
    code = (code << 6) | (next & 0x3F);
  }
  const std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least.at(length) || code > 0x10FFFF || is_surrogate) return {0, 0};
  return {code, length};
}

bool is_shown(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  return !(c < 0x20 || within(0x7F, 0x9F) || c == 0xAD || c == 0x61C || within(0x200B, 0x200F) ||
           within(0x2028, 0x202E) || within(0x2060, 0x206F) || c == 0xFEFF || within(0xFFF0, 0xFFFB) ||
           within(0xE0000, 0xE007F));
}

// Characters, each as its bytes.
std::string without_middle(const std::string& text, Keep keep) {
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80) begins.push_back(at);
  if (begins.size() <= keep.longest) return text;
  return text.substr(0, begins[keep.beginning]) + "..." + text.substr(begins[begins.size() - keep.end]);
}

}  // namespace

std::string printable(const std::string& sentence) {
  std::string shown, word;
  const auto end_word = [&] {
    shown += without_middle(word, of_word);
    word.clear();
  };
  for (std::size_t at = 0; at < sentence.size();) {
    const auto [code, bytes] = character(sentence, at);
    const std::string as_typed = sentence.substr(at, std::max<std::size_t>(bytes, 1));
    word += bytes > 0 && is_shown(code) ? as_typed : "?";
    if (code == ' ') end_word();
    at += as_typed.size();
  }
  end_word();
  return without_middle(shown, of_sentence);
}

}  // namespace epure
