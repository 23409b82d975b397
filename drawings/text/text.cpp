#include "drawings/text/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "drawings/text/even_lines.h"
#include "drawings/text/typeset.h"

namespace epure::drawings {
namespace {

// At spaces outside of mathematics. A line break is a space too.
std::vector<std::string> words_of(const std::string& rich_text) {
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

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& all, const std::string& word) {
  return std::find(all.begin(), all.end(), word) != all.end();
}
constexpr std::array<std::string_view, 8> relations{"=", "≈", "≡", "<", ">", "≤", "≥", ":"};
// They stand between two terms of a formula, or before one.
bool joins_both(const std::string& word) {
  constexpr std::array<std::string_view, 7> operations{"+", "−", "±", "·", "/", "∥", "⊥"};
  return is_one_of(relations, word) || is_one_of(operations, word);
}
bool joins_next(const std::string& word) {
  constexpr std::array<std::string_view, 7> functions{"sin", "cos", "tan", "tg", "ln", "arctan", "arctg"};
  return is_one_of(functions, word);
}

// Of a number's last digit and the unit after it, whatever mark of punctuation ends the words.
bool is_number(const std::string& word) {
  return std::any_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
         word.find_first_not_of("0123456789.,−") == std::string::npos;
}
bool is_unit(std::string word) {
  constexpr std::array<std::string_view, 26> units{
      "m",   "cm",  "mm",   "µm", "s",  "ms", "min",  "m/s",   "m/s²", "mm/s", "rad", "rad/s", "rad/s²",
      "rpm", "1/s", "1/s²", "N",  "kN", "MN", "N/mm", "N/mm²", "Pa",   "MPa",  "kg",  "J",     "W"};
  word.erase(std::find_if(word.rbegin(), word.rend(),
                          [](char c) { return std::string_view(".,;:)").find(c) == std::string_view::npos; })
                 .base(),
             word.end());
  return is_one_of(units, word);
}

using Words = std::vector<std::string>;

// As what stands side by side in a formula does, or a number and its unit.
bool belong_together(const std::string& word, const std::string& next) {
  return joins_both(word) || joins_both(next) || joins_next(word) || (is_number(word) && is_unit(next)) ||
         (word == "N" && is_unit(next));
}

// Words that are one formula stay together.
std::vector<Words> formulas(Words words) {
  std::vector<Words> all;
  for (std::string& word : words) {
    if (all.empty() || !belong_together(all.back().back(), word)) all.emplace_back();
    all.back().push_back(std::move(word));
  }
  return all;
}

// A formula that is too long for a line: before its relations, or where it has but one, at every word.
std::vector<Words> parts(const Words& formula) {
  std::vector<Words> all(1);
  for (const std::string& word : formula) {
    if (is_one_of(relations, word) && !all.back().empty()) all.emplace_back();
    all.back().push_back(word);
  }
  if (all.size() > 1) return all;
  all.clear();
  for (const std::string& word : formula) all.push_back({word});
  return all;
}

std::string in_a_row(const Words& words) {
  std::string all;
  for (const std::string& word : words) (all += all.empty() ? "" : " ") += word;
  return all;
}

class Wrapped {
 public:
  Wrapped(double size, double width, Weight weight)
      : size_(size), width_(width), weight_(weight), space_(measure(" ", size, weight).width) {}

  void add(const Words& formula) {
    double own = -space_;
    for (const std::string& word : formula) own += space_ + measure(word, size_, weight_).width;
    const std::string text = in_a_row(formula);
    if (fits(text, own)) {
      lines_.back() += " " + text;
      pen_ += space_ + own;
    } else if (formula.size() == 1 || own <= width_) {
      lines_.push_back(text);
      pen_ = own;
    } else {
      for (const Words& part : parts(formula)) add(part);
    }
  }
  std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  // Words side by side are as wide as the line of them, but for kerning at the spaces: only a line that ends near the
  // edge has to be set to be measured.
  bool fits(const std::string& text, double own) const {
    if (lines_.empty()) return false;
    const double near_edge = size_ / 2, end = pen_ + space_ + own;
    if (std::abs(end - width_) > near_edge) return end < width_;
    return measure(lines_.back() + " " + text, size_, weight_).width <= width_;
  }

  const double size_, width_;
  const Weight weight_;
  const double space_;
  std::vector<std::string> lines_;
  double pen_ = 0;  // where the last line ends, nearly
};

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
  Wrapped wrapped(size, width, weight);
  for (const Words& formula : formulas(words_of(rich_text))) wrapped.add(formula);
  return std::move(wrapped).lines();
}

std::vector<std::string> wrap_evenly(const std::string& rich_text, double size, double width, Weight weight) {
  const auto fill = [&](double room) { return wrap(rich_text, size, room, weight); };
  const auto widest = [&](const std::vector<std::string>& lines) {
    double most = 0;
    for (const std::string& line : lines) most = std::max(most, measure(line, size, weight).width);
    return most;
  };
  return in_even_lines(width, fill, widest);
}

}  // namespace epure::drawings
