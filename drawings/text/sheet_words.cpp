#include "drawings/text/sheet_words.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace epure::drawings {

const SheetWords& words(Language language) {
  static const SheetWords english{
      .scale = "scale",
      .scales = "scales",
      .source = "source",
      .paper = "paper",
      .sheet = "sheet",
      .check_bar = "50 mm when printed at 100 %",
      .construction = "Construction",
      .results = "Results",
      .given = "Given",
      .direction = "direction",
      .magnitude = "magnitude",
      .quantity = "quantity",
      .value = "value",
      .on_sheet = "on the sheet",
      .printed = "printed",
  };
  static const SheetWords italian{
      .scale = "scala",
      .scales = "scale",
      .source = "fonte",
      .paper = "formato",
      .sheet = "tavola",
      .check_bar = "50 mm se stampato al 100 %",
      .construction = "Costruzione",
      .results = "Risultati",
      .given = "Dati",
      .direction = "direzione",
      .magnitude = "modulo",
      .quantity = "grandezza",
      .value = "valore",
      .on_sheet = "sul foglio",
      .printed = "stampato",
  };
  return language == Language::italian ? italian : english;
}

std::string number(double value, int significant, Language language) {
  if (!std::isfinite(value)) throw std::invalid_argument("a number to print must be finite");
  if (significant < 1 || significant > 15) throw std::invalid_argument("1 to 15 significant figures");
  // fmt rounds first; its exponent is that of the rounded number (9.996 to three figures is 1.00e1).
  const std::string scientific = fmt::format("{:.{}e}", std::abs(value), significant - 1);
  const std::size_t at = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(at + 1));
  const bool plain = value == 0 || (exponent >= -3 && exponent < 6);
  std::string text = plain ? fmt::format("{:.{}f}", std::abs(value), std::max(0, significant - 1 - exponent))
                           : scientific.substr(0, at);
  if (language == Language::italian)
    if (const std::size_t point = text.find('.'); point != std::string::npos) text[point] = ',';
  const std::string sign = value < 0 ? "−" : "";
  if (plain) return sign + text;
  const std::string power = exponent < 0 ? fmt::format("−{}", -exponent) : fmt::format("{}", exponent);
  return fmt::format("${}{}·10^{{{}}}$", sign, text, power);
}

}  // namespace epure::drawings
