#include "exercises/cli/printable.h"

#include <algorithm>
#include <vector>

#include "exercises/cli/utf8.h"

namespace epure {
namespace {

// Longer words are nobody's words, longer sentences nobody reads: what is kept of both ends, in characters.
struct Keep {
  std::size_t longest, beginning, end;
};
constexpr Keep of_word{120, 60, 20}, of_sentence{1200, 800, 300};

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c <= 0x9F); }

bool is_shown(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  return !(is_control(c) || c == 0xAD || c == 0x61C || within(0x200B, 0x200F) || within(0x2028, 0x202E) ||
           within(0x2060, 0x206F) || c == 0xFEFF || within(0xFFF0, 0xFFFB) || within(0xE0000, 0xE007F));
}

// Characters, each as its bytes.
std::string without_middle(const std::string& text, Keep keep) {
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (!continues_a_character(text[at])) begins.push_back(at);
  if (begins.size() <= keep.longest) return text;
  return text.substr(0, begins[keep.beginning]) + "..." + text.substr(begins[begins.size() - keep.end]);
}

}  // namespace

std::string shown_whole(const std::string& text) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, bytes] = character(text, at);
    const std::size_t width = std::max<std::size_t>(bytes, 1);
    all += bytes > 0 && is_shown(code) ? text.substr(at, width) : "?";
    at += width;
  }
  return all;
}

std::string printable(const std::string& sentence) {
  std::string all, word;
  const auto end_word = [&] {
    all += without_middle(word, of_word);
    word.clear();
  };
  for (const char c : shown_whole(sentence)) {
    word += c;
    if (c == ' ') end_word();
  }
  end_word();
  return without_middle(all, of_sentence);
}

bool commands_a_terminal(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, bytes] = character(text, at);
    if (bytes > 0 && is_control(code)) return true;
    at += std::max<std::size_t>(bytes, 1);
  }
  return false;
}

}  // namespace epure
