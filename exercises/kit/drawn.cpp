#include "exercises/kit/drawn.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/enclosure.h"

namespace epure {

using geometry::Deep;
using geometry::Sign;

namespace {

bool is_nonzero(const Deep& x) {
  const Sign s = geometry::sign(x);
  return s == Sign::positive || s == Sign::negative;
}

// Drawings are made of true values rounded to so many binary digits, however they are found. The longest side of a
// sheet has 2^18.3 parts of 1/256 pt, and the last digit is at most 2^-34.5 of a number: so rounding moves a place by
// 2^-17 of a part where coordinates are no larger than the sheet, and by half a part where they are 2^16 times as
// large.
constexpr int digits_of_a_drawing = 40;

// Among greater ones, what is so much smaller is rounded as these are: to no digit of its own where doubles, of
// 53 digits, may know none.
constexpr double least_part = 0x1p-12;

// Doubles around a true value; both are the nearest to it where bits found it.
struct Ends {
  double lower, upper;
  double least() const { return std::max({lower, -upper, 0.0}); }
  double most() const { return std::max(-lower, upper); }
};

Ends ends_of(const Deep& x) {
  if (x.is_interval()) return {x.interval().inf(), x.interval().sup()};
  const geometry::Enclosure found = geometry::enclosure(x);
  const double value = found.lower <= 0 && found.upper >= 0 ? 0 : found.value;
  return {value, value};
}

// What a function that grows, or stays, makes of the true value's nearest double: that of both ends, where they
// agree.
template <class Function>
auto of_both(double lower, double upper, const Function& function) {
  const auto first = function(lower);
  if (first != function(upper)) throw geometry::TooCoarse{};
  return first;
}

// The power of two that is the last digit of numbers of this size. It is the next one's from somewhere below a power
// of two on, where no number of few digits lies, as powers of two do: doubles that are not sure of the size climb.
int last_digit(double size) {
  int exponent = 0;
  const double part = std::frexp(size, &exponent);
  return (part < 0.73 ? exponent : exponent + 1) - digits_of_a_drawing;
}

// The first of two coordinates of one point.
double one_of(const Ends& x, const Ends& y, double beside) {
  const double least = std::max({x.least(), y.least(), least_part * beside});
  const double most = std::max({x.most(), y.most(), least_part * beside});
  if (most == 0) return 0;
  const int digit = of_both(least, most, last_digit);
  const double units = of_both(x.lower, x.upper, [&](double end) { return std::round(std::scalbn(end, -digit)); });
  return units == 0 ? 0 : std::scalbn(units, digit);
}

std::pair<double, double> both_of(const Deep& x, const Deep& y, double beside) {
  const Ends of_x = ends_of(x), of_y = ends_of(y);
  return {one_of(of_x, of_y, beside), one_of(of_y, of_x, beside)};
}

}  // namespace

double to_double(const Deep& x) { return one_of(ends_of(x), {0, 0}, 0); }
Place to_double(const geometry::Point<Deep>& P, double beside) {
  const auto [x, y] = both_of(P.x, P.y, beside);
  return {x, y};
}
Arrow2 to_double(const geometry::Vector<Deep>& v) {
  const auto [x, y] = both_of(v.x, v.y, 0);
  return {x, y};
}

std::optional<Place> to_double(const geometry::ProjectivePoint<Deep>& P, double beside) {
  if (!is_nonzero(P.w)) return {};
  return to_double(geometry::finite(P), beside);
}

DrawnCycle to_double(const geometry::Cycle<Deep>& cycle) {
  const geometry::Point<Deep> origin{Deep(0), Deep(0)};
  if (is_nonzero(cycle.k)) {
    const geometry::Point<Deep> centre = geometry::finite(cycle.centre());
    const Deep radius = cycle.radius(), distance = geometry::distance(origin, centre);
    DrawnCycle circle{.centre = to_double(centre), .radius = to_double(radius)};
    if (is_nonzero(distance)) {
      const geometry::Vector<Deep> to_centre = centre - origin;
      circle.on_line = to_double(origin + geometry::quotient(distance - radius, distance) * to_centre, circle.radius);
      circle.along = to_double(geometry::quotient(Deep(1), distance) * geometry::quarter_turn(to_centre));
    }
    return circle;
  }
  if (!is_nonzero(geometry::square(cycle.l) + geometry::square(cycle.m))) return {};
  const auto line = cycle.straight();
  return {.on_line = to_double(geometry::foot(origin, line)), .along = to_double(line.direction())};
}

}  // namespace epure
