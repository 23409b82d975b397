#include "exercises/kit/statement/suggest.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace epure {
namespace {

// Enough to choose from, and still a sentence.
constexpr std::size_t most_listed = 12, most_suggested = 3;

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// Insertions, deletions and replacements that lead from one word to the other (Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

std::string join(const std::vector<std::string>& names, const std::string& before_last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? before_last : ", ") + names[i];
  return text;
}

// Half of the letters may be wrong: two exchanged letters of a short word count twice.
std::vector<std::string> near_names(const std::string& wrong, const std::vector<std::string>& known) {
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& name : known) {
    const std::size_t apart = distance(lower_case(wrong), lower_case(name));
    if (apart <= std::max(wrong.size(), name.size()) / 2) found.emplace_back(apart, name);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (const auto& [apart, name] : found)
    if (names.size() < most_suggested) names.push_back(name);
  return names;
}

}  // namespace

Words alternatives(const std::vector<std::string>& names) { return {join(names, " or "), join(names, " o ")}; }

Words did_you_mean(const std::string& wrong, const std::vector<std::string>& known) {
  // A long word is no slip of the finger, and comparing it would take long.
  const auto near = wrong.size() <= 100 ? near_names(wrong, known) : std::vector<std::string>{};
  if (!near.empty()) return Words{"did you mean ", "si intendeva "} + alternatives(near) + "?";
  const Words known_are = {"known are: ", "si conoscono: "};
  if (known.size() <= most_listed) return known_are + join(known, ", ");
  return known_are + join({known.begin(), known.begin() + most_listed}, ", ") + ", ...";
}

}  // namespace epure
