#include "geometry/numbers/given.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace epure::geometry {

namespace {

// Beyond it a decimal exponent is refused: every finite double fits, and 1e999999999 cannot exhaust the memory.
constexpr int largest_exponent = 400;
// Nobody types more, and a number of a million digits would be read in quadratic time.
constexpr std::size_t longest_text = 1000;

std::vector<Unit> make_units() {
  const auto ratio = [](int numerator, int denominator) { return Rational(numerator, denominator); };
  return {
      {"1", 1, "pure number"},
      {"m", 1, "length"},
      {"cm", ratio(1, 100), "length"},
      {"mm", ratio(1, 1000), "length"},
      {"km", 1000, "length"},
      {"s", 1, "time"},
      {"ms", ratio(1, 1000), "time"},
      {"min", 60, "time"},
      {"rpm", ratio(1, 60), "turns per time"},
      {"giri/min", ratio(1, 60), "turns per time"},
      {"1/min", ratio(1, 60), "turns per time"},
      {"Hz", 1, "turns per time"},
      {"1/s", 1, "turns per time"},
      {"turn/s", 1, "turns per time"},
      {"giri/s", 1, "turns per time"},
      {"turn", 1, "angle"},
      {"deg", ratio(1, 360), "angle"},
      {"°", ratio(1, 360), "angle"},
      {"rad", 1, "angle in radians"},
      {"rad/s", 1, "angular velocity in radians"},
      {"rad/s^2", 1, "angular acceleration"},
      {"rad/s2", 1, "angular acceleration"},
      {"rad/s²", 1, "angular acceleration"},
      {"m/s", 1, "velocity"},
      {"cm/s", ratio(1, 100), "velocity"},
      {"mm/s", ratio(1, 1000), "velocity"},
      {"km/h", ratio(5, 18), "velocity"},
      {"m/s^2", 1, "acceleration"},
      {"m/s2", 1, "acceleration"},
      {"m/s²", 1, "acceleration"},
      {"cm/s^2", ratio(1, 100), "acceleration"},
      {"mm/s^2", ratio(1, 1000), "acceleration"},
      {"N", 1, "force"},
      {"kN", 1000, "force"},
      {"Nm", 1, "moment"},
      {"N*m", 1, "moment"},
      {"kNm", 1000, "moment"},
      {"kg", 1, "mass"},
      {"g", ratio(1, 1000), "mass"},
      {"kg m^2", 1, "moment of inertia"},
      {"kgm^2", 1, "moment of inertia"},
      {"kg*m^2", 1, "moment of inertia"},
      {"kg m²", 1, "moment of inertia"},
  };
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 60)) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return result + (text.size() > 60 ? "...\"" : "\"");
}

std::string units_like(const Unit& unit) {
  std::string list;
  for (const Unit& known : known_units())
    if (known.dimension == unit.dimension) list += (list.empty() ? "" : ", ") + known.symbol;
  return list;
}

std::string with_article(const std::string& noun) {
  return (std::string_view("aeiou").find(noun.front()) == std::string_view::npos ? "a " : "an ") + noun;
}

