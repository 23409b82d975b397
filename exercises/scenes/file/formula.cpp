#include "exercises/scenes/file/formula.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include "exercises/kit/statement/bare_number.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/sensible_size.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/file/greek.h"

namespace epure::scenes {
namespace {

using geometry::InUnit;
using geometry::Kind;
using geometry::Unit;

constexpr int deepest_parentheses = 50;
// A product of products of long numbers has as many digits as all of them.
constexpr std::size_t most_digits = 10'000;

struct OfKind {
  Kind kind;
  Dimension dimension;
};
constexpr bool it_turns = true;
const std::vector<OfKind>& dimensions() {
  static const std::vector<OfKind> all = {{Kind::pure_number, {}},
                                          {Kind::length, {1, 0}},
                                          {Kind::time, {0, 1}},
                                          {Kind::velocity, {1, -1}},
                                          {Kind::acceleration, {1, -2}},
                                          {Kind::area, {2, 0}},
                                          {Kind::angle, {0, 0, it_turns}},
                                          {Kind::angular_velocity, {0, -1, it_turns}},
                                          {Kind::angular_acceleration, {0, -2, it_turns}}};
  return all;
}
Dimension dimension_of(Kind kind) {
  for (const OfKind& each : dimensions())
    if (each.kind == kind) return each.dimension;
  return {.own = kind};
}
bool is_pure(const Amount& amount) { return amount.dimension == Dimension{}; }

// "a length"; of what has no name its unit: "a number in m^3".
Words in_words(const Dimension& dimension) {
  if (dimension.own) return name_of(*dimension.own);
  for (const OfKind& each : dimensions())
    if (each.dimension == dimension) return name_of(each.kind);
  std::string unit;
  for (const auto& [letter, power] : {std::pair{"m", dimension.metres}, std::pair{"s", dimension.seconds}})
    if (power != 0)
      unit += (unit.empty() ? "" : " ") + std::string(letter) + (power == 1 ? "" : "^" + std::to_string(power));
  return format_words("a number in {}", "un numero in {}", unit);
}

Amount amount_in(const InUnit& number) {
  Amount amount{.dimension = dimension_of(number.unit.kind), .is_bare = number.unit.kind == Kind::pure_number};
  if (amount.dimension.turns)
    amount.angle = geometry::angle_of(number);
  else
    amount.value = geometry::in_si(number);
  return amount;
}

void demand_shortness(const Rational& q) {
  if (mpz_sizeinbase(q.numerator().mpz(), 10) > most_digits ||
      mpz_sizeinbase(q.denominator().mpz(), 10) > most_digits)
    throw BadFormula(format_words("the number has more than {} digits", "il numero ha più di {} cifre", most_digits));
}

// In SI units; what turns may be as small as it likes, a turn being what it is counted in.
const Amount& of_sensible_size(const Amount& amount, const std::string& text) {
  const auto is_large = [](const Rational& q) { return !has_sensible_size(q) && CGAL::abs(q) > 1; };
  if (is_large(amount.angle.turns) || is_large(amount.angle.radians))
    throw BadFormula(format_words("\"{}\" must be at most {} turns or radians, without its sign",
                                  "\"{}\" deve essere al più {} giri o radianti, senza segno", text,
                                  std::string(largest_size)));
  if (!has_sensible_size(amount.value))
    throw BadFormula(format_words("\"{}\" must be zero or, without its sign, lie between {} and {} in SI units",
                                  "\"{}\" deve essere zero o, senza segno, stare tra {} e {} in unità SI", text,
                                  std::string(smallest_size), std::string(largest_size)));
  return amount;
}

// What is told in 1/s, where something that turns is asked for.
Amount turning_like(const Amount& amount, const Dimension& wanted) {
  const Dimension without{wanted.metres, wanted.seconds};
  if (!wanted.turns || wanted.seconds == 0 || amount.dimension != without) return amount;
  return {.dimension = wanted, .angle = {.radians = amount.value}};
}

class Reader {
 public:
  Reader(std::string_view text, const Amounts& known) : text_(text), known_(known) {}

  Amount whole() {
    const Amount amount = sum();
    blanks();
    if (place_ != text_.size())
      throw BadFormula(format_words("\"{}\" cannot be read from \"{}\" on",
                                    "\"{}\" non si può leggere da \"{}\" in poi", text_, text_.substr(place_)));
    return amount;
  }

 private:
  void blanks() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  }
  bool takes(char sign) {
    blanks();
    if (place_ == text_.size() || text_[place_] != sign) return false;
    ++place_;
    return true;
  }

