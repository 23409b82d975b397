// Numbers read off a drawing: how they are typed, and how far from the true value they may lie.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/proof/checked.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/dimension.h"

namespace epure {

// What a millimetre of somebody's own drawing is worth: 1/200 m, of lengths at 1:5.
struct PaperScale {
  Dimension of;
  Rational per_mm;  // SI
  bool operator==(const PaperScale&) const = default;
};

// Who reads what with what.
struct Ruler {
  Rational reading_mm = Rational(1, 2);  // how well lengths are read
  std::string sheet = {};  // the sheet of epure's that was measured; empty, or one that does not show a quantity:
                           // the sheet that shows it at the smallest scale, as nobody says which it was
  std::vector<PaperScale> scales = {};  // of the reader's own drawing, which count before those of epure's
};

struct Allowance {
  Rational size;  // SI
  Words by;       // "0.5 mm on sheet poles"
};

// How far a number for this quantity may lie from the true value.
//
// What is drawn: the reading times the scale. What is calculated from readings, to the first order: of every product
// X·Y, quotient X/Y and X²/Y of drawn quantities and givens that has the quantity's value and dimension, relative
// errors are added (twice that of a square); a given has none. Which way the reader went is not known, so the way
// with the largest error counts, of those whose lines are all at least 20 mm long (where there is none such, the one
// with the smallest). What none of them gives: as calculated from two lines of 100 mm, which is 1 % for half a
// millimetre. An angle, read off two such lines: a hundredth of a radian. Of a zero, which has no parts, what the
// reading is worth in what is drawn of the same kind; so it is never nothing.
Allowance allowance(const CheckedExercise& checked, const CheckedQuantity& quantity, const Ruler& ruler);

// The same of many numbers: what each quantity's allowance is, is found once.
class Allowances {
 public:
  // `checked` must outlive it.
  Allowances(const CheckedExercise& checked, Ruler ruler) : checked_(checked), ruler_(std::move(ruler)) {}

  const Allowance& of(const CheckedQuantity& quantity) {
    const auto known = found_.find(quantity.spec.name);
    if (known != found_.end()) return known->second;
    return found_.emplace(quantity.spec.name, allowance(checked_, quantity, ruler_)).first->second;
  }
  const Ruler& ruler() const { return ruler_; }

 private:
  const CheckedExercise& checked_;
  Ruler ruler_;
  std::map<std::string, Allowance> found_ = {};
};

// The same for this very number: half a unit of its last digit when that is more, and the number has two digits at
// least. ("0" for 0.4 says nothing.) So more digits are never worth less than the reading, nor fewer more than they
// say.
Allowance allowance_of(const Decimal& number, const Allowance& by_reading);

// "5.25", "5,25 m/s"; also "43deg" for a quantity in rad, and "127rpm" in rad/s; of "≈ 5.25" and "5.25 ± 0.05 m/s"
// the value. Throws geometry::BadGiven, also beyond ±1e60.
Decimal read_measured(const std::string& text, const std::string& unit);

// 360, 2π; 0 of what is no direction.
double whole_turn(const Quantity& quantity);
// The same direction as `value`, whole turns away, that is nearest to `to`; of what is no direction the value itself.
double nearest_turn(double value, double to, const Quantity& quantity);

// Whether a direction, told within a turn, has gone over its end from one value to the next: the way there is no
// curve.
bool goes_over_end_of_turn(double from, double to, const Quantity& quantity);

// Whether the number is no further than `size` from the value, or from its magnitude when it is typed without sign;
// a direction by whole turns.
bool is_near(const Decimal& number, double value, const Rational& size, const Quantity& quantity);

}  // namespace epure
