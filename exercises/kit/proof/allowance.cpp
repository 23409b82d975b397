// What a reading error is worth in what was read, and in what is calculated from it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exercises/kit/proof/measured.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// Shorter lines nobody chooses who can read longer ones.
constexpr double shortest_line_mm = 20;
// What is calculated in a way that epure does not know: from lines of this length.
constexpr int usual_line_mm = 100;
// Who calculates takes a way that tells more than this part of the number, and some ways that have the number's value
// have it by chance. (What is drawn may be as short as it is.)
const Rational roughest_calculated(1, 10);

const OnSheet* sheet_measured(const CheckedQuantity& quantity, const std::string& sheet) {
  const auto named = std::find_if(quantity.on_sheets.begin(), quantity.on_sheets.end(),
                                  [&](const OnSheet& each) { return each.sheet == sheet; });
  if (named != quantity.on_sheets.end()) return &*named;
  const auto coarsest = std::max_element(quantity.on_sheets.begin(), quantity.on_sheets.end(),
                                         [](const OnSheet& a, const OnSheet& b) { return a.per_mm < b.per_mm; });
  return coarsest == quantity.on_sheets.end() ? nullptr : &*coarsest;
}

const PaperScale* own_scale(const CheckedQuantity& quantity, const Ruler& ruler) {
  const auto dimension = dimension_of(quantity.spec.unit);
  const auto found = std::find_if(ruler.scales.begin(), ruler.scales.end(),
                                  [&](const PaperScale& each) { return dimension == each.of; });
  return found == ruler.scales.end() ? nullptr : &*found;
}

Words in_mm(const Rational& reading) { return decimal(fmt::format("{}", nearest(reading))) + " mm"; }

// Of what is measured on paper, with what a millimetre is worth.
struct Drawn {
  Rational per_mm;
  Words where;
};
std::optional<Drawn> drawn(const CheckedQuantity& quantity, const Ruler& ruler) {
  if (const PaperScale* own = own_scale(quantity, ruler))
    return Drawn{own->per_mm, {" at the scale given", " nella scala data"}};
  if (const OnSheet* shown = sheet_measured(quantity, ruler.sheet))
    return Drawn{Rational(shown->per_mm), format_words(" on sheet {}", " sulla tavola {}", shown->sheet)};
  return std::nullopt;
}

// What another quantity may be calculated from. Magnitudes.
struct Operand {
  std::string name;
  Dimension dimension;
  double value = 0, error = 0;  // a given has no error
  double mm = 0;                // how long it is drawn
  bool is_given = false;
};

std::vector<Operand> operands(const CheckedExercise& checked, const Ruler& ruler) {
  std::vector<Operand> all;
  for (const CheckedQuantity& each : checked.quantities) {
    const auto dimension = dimension_of(each.spec.unit);
    if (each.on_sheets.empty() || !dimension || !has_value(each.settled)) continue;
    const double value = std::abs(each.settled.enclosure.value), per_mm = nearest(drawn(each, ruler)->per_mm);
    all.push_back({each.spec.name, *dimension, value, nearest(ruler.reading_mm) * per_mm, value / per_mm});
  }
  for (const GivenSpec& given : checked.givens.specs()) {
    const auto read = checked.givens.reading(given.symbol);
    const auto dimension = dimension_of(given.unit);
    if (!given.choices.empty() || !read || !dimension) continue;
    const double value = geometry::turns(read->unit.kind) ? geometry::to_double(geometry::angle_of(*read))
                                                          : nearest(geometry::in_si(*read));
    all.push_back({given.symbol, *dimension, std::abs(value), 0, shortest_line_mm, true});
  }
  return all;
}

// x·y, x/y or x²/y.
struct Formula {
  enum Kind { product, quotient, square_quotient } kind;
  const Operand *x, *y;