  Amount sum() {
    Amount left = product();
    while (true) {
      const bool is_plus = takes('+');
      if (!is_plus && !takes('-')) return left;
      Amount right = product();
      make_alike(left, right);
      if (left.dimension != right.dimension)
        throw BadFormula(format_words("in \"{}\" {} and {} are added", "in \"{}\" si sommano {} e {}", text_,
                                      in_words(left.dimension), in_words(right.dimension)));
      left.value = is_plus ? left.value + right.value : left.value - right.value;
      left.angle = is_plus ? left.angle + right.angle : left.angle - right.angle;
      left.is_bare = left.is_bare && right.is_bare;
    }
  }
  // 1/s beside what turns is rad/s.
  static void make_alike(Amount& a, Amount& b) {
    if (a.dimension.turns) b = turning_like(b, a.dimension);
    if (b.dimension.turns) a = turning_like(a, b.dimension);
  }

  Amount product() {
    Amount left = factor();
    while (true) {
      if (takes('*'))
        left = multiplied(left, factor());
      else if (takes('/'))
        left = divided(left, factor());
      else
        return left;
      demand_shortness(left.value);
    }
  }

  Amount multiplied(const Amount& a, const Amount& b) const {
    if (is_pure(a) || is_pure(b)) {
      const Amount &pure = is_pure(a) ? a : b, &other = is_pure(a) ? b : a;
      return {other.dimension, pure.value * other.value, pure.value * other.angle, a.is_bare && b.is_bare};
    }
    const Amount x = without_turns(a), y = without_turns(b);
    return {of_powers(x.dimension, y.dimension, 1), x.value * y.value};
  }

  Amount divided(const Amount& a, const Amount& b) const {
    if (b.value == 0 && is_zero(b.angle))
      throw BadFormula(format_words("\"{}\" divides by zero", "\"{}\" divide per zero", text_));
    if (is_pure(b)) return {a.dimension, a.value / b.value, Rational(1 / b.value) * a.angle, a.is_bare && b.is_bare};
    if (a.dimension == b.dimension && a.dimension.own) return {{}, a.value / b.value};
    if (a.dimension == b.dimension && a.dimension.turns)
      if (const auto ratio = geometry::ratio(a.angle, b.angle)) return {{}, *ratio};
    const Amount x = without_turns(a), y = without_turns(b);
    return {of_powers(x.dimension, y.dimension, -1), x.value / y.value};
  }

  Dimension of_powers(const Dimension& a, const Dimension& b, int sign) const {
    constexpr int highest = 20;
    const Dimension both{a.metres + sign * b.metres, a.seconds + sign * b.seconds};
    for (const Dimension& one : {a, b})
      if (one.own)
        throw BadFormula(format_words("in \"{}\" {} stands in a product or quotient with {}",
                                      "in \"{}\" {} sta in un prodotto o quoziente con {}", text_, in_words(a),
                                      in_words(b)));
    if (std::max(std::abs(both.metres), std::abs(both.seconds)) > highest)
      throw BadFormula(format_words("\"{}\" is a number in {}: beyond the power {}",
                                    "\"{}\" è un numero in {}: oltre la potenza {}", text_, in_words(both), highest));
    return both;
  }
  // Radians are no unit: v = ω r.
  Amount without_turns(const Amount& a) const {
    if (!a.dimension.turns) return a;
    if (a.angle.turns != 0)
      throw BadFormula(
          format_words("in \"{}\" degrees or turns stand in a product with units: π lies between, and no fraction "
                       "says it; give them in radians",
                       "in \"{}\" gradi o giri stanno in un prodotto con unità: c'è di mezzo π, e nessuna frazione "
                       "lo dice; darli in radianti",
                       text_));
    return {{a.dimension.metres, a.dimension.seconds}, a.angle.radians};
  }

