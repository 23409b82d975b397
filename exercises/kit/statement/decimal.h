// A number as it stands in print: its value, and what its last digit is worth.
#pragma once

#include <optional>
#include <string>

#include "geometry/numbers/number.h"

namespace epure {

struct Decimal {
  geometry::Rational value;      // in the unit asked for
  geometry::Rational half_unit;  // half a unit of the last digit; 0 for a fraction, which claims to be exact
  bool signed_text = false;  // the text begins with a sign; without one it may be the magnitude of a signed number
};

// "6.50", "13", "-4.2e3", "250 mm" in the unit asked for (6.50 ± 0.005, 13 ± 0.5). Throws geometry::BadGiven.
// Any unit may be asked for; of one that no given has (geometry/numbers/given.h) others are known as products of
// units (unit_product.h).
Decimal read_decimal(const std::string& text, const std::string& unit);

// As a source prints it, in SI units where it has one: "8.077×10^4 MPa".
Decimal read_printed(std::string text);

// Text minus value; minus the value's magnitude when the text bears no sign.
geometry::Rational excess(const Decimal& number, double value);

// 3.42 as 3.24: a number of two decimals whose last digits were exchanged in print. `value` must be positive.
double with_last_digits_swapped(double value);

// The double nearest to a rational. (CGAL::to_double cuts off instead: 13/25 would come out below 0.52.)
double nearest(const geometry::Rational& value);

// A difference in hundredths of the value's magnitude; none when only the value is zero.
std::optional<double> percent(const geometry::Rational& difference, double of_value);

}  // namespace epure
