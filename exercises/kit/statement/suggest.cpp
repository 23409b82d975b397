#include "exercises/kit/statement/suggest.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace epure {
namespace {

// Enough to choose from, and still a sentence.
constexpr std::size_t most_listed = 12, most_suggested = 3;

// Insertions, deletions, replacements and exchanges of two neighbours that lead from one word to the other.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> apart(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  std::iota(apart[0].begin(), apart[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    apart[i][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = apart[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      apart[i][j] = std::min({apart[i - 1][j] + 1, apart[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        apart[i][j] = std::min(apart[i][j], apart[i - 2][j - 2] + 1);
    }
  }
  return apart.back().back();
}

std::string join(const std::vector<std::string>& names, const std::string& before_last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? before_last : ", ") + names[i];
  return text;
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

Words alternatives(const std::vector<std::string>& names) { return {join(names, " or "), join(names, " o ")}; }

// A third of the letters may be wrong, and a name may be unfinished; one letter alone is no beginning.
std::vector<std::string> near_names(const std::string& wrong, const std::vector<std::string>& known) {
  constexpr std::size_t longest_compared = 100;  // a longer word is no slip of the finger, and would take long
  if (wrong.size() > longest_compared) return {};
  const std::string typed = lower_case(wrong);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& name : known) {
    const bool is_begun = typed.size() > 1 && lower_case(name).starts_with(typed);
    const std::size_t apart = is_begun ? 0 : edits_between(typed, lower_case(name));
    if (apart <= std::max(typed.size(), name.size()) / 3) found.emplace_back(apart, name);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (const auto& [apart, name] : found)
    if (names.size() < most_suggested && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

Words did_you_mean(const std::string& wrong, const std::vector<std::string>& known) {
  if (known.empty()) return {"there are none", "non ce ne sono"};
  const std::vector<std::string> near = near_names(wrong, known);
  if (!near.empty()) return Words{"did you mean ", "si intendeva "} + alternatives(near) + "?";
  const Words known_are = {"known are: ", "si conoscono: "};
  if (known.size() <= most_listed) return known_are + join(known, ", ");
  return known_are + join({known.begin(), known.begin() + most_listed}, ", ") + ", ...";
}

}  // namespace epure
