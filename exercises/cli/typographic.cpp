#include "exercises/cli/typographic.h"

#include <algorithm>

namespace epure {

std::string with_true_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, text == "-" ? "–" : "−");
  return text;
}

std::string typographic(std::string number) {
  const auto power = number.find('e');
  std::string exponent = power == std::string::npos ? "" : number.substr(power + 1);
  number = number.substr(0, power);
  number = with_true_minus(number);
  if (exponent.empty()) return number;
  const std::string sign = exponent.starts_with('-') ? "−" : "";
  exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size() - 1));
  return "$" + number + "·10^{" + sign + exponent + "}$";
}

}  // namespace epure