std::string example(const Unit& unit) {
  const std::string symbol = unit.symbol == "1" ? "" : unit.symbol;
  return "a number such as 0.25" + symbol + " or 1/4" + symbol;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Reads one text from front to back. What is wrong is told with the whole text.
class Reader {
 public:
  Reader(const std::string& text, const Unit& expected) : text_(text), rest_(text), expected_(expected) {}

  Rational read() {
    if (text_.size() > longest_text) refuse("is longer than " + std::to_string(longest_text) + " characters");
    skip_blanks();
    if (rest_.empty()) refuse("is empty");
    const Rational number = read_fraction();
    refuse_comma();
    return number * factor_of(read_unit());
  }

 private:
  [[noreturn]] void refuse(const std::string& condition) const { refuse(condition, example(expected_)); }

  [[noreturn]] void refuse(const std::string& condition, const std::string& accepted) const {
    throw BadGiven(quoted(text_) + " " + condition + "; write " + accepted);
  }

  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool take_sign() {
    const bool is_negative = take('-');
    if (!is_negative) take('+');
    return is_negative;
  }

  std::string take_digits() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_digit);
    std::string digits(rest_.begin(), end);
    rest_.remove_prefix(digits.size());
    return digits;
  }

  void refuse_comma() const {
    if (!rest_.empty() && rest_.front() == ',') refuse("has a decimal comma", "a decimal point, such as 0.25");
  }

  // Two decimals with a slash, or one. "1/s" is no fraction: a slash counts only before a digit, point or sign.
  Rational read_fraction() {
    const Rational numerator = read_decimal();
    const bool is_fraction = rest_.size() >= 2 && rest_[0] == '/' &&
                             (is_digit(rest_[1]) || rest_[1] == '.' || rest_[1] == '-' || rest_[1] == '+');
    if (!is_fraction) return numerator;
    take('/');
    const Rational denominator = read_decimal();
    if (CGAL::is_zero(denominator)) refuse("divides by zero");
    return numerator / denominator;
  }

  Rational read_decimal() {
    const bool is_negative = take_sign();
    std::string digits = take_digits();
    std::string decimals;
    refuse_comma();
    if (take('.')) decimals = take_digits();
    if (digits.empty() && decimals.empty()) refuse("does not begin with a finite number");
    const int exponent = read_exponent() - static_cast<int>(decimals.size());
    const Rational magnitude = Rational(CGAL::Gmpz("0" + digits + decimals), CGAL::Gmpz(1)) * power_of_ten(exponent);
    return is_negative ? -magnitude : magnitude;
  }

  // An e or E counts as an exponent only when digits follow, and must then be within bounds.
  int read_exponent() {
    if (rest_.empty() || (rest_.front() != 'e' && rest_.front() != 'E')) return 0;
    rest_.remove_prefix(1);
    const bool is_negative = take_sign();
    const std::string digits = take_digits();
    if (digits.empty()) refuse("has an exponent without digits");
    int exponent = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc() || end != digits.data() + digits.size() || exponent > largest_exponent)
      refuse("has an exponent beyond ±" + std::to_string(largest_exponent));
    return is_negative ? -exponent : exponent;
  }

  static Rational power_of_ten(int exponent) {
    CGAL::Gmpz power;
    mpz_ui_pow_ui(power.mpz(), 10, static_cast<unsigned long>(std::abs(exponent)));
    return exponent < 0 ? Rational(1, power) : Rational(power, 1);
  }

  // The rest without blanks around it, as a symbol.
  std::string read_unit() {
    skip_blanks();
    while (!rest_.empty() && is_blank(rest_.back())) rest_.remove_suffix(1);
    return std::string(rest_);
  }

  Rational factor_of(const std::string& symbol) const {
    if (symbol.empty()) return 1;
    const auto unit = find_unit(symbol);
    if (!unit) refuse("ends in " + quoted(symbol) + ", which is no unit of this program", accepted_units());
    if (unit->dimension == "angular velocity in radians" && expected_.dimension == "turns per time")
      refuse("is in radians, and a turn is 2π of them, which no fraction can say exactly", accepted_units());
    if (unit->dimension != expected_.dimension)
      refuse("is " + with_article(unit->dimension) + " where " + with_article(expected_.dimension) + " is asked",
             accepted_units());
    return unit->factor / expected_.factor;
  }

  std::string accepted_units() const {
    return expected_.symbol == "1" ? "a number without a unit" : "a number in one of: " + units_like(expected_);
  }

  const std::string& text_;
  std::string_view rest_;
  const Unit& expected_;
};

}  // namespace

const std::vector<Unit>& known_units() {
  static const std::vector<Unit> units = make_units();
  return units;
}

std::optional<Unit> find_unit(const std::string& symbol) {
  const std::string& wanted = symbol.empty() ? known_units().front().symbol : symbol;
  const auto& units = known_units();
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.symbol == wanted; });
  return found == units.end() ? std::nullopt : std::optional(*found);
}

Rational parse_given(const std::string& text, const std::string& unit_of_the_given) {
  const auto expected = find_unit(unit_of_the_given);
  assert(expected && "the unit of a given must be known");
  return Reader(text, *expected).read();
}

Rational conversion(const std::string& from, const std::string& to) {
  const auto source = find_unit(from);
  const auto target = find_unit(to);
  assert(source && target && source->dimension == target->dimension);
  return source->factor / target->factor;
}

std::string to_text(const Rational& value) {
  std::ostringstream text;
  text << value.numerator();
  if (value.denominator() != 1) text << '/' << value.denominator();
  return text.str();
}

}  // namespace epure::geometry
