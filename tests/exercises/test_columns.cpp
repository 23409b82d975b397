// Text for a terminal: nothing is wider, nothing is lost.
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "exercises/cli/columns.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

std::size_t widest(const std::string& text) {
  std::size_t width = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) width = std::max(width, display_width(line));
  return width;
}

// What is left when all blanks and ends of lines are taken out.
std::string ink(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

}  // namespace

TEST_CASE("width is counted in characters, and colours take none") {
  CHECK(display_width("") == 0);
  CHECK(display_width("ω₃ ± 1°") == 7);
  CHECK(display_width("\x1b[1;31mdisagrees\x1b[0m") == 9);
}

TEST_CASE("columns are as wide as their widest cell") {
  CHECK(columns({{"ω₃", "x"}, {"four", "y"}, {"", "z"}}, 1) == " ω₃    x\n four  y\n       z\n");
  const std::string wide(200, 'x');
  CHECK(columns({{wide, "y"}}) == wide + "  y\n");
}

TEST_CASE("a cell wider than its column runs on, and the next one stands below where there is no room") {
  const std::string filler(66, '-');
  CHECK(table({{"a", "1", filler}, {"a long name", "2"}, {"heading"}, {"b", "3"}}, 2, {4}) ==
        "  a        1  " + filler + "\n  a long name\n           2\n  heading\n  b        3\n");
  CHECK(table({{"a", "1", filler + filler}, {"a long name", "2"}}, 2, {4}) ==
        "  a     1  " + std::string(69, '-') + "\n           " + std::string(63, '-') +
            "\n  a long name\n        2\n");
}

TEST_CASE("nothing is wider than a terminal, and nothing is lost") {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t n = 0; n < 130; n += 7)
    rows.push_back({std::string(n, 'n'), "[" + std::string(n / 2, '1') + ", " + std::string(n / 3, '2') + "] m",
                    "abc?", "\x1b[32mof many words which go on and on, 0,123 ± 4e-05 (2)\x1b[0m"});
  const std::string set = table(rows, 2, {24, 19, 6});
  CHECK(widest(set) == terminal_width);
  std::string all;
  for (const auto& row : rows)
    for (const std::string& cell : row) all += cell;
  CHECK(ink(set) == ink(all));
}

TEST_CASE("paragraphs are broken between words, and within a word only when a line cannot hold it") {
  CHECK(wrapped("") == "\n");
  CHECK(wrapped("one two", 2, 4) == "  one two\n");
  const std::string word(30, 'w'), long_word(100, 'l');
  CHECK(wrapped(word + " " + word + " " + word, 2, 4) == "  " + word + " " + word + "\n    " + word + "\n");
  CHECK(wrapped("a " + long_word + " b", 0, 2) ==
        "a " + std::string(78, 'l') + "\n  " + std::string(22, 'l') + " b\n");
  CHECK(wrapped(std::vector<std::string>{"x = 1 m,", std::string(70, 'y') + " = 2 m,", "z = 3 m"}, 2, 4) ==
        "  x = 1 m,\n    " + std::string(70, 'y') + " = 2\n    m, z = 3 m\n");
  const std::string just(80, 'j');
  CHECK(wrapped(just) == just + "\n");
}
