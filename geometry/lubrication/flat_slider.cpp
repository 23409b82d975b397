#include "geometry/lubrication/flat_slider.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/growing.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::geometry {

// n - 1 is sought, as the centre is beyond the middle by about a tenth of it where it is small; where n is large
//   (x_N - l/2)/l ≈ 1/2 - 1/(2 ln n - 4).
template <>
Deep ratio_of_films<Deep>(const Rational& centre) {
  const Rational beyond = centre - Rational(1, 2);
  const double smallest = std::log2(5 * CGAL::to_double(beyond)),
               largest = (4 + 1 / CGAL::to_double(Rational(1) - centre)) / std::log(2.0);
  const long bits = Arithmetic<Deep>::bits(), below_one = static_cast<long>(std::max(0.0, -smallest));
  const Arithmetic<Deep> more(bits + 16 + 2 * below_one);
  const Deep sought = from_rational<Deep>(beyond);
  return Deep(1) + increasing_root(
                       [&](const Deep& n_less_one) {
                         return FlatSlider<Deep>{Deep(1) + n_less_one}.centre_beyond_middle() - sought;
                       },
                       smallest, std::max(largest, smallest + 8));
}

template <>
Bounded ratio_of_films<Bounded>(const Rational& centre) {
  return in_doubles([&] { return ratio_of_films<Deep>(centre); });
}

template <>
Fast ratio_of_films<Fast>(const Rational& centre) {
  const Arithmetic<Deep> scope(64);
  return enclosure(ratio_of_films<Deep>(centre)).value;
}

}  // namespace epure::geometry
