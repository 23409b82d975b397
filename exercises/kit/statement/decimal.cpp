#include "exercises/kit/statement/decimal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "exercises/kit/statement/format_words.h"
#include "geometry/numbers/fast.h"
#include "geometry/numbers/given.h"
#include "geometry/numbers/unit_product.h"
#include "words/quoted.h"

namespace epure {
namespace {

using geometry::Rational;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

// Where the parts of a readable number lie.
struct Anatomy {
  bool signed_text = false, fraction = false;
  int last_digit = 0;     // its power of ten
  std::string_view unit;  // what follows, without blanks
};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

int take_digits(std::string_view& text) {
  int count = 0;
  for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1)) ++count;
  return count;
}

// Of a text that parse_given has read, so an e after the digits is an exponent, and a short one.
Anatomy dissect(std::string_view text) {
  text = without_blanks(text);
  Anatomy parts;
  if (!text.empty() && is_sign(text.front())) {
    parts.signed_text = true;
    text.remove_prefix(1);
  }
  take_digits(text);
  if (!text.empty() && (text.front() == '.' || text.front() == ',')) {
    text.remove_prefix(1);
    parts.last_digit = -take_digits(text);
  }
  if (!text.empty() && (text.front() == 'e' || text.front() == 'E')) {
    text.remove_prefix(text.size() > 1 && text[1] == '+' ? 2 : 1);
    int exponent = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    parts.last_digit += exponent;
  }
  parts.fraction = text.size() > 1 && text[0] == '/' &&
                   (is_digit(text[1]) || text[1] == '.' || text[1] == ',' || is_sign(text[1]));
  parts.unit = without_blanks(text);
  return parts;
}

// Of a number with a unit that no given has: where its unit begins. A slash is the number's where another follows.
std::size_t end_of_number(std::string_view text) {
  const auto is_of_number = [&](std::size_t at) {
    return at < text.size() && (is_digit(text[at]) || is_sign(text[at]) || text[at] == '.' || text[at] == ',');
  };
  const auto goes_on = [&](std::size_t at) {
    const bool may_part = text[at] == '/' || text[at] == 'e' || text[at] == 'E';
    return is_of_number(at) || (may_part && at > 0 && is_of_number(at + 1));
  };
  std::size_t end = 0;
  while (end < text.size() && goes_on(end)) ++end;
  return end;
}

Rational power_of_ten(int exponent) { return geometry::parse_given("1e" + std::to_string(exponent), "1"); }

// In a unit that no given has: "9700 cm^3", "5 kN/m".
Decimal read_product(const std::string& text, const std::string& unit) {
  const std::string plain = geometry::in_plain_characters(text);
  const std::string_view trimmed = without_blanks(plain);
  const std::size_t end = end_of_number(trimmed);
  const std::string typed(without_blanks(trimmed.substr(end)));
  Decimal number = read_decimal(std::string(end == 0 ? trimmed : trimmed.substr(0, end)), "1");
  if (typed.empty() || typed == unit) return number;
  const auto is = geometry::unit_product(typed), asked = geometry::unit_product(unit);
  if (!is || !asked || is->powers != asked->powers) {
    if (!is) read_decimal(text, "1");  // whose sentence knows thousands and the like
    throw geometry::BadGiven(
        format_words("{} ends in {}, which is no unit of what is asked; write a number in {}",
                     "{} finisce con {}, che non è un'unità di ciò che si chiede; scrivere un numero in {}",
                     quoted(text), quoted(typed), unit));
  }
  const Rational factor = is->factor / asked->factor;
  number.value *= factor;
  number.half_unit *= factor;
  return number;
}

}  // namespace

Decimal read_decimal(const std::string& text, const std::string& unit) {
  if (!geometry::find_unit(unit)) return read_product(text, unit);
  const Rational value = geometry::parse_given(text, unit);
  const std::string plain = geometry::in_plain_characters(text);
  const Anatomy parts = dissect(plain);
  if (parts.fraction) return {value, 0, parts.signed_text};
  const Rational factor = parts.unit.empty() ? Rational(1) : geometry::conversion(std::string(parts.unit), unit);
  return {value, power_of_ten(parts.last_digit) / 2 * factor, parts.signed_text};
}

Decimal read_printed(std::string text) {
  const std::string_view power = "×10^";
  if (const auto at = text.find(power); at != std::string::npos) text.replace(at, power.size(), "e");
  const auto first = std::find_if(text.begin(), text.end(), [](char c) { return c == ' '; });
  const std::string symbol(without_blanks(std::string_view(first, text.end())));
  Decimal number = read_decimal(text, symbol);
  if (const auto unit = geometry::find_unit(symbol); unit && !unit->counts_turns) {
    number.value *= unit->factor;
    number.half_unit *= unit->factor;
  }
  return number;
}

Rational excess(const Decimal& number, double value) {
  const Rational exact(value);
  return number.value - (number.signed_text ? exact : CGAL::abs(exact));
}

double nearest(const Rational& value) { return geometry::from_rational<geometry::Fast>(value); }

double with_last_digits_swapped(double value) {
  const int hundredths = static_cast<int>(std::lround(100 * value)), last = hundredths % 10,
            before = hundredths / 10 % 10;
  const int whole = hundredths / 100;
  return (whole * 100 + last * 10 + before) / 100.0;
}

std::optional<double> percent(const Rational& difference, double of_value) {
  if (of_value != 0) return nearest(difference / CGAL::abs(Rational(of_value)) * 100);
  return difference == 0 ? std::optional(0.0) : std::nullopt;
}

}  // namespace epure
