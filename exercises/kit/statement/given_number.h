// A given's number as a sheet writes it.
#pragma once

#include <optional>
#include <string>

#include "exercises/kit/statement/format_words.h"
#include "geometry/numbers/angle.h"
#include "geometry/numbers/number.h"

namespace epure {

// "0.25", "-12": with a decimal point; none when that would take more than so many decimals.
std::optional<std::string> as_decimal(const geometry::Rational& value, std::size_t most_decimals);

// "= 0.25", "= −1/72": as a decimal or else as a fraction, where one is short; "≈ 0.4123456789" where none is. The
// blanks do not break.
std::string equal_to(const geometry::Rational& value, Language language);

// In a sentence: "0.0029000001" exactly, where a decimal of at most 24 characters is (what people write has 20 digits
// at most); else rounded.
Words told_value(const geometry::Rational& value, int figures = 12);
// An angle in degrees, so too.
Words told_degrees(const geometry::Angle& angle, int figures = 12);

// How many figures, six at least, tell two numbers apart, so that a sentence says which is the greater; none where
// the fifteen that a double holds do not.
std::optional<int> figures_that_tell_apart(double one, double other);

}  // namespace epure
