// All that epure says to a terminal, in both languages: no line is wider than 80 characters, nothing of one language
// is left in the other, and what is counted is what there is.
#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "exercises/cli/columns.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/route_names.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

struct Said {
  int exit;
  std::string out, err;
};
Said say(Typed words, const std::string& language, bool colours = false) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err, {.language = language, .colours = colours});
  return {exit, out.str(), err.str()};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string last_line(const std::string& text) { return lines_of(text).back(); }

// Every text for standard output that has lines to measure.
std::vector<Typed> all_texts() {
  std::vector<Typed> all = {{"help"},          {"help", "list"},  {"help", "draw"}, {"help", "check"},
                            {"help", "sweep"}, {"help", "bench"}, {"list"}};
  for (const auto& exercise : catalogue()) all.push_back({"list", exercise.id()});
  all.push_back({"check", "all"});
  all.push_back({"check", "all", "--arithmetic", "bounded"});
  return all;
}

// Refusals of every kind, and a few more of what each exercise refuses.
const std::vector<Typed> refusals = {
    {},
    {"chek"},
    {""},
    {"--frob"},
    {"--measured", "x=1", "four-bar", "check"},
    {"list", "--frob"},
    {"draw", "four-bar", "--formt", "pdf"},
    {"bench", "x"},
    {"draw", "four-bar", "--set"},
    {"draw", "four-bar", "--paper", "a4", "--paper", "a3"},
    {"check", "four-bar", "--json=x"},
    {"draw"},
    {"draw", "four-bra"},
    {"draw", "frobnicate"},
    {"draw", "four-bar/pols"},
    {"list", "four-bar/poles"},
    {"list", "four-bar", "gear-pair"},
    {"check", "four-bar/poles"},
    {"draw", "four-bar", "--format", "gif"},
    {"draw", "four-bar", "--format", "pdf", "-o", "x.svg"},
    {"draw", "four-bar", "-o", "x.svg"},
    {"draw", "four-bar", "-o", "x"},
    {"draw", "four-bar", "-o", "x", "--format", "pdf,svg"},
    {"draw", "four-bar", "-o", "x.pdf", "--out", "y"},
    {"draw", "four-bar", "--out", ""},
    {"draw", "four-bar", "--out", "/proc/nowhere"},
    {"draw", "four-bar/poles", "-o", "/proc/nowhere/x.pdf"},
    {"draw", "four-bar", "--paper", "a5"},
    {"draw", "four-bar", "--scale", "big"},
    {"draw", "four-bar", "--scale", "1:1e9"},
    {"draw", "four-bar", "--scale", "10:1"},
    {"check", "four-bar", "--arithmetic", "magic"},
    {"check", "four-bar", "--reading", "0"},
    {"check", "four-bar", "--reading", "x"},
    {"check", "four-bar", "--measured", "omga=1"},
    {"check", "four-bar", "--measured", "omega_3"},
    {"check", "four-bar", "--measured", "omega_3=x"},
    {"check", "four-bar", "--measured", "omega_3=1e61"},
    {"check", "all", "--set", "qqq=1"},
    {"check", "four-bar", "--set", "n=50", "--set", "n=60"},
    {"check", "four-bar", "--set", "n=0"},
    {"check", "four-bar", "--set", "x_B0=0", "--set", "y_B0=0"},
    {"check", "four-bar", "--set", "AB=0.01"},
    {"check", "four-bar", "--set", "AB=9"},
    {"check", "four-bar", "--set", "AC=0.5"},
    {"check", "four-bar", "--set", "lambda=1"},
    {"check", "slider-crank-velocity", "--set", "l=0.05", "--set", "AC=0.03", "--set", "BC=0.04"},
    {"check", "slider-crank-velocity", "--set", "AC=3"},
    {"check", "slider-crank-velocity", "--set", "n=0"},
    {"check", "pin-in-slot", "--set", "OB=0.001"},
    {"check", "gear-pair", "--set", "z1=12.5"},
    {"check", "gear-pair", "--set", "alpha=80deg"},
    {"check", "gear-pair", "--set", "x1=11"},
    {"check", "gear-pair", "--set", "kind=internal", "--set", "z2=3"},
    {"check", "gear-pair", "--set", "x1=-5"},
    {"check", "gear-pair", "--set", "kind=rack", "--set", "x2=1"},
    {"check", "gear-pair", "--set", "j=100"},
    {"check", "gear-pair", "--set", "k=9"},
    {"check", "roulette", "--set", "how=circle_inside_circle", "--set", "r=3", "--set", "R=1"},
    {"check", "roulette", "--set", "d=-1"},
    {"check", "four-bar-constraints", "--set", "theta_3_start=0", "--set", "theta_4_start=0"},
    {"sweep", "all"},
    {"sweep", "roulette"},
    {"sweep", "roulette", "--over", "phi=0..90/91"},
    {"sweep", "roulette", "--over", "phi=0..90/91", "--quantity", "vM"},
    {"sweep", "roulette", "--over", "phi=0..90", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=30", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..90/0.7", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..90/1", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..0/3", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0deg..1rad/3", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=1|1", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/2000000000", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/1000000", "--over", "r=1..2/1000000", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--set", "phi=3", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--over", "phi=0..1/3", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--quantity", "v_M", "--part", "3/2"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--quantity", "v_M", "--format", "pdf"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--quantity", "v_M", "--chart", "x.png"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--quantity", "v_M", "--chart", "x.pdf", "--part", "1/2"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--over", "r=1..2/20", "--quantity", "v_M", "--chart", "x.pdf"},
    {"sweep", "roulette", "--over", "how=x|y", "--quantity", "v_M"},
    {"sweep", "roulette", "--over", "phi=0..1/2", "--quantity", "v_M", "-o", "/proc/nowhere/x.csv"},
    {"bench", "--seconds", "-1"},
    {"bench", "--seconds", "x"}};

// A message without the names in it: what is between quotes, what was typed, numbers and letters of points.
std::set<std::string> words_in(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (!word.empty()) words.insert(word);
    word.clear();
  }
  return words;
}

