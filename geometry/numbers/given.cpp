#include "geometry/numbers/given.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "geometry/numbers/unit_product.h"
#include "geometry/numbers/unit_symbol.h"
#include "words/quoted.h"
#include "words/replace_all.h"

namespace epure::geometry {

namespace {

// Beyond it a decimal exponent is refused: every finite double fits, and 1e999999999 cannot exhaust the memory.
constexpr int largest_exponent = 400;
// Nobody types more, and a number of a million digits would be read in quadratic time.
constexpr std::size_t longest_text = 1000;

std::vector<Unit> make_units() {
  const auto ratio = [](int numerator, int denominator) { return Rational(numerator, denominator); };
  constexpr bool by_turns = true;
  const Rational kgf = ratio(980665, 100000), lb(45359237, 100000000), foot = ratio(3048, 10000);
  return {
      {"1", Kind::pure_number, 1},
      {"%", Kind::pure_number, ratio(1, 100)},
      {"m", Kind::length, 1},
      {"cm", Kind::length, ratio(1, 100)},
      {"mm", Kind::length, ratio(1, 1000)},
      {"km", Kind::length, 1000},
      {"dm", Kind::length, ratio(1, 10)},
      {"µm", Kind::length, ratio(1, 1000000)},
      {"um", Kind::length, ratio(1, 1000000)},
      {"in", Kind::length, ratio(254, 10000)},
      {"ft", Kind::length, foot},
      {"s", Kind::time, 1},
      {"ms", Kind::time, ratio(1, 1000)},
      {"min", Kind::time, 60},
      {"h", Kind::time, 3600},
      {"deg", Kind::angle, ratio(1, 360), by_turns},
      {"°", Kind::angle, ratio(1, 360), by_turns},
      {"turn", Kind::angle, 1, by_turns},
      {"rev", Kind::angle, 1, by_turns},
      {"gon", Kind::angle, ratio(1, 400), by_turns},
      {"rad", Kind::angle, 1},
      {"mrad", Kind::angle, ratio(1, 1000)},
      {"rpm", Kind::angular_velocity, ratio(1, 60), by_turns},
      {"rev/min", Kind::angular_velocity, ratio(1, 60), by_turns},
      {"turn/min", Kind::angular_velocity, ratio(1, 60), by_turns},
      {"giri/min", Kind::angular_velocity, ratio(1, 60), by_turns},
      {"1/min", Kind::angular_velocity, ratio(1, 60), by_turns},
      {"Hz", Kind::angular_velocity, 1, by_turns},
      {"rev/s", Kind::angular_velocity, 1, by_turns},
      {"turn/s", Kind::angular_velocity, 1, by_turns},
      {"giri/s", Kind::angular_velocity, 1, by_turns},
      {"deg/s", Kind::angular_velocity, ratio(1, 360), by_turns},
      {"°/s", Kind::angular_velocity, ratio(1, 360), by_turns},
      {"rad/s", Kind::angular_velocity, 1},
      {"rad/min", Kind::angular_velocity, ratio(1, 60)},
      {"rad/s^2", Kind::angular_acceleration, 1},
      {"rev/s^2", Kind::angular_acceleration, 1, by_turns},
      {"turn/s^2", Kind::angular_acceleration, 1, by_turns},
      {"deg/s^2", Kind::angular_acceleration, ratio(1, 360), by_turns},
      {"°/s^2", Kind::angular_acceleration, ratio(1, 360), by_turns},
      {"rpm/s", Kind::angular_acceleration, ratio(1, 60), by_turns},
      {"m/s", Kind::velocity, 1},
      {"cm/s", Kind::velocity, ratio(1, 100)},
      {"mm/s", Kind::velocity, ratio(1, 1000)},
      {"km/h", Kind::velocity, ratio(5, 18)},
      {"m/min", Kind::velocity, ratio(1, 60)},
      {"in/s", Kind::velocity, ratio(254, 10000)},
      {"ft/s", Kind::velocity, foot},
      {"m/s^2", Kind::acceleration, 1},
      {"cm/s^2", Kind::acceleration, ratio(1, 100)},
      {"mm/s^2", Kind::acceleration, ratio(1, 1000)},
      {"ft/s^2", Kind::acceleration, foot},
      {"N", Kind::force, 1},
      {"kN", Kind::force, 1000},
      {"MN", Kind::force, 1000000},
      {"kgf", Kind::force, kgf},
      {"daN", Kind::force, 10},
      {"tf", Kind::force, kgf * 1000},
      {"lbf", Kind::force, lb * kgf},
      {"Nm", Kind::moment, 1},
      {"N m", Kind::moment, 1},
      {"N*m", Kind::moment, 1},
      {"kNm", Kind::moment, 1000},
      {"Nmm", Kind::moment, ratio(1, 1000)},
      {"kgf m", Kind::moment, kgf},
      {"kg", Kind::mass, 1},
      {"g", Kind::mass, ratio(1, 1000)},
      {"t", Kind::mass, 1000},
      {"lb", Kind::mass, lb},
      {"kg m^2", Kind::moment_of_inertia, 1},
      {"kgm^2", Kind::moment_of_inertia, 1},
      {"kg*m^2", Kind::moment_of_inertia, 1},
      {"kg cm^2", Kind::moment_of_inertia, ratio(1, 10000)},
      {"g m^2", Kind::moment_of_inertia, ratio(1, 1000)},
      {"Pa", Kind::stress, 1},
      {"kPa", Kind::stress, 1000},
      {"MPa", Kind::stress, 1000000},
      {"GPa", Kind::stress, 1000000000},
      {"N/m^2", Kind::stress, 1},
      {"N/mm^2", Kind::stress, 1000000},
      {"bar", Kind::stress, 100000},
      {"kgf/cm^2", Kind::stress, kgf * 10000},
      {"kgf/mm^2", Kind::stress, kgf * 1000000},
      {"m^2", Kind::area, 1},
      {"cm^2", Kind::area, ratio(1, 10000)},
      {"mm^2", Kind::area, ratio(1, 1000000)},
      {"m^4", Kind::second_moment_of_area, 1},
      {"cm^4", Kind::second_moment_of_area, ratio(1, 100000000)},
      {"mm^4", Kind::second_moment_of_area, Rational(1, 1000000) * Rational(1, 1000000)},
      {"J", Kind::energy, 1},
      {"kJ", Kind::energy, 1000},
      {"W", Kind::power, 1},
      {"kW", Kind::power, 1000},
      {"MW", Kind::power, 1000000},
      {"Pa s", Kind::viscosity, 1},
      {"Pa*s", Kind::viscosity, 1},
      {"mPa s", Kind::viscosity, ratio(1, 1000)},
      {"cP", Kind::viscosity, ratio(1, 1000)},
      {"N s/m^2", Kind::viscosity, 1},
      {"kgf s/m^2", Kind::viscosity, kgf},
      {"N/s", Kind::force_per_time, 1},
      {"kN/s", Kind::force_per_time, 1000},
      {"N/s^2", Kind::force_per_time_squared, 1},
      {"kN/s^2", Kind::force_per_time_squared, 1000},
      {"N/s^3", Kind::force_per_time_cubed, 1},
      {"kN/s^3", Kind::force_per_time_cubed, 1000},
      {"m^3/s", Kind::flow, 1},
      {"m^3/min", Kind::flow, ratio(1, 60)},
      {"m^3/h", Kind::flow, ratio(1, 3600)},
      {"l/s", Kind::flow, ratio(1, 1000)},
      {"l/min", Kind::flow, ratio(1, 60000)},
      {"N s^2/m^2", Kind::mass_per_length, 1},  // of drag and lift: a force over the square of a speed
      {"kg/m", Kind::mass_per_length, 1},
  };
}

std::string units_like(const Unit& unit) {
  std::string list;
  for (const Unit& known : known_units())
    if (known.kind == unit.kind) list += (list.empty() ? "" : ", ") + known.symbol;
  return list;
}

Words example(const Unit& unit) {
  const std::string symbol = unit.symbol == "1" ? "" : unit.symbol;
  return {"a number such as 0.25" + symbol + " or 1/4" + symbol, "un numero come 0,25" + symbol + " o 1/4" + symbol};
}

// A work may be in N m; a couple is not in joules.
bool stands_for(Kind typed, Kind asked) { return typed == asked || (typed == Kind::moment && asked == Kind::energy); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Reads one text from front to back. What is wrong is told with the whole text.
class Reader {
 public:
  Reader(const std::string& text, const Unit& expected)
      : text_(text), plain_(in_plain_characters(text)), rest_(plain_), expected_(expected) {}

  InUnit read_as_typed() {
    if (text_.size() > longest_text) refuse_long();
    skip_blanks();
    if (rest_.empty()) refuse({"is empty", "è vuoto"});
    const Rational number = read_fraction();
    return {number, unit_of(read_unit())};
  }

  InUnit read() {
    const InUnit typed = read_as_typed();
    if (typed.unit.counts_turns != expected_.counts_turns) return typed;
    return {typed.number * (typed.unit.factor / expected_.factor), expected_};
  }

  [[noreturn]] void refuse_pi(const Unit& typed) const {
    refuse({"is in " + typed.symbol + ", and a turn is 2π radians, which no fraction can say exactly",
            "è in " + typed.symbol + ", e un giro è 2π radianti, che nessuna frazione dice esattamente"},
           {"a number in " + expected_.symbol, "un numero in " + expected_.symbol});
  }

 private:
  [[noreturn]] void refuse(const Words& condition) const { refuse(condition, example(expected_)); }

  [[noreturn]] void refuse(const Words& condition, const Words& accepted) const {
    throw BadGiven(quoted(text_) + " " + condition.english + "; write " + accepted.english,
                   quoted(text_) + " " + condition.italian + "; scrivere " + accepted.italian);
  }

  [[noreturn]] void refuse_long() const {
    const std::string limit = std::to_string(longest_text);
    refuse({"is longer than " + limit + " characters", "è più lungo di " + limit + " caratteri"});
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

  // Two decimals with a slash, or one. "1/s" is no fraction: a slash counts only before what a number begins with.
  Rational read_fraction() {
    const Rational numerator = read_decimal();
    const bool is_fraction =
        rest_.size() >= 2 && rest_[0] == '/' &&
        (is_digit(rest_[1]) || std::string_view(".,-+").find(rest_[1]) != std::string_view::npos);
    if (!is_fraction) return numerator;
    take('/');
    const Rational denominator = read_decimal();
    if (CGAL::is_zero(denominator)) refuse({"divides by zero", "divide per zero"});
    return numerator / denominator;
  }

  Rational read_decimal() {
    const bool is_negative = take_sign();
    std::string digits = take_digits();
    std::string decimals;
    if (take('.') || take(',')) decimals = take_digits();
    if (digits.empty() && decimals.empty())
      refuse({"does not begin with a finite number", "non comincia con un numero finito"});
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
    if (digits.empty()) refuse({"has an exponent without digits", "ha un esponente senza cifre"});
    int exponent = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc() || end != digits.data() + digits.size() || exponent > largest_exponent)
      refuse_exponent();
    return is_negative ? -exponent : exponent;
  }

  [[noreturn]] void refuse_exponent() const {
    const std::string limit = "±" + std::to_string(largest_exponent);
    refuse({"has an exponent beyond " + limit, "ha un esponente oltre " + limit});
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

  Unit unit_of(const std::string& symbol) const {
    if (symbol.empty()) return expected_;
    const auto unit = find_unit(symbol);
    if (!unit && may_turn(symbol))
      refuse({"may be in turns or in radians", "può essere in giri o in radianti"}, accepted_units());
    if (!unit) refuse_unknown(symbol);
    if (stands_for(unit->kind, expected_.kind))
      return {unit->symbol, expected_.kind, unit->factor, unit->counts_turns};
    const Words is = name_of(unit->kind), asked = name_of(expected_.kind);
    refuse({"is " + is.english + " where " + asked.english + " is asked",
            "è " + is.italian + " dove occorre " + asked.italian},
           accepted_units());
  }

  // 1/s, 1/h² and the like, where something turns.
  bool may_turn(const std::string& symbol) const {
    const auto product = unit_product(symbol);
    return product &&
           ((expected_.kind == Kind::angular_velocity && product->powers == UnitProduct::Powers{0, 0, -1, 0}) ||
            (expected_.kind == Kind::angular_acceleration && product->powers == UnitProduct::Powers{0, 0, -2, 0}));
  }

  [[noreturn]] void refuse_unknown(const std::string& symbol) const {
    const bool separates = std::string_view(".,'").find(symbol.front()) != std::string_view::npos;
    if (is_digit(symbol.front()) || (separates && symbol.size() > 1 && is_digit(symbol[1])))
      refuse({"has more than a decimal point or comma between its digits",
              "ha più di un punto o di una virgola decimale tra le cifre"},
             {"thousands without a separator, as in 1234.5", "le migliaia senza separatore, come in 1234,5"});
    if (const Words asked = name_of(expected_.kind); unit_product(symbol))
      refuse({"ends in " + quoted(symbol) + ", which is no unit of " + asked.english,
              "finisce con " + quoted(symbol) + ", che non è un'unità di " + asked.italian},
             accepted_units());
    refuse({"ends in " + quoted(symbol) + ", which is no unit of this program",
            "finisce con " + quoted(symbol) + ", che non è un'unità di questo programma"},
           accepted_units());
  }

  Words accepted_units() const {
    if (expected_.symbol == "1") return {"a number without a unit", "un numero senza unità"};
    const std::string units = units_like(expected_);
    return {"a number in one of: " + units, "un numero in una di queste unità: " + units};
  }

  const std::string& text_;
  const std::string plain_;
  std::string_view rest_;
  const Unit& expected_;
};

// "kN m", "kg cm^2": a product of other units whose dimensions are those of a kind.
std::optional<Unit> product_of_a_kind(const std::string& symbol) {
  static const auto dimensions = [] {
    std::vector<std::pair<UnitProduct::Powers, Kind>> all;
    for (const Unit& known : known_units())
      if (const auto product = unit_product(known.symbol); product && !known.counts_turns)  // no 1/s of 1/min
        all.emplace_back(product->powers, known.kind);
    return all;
  }();
  const auto product = unit_product(symbol);
  if (!product) return {};
  const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                  [&](const auto& each) { return each.first == product->powers; });
  if (found == dimensions.end()) return {};
  // A couple and a work have one dimension; what is made of watts or joules is a work.
  const bool is_work = found->second == Kind::moment && symbol.find_first_of("WJ") != std::string::npos;
  return Unit{symbol, is_work ? Kind::energy : found->second, product->factor};
}

}  // namespace

Words name_of(Kind kind) {
  switch (kind) {
    case Kind::pure_number:
      return {"a pure number", "un numero puro"};
    case Kind::length:
      return {"a length", "una lunghezza"};
    case Kind::time:
      return {"a time", "un tempo"};
    case Kind::angle:
      return {"an angle", "un angolo"};
    case Kind::angular_velocity:
      return {"an angular velocity", "una velocità angolare"};
    case Kind::angular_acceleration:
      return {"an angular acceleration", "un'accelerazione angolare"};
    case Kind::velocity:
      return {"a velocity", "una velocità"};
    case Kind::acceleration:
      return {"an acceleration", "un'accelerazione"};
    case Kind::force:
      return {"a force", "una forza"};
    case Kind::moment:
      return {"a couple or moment", "una coppia o un momento"};
    case Kind::mass:
      return {"a mass", "una massa"};
    case Kind::moment_of_inertia:
      return {"a moment of inertia", "un momento d'inerzia"};
    case Kind::stress:
      return {"a stress or pressure", "una tensione o pressione"};
    case Kind::area:
      return {"an area", "un'area"};
    case Kind::second_moment_of_area:
      return {"a second moment of area", "un momento d'inerzia di superficie"};
    case Kind::energy:
      return {"an energy", "un'energia"};
    case Kind::power:
      return {"a power", "una potenza"};
    case Kind::viscosity:
      return {"a viscosity", "una viscosità"};
    case Kind::force_per_time:
      return {"a force per time", "una forza per unità di tempo"};
    case Kind::force_per_time_squared:
      return {"a force per time squared", "una forza per unità di tempo al quadrato"};
    case Kind::force_per_time_cubed:
      return {"a force per time cubed", "una forza per unità di tempo al cubo"};
    case Kind::flow:
      return {"a flow", "una portata"};
    case Kind::mass_per_length:
      return {"a force over the square of a speed", "una forza sul quadrato di una velocità"};
  }
  return {};
}

std::string in_plain_characters(std::string text) {
  constexpr std::array<std::pair<std::string_view, char>, 7> printed{{{"\u00A0", ' '},
                                                                      {"\u2007", ' '},
                                                                      {"\u2009", ' '},
                                                                      {"\u200A", ' '},
                                                                      {"\u202F", ' '},
                                                                      {"\u2212", '-'},
                                                                      {"\u2013", '-'}}};
  for (const auto& [character, plain] : printed) replace_all(text, character, std::string_view(&plain, 1));
  return text;
}

bool turns(Kind kind) {
  return kind == Kind::angle || kind == Kind::angular_velocity || kind == Kind::angular_acceleration;
}

const std::vector<Unit>& known_units() {
  static const std::vector<Unit> units = make_units();
  return units;
}

std::optional<Unit> find_unit(const std::string& symbol) {
  const std::string wanted = symbol.empty() ? known_units().front().symbol : spelled_unit(symbol);
  const auto& units = known_units();
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.symbol == wanted; });
  return found == units.end() ? product_of_a_kind(wanted) : std::optional(*found);
}