  Dimension dimension() const {
    const Dimension of_x = (kind == square_quotient ? 2 : 1) * x->dimension;
    return kind == product ? of_x + y->dimension : of_x - y->dimension;
  }
  // Each of the three numbers is within a unit in the last place of the true one, and two products are rounded: two
  // numbers that are equal in truth differ here by less than 2^-49 of themselves.
  bool gives(double value) const {
    const double left = kind == product ? value : kind == quotient ? x->value : x->value * x->value;
    const double right = kind == product ? x->value * y->value : value * y->value;
    return std::abs(left - right) <= 0x1p-49 * std::max(left, right);
  }
  // To the first order; `value` is what it gives.
  double error(double value) const {
    if (value == 0) return kind == product ? x->error * y->value + y->error * x->value : x->error / y->value;
    return value * (times_x() * x->error / x->value + y->error / y->value);
  }
  bool is_of_long_lines() const { return x->mm >= shortest_line_mm && y->mm >= shortest_line_mm; }
  // "v_B / P0B, 0.5 mm in each: 2.4 % + 0.65 %"
  Words in_words(const Rational& reading) const {
    const std::string text = kind == product    ? x->name + " · " + y->name
                             : kind == quotient ? x->name + " / " + y->name
                                                : x->name + "² / " + y->name;
    const bool is_one = x->is_given || y->is_given;
    const Words each =
        is_one ? format_words(" in {}", " in {}", (x->is_given ? y : x)->name) : Words{" in each", " in ciascuna"};
    return text + Words{", ", ", "} + in_mm(reading) + each + shares();
  }

 private:
  int times_x() const { return kind == square_quotient ? 2 : 1; }
  Words shares() const {
    Words text;
    for (const auto& [operand, times] : {std::pair{x, times_x()}, {y, 1}})
      if (!operand->is_given && operand->value > 0)
        text = text + (text.empty() ? ": " : " + ") +
               decimal(fmt::format("{:.2g} %", 100 * times * operand->error / operand->value));
    return text;
  }
};

// All that have the quantity's value and dimension. A zero comes of a zero over something only. None where two givens
// tell it: then nothing was read.
std::vector<Formula> formulas_for(double value, const Dimension& dimension, const std::vector<Operand>& all) {
  std::vector<Formula> found;
  for (const Operand& x : all)
    for (const Operand& y : all) {
      if (&x == &y) continue;
      for (const auto kind : {Formula::product, Formula::quotient, Formula::square_quotient}) {
        const Formula formula{kind, &x, &y};
        const bool is_twin = kind == Formula::product && &y < &x;
        const bool is_sense = y.value > 0 && (x.value > 0 || kind == Formula::quotient);
        if (is_twin || !is_sense || formula.dimension() != dimension || !formula.gives(value)) continue;
        if (x.is_given && y.is_given) return {};
        found.push_back(formula);
      }
    }
  return found;
}

std::optional<Allowance> calculated(const CheckedExercise& checked, const CheckedQuantity& quantity,
                                    const Ruler& ruler) {
  const auto dimension = dimension_of(quantity.spec.unit);
  if (!dimension || !has_value(quantity.settled)) return std::nullopt;
  const double value = std::abs(quantity.settled.enclosure.value);
  const std::vector<Operand> all = operands(checked, ruler);
  const std::vector<Formula> formulas = formulas_for(value, *dimension, all);
  if (formulas.empty()) return std::nullopt;
  const Formula& chosen =
      *std::max_element(formulas.rbegin(), formulas.rend(), [&](const Formula& a, const Formula& b) {
        if (a.is_of_long_lines() != b.is_of_long_lines()) return b.is_of_long_lines();
        return a.is_of_long_lines() ? a.error(value) < b.error(value) : b.error(value) < a.error(value);
      });
  return Allowance{Rational(chosen.error(value)), chosen.in_words(ruler.reading_mm)};
}

bool is_angle(const std::string& unit) {
  const auto known = geometry::find_unit(unit);
  return known && known->kind == geometry::Kind::angle;
}

