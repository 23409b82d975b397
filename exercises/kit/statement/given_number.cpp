#include "exercises/kit/statement/given_number.h"

#include <CGAL/Gmpq.h>

#include <optional>

#include "drawings/text/sheet_words.h"
#include "exercises/kit/statement/decimal.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

using geometry::Rational;

constexpr std::size_t longest_number = 14;  // characters: what the sheets' column bears beside letters and unit
constexpr int figures_of_a_long_one = 10;

std::optional<std::string> short_decimal(const Rational& magnitude, Language language) {
  Rational shifted = magnitude;
  std::size_t decimals = 0;
  for (; shifted.denominator() != 1; ++decimals) {
    if (decimals == longest_number) return std::nullopt;
    shifted *= 10;
  }
  std::string digits = geometry::to_text(shifted);
  if (decimals > 0) {
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, language == Language::italian ? "," : ".");
  }
  return digits.size() <= longest_number ? std::optional(digits) : std::nullopt;
}

std::optional<std::string> short_fraction(const Rational& magnitude) {
  std::string text = geometry::to_text(magnitude);
  return text.size() <= longest_number ? std::optional(text) : std::nullopt;
}

}  // namespace

std::string equal_to(const Rational& value, Language language) {
  const Rational magnitude = CGAL::abs(value);
  auto text = short_decimal(magnitude, language);
  if (!text) text = short_fraction(magnitude);
  if (!text) return "≈\u00a0" + drawings::number(nearest(value), figures_of_a_long_one, language);
  return "=\u00a0" + std::string(value < 0 ? "−" : "") + *text;
}

}  // namespace epure
