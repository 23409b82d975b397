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
  const auto text = as_decimal(magnitude, longest_number);
  return text && text->size() <= longest_number ? std::optional(decimal(*text).in(language)) : std::nullopt;
}

std::optional<std::string> short_fraction(const Rational& magnitude) {
  std::string text = geometry::to_text(magnitude);
  return text.size() <= longest_number ? std::optional(text) : std::nullopt;
}

}  // namespace

std::optional<std::string> as_decimal(const Rational& value, std::size_t most_decimals) {
  Rational shifted = CGAL::abs(value);
  std::size_t decimals = 0;
  for (; shifted.denominator() != 1; ++decimals) {
    if (decimals == most_decimals) return std::nullopt;
    shifted *= 10;
  }
  std::string digits = geometry::to_text(shifted);
  if (decimals > 0) {
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return (value < 0 ? "-" : "") + digits;
}

std::string equal_to(const Rational& value, Language language) {
  const Rational magnitude = CGAL::abs(value);
  auto text = short_decimal(magnitude, language);
  if (!text) text = short_fraction(magnitude);
  if (!text) return "≈\u00a0" + drawings::number(nearest(value), figures_of_a_long_one, language);
  return "=\u00a0" + std::string(value < 0 ? "−" : "") + *text;
}

Words told_value(const Rational& value, int figures) {
  constexpr std::size_t longest = 24;
  const auto exactly = as_decimal(value, longest);
  return exactly && exactly->size() <= longest ? decimal(*exactly) : decimal(nearest(value), figures);
}

Words told_degrees(const geometry::Angle& angle, int figures) {
  if (angle.radians == 0) return told_value(360 * angle.turns, figures);
  return decimal(geometry::degrees(angle), figures);
}

std::optional<int> figures_that_tell_apart(double one, double other) {
  constexpr int least = 6, most = 15;
  for (int figures = least; figures <= most; ++figures)
    if (decimal(one, figures).english != decimal(other, figures).english) return figures;
  return {};
}

}  // namespace epure
