#include "geometry/numbers/unit_symbol.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "words/replace_all.h"

namespace epure::geometry {
namespace {

// "s^-2", "s-2" and "sec" of a product of units: the unit, and its power where that is negative.
struct Factor {
  std::string unit;
  std::string power;  // "2" of s^-2; empty: not negative
};
Factor factor_of(std::string text) {
  const std::size_t minus = text.find('-');
  std::string power;
  if (minus != std::string::npos && minus > 0 && minus + 1 < text.size() &&
      text.find_first_not_of("0123456789", minus + 1) == std::string::npos) {
    power = text.substr(minus + 1);
    text.erase(text[minus - 1] == '^' ? minus - 1 : minus);
  }
  return {text, power};
}

// "m*s^-1" and "m s-1" as "m/s": what has a negative power stands behind the slash. Others stay as they are.
std::string with_slash(const std::string& symbol) {
  if (symbol.find('-') == std::string::npos) return symbol;
  std::string above, below, rest = symbol;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(" *"), rest.size());
    const Factor factor = factor_of(rest.substr(0, end));
    rest.erase(0, std::min(end + 1, rest.size()));
    if (factor.unit.empty()) continue;
    std::string& side = factor.power.empty() ? above : below;
    side += (side.empty() ? "" : " ") + factor.unit + (factor.power.empty() || factor.power == "1" ? "" : "^") +
            (factor.power == "1" ? "" : factor.power);
  }
  return below.empty() ? symbol : (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace

std::string spelled_unit(std::string symbol) {
  constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  replace_all(symbol, "⁻", "^-");
  for (std::size_t digit = 0; digit < raised.size(); ++digit) {
    const std::string plain = std::to_string(digit);
    replace_all(symbol, "^-" + std::string(raised[digit]), "^-" + plain);
    replace_all(symbol, raised[digit], "^" + plain);
  }
  for (const std::string_view dot : {"·", "⋅", "∙"}) replace_all(symbol, dot, "*");
  replace_all(symbol, "μ", "µ");  // the Greek letter, for the sign
  for (const std::string_view slash : {" /", "/ "})
    while (symbol.find(slash) != std::string::npos) symbol.replace(symbol.find(slash), slash.size(), "/");
  if (symbol.starts_with('/')) symbol.insert(0, "1");
  symbol = with_slash(symbol);
  replace_all(symbol, "sec", "s");
  replace_all(symbol, "gradi", "deg");
  if (symbol.ends_with("/s2") || symbol.ends_with("/s3") || symbol.ends_with("m2"))
    symbol.insert(symbol.size() - 1, "^");
  return symbol;
}

}  // namespace epure::geometry