InUnit read_given(const std::string& text, const std::string& unit_of_the_given) {
  const auto expected = find_unit(unit_of_the_given);
  assert(expected && "the unit of a given must be known");
  return Reader(text, *expected).read();
}

InUnit read_as_typed(const std::string& text, const std::string& unit_of_the_given) {
  const auto expected = find_unit(unit_of_the_given);
  assert(expected && "the unit of a given must be known");
  return Reader(text, *expected).read_as_typed();
}

Rational parse_given(const std::string& text, const std::string& unit_of_the_given) {
  const auto expected = find_unit(unit_of_the_given);
  assert(expected && "the unit of a given must be known");
  Reader reader(text, *expected);
  const InUnit read = reader.read();
  if (read.unit.counts_turns != expected->counts_turns) reader.refuse_pi(read.unit);
  return read.number;
}

Angle angle_of(const InUnit& of) {
  assert(turns(of.unit.kind));
  const Rational value = of.number * of.unit.factor;
  return of.unit.counts_turns ? Angle{value, 0} : Angle{0, value};
}

Rational in_si(const InUnit& of) {
  assert(!of.unit.counts_turns);
  return of.number * of.unit.factor;
}

Rational conversion(const std::string& from, const std::string& to) {
  const auto source = find_unit(from);
  const auto target = find_unit(to);
  assert(source && target && stands_for(source->kind, target->kind) && source->counts_turns == target->counts_turns);
  return source->factor / target->factor;
}

std::string to_text(const Rational& value) {
  std::ostringstream text;
  text << value.numerator();
  if (value.denominator() != 1) text << '/' << value.denominator();
  return text.str();
}

}  // namespace epure::geometry
