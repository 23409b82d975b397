#include "geometry/numbers/bounded.h"

#include "geometry/numbers/deep.h"
#include "geometry/numbers/direction.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/small_fraction.h"
#include "geometry/numbers/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epure::geometry {

namespace {

// Bits beyond the 53 of a double, so that rounding outwards adds one ulp at each end and no more.
constexpr long bits_of_a_value = 80;

// At most 2 ulp wide: what doubles alone give mostly is. What is not takes Deep.
bool is_tight(const Bounded& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return x.sup() <= std::nextafter(std::nextafter(x.inf(), infinity), infinity);
}

Bounded angle(double y, double x) {
  if (const auto found = split_arc_tangent(y, x); found && is_tight(*found)) return *found;
  const Arithmetic<Deep> scope(bits_of_a_value);
  return to_bounded(arc_tangent(Deep::from_double(y), Deep::from_double(x)));
}

Bounded hull(const Bounded& a, const Bounded& b) { return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())}; }

}  // namespace

template <>
Bounded from_rational<Bounded>(const Rational& value) {
  if (const auto small = small_fraction(value)) {
    const Arithmetic<Bounded> rounding;
    return Bounded(small->numerator) / Bounded(small->denominator);
  }
  const auto [lower, upper] = CGAL::to_interval(value);
  return {lower, upper};
}

template <>
Bounded pi<Bounded>() {
  return {2 * right_angle().inf(), 2 * right_angle().sup()};
}

template <>
Bounded cosine<Bounded>(const Turn& turn) {
  if (const auto known = rational_cosine(turn)) return from_rational<Bounded>(*known);
  const Arithmetic<Bounded> rounding;
  if (const auto angle = split_angle(turn))
    if (const Bounded value = direction(*angle).cosine.value(); is_tight(value)) return value;
  const Arithmetic<Deep> scope(bits_of_a_value);
  return to_bounded(cosine<Deep>(turn));
}

template <>
Bounded sine<Bounded>(const Turn& turn) {
  return cosine<Bounded>(turn_for_sine(turn));
}

Bounded arc_tangent(const Bounded& y, const Bounded& x) {
  const Sign side = sign(y);
  const bool on_the_axis = side == Sign::zero && sign(x) == Sign::negative;
  const bool may_reach_the_cut = side == Sign::undecided || side == Sign::zero;
  if (may_reach_the_cut && !on_the_axis && sign(x) != Sign::positive)
    throw Undecided(
        "direction that may be a zero vector or lie on either side of 180 degrees",
        "una direzione che può essere di un vettore nullo o stare da una o dall'altra parte di 180 gradi");
  for (const double end : {y.inf(), y.sup(), x.inf(), x.sup()})
    if (!std::isfinite(end))
      throw Undecided("direction of a vector without bounds", "la direzione di un vettore senza limiti");
  // Along a side of the box one coordinate is constant and the angle is monotone, and inside the angle has no
  // extremum: so the corners bound it.
  const Arithmetic<Bounded> rounding;
  return hull(hull(angle(y.inf(), x.inf()), angle(y.inf(), x.sup())),
              hull(angle(y.sup(), x.inf()), angle(y.sup(), x.sup())));
}

namespace {

// With enough bits for any double as an angle: none comes nearer than 2^-62 to a multiple of a right angle, relative
// to 1, that is no multiple itself (Muller, Elementary Functions, on range reduction).
constexpr long bits_of_an_angle = 160;

// The sine of all angles between two, whose distance need not be small.
Bounded sine_between(const SplitAngle& from, const SplitAngle& to) {
  const Bounded first = direction(from).sine.value(), last = direction(to).sine.value();
  if (to.right_angles - from.right_angles > 4) return Bounded(-1, 1);
  Bounded all = hull(first, last);
  // Between them it is monotone but for the right angles where it is 1 or -1, those that are not proved outside.
  for (long n = from.right_angles; n <= to.right_angles; ++n) {
    const bool is_before = n == from.right_angles && from.left.value().inf() > 0;
    const bool is_after = n == to.right_angles && to.left.value().sup() < 0;
    if (n % 2 == 0 || is_before || is_after) continue;
    all = hull(all, Bounded((n & 3) == 1 ? 1 : -1));
  }
  return all;
}

// The sine of an angle and so many right angles more. None when doubles do not give that of a point tightly: an angle
// that is wide itself does not widen by what is lost there.
std::optional<Bounded> sine_in_doubles(const Bounded& angle, long more) {
  auto from = split_angle(angle.inf()), to = split_angle(angle.sup());
  if (!from || !to) return {};
  from->right_angles += more;
  to->right_angles += more;
  const Bounded value = sine_between(*from, *to);
  if (angle.is_point() && !is_tight(value)) return {};
  return value;
}

template <class Function>
Bounded of_angle(const Bounded& angle, long right_angles_from_sine, const Function& function) {
  if (!std::isfinite(angle.inf()) || !std::isfinite(angle.sup()))
    throw Undecided("an angle without bounds", "un angolo senza limiti");
  const Arithmetic<Bounded> rounding;
  const Bounded value = [&] {
    if (const auto found = sine_in_doubles(angle, right_angles_from_sine)) return *found;
    const Arithmetic<Deep> scope(bits_of_an_angle);
    return to_bounded(function(Deep::from_bounded(angle)));
  }();
  return {std::max(value.inf(), -1.0), std::min(value.sup(), 1.0)};
}

}  // namespace

Bounded cosine_of_angle(const Bounded& angle) {
  return of_angle(angle, 1, [](const Deep& x) { return cosine_of_angle(x); });
}

Bounded sine_of_angle(const Bounded& angle) {
  return of_angle(angle, 0, [](const Deep& x) { return sine_of_angle(x); });
}

}  // namespace epure::geometry
