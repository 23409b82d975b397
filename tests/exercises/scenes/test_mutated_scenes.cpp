// Files that nobody would write: those of docs/scenes with something done to them, by chance. Each is checked and
// drawn as the program does it, or refused with a sentence; nothing ends otherwise, and the two routes never
// disagree.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "exercises/cli/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(EPURE_SCENES))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_); }
  template <class List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }

 private:
  std::mt19937 engine_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// Words are what stands between blanks and signs; a number with its unit is two of them.
std::vector<std::pair<std::size_t, std::size_t>> words_of(const std::string& text) {
  constexpr std::string_view between = " \n:,[]{}()";
  std::vector<std::pair<std::size_t, std::size_t>> words;
  for (std::size_t begin = text.find_first_not_of(between); begin != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
    words.emplace_back(begin, end - begin);
    begin = text.find_first_not_of(between, end);
  }
  return words;
}

// Of a handful of ways: a number becomes another, some at the edge of what is sensible, a word another word, a line
// goes, comes twice, moves in or out, lines of another scene come in, a byte becomes any other, the end is cut.
void mutate(std::string& text, const std::string& other, Chance& chance) {
  static constexpr std::array numbers{
      "0",  "-1",    "1e308", "1e-308", "1/0",  "1/3", "nan",  "0,5", "360",   "180",
      "90", "1e-12", "1e12",  "0.1",    "0.35", "1",   "0.25", "100", "1e-40", "2",
      "π",  "1..2",  "300",   "45",     "120",  "-60", "200",  "r/r", "(1",    "999999999999999999999999"};
  static constexpr std::array bytes{'\0', '\t', '\r', '\n', ':', '#', '&', '*', '!', '|', '>', '%', '@',    '"',
                                    '\'', '[',  ']',  '{',  '}', ',', '-', '?', ' ', '0', '9', 'A', '\xff', '\xc3'};
  std::vector<std::string> lines = lines_of(text);
  const auto words = words_of(text);
  if (lines.empty() || words.empty()) return;
  const std::size_t at = chance.below(lines.size());
  const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
  switch (chance.below(10)) {
    case 0:
    case 1:
    case 2:
    case 3: {
      std::vector<std::pair<std::size_t, std::size_t>> given;
      for (const auto& word : words)
        if (text.find_first_of("0123456789", word.first) == word.first) given.push_back(word);
      if (given.empty()) return;
      const auto [begin, length] = chance.one_of(given);
      text.replace(begin, length, chance.one_of(numbers));
      return;
    }
    case 4: {
      const auto [from, count] = chance.one_of(words);
      const std::string word = text.substr(from, count);
      const auto [begin, length] = chance.one_of(words);
      text.replace(begin, length, word);
      return;
    }
    case 5:
      lines.erase(place);
      break;
    case 6:
      lines.insert(place, chance.one_of(lines));
      break;
    case 7:
      *place = chance.below(2) == 0 ? "  " + *place : place->substr(std::min<std::size_t>(2, place->size()));
      break;
    case 8:
      lines.insert(place, chance.one_of(lines_of(other)));
      break;
    default:
      if (chance.below(5) == 0) {
        text.resize(chance.below(text.size()));
      } else {
        text[chance.below(text.size())] = chance.one_of(bytes);
      }
      return;
  }
  text = joined(lines);
}

struct Counted {
  int refused = 0, undecided = 0, passed = 0;
};

void check_and_draw(const std::string& file, Counted& counted) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", file, "--json"}, {"draw", file, "-o", "-", "--format", "svg"}}) {
    std::ostringstream out, err;
    const int exit = run_cli({}, words, out, err);
    CAPTURE(words[0], exit, err.str());
    // 2 of draw: also several sheets, where one is asked for.
    CHECK((exit == 0 || exit == 2 || exit == 4));
    if (exit == 2) CHECK_FALSE(err.str().empty());
    if (words[0] == "check") ++(exit == 0 ? counted.passed : exit == 2 ? counted.refused : counted.undecided);
  }
}

Counted run(unsigned first, unsigned count) {
  const std::vector<std::string> scenes = shipped_scenes();
  const fs::path file = fs::temp_directory_path() / ("epure-mutated-" + std::to_string(first) + ".yaml");
  Counted counted;
  for (unsigned seed = first; seed < first + count; ++seed) {
    Chance chance(seed);
    std::string text = chance.one_of(scenes);
    const std::string& other = chance.one_of(scenes);
    for (std::size_t times = 1 + chance.below(2); times > 0; --times) mutate(text, other, chance);
    INFO("seed " << seed << ":\n" << text);
    std::ofstream(file, std::ios::binary) << text;
    check_and_draw(file.string(), counted);
  }
  fs::remove(file);
  return counted;
}

}  // namespace

TEST_CASE("a scene to which anything was done is checked and drawn, or refused with a sentence", "[scenes]") {
  const Counted counted = run(1, 400);
  CHECK(counted.passed > 40);
  CHECK(counted.refused > 100);
}

// EPURE_FIRST_SEED=1000 EPURE_SCENES_TRIED=20000 test_scenes "[mutated]": by hand, some minutes.
TEST_CASE("as many scenes as are asked for, of any seeds", "[.][mutated]") {
  const auto number = [](const char* name, unsigned otherwise) {
    const char* text = std::getenv(name);
    return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
  };
  const Counted counted = run(number("EPURE_FIRST_SEED", 1000), number("EPURE_SCENES_TRIED", 10'000));
  WARN(counted.passed << " pass, " << counted.refused << " refused, " << counted.undecided << " undecided");
}