// As calculated from two usual lines.
Allowance usual(const CheckedQuantity& quantity, const Rational& reading) {
  const Rational relative = 2 * reading / usual_line_mm;
  const Words lines = in_mm(reading) + format_words(" in each of two lines of {} mm",
                                                    " in ciascuno di due segmenti di {} mm", usual_line_mm);
  if (is_angle(quantity.spec.unit)) {
    const geometry::Unit unit = *geometry::find_unit(quantity.spec.unit);
    static const Rational radian_in_turns = geometry::parse_given("0.15915494309189533576888376337251436203", "1");
    return {unit.counts_turns ? relative * radian_in_turns / unit.factor : relative / unit.factor, lines};
  }
  const Rational value = has_value(quantity.settled) ? Rational(quantity.settled.enclosure.value) : Rational(0);
  return {relative * CGAL::abs(value), lines};
}

// Angles in degrees are directions, which are read off as they are; in radians they are slopes, which are calculated.
Allowance no_rougher(const Allowance& found, const CheckedQuantity& quantity) {
  if (!has_value(quantity.settled) || quantity.spec.unit == "deg") return found;
  const Rational most = roughest_calculated * CGAL::abs(Rational(quantity.settled.enclosure.value));
  if (most == 0 || found.size <= most) return found;
  return {most, {"a tenth of what is calculated", "un decimo di ciò che si calcola"}};
}

// Of nothing no part is anything. What the reading is worth in what is drawn of the same kind; else in a product or
// quotient of two lines that is of the kind, whose value says nothing here, as the quantity is zero; the roughest
// counts.
Allowance of_zero(const CheckedExercise& checked, const CheckedQuantity& quantity, const Ruler& ruler) {
  const auto dimension = dimension_of(quantity.spec.unit);
  const std::vector<Operand> all = operands(checked, ruler);
  const Words reading = in_mm(ruler.reading_mm);
  const auto drawn_like_it = [&](const Operand& each) { return !each.is_given && dimension == each.dimension; };
  const Operand* like_it = nullptr;
  for (const Operand& each : all)
    if (drawn_like_it(each) && (!like_it || each.error > like_it->error)) like_it = &each;
  if (like_it) return {Rational(like_it->error), reading + format_words(" in {}", " in {}", like_it->name)};
  Allowance found{Rational(0), {}};
  for (const Operand& x : all)
    for (const Operand& y : all) {
      if (&x == &y || x.is_given || x.mm < shortest_line_mm || y.mm < shortest_line_mm || !(y.value > 0)) continue;
      for (const auto kind : {Formula::quotient, Formula::product}) {
        const double error = kind == Formula::quotient ? x.error / y.value : x.error * y.value;
        if (dimension != Formula{kind, &x, &y}.dimension() || Rational(error) <= found.size) continue;
        found = {Rational(error), reading + format_words(" in {}, {} {}", " in {}, {} {}", x.name,
                                                         kind == Formula::quotient ? "/" : "·", y.name)};
      }
    }
  if (found.size > 0) return found;
  const Rational hundredth = 2 * ruler.reading_mm / usual_line_mm;
  return {hundredth, format_words("{} of the unit, as it is zero", "{} dell'unità, perché è nulla",
                                  decimal(fmt::format("{}", nearest(hundredth))))};
}

}  // namespace

Allowance allowance(const CheckedExercise& checked, const CheckedQuantity& quantity, const Ruler& ruler) {
  if (const auto line = drawn(quantity, ruler))
    return {ruler.reading_mm * line->per_mm, in_mm(ruler.reading_mm) + line->where};
  if (!is_angle(quantity.spec.unit))
    if (const auto from_readings = calculated(checked, quantity, ruler); from_readings && from_readings->size > 0)
      return no_rougher(*from_readings, quantity);
  const Allowance by_lines = usual(quantity, ruler.reading_mm);
  return by_lines.size > 0 ? no_rougher(by_lines, quantity) : of_zero(checked, quantity, ruler);
}

Allowance allowance_of(const Decimal& number, const Allowance& by_reading) {
  const bool has_two_digits = CGAL::abs(number.value) >= 20 * number.half_unit;
  if (!has_two_digits || number.half_unit <= by_reading.size) return by_reading;
  return {number.half_unit, {"half a unit of its last digit", "mezza unità dell'ultima cifra"}};
}

}  // namespace epure
