#include "exercises/gear-pair/contact_words.h"

#include <fmt/format.h>

#include <cmath>

#include "exercises/gear-pair/fault_words.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

using By = DrawnPath::By;

// "$F_{1}$, 3.2 mm before $P_{0}$".
std::string place_of(const DrawnPath::End& end, Language language) {
  const Words side = end.xi < 0 ? Words{"before", "prima di"} : Words{"after", "dopo"};
  return fmt::format("${}$, {}\u00a0mm {} $P_{{0}}$", end.name, figures(1000 * std::abs(end.xi), 4, language),
                     side.in(language));
}

std::string why_it_begins(const DrawnPair& pair, Language language) {
  if (pair.path.begins.by == By::root)
    return Words{"flank 1 begins only in ", "il fianco 1 inizia solo in "}.in(language);
  return name_of(2, pair, language) +
         Words{", pointed, touches only from ", ", a punta, tocca solo da "}.in(language);
}
Words why_it_ends(By by) {
  return by == By::root ? Words{"flank 2 reaches only to ", "il fianco 2 arriva solo a "}
                        : Words{"wheel 1, pointed, touches only to ", "la ruota 1, a punta, tocca solo fino a "};
}

std::string shortened(const DrawnPair& pair, Language language) {
  const DrawnPath& path = pair.path;
  std::string text;
  if (path.begins.by != By::tip) text = why_it_begins(pair, language) + place_of(path.begins, language);
  if (path.ends.by == By::tip) return text;
  if (!text.empty()) text += Words{", and ", ", e "}.in(language);
  return text + why_it_ends(path.ends.by).in(language) + place_of(path.ends, language);
}

std::string what_is_left(const DrawnPair& pair, Language language) {
  if (!pair.path.touches) return Words{"they never touch", "non si toccano mai"}.in(language);
  return fmt::format("{} ${}$ = {}\u00a0mm, {}", Words{"contact", "contatto"}.in(language), name_of_path(pair.path),
                     figures(1000 * pair.path.length(), 4, language), true_contact_ratio(pair, language));
}

}  // namespace

std::string name_of_path(const DrawnPath& path) { return path.begins.name + path.ends.name; }

std::string plain_name(const DrawnPath::End& end) {
  std::string name = end.name;
  std::erase_if(name, [](char c) { return c == '_' || c == '{' || c == '}'; });
  return name;
}

std::string true_contact_ratio(const DrawnPair& pair, Language language) {
  return fmt::format("$f$ = ${}$/$p_{{b}}$ = {}{}", name_of_path(pair.path),
                     figures(pair.true_contact_ratio(), 4, language),
                     pair.path.is_continuous ? "" : Words{", below 1", ", minore di 1"}.in(language));
}

std::string about_path(const DrawnPair& pair, const Words& whole, Language language) {
  if (!pair.path.known) return whole.in(language) + ".";
  return fmt::format("{}, {} {}: {}.", whole.in(language), Words{"but", "ma"}.in(language), shortened(pair, language),
                     what_is_left(pair, language));
}

}  // namespace epure::gear_pair
