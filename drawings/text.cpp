#include "drawings/text.h"

#include <stdexcept>
#include <utility>

#include "drawings/typeset.h"

namespace epure::drawings {
namespace {

// At spaces outside of mathematics. A line break is a space too.
std::vector<std::string> words(const std::string& rich_text) {
  std::vector<std::string> found;
  std::string word;
  bool mathematics = false, escaped = false;
  const auto end_word = [&] {
    if (!word.empty()) found.push_back(std::exchange(word, {}));
  };
  for (const char c : rich_text) {
    if (c == '$' && !escaped) mathematics = !mathematics;
    escaped = c == '\\' && !(mathematics && escaped);
    if ((c == ' ' || c == '\n') && !mathematics)
      end_word();
    else
      word += c;
  }
  end_word();
  return found;
}

}  // namespace

TextSize measure(const std::string& rich_text, double size, Weight weight) {
  return typeset(rich_text, size, weight).extent;
}

std::vector<std::string> wrap(const std::string& rich_text, double size, double width, Weight weight) {
  std::vector<std::string> lines;
  for (const std::string& word : words(rich_text)) {
    std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && measure(longer, size, weight).width <= width)
      lines.back() = std::move(longer);
    else
      lines.push_back(word);
  }
  return lines;
}

}  // namespace epure::drawings
