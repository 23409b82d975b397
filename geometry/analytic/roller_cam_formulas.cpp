#include "geometry/analytic/roller_cam_formulas.h"

namespace epure::geometry::analytic {
namespace {

// y''' = -r c - s B/u⁵.
template <class T>
T part_with_sine(const RollerCam& of, const T& c) {
  const T r = from_rational<T>(of.r), l2 = from_rational<T>(Rational(of.l * of.l)),
          d = from_rational<T>(of.e) - r * c;
  const T u2 = l2 - d * d, r2 = r * r;
  const T Q = r2 * l2 * (T(1) - c * c) + r * d * c * u2;
  const T slope = T(2) * r2 * l2 * c + r * (r * c - d) * u2 - T(2) * r2 * d * d * c;
  return slope * u2 + T(3) * Q * d * r;
}

Polynomial stationary(const RollerCam& of) {
  const Polynomial c = Polynomial::indeterminate(), r = from_rational<Polynomial>(of.r);
  const Polynomial d = from_rational<Polynomial>(of.e) - r * c,
                   u2 = from_rational<Polynomial>(Rational(of.l * of.l)) - d * d;
  const Polynomial B = part_with_sine<Polynomial>(of, c);
  return r * r * c * c * u2 * u2 * u2 * u2 * u2 - (Polynomial(1) - c * c) * B * B;
}

}  // namespace

LeastFollowerAcceleration::LeastFollowerAcceleration(const RollerCam& of) : of_(of) {
  const auto consider = [&](const Place& place) {
    if (place_.empty() || is_less(place, place_.front())) place_.assign(1, place);
  };
  const auto beyond = [](const auto& x) { return x * x - std::decay_t<decltype(x)>(1); };
  for (const RealRoot& c : stationary(of).real_roots()) {
    if (c.sign_of(beyond) != Sign::negative) continue;
    const Sign of_c = c.sign_of([](const auto& x) { return x; });
    if (of.e == 0 && of_c == Sign::negative) continue;
    const Sign of_B = c.sign_of([&](const auto& x) { return part_with_sine<std::decay_t<decltype(x)>>(of, x); });
    // s B = -r c u⁵; where both sides are zero for any s, A is above or below.
    if (of_c == Sign::zero || of_c != of_B) consider({c, true});
    if (of_c == Sign::zero || of_c == of_B) consider({c, false});
  }
  if (place_.empty()) throw Undecided("where the follower is accelerated least", "dove l'accelerazione è minima");
}

Deep LeastFollowerAcceleration::sine(const Place& place) const {
  const Deep c = place.cosine.value(), s = root((Deep(1) - c) * (Deep(1) + c));
  return place.is_above ? s : -s;
}

Deep LeastFollowerAcceleration::acceleration(const Place& place) const {
  return follower_lift<Deep>(of_, place.cosine.value(), sine(place)).y2;
}

bool LeastFollowerAcceleration::is_less(const Place& one, const Place& other) const {
  for (long bits = 128; bits <= 4096; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    const Sign difference = sign(acceleration(one) - acceleration(other));
    if (difference != Sign::undecided) return difference == Sign::negative;
  }
  throw Undecided("which of two places has the least acceleration",
                  "quale di due posizioni abbia l'accelerazione minima");
}

Deep LeastFollowerAcceleration::angle_now() const {
  const Place& place = place_.front();
  const Deep angle = arc_tangent(sine(place), place.cosine.value());
  return place.is_above ? angle : Deep(2) * pi<Deep>() + angle;
}

Deep LeastFollowerAcceleration::least_now() const { return acceleration(place_.front()); }

}  // namespace epure::geometry::analytic
