// The standard scales of a sheet: ISO 5455 for lengths, 1, 2, 2.5 and 5 times a power of ten for vectors.
#pragma once

#include <string>

#include "drawings/picture.h"
#include "exercises/kit/statement/format_words.h"
#include "geometry/numbers/number.h"

namespace epure {

using geometry::Rational;

struct Scale {
  double mm_per_unit = 1;  // of paper, for one metre, metre per second, ...
  std::string caption;     // "1 : 5", "1 cm ≙ 2.5 m/s"
  std::string unit;
};

// 1 : 5 for lengths in metres. `ratio` is paper over nature.
Scale length_scale(const Rational& ratio);

// The largest standard scale of lengths that is not larger than `mm_per_metre`.
Scale largest_length_scale(double mm_per_metre);

// The largest standard scale at which one `unit` takes at most `mm_per_unit`.
Scale largest_vector_scale(double mm_per_unit, const std::string& unit, Language language);

// A scale of lengths, its bar in millimetres.
Scale in_millimetres(Scale scale);

// As few figures as the number has, at most six: 2.5, 30, 0.2.
std::string short_number(double x, Language language);

// The scale as a graduated bar of about 40 mm, its caption above, its left end at `at`.
drawings::ScaleBar bar(const Scale& scale, drawings::Point at, Language language);

}  // namespace epure