// Words that no Italian sentence of ours has.
const std::set<std::string> english = {
    "the",     "of",    "and",    "is",     "are",    "not",     "with",   "which",   "where",  "whether", "must",
    "than",    "too",   "from",   "one",    "no",     "does",    "write",  "or",      "choose", "there",   "at",
    "as",      "it",    "its",    "this",   "that",   "cannot",  "name",   "value",   "known",  "did",     "you",
    "mean",    "sheet", "sheets", "given",  "givens", "printed", "routes", "point",   "line",   "angle",   "crank",
    "coupler", "pole",  "poles",  "circle", "to",     "an",      "needs",  "between", "option"};

std::string english_in(const std::string& text, const std::set<std::string>& names) {
  static const std::regex options("--[a-z-]+|[{][a-z]+[}]");  // and fields of a pattern of names
  std::string found;
  for (const std::string& word : words_in(std::regex_replace(text, options, "")))
    if (english.contains(word) && !names.contains(word)) found += word + " ";
  return found;
}

// Names that are the same in every language: of exercises, sheets, quantities, givens, their words, verbs and
// options.
std::set<std::string> names() {
  std::set<std::string> all = {"it"};  // --lang it
  const auto add = [&](const std::string& name) {
    for (const std::string& word : words_in(name)) all.insert(word);
  };
  for (const auto& exercise : catalogue()) {
    const Description& about = exercise->about();
    add(about.id);
    for (const SheetSpec& sheet : about.sheets) add(sheet.name);
    for (const Quantity& quantity : about.quantities()) add(quantity.name);
    for (const GivenSpec& given : about.givens) {
      add(given.symbol);
      for (const Choice& choice : given.choices) add(choice.word);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("no line is wider than a terminal of 80 columns") {
  for (const std::string language : {"en", "it"})
    for (const Typed& words : all_texts()) {
      CAPTURE(language, words);
      const Said said = say(words, language);
      CHECK((said.exit == 0));
      CHECK(lines_of(said.out).size() > 5);
      for (const std::string& line : lines_of(said.out)) {
        CAPTURE(line);
        CHECK(display_width(line) <= 80);
        CHECK_FALSE(line.ends_with(' '));
      }
    }
}

TEST_CASE("measured, failing and changed checks are no wider") {
  const std::string digits(300, '3');
  for (const std::string language : {"en", "it"})
    for (const Typed& words :
         {Typed{"check", "four-bar", "--measured", "omega_3=13", "--measured", "v_B=0." + digits},
          {"check", "slider-crank-velocity", "--set", "r=0.2" + digits},
          {"check", "four-bar", "--set", "t=0.1" + digits, "--arithmetic", "bounded"},
          {"check", "roulette", "--set", "how=circle_on_line", "--set", "d=0"}}) {
      CAPTURE(language, words);
      const Said said = say(words, language);
      CHECK(said.exit < 2);
      for (const std::string& line : lines_of(said.out)) {
        CAPTURE(line);
        CHECK(display_width(line) <= 80);
      }
    }
}

TEST_CASE("the totals are those of the JSON report") {
  for (const Typed& which : {Typed{"all"}, {"four-bar"}, {"gear-pair", "roulette"}, {"four-bar", "--set", "t=0.2"}}) {
    Typed words = which;
    words.insert(words.begin(), "check");
    const std::string line = last_line(say(words, "en").out);
    words.push_back("--json");
    const auto report = nlohmann::json::parse(say(words, "en").out);
    std::size_t quantities = 0;
    std::map<std::string, int> verdicts;
    int printed = 0;
    for (const auto& exercise : report["exercises"])
      for (const auto& quantity : exercise["quantities"]) {
        ++quantities;
        for (const auto& each : quantity.value("printed", nlohmann::json::array())) {
          ++verdicts[each["verdict"]];
          ++printed;
        }
      }
    std::string expected = "passed: " + std::to_string(quantities) + " quantities";
    if (printed > 0)
      expected += "; printed: " + std::to_string(verdicts["rounding"]) + " rounding, " +
                  std::to_string(verdicts["reading"]) + " reading, " + std::to_string(verdicts["disagrees"]) +
                  " disagree";
    CHECK(line == expected);
    CHECK(quantities > 20);
  }
}

TEST_CASE("every number, sheet and route of the JSON report is in the text") {
  const std::string text = say({"check", "four-bar"}, "en").out;
  const auto report = nlohmann::json::parse(say({"check", "four-bar", "--json"}, "en").out)["exercises"][0];
  const std::string flat = [&] {
    std::string all;
    for (const std::string& word : lines_of(text)) all += word + " ";
    return all;
  }();
  int seen = 0;
  for (const auto& quantity : report["quantities"]) {
    for (const auto& route : quantity["routes"]) CHECK(flat.find(route["route"]) != std::string::npos);
    for (const auto& each : quantity.value("printed", nlohmann::json::array())) {
      CHECK(flat.find(" " + each["text"].get<std::string>() + " ") != std::string::npos);
      ++seen;
    }
  }
  CHECK(seen > 20);
  for (const auto& exercise : catalogue())
    if (exercise.id() == "four-bar")
      for (const SheetSpec& sheet : exercise->about().sheets) CHECK(flat.find(" " + sheet.name) != std::string::npos);
}

TEST_CASE("colours are for terminals only, and change nothing else") {
  const std::string plain = say({"check", "four-bar"}, "en").out;
  CHECK(plain.find('\x1b') == std::string::npos);
  std::string coloured = say({"check", "four-bar"}, "en", true).out;
  CHECK(coloured.find("\x1b[32mrounding\x1b[0m") != std::string::npos);
  CHECK(coloured.find("\x1b[33mreading\x1b[0m") != std::string::npos);
  CHECK(coloured.find("\x1b[1;31mdisagrees\x1b[0m") != std::string::npos);
  CHECK(coloured.find("\x1b[32mpassed\x1b[0m") != std::string::npos);
  for (auto at = coloured.find('\x1b'); at != std::string::npos; at = coloured.find('\x1b'))
    coloured.erase(at, coloured.find('m', at) + 1 - at);
  CHECK(coloured == plain);
  const auto measured = [](const char* v_B) { return say({"check", "four-bar", "--measured", v_B}, "en", true).out; };
  CHECK(measured("v_B=0.866").find("\x1b[32mwithin reading\x1b[0m") != std::string::npos);
  CHECK(measured("v_B=1").find("\x1b[1;31mbeyond reading\x1b[0m") != std::string::npos);
  const Said json = say({"check", "four-bar", "--json"}, "en", true);
  CHECK(json.out.find('\x1b') == std::string::npos);
}

TEST_CASE("every refusal is one sentence, in the language asked for") {
  const std::set<std::string> same = names();
  for (const Typed& words : refusals) {
    CAPTURE(words);
    const Said in_english = say(words, "en"), in_italian = say(words, "it");
    CAPTURE(in_english.err, in_italian.err);
    CHECK(in_english.exit == in_italian.exit);
    CHECK(in_english.exit >= 2);
    CHECK(in_english.exit <= 3);
    CHECK(in_italian.out.empty());
    CHECK(lines_of(in_italian.err).size() == 1);
    CHECK(in_italian.err != in_english.err);
    CHECK(english_in(in_italian.err, same) == "");
  }
}

TEST_CASE("what is said of all exercises has no English left in Italian") {
  const std::set<std::string> same = names();
  for (const Typed& words : all_texts()) {
    if (words == Typed{"help", "bench"}) continue;  // which quotes the heads of its English table
    const std::string italian = say(words, "it").out;
    for (const std::string& line : lines_of(italian)) {
      CAPTURE(words, line);
      CHECK(english_in(line, same) == "");
    }
    CHECK(italian != say(words, "en").out);
  }
}

TEST_CASE("no verdict is broken") {
  for (const auto& [language, verdict] : {std::pair{"en", "rounding"}, {"it", "arrotondata"}}) {
    const std::string text = say({"check", "all"}, language).out;
    std::size_t count = 0;
    for (const std::string& line : lines_of(text)) count += line.ends_with(verdict);
    const auto totals = text.substr(text.rfind("; "));
    CAPTURE(language, totals);
    CHECK(totals.find(std::to_string(count) + " ") != std::string::npos);
  }
}

TEST_CASE("a number has a comma in Italian") {
  const std::regex point("[0-9][.][0-9]");
  for (const Typed& words : all_texts()) {
    if (words.front() == "help") continue;  // its examples hold what is typed
    for (const std::string& line : lines_of(say(words, "it").out)) {
      CAPTURE(words, line);
      CHECK(!std::regex_search(line, point));
    }
  }
}

TEST_CASE("--lang is stronger than the environment, and what is no language is refused") {
  CHECK(say({"check", "roulette", "--lang", "en"}, "it").out == say({"check", "roulette"}, "en").out);
  CHECK(say({"check", "roulette", "--lang", "it"}, "").out == say({"check", "roulette"}, "it").out);
  CHECK(say({"check", "roulette", "--lang=it", "--frob"}, "").err == say({"check", "roulette", "--frob"}, "it").err);
  CHECK(say({"check", "roulette"}, "").out == say({"check", "roulette"}, "en").out);
  const Said french = say({"check", "roulette"}, "fr");
  CHECK(french.exit == 2);
  CHECK(french.err == "epure: \"fr\" is no language of epure; choose en or it\n");
}

TEST_CASE("every route has an Italian name") {
  for (const auto& exercise : catalogue())
    for (const RouteValue& value : exercise->solve(Givens(exercise->about().givens), Rung::fast)) {
      CAPTURE(value.route);
      CHECK(route_in_words(value.route).italian != value.route);
    }
}
