// The exercises the build found are those in the folders, under the folders' names, and fit together.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "exercises/kit/checked.h"

using namespace epure;

namespace {

std::vector<std::string> folders() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(EPURE_EXERCISES)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name != "kit" && name != "cli" && name != "bench") names.push_back(name);
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

}  // namespace

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
    are_distinct(about.quantities, [](const QuantitySpec& quantity) { return quantity.name; });
    CHECK(Givens(about.givens).as_stated());
  }
}

TEST_CASE("every exercise speaks both languages") {
  for (const auto& exercise : catalogue()) {
    const Description& about = exercise->about();
    std::vector<Words> all = {about.title, about.source};
    for (const GivenSpec& given : about.givens) all.push_back(given.meaning);
    for (const SheetSpec& sheet : about.sheets) all.push_back(sheet.title);
    for (const QuantitySpec& quantity : about.quantities) all.push_back(quantity.meaning);
    for (const Printed& printed : about.printed)
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
    CAPTURE(checked.failures);
    CHECK(checked.passed());
  }
}

// The method the source names need not be the route that gives this quantity here, but must be one of the exercise's.
TEST_CASE("printed numbers name a route of their exercise") {
  for (const auto& exercise : catalogue()) {
    std::set<std::string> routes;
    for (const RouteValue& value : exercise->solve(Givens(exercise->about().givens), Rung::fast))
      routes.insert(value.route);
    for (const Printed& printed : exercise->about().printed) {
      INFO(exercise->about().id << ": " << printed.quantity << " printed " << printed.text << " by "
                                << printed.route);
      CHECK(routes.contains(printed.route));
    }
  }
}
