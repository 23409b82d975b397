#include "exercises/scenes/sheets/legend.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "exercises/kit/statement/quantity.h"

namespace epure::scenes {
namespace {

// "A0", "A0B0", "ABC": the letters of points, within mathematics.
std::optional<std::string> letters_of_points(const std::string& word, const std::vector<std::string>& points) {
  for (const std::string& first : points) {
    if (word == first) return point_letters(first);
    if (!word.starts_with(first)) continue;
    if (const auto others = letters_of_points(word.substr(first.size()), points))
      return point_letters(first) + *others;
  }
  return {};
}

// The letter of a line, unless it is a word by itself.
bool is_line(const std::string& word, const std::vector<std::string>& lines) {
  const bool is_word = word == "a" || word == "e" || word == "i" || word == "o";
  return !is_word && std::find(lines.begin(), lines.end(), word) != lines.end();
}

// With the letters of points and lines as they stand on the sheet.
std::string with_letters(const std::string& text, const Letters& of) {
  std::string written;
  for (std::size_t i = 0; i < text.size();) {
    const auto is_of_word = [&](std::size_t at) {
      return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    std::size_t end = i;
    while (is_of_word(end)) ++end;
    if (end == i) {
      written += text[i++];
      continue;
    }
    const std::string word = text.substr(i, end - i);
    const auto letters =
        is_line(word, of.lines) ? std::optional(point_letters(word)) : letters_of_points(word, of.points);
    written += letters ? "$" + *letters + "$" : word;
    i = end;
  }
  return written;
}

}  // namespace

std::vector<Result> legend_of(const Scene& scene, const Words& first_sheet, Language language) {
  const Letters letters = scene.built(Givens(scene.givens())).letters;
  Words meanings;
  for (const GivenSpec& given : scene.givens()) {
    const bool is_explained = given.meaning.english != given.symbol;
    if (!is_explained || letters_of_points(given.symbol, letters.points)) continue;
    meanings = meanings + (meanings.empty() ? "" : "; ") + given.letters + ": " +
               Words{with_letters(given.meaning.english, letters), with_letters(given.meaning.italian, letters)};
  }
  if (meanings.empty()) return {};
  std::vector<Result> ways{remark((meanings + ".").in(language))};
  if (!first_sheet.empty())
    ways.push_back(remark(
        format_words("What these letters mean: {}.", "Che cosa sono queste lettere: {}.", first_sheet).in(language)));
  return ways;
}

}  // namespace epure::scenes
