// Has a sheet changed? Every sheet of every exercise and shipped mechanism at its stated givens, held against what
// was seen and found good (sheets/, marks.h).
//
//   golden            Exit 1 when one differs, and pictures of those, before beside after, in the folder
//   golden-changes golden WORD...    takes what these pictures show for good. The word of a picture stands in it:
//   look at it first.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "drawings/output.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/scenes/scene_exercise.h"
#include "exercises/scenes/shipped.h"
#include "tests/golden/before_and_after.h"

namespace epure::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kept = EPURE_GOLDEN, changes_folder = "golden-changes";

using SheetLines = std::map<std::string, Lines>;     // of an exercise, by the sheets' names
using AllLines = std::map<std::string, SheetLines>;  // by the exercises' ids

SheetLines drawn(const Exercise& exercise) {
  SheetLines all;
  const Solution solution = exercise.solution(Givens(exercise.about().givens));
  for (const SheetSpec& spec : exercise.about().sheets) {
    const DrawnSheet drawn = exercise.draw(spec.name, solution, {});
    all[spec.name] = lines_of(drawings::compose(drawn.sheet));
    for (std::size_t i = 0; i < drawn.further.size(); ++i)
      all[spec.name + "/" + std::to_string(i + 2)] = lines_of(drawings::compose(drawn.further[i]));
  }
  return all;
}

AllLines drawn_today() {
  AllLines all;
  for (const Listed& exercise : catalogue()) all[exercise.id()] = drawn(*exercise);
  for (const scenes::Shipped& shipped : scenes::shipped_scenes()) {
    const std::string id(shipped.id);
    all[id] = drawn(*scenes::scene_exercise(std::make_shared<const scenes::Scene>(id, shipped.text)));
  }
  return all;
}

constexpr std::string_view before_a_name = "= ";

SheetLines read(const fs::path& file) {
  SheetLines all;
  Lines* lines = nullptr;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(before_a_name))
      lines = &all[line.substr(before_a_name.size())];
    else
      lines->push_back(line);
  return all;
}

AllLines read_all() {
  AllLines all;
  for (const auto& file : fs::directory_iterator(kept)) all[file.path().stem()] = read(file.path());
  return all;
}

void write(const std::string& exercise, const SheetLines& sheets) {
  std::string text;
  for (const auto& [name, lines] : sheets) {
    text += std::string(before_a_name) + name + '\n';
    for (const std::string& line : lines) text += line + '\n';
  }
  const fs::path file = kept / (exercise + ".txt");
  if (text.empty())
    fs::remove(file);
  else
    drawings::write_whole(file, text);
}

std::vector<Change> changes_between(AllLines& before, AllLines& after) {
  std::map<std::string, std::map<std::string, int>> names;
  for (const AllLines* all : {&before, &after})
    for (const auto& [exercise, sheets] : *all)
      for (const auto& [sheet, lines] : sheets) names[exercise][sheet];
  std::vector<Change> changes;
  for (const auto& [exercise, sheets] : names)
    for (const auto& [sheet, unused] : sheets)
      if (Lines& old = before[exercise][sheet], &now = after[exercise][sheet]; old != now)
        changes.push_back({exercise, sheet, old, now});
  return changes;
}

int show(const std::vector<Picture>& pictures) {
  fs::remove_all(changes_folder);
  if (pictures.empty()) return 0;
  fs::create_directory(changes_folder);
  constexpr double dots_per_inch = 170;
  int number = 0;
  for (const Picture& picture : pictures) {
    const fs::path file = changes_folder / (std::to_string(++number) + ".png");
    drawings::write_whole(file, drawings::write_png(picture.page, dots_per_inch));
    for (const Change& change : picture.changes)
      std::cout << change.exercise << "/" << change.sheet << " has changed: " << fs::absolute(file).string() << '\n';
  }
  std::cout
      << "Look at each picture. Is it as good or better, take it: golden WORD..., with the words in the pictures.\n";
  return 1;
}

int bless(const std::vector<Picture>& pictures, AllLines before, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const auto seen =
        std::find_if(pictures.begin(), pictures.end(), [&](const Picture& each) { return each.word == word; });
    if (seen == pictures.end()) {
      std::cout << word << " stands in no picture of what has changed now.\n";
      return 1;
    }
    for (const Change& change : seen->changes) {
      SheetLines& sheets = before[change.exercise];
      if (change.after.empty())
        sheets.erase(change.sheet);
      else
        sheets[change.sheet] = change.after;
      std::erase_if(sheets, [](const auto& sheet) { return sheet.second.empty(); });
      write(change.exercise, sheets);
    }
  }
  return 0;
}

}  // namespace
}  // namespace epure::golden

int main(int count, char** arguments) {
  using namespace epure::golden;
  AllLines before = read_all(), after = drawn_today();
  const std::vector<Picture> pictures = pictures_of(changes_between(before, after));
  return count == 1 ? show(pictures) : bless(pictures, before, {arguments + 1, arguments + count});
}
