#include "drawings/text/text.h"

#include <cmath>
#include <utility>

#include "drawings/text/typeset.h"

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

bool can_write(const std::string& plain_text) {
  try {
    measure(escaped(plain_text), 1);
    return true;
  } catch (const std::invalid_argument&) {  // names the first letter that is missing
    return false;
  }
}

TextSize measure(const std::string& rich_text, double size, Weight weight) {
  return typeset(rich_text, size, weight).extent;
}

std::vector<std::string> wrap(const std::string& rich_text, double size, double width, Weight weight) {
  // Words side by side are as wide as the line of them, but for kerning at the spaces: only a line that ends near the
  // edge has to be set to be measured.
  const double near_edge = size / 2;
  const double space = measure(" ", size, weight).width;
  std::vector<std::string> lines;
  double pen = 0;  // where the last line ends, nearly
  for (const std::string& word : words(rich_text)) {
    const double own = measure(word, size, weight).width, end = pen + space + own;
    const auto fits = [&] {
      if (std::abs(end - width) > near_edge) return end < width;
      return measure(lines.back() + " " + word, size, weight).width <= width;
    };
    if (!lines.empty() && fits()) {
      lines.back() += " " + word;
      pen = end;
    } else {
      lines.push_back(word);
      pen = own;
    }
  }
  return lines;
}

}  // namespace epure::drawings
