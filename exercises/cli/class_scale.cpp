#include "exercises/cli/class_scale.h"

#include <algorithm>
#include <set>

#include "exercises/cli/abreast.h"
#include "exercises/cli/request.h"
#include "exercises/kit/panels/scale.h"

namespace epure {
namespace {

// Whose number no student has: no line of a roster holds what ends a line.
std::vector<Candidate> samples(const Lots& lots, const std::vector<Candidate>& students) {
  constexpr std::size_t in_all = 24, of_a_row = 3;
  std::set<std::vector<std::string>> rows;
  for (const Candidate& each : students) rows.insert(each.assignments);
  const std::size_t of_each = lots.variations.empty() ? 1 : std::max(of_a_row, in_all / rows.size());
  std::vector<Candidate> all;
  for (const std::vector<std::string>& row : rows)
    for (std::size_t i = 0; i < of_each; ++i)
      all.push_back({.number = "\n" + std::to_string(i), .name = "", .file = "", .assignments = row});
  return all;
}

}  // namespace

ClassScales class_scales(const Lots& lots, const std::vector<Candidate>& students,
                         const std::vector<std::string>& awkward_anyway) {
  const std::vector<Candidate> drawn = samples(lots, students);
  std::vector<std::vector<std::optional<Rational>>> scales(drawn.size());
  try {
    abreast(drawn.size(), [&](std::size_t i) {
      for (const DrawnSheet& sheet : draw_variant(lots, drawn[i], awkward_anyway).solved)
        scales[i].push_back(scale_shown(sheet));
    });
  } catch (const BadGivens&) {
    return {};
  }
  ClassScales found;
  for (std::size_t k = 0; k < lots.sheets.size(); ++k) {
    std::vector<Rational> of_sheet;
    for (const auto& of_sample : scales)
      if (of_sample[k]) of_sheet.push_back(*of_sample[k]);
    if (of_sheet.empty()) continue;
    const auto [smallest, largest] = std::minmax_element(of_sheet.begin(), of_sheet.end());
    constexpr int most_times_smaller = 5;
    if (*largest > most_times_smaller * *smallest)
      found.too_different.push_back(lots.sheets[k]);
    else
      found.of_sheets.emplace(lots.sheets[k], *smallest);
  }
  return found;
}

std::optional<Rational> scale_shown(const DrawnSheet& sheet) {
  const std::vector<std::string>& captions = sheet.sheet.title_block.scales;  // that of lengths, if any, is the first
  if (captions.empty() || captions.front().find(" : ") == std::string::npos) return {};
  std::string caption = captions.front();
  std::erase(caption, ' ');
  return scale_of_lengths(caption);
}

std::string scale_in_words(const Rational& scale) {
  std::string caption = length_scale(scale).caption;
  std::erase(caption, ' ');
  return caption;
}

}  // namespace epure
