// Numbers a reader measured with a ruler.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/kit/proof/measured.h"
#include "exercises/kit/statement/bare_number.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// Also "43deg" in rad and "127rpm" in rad/s. With more digits of 2π than doubles have.
Decimal read_any_unit(const std::string& text, const std::string& unit) {
  const auto own = geometry::find_unit(unit);
  if (!own || !geometry::turns(own->kind)) return read_decimal(text, unit);
  const geometry::Unit typed = geometry::read_given(text, unit).unit;
  if (typed.counts_turns == own->counts_turns) return read_decimal(text, unit);
  Decimal number = read_decimal(text, typed.symbol);
  static const Rational turn = geometry::parse_given("6.2831853071795864769252867665590057684", "1");
  const Rational factor = typed.factor / own->factor * (typed.counts_turns ? turn : Rational(1) / turn);
  number.value *= factor;
  number.half_unit *= factor;
  return number;
}

// 5.1·10^3 as sheets print it, and 5.1×10^3.
std::string with_e_for_powers(std::string text) {
  for (const std::string_view times : {"·10^", "×10^", "*10^"})
    if (const auto at = text.find(times); at != std::string::npos) text.replace(at, times.size(), "e");
  return text;
}

std::string without_outer_blanks(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// "≈ 4.5", "4,5 ± 0,1 m/s" and "(4,5 ± 0,1) m/s" as the value they tell: how sure of it who read it was, allowance
// does not ask.
std::string without_uncertainty(const std::string& typed) {
  std::string text = without_outer_blanks(geometry::in_plain_characters(typed));
  for (const std::string_view about : {"≈", "~"})
    if (text.starts_with(about)) text = without_outer_blanks(text.substr(about.size()));
  for (const std::string_view sign : {"±", "+/-", "+-"}) {
    const auto at = text.find(sign);
    if (at == std::string::npos) continue;
    std::string value = without_outer_blanks(text.substr(0, at)), by = text.substr(at + sign.size());
    if (const auto close = by.find(')'); value.starts_with('(') && close != std::string::npos) {
      value.erase(0, 1);
      by.erase(close, 1);
    }
    const auto end_of_digits = [&](std::size_t from) {
      return std::min(by.find_first_not_of("0123456789.,", from), by.size());
    };
    const std::size_t begin = std::min(by.find_first_not_of(' '), by.size());
    std::size_t end = end_of_digits(begin);
    if (end == begin) return typed;  // no number follows the sign
    if (by.substr(end).starts_with('/') && end_of_digits(end + 1) > end + 1) end = end_of_digits(end + 1);
    const std::string unit = without_outer_blanks(by.substr(end));
    return has_no_unit(value) && unit != "%" ? value + " " + unit : value;
  }
  return text;
}

}  // namespace

// Far from where doubles overflow, and beyond all that comes of the largest givens.
Decimal read_measured(const std::string& text, const std::string& unit) {
  Decimal number = read_any_unit(with_e_for_powers(without_uncertainty(text)), unit);
  const Rational largest = geometry::parse_given("1e60", "1");
  if (CGAL::abs(number.value) > largest || number.half_unit > largest)
    throw geometry::BadGiven(format_words("\"{}\" must lie between -1e60 and 1e60{}",
                                          "\"{}\" dev'essere tra -1e60 e 1e60{}", text.substr(0, 60),
                                          unit == "1" ? std::string() : " " + unit));
  return number;
}

double whole_turn(const Quantity& quantity) {
  if (quantity.is_rotation) return 0;
  return quantity.unit == "deg" ? 360 : quantity.unit == "rad" ? 2 * std::numbers::pi : 0;
}

double nearest_turn(double value, double to, const Quantity& quantity) {
  const double turn = whole_turn(quantity);
  return turn == 0 ? value : value + turn * std::round((to - value) / turn);
}

bool goes_over_end_of_turn(double from, double to, const Quantity& quantity) {
  const double turn = whole_turn(quantity);
  return turn > 0 && std::abs(to - from) > turn / 2;
}

bool is_near(const Decimal& number, double value, const Rational& size, const Quantity& quantity) {
  return CGAL::abs(excess(number, nearest_turn(value, nearest(number.value), quantity))) <= size;
}

void add_measured(CheckedExercise& checked, CheckedQuantity& quantity, const std::string& text, const Ruler& ruler) {
  const auto fail = [&](const Words& why) {
    checked.failures.push_back({Complaint::About::quantity, quantity.spec.name, why});
  };
  const Decimal number = read_measured(text, quantity.spec.unit);
  const Allowance allowed = allowance_of(number, allowance(checked, quantity, ruler));
  Measured measured{
      .text = text, .value = nearest(number.value), .allowed = nearest(allowed.size), .allowed_by = allowed.by};
  if (has_value(quantity.settled)) {
    const double value = nearest_turn(quantity.settled.enclosure.value, measured.value, quantity.spec);
    measured.within = is_near(number, value, allowed.size, quantity.spec);
    // Told in doubles: that 0.3 as typed is 1e-17 off the double 0.3 is nobody's error.
    measured.difference = measured.value - (number.signed_text ? value : std::abs(value));
    measured.difference_percent = percent(Rational(*measured.difference), quantity.settled.enclosure.value);
    if (!measured.within)
      fail(format_words("{}: measured {} is beyond reading: {} off, {} allowed ({})",
                        "{}: misurata {}, oltre l'errore di lettura: scarto {}, ammesso {} ({})", quantity.spec.name,
                        text, decimal(std::abs(*measured.difference), 3), decimal(measured.allowed, 3),
                        measured.allowed_by));
  } else {
    fail(format_words("{}: measured {}, but there is no value to compare with ({})",
                      "{}: misurata {}, ma non c'è un valore con cui confrontarla ({})", quantity.spec.name, text,
                      quantity.settled.reason));
  }
  quantity.measured.push_back(std::move(measured));
}

}  // namespace epure