  Amount factor() {
    if (++depth_ > deepest_parentheses)
      throw BadFormula(format_words("\"{}\" has too many parentheses", "\"{}\" ha troppe parentesi", text_));
    const Amount amount = takes('-') ? negated(factor()) : takes('(') ? in_parentheses() : number_or_name();
    --depth_;
    return amount;
  }
  static Amount negated(const Amount& a) { return {a.dimension, -a.value, -a.angle, a.is_bare}; }
  Amount in_parentheses() {
    const Amount amount = sum();
    if (!takes(')'))
      throw BadFormula(
          format_words("in \"{}\" a parenthesis is not closed", "in \"{}\" una parentesi non è chiusa", text_));
    return amount;
  }

  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
  static bool is_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80);
  }

  Amount number_or_name() {
    blanks();
    const std::size_t begin = place_;
    if (place_ < text_.size() && (is_digit(text_[place_]) || text_[place_] == '.')) return number();
    while (place_ < text_.size() && is_of_name(text_[place_])) ++place_;
    const std::string name = spelled_out(std::string(text_.substr(begin, place_ - begin)));
    if (name.empty())
      throw BadFormula(
          format_words("in \"{}\" a number or a given is missing", "in \"{}\" manca un numero o un dato", text_));
    if (const auto found = known_.find(name); found != known_.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, amount] : known_) names.push_back(known);
    if (names.empty())
      throw BadFormula(
          format_words("\"{}\" is no given: there are none", "\"{}\" non è un dato: non ce ne sono", name));
    throw BadFormula(
        format_words("\"{}\" is no given; {}", "\"{}\" non è un dato; {}", name, did_you_mean(name, names)));
  }

  // Digits, and the unit right after them if there is one.
  Amount number() {
    const std::size_t begin = place_;
    while (place_ < text_.size() && (is_digit(text_[place_]) || text_[place_] == '.')) ++place_;
    if (place_ + 1 < text_.size() && (text_[place_] == 'e' || text_[place_] == 'E') &&
        (is_digit(text_[place_ + 1]) ||
         (place_ + 2 < text_.size() && (text_[place_ + 1] == '-' || text_[place_ + 1] == '+') &&
          is_digit(text_[place_ + 2])))) {
      place_ += 2;
      while (place_ < text_.size() && is_digit(text_[place_])) ++place_;
    }
    const std::string digits(text_.substr(begin, place_ - begin));
    const std::string unit = unit_here();
    try {
      return amount_in(geometry::read_as_typed(digits, unit));
    } catch (const geometry::BadGiven& bad) {
      throw BadFormula(bad.words());
    }
  }

  // The longest unit that stands here; "1" where none does.
  std::string unit_here() {
    const std::size_t before = place_;
    blanks();
    std::string longest;
    for (const Unit& unit : geometry::known_units()) {
      const std::size_t after = place_ + unit.symbol.size();
      if (unit.symbol == "1" || unit.symbol == "1/min" || unit.symbol.size() <= longest.size() ||
          !text_.substr(place_).starts_with(unit.symbol))
        continue;
      if (after < text_.size() && (is_of_name(text_[after]) || text_[after] == '^')) continue;
      longest = unit.symbol;
    }
    if (longest.empty()) {
      if (place_ < text_.size() && is_of_name(text_[place_])) throw BadFormula(no_unit(text_.substr(place_)));
      place_ = before;
      return "1";
    }
    place_ += longest.size();
    return longest;
  }

  std::string_view text_;
  const Amounts& known_;
  std::size_t place_ = 0;
  int depth_ = 0;
};

// A plain number with its unit, as --set takes it, in which "1/72 s" is a part of a second.
std::optional<Amount> plain(const std::string& text, const std::string& unit) {
  try {
    return amount_in(geometry::read_as_typed(text, unit));
  } catch (const geometry::BadGiven&) {
    return {};
  }
}

}  // namespace

Words no_unit(std::string_view text) {
  constexpr Kind told[] = {Kind::length,
                           Kind::angle,
                           Kind::angular_velocity,
                           Kind::angular_acceleration,
                           Kind::velocity,
                           Kind::acceleration,
                           Kind::force,
                           Kind::moment};
  std::string known;
  for (const Kind kind : told)
    for (const Unit& unit : geometry::known_units())
      if (unit.kind == kind) known += (known.empty() ? "" : ", ") + unit.symbol;
  return format_words("\"{}\" is no unit; known are: {}", "\"{}\" non è un'unità; si conoscono: {}", text, known);
}

std::string unit_of(Kind kind) {
  const auto& units = geometry::known_units();
  return std::find_if(units.begin(), units.end(),
                      [&](const Unit& unit) { return unit.kind == kind && unit.factor == 1 && !unit.counts_turns; })
      ->symbol;
}

Amount amount_of(const Givens& givens, const GivenSpec& spec) {
  const auto reading = givens.reading(spec.symbol);
  return reading ? amount_in(*reading) : Amount{};
}

Amount read_any_amount(const std::string& text, const Amounts& known) {
  for (const OfKind& each : dimensions())
    if (const auto amount = plain(text, unit_of(each.kind)); amount && !has_no_unit(text)) return *amount;
  return Reader(text, known).whole();
}

Amount read_amount(const std::string& text, Kind wanted, const std::string& unit_of_bare, const Amounts& known) {
  const bool has_unit = !has_no_unit(text);
  const std::string unit = unit_of_bare.empty() ? unit_of(wanted) : unit_of_bare;
  const Dimension asked = dimension_of(wanted);
  if (has_unit || !unit_of_bare.empty())
    if (const auto amount = plain(text, unit); amount && amount->dimension == asked) {
      demand_shortness(amount->value);
      return of_sensible_size(*amount, text);
    }
  Amount amount = turning_like(Reader(text, known).whole(), asked);
  if (amount.is_bare && wanted != Kind::pure_number) {
    if (unit_of_bare.empty() && amount.value != 0)
      throw BadFormula(format_words("\"{}\" has no unit where {} is asked, such as {}",
                                    "\"{}\" non ha unità dove si chiede {}, come {}", text, name_of(wanted),
                                    geometry::turns(wanted) && wanted == Kind::angle ? "deg" : unit_of(wanted)));
    amount = amount_in({amount.value, *geometry::find_unit(unit)});
  }
  if (amount.dimension != asked)
    throw BadFormula(format_words("\"{}\" is {} where {} is asked", "\"{}\" è {} dove si chiede {}", text,
                                  in_words(amount.dimension), name_of(wanted)));
  return of_sensible_size(amount, text);
}

}  // namespace epure::scenes
