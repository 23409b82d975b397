// The exercises the build found are those in the folders, under the folders' names, and fit together.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "drawings/output.h"
#include "exercises/kit/proof/checked.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

std::vector<std::string> folders() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(EPURE_EXERCISES)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name != "kit" && name != "cli" && name != "scenes") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

template <class Entries, class Name>
void are_distinct(const Entries& entries, const Name& name) {
  std::set<std::string> seen;
  for (const auto& entry : entries) {
    INFO(name(entry));
    CHECK_FALSE(name(entry).empty());
    CHECK(seen.insert(name(entry)).second);
  }
}

// Every sheet as its exercise states it.
template <class Look>
void look_at_sheets(Language language, const Look& look) {
  for (const auto& exercise : catalogue())
    for (const SheetSpec& sheet : exercise->about().sheets) {
      INFO(exercise->about().id << "/" << sheet.name);
      look(exercise->draw(sheet.name, Givens(exercise->about().givens), {.language = language}));
    }
}

std::string words_of(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
    if (const auto* heading = std::get_if<drawings::Heading>(&block)) text += heading->text + "\n";
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
  }
  for (const drawings::Label& label : drawn.sheet.figure.labels) text += label.text + "\n";
  return text;
}

// "1 : 10" and no more.
bool says_only_a_ratio(const std::string& caption) {
  return caption.find_first_not_of("0123456789.: ") == std::string::npos;
}

}  // namespace

TEST_CASE("an SVG of a sheet, or of a page of its table, holds at most 100 kB") {
  for (const Language language : {Language::english, Language::italian})
    look_at_sheets(language, [](const DrawnSheet& drawn) {
      constexpr std::size_t most = 100'000;
      CHECK(drawings::svg(drawn.sheet).size() <= most);
      for (const drawings::Sheet& page : drawn.further) CHECK(drawings::svg(page).size() <= most);
    });
}

TEST_CASE("an exercise's id is the name of its folder, and the catalogue is in order") {
  std::vector<std::string> ids;
  for (const auto& exercise : catalogue()) ids.push_back(exercise->about().id);
  CHECK_FALSE(ids.empty());
  CHECK(ids == folders());
}

TEST_CASE("within an exercise every name is used once") {
  for (const auto& exercise : catalogue()) {
    const Description& about = exercise->about();
    INFO(about.id);
    are_distinct(about.givens, [](const GivenSpec& given) { return given.symbol; });
    are_distinct(about.sheets, [](const SheetSpec& sheet) { return sheet.name; });
    are_distinct(about.quantities(), [](const Quantity& quantity) { return quantity.name; });
    CHECK(Givens(about.givens).as_stated());
  }
}

TEST_CASE("every exercise speaks both languages") {
  for (const auto& exercise : catalogue()) {
    const Description& about = exercise->about();
    std::vector<Words> all = {about.title, about.source};
    for (const GivenSpec& given : about.givens) all.push_back(given.meaning);
    for (const SheetSpec& sheet : about.sheets) all.push_back(sheet.title);
    for (const Quantity& quantity : about.quantities()) all.push_back(quantity.meaning);
    for (const Printed& printed : about.printed())
      if (printed.explanation) all.push_back(printed.explanation->sentence);
    for (const Words& words : all) {
      INFO(about.id << ": " << words.english << " / " << words.italian);
      CHECK_FALSE(words.english.empty());
      CHECK_FALSE(words.italian.empty());
    }
  }
}

TEST_CASE("every exercise passes as its source states it") {
  for (const auto& exercise : catalogue()) {
    const CheckedExercise checked = check(*exercise, Givens(exercise->about().givens), Rung::climb);
    INFO(checked.about.id);
    CAPTURE(complaints(checked));
    CHECK(checked.passed());
  }
}

// Names are a contract with those who read them: tests/exercises/names.txt holds those that were ever promised.
TEST_CASE("every exercise reports each name, in its unit, that was promised") {
  std::ifstream promised(EPURE_NAMES);
  std::set<std::string> reported;
  for (const auto& exercise : catalogue())
    for (const Quantity& quantity : exercise->about().quantities())
      reported.insert(exercise->about().id + " " + quantity.name + " " + quantity.unit);
  int names = 0;
  for (std::string line; std::getline(promised, line);) {
    if (line.starts_with("#")) continue;
    INFO(line);
    CHECK(reported.contains(line));
    ++names;
  }
  CHECK(names >= 697);
}

TEST_CASE("every quantity is found by two routes") {
  for (const auto& exercise : catalogue())
    for (const CheckedQuantity& quantity :
         check(*exercise, Givens(exercise->about().givens), Rung::fast).quantities) {
      INFO(exercise->about().id << ": " << quantity.spec.name);
      CHECK(quantity.routes.size() >= 2);
    }
}

// The method the source names need not be the route that gives this quantity here, but must be one of the exercise's.
TEST_CASE("printed numbers name a route of their exercise") {
  for (const auto& exercise : catalogue()) {
    std::set<std::string> routes;
    for (const RouteValue& value : exercise->solve(Givens(exercise->about().givens), Rung::fast))
      routes.insert(value.route);
    for (const Printed& printed : exercise->about().printed()) {
      INFO(exercise->about().id << ": " << printed.quantity << " printed " << printed.text << " by "
                                << printed.route);
      CHECK(routes.contains(printed.route));
    }
  }
}

TEST_CASE("scales of lengths at the foot of a sheet say which picture each is for, or stand below the pictures") {
  look_at_sheets(Language::english, [](const DrawnSheet& drawn) {
    const double foot = drawings::drawing_area(drawn.sheet.paper).low.y + 10;
    int of_lengths = 0;
    std::set<std::string> plain, in_figure;
    for (const drawings::Label& label : drawn.sheet.figure.labels) in_figure.insert(label.text);
    for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
      const auto* bar = std::get_if<drawings::ScaleBar>(&mark);
      if (!bar || bar->at.y > foot || bar->caption.find("≙") != std::string::npos) continue;
      ++of_lengths;
      if (says_only_a_ratio(bar->caption)) plain.insert(bar->caption);
    }
    if (of_lengths < 2) return;
    CHECK(std::includes(in_figure.begin(), in_figure.end(), plain.begin(), plain.end()));
  });
}

TEST_CASE("no English word is left on an Italian sheet") {
  look_at_sheets(Language::italian, [](const DrawnSheet& drawn) {
    const std::string text = words_of(drawn);
    CAPTURE(text);
    for (const char* word : {"\u00a0rpm", " the ", " of ", " and ", " with ", " from ", " at ", "sheet", "sin "})
      CHECK(text.find(word) == std::string::npos);
  });
}
