#include "geometry/numbers/bounded.h"

#include "geometry/numbers/deep.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/turn.h"

#include <algorithm>
#include <cmath>

namespace epure::geometry {

namespace {

// Bits beyond the 53 of a double, so that rounding outwards adds one ulp at each end and no more.
constexpr long bits_of_a_value = 80;

Bounded angle(double y, double x) { return to_bounded(arc_tangent(Deep::from_double(y), Deep::from_double(x))); }

Bounded hull(const Bounded& a, const Bounded& b) { return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())}; }

}  // namespace

template <>
Bounded from_rational<Bounded>(const Rational& value) {
  const auto [lower, upper] = CGAL::to_interval(value);
  return {lower, upper};
}

template <>
Bounded pi<Bounded>() {
  static const Bounded value = [] {
    const Arithmetic<Deep> scope(bits_of_a_value);
    return to_bounded(pi<Deep>());
  }();
  return value;
}

template <>
Bounded cosine<Bounded>(const Turn& turn) {
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
  const Arithmetic<Deep> scope(bits_of_a_value);
  return hull(hull(angle(y.inf(), x.inf()), angle(y.inf(), x.sup())),
              hull(angle(y.sup(), x.inf()), angle(y.sup(), x.sup())));
}

namespace {

// With enough bits for any double as an angle: none comes nearer than 2^-62 to a multiple of a right angle, relative
// to 1, that is no multiple itself (Muller, Elementary Functions, on range reduction).
constexpr long bits_of_an_angle = 160;

template <class Function>
Bounded of_angle(const Bounded& angle, const Function& function) {
  if (!std::isfinite(angle.inf()) || !std::isfinite(angle.sup()))
    throw Undecided("an angle without bounds", "un angolo senza limiti");
  const Arithmetic<Deep> scope(bits_of_an_angle);
  const Bounded value = to_bounded(function(Deep::from_bounded(angle)));
  return {std::max(value.inf(), -1.0), std::min(value.sup(), 1.0)};
}

}  // namespace

Bounded cosine_of_angle(const Bounded& angle) {
  return of_angle(angle, [](const Deep& x) { return cosine_of_angle(x); });
}

Bounded sine_of_angle(const Bounded& angle) {
  return of_angle(angle, [](const Deep& x) { return sine_of_angle(x); });
}

}  // namespace epure::geometry
