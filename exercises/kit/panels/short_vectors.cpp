#include "exercises/kit/panels/short_vectors.h"

#include "exercises/kit/panels/sheet.h"

namespace epure {

std::string without_arrow(std::string letters) {
  const std::string before = "\\vec{";
  const auto at = letters.find(before);
  if (at == std::string::npos) return letters;
  letters.erase(at, before.size());
  letters.erase(letters.find('}', at), 1);
  return letters;
}

std::string letters_or_value(const std::string& letters, double length, double mm_on_paper, const std::string& unit,
                             Language language) {
  constexpr double head = 3;  // mm
  if (mm_on_paper >= head) return letters;
  return fmt::format("{} = {} {}", without_arrow(letters), length == 0 ? "0" : figures(length, 3, language), unit);
}

}  // namespace epure
