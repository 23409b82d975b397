// The paths of points carried by a rolling circle or line, as curves over φ in radians (span.h).
#pragma once

#include "geometry/curves/span.h"
#include "geometry/motion/rolling.h"

namespace epure::geometry {

struct Roulette {
  Rolling rolling;

  template <class X>
  Point<X> operator()(const X& phi) const {
    return tracing_point<X>(rolling, Radians<X>{phi});
  }
};

// The same path from one instant on, over the angle turned since (radians), about the contact of that instant:
// however many turns went before, and however far the fixed circle's centre is, no digits are lost to them. T: the
// number that what is known of the instant is held in, Fast or Bounded.
template <class T>
class RouletteSince {
 public:
  RouletteSince(const Rolling& rolling, const Angle& phi) : rolling_(rolling) {
    const Arithmetic<Deep> bits(256);  // 1e12 radians, and as many times the size of the other circle: 120 of them
    turned_ = held(radians<Deep>(phi));
    normal_ = held(common_normal<Deep>(rolling, phi));
    const Angle half = half_rolled_angle(rolling, phi);
    half_ = held(Vector<Deep>{cosine<Deep>(half), sine<Deep>(half)});
  }

  template <class X>
  Point<X> operator()(const X& since) const {
    const X half_gone = from_rational<X>(gone_around_per_turned(rolling_) / 2) * since;
    const Vector<X> half_way = turned(normal_, half_gone), normal = turned(half_way, half_gone);
    const Point<X> here{X(0), X(0)};
    return here + contact_gone(half_way, half_gone, since) + from_contact_axes(normal, contact_to_point(since));
  }

 private:
  static T held(const Deep& x) {
    if constexpr (std::is_same_v<T, Bounded>) return to_bounded(x);
    if constexpr (std::is_same_v<T, Fast>) return enclosure(x).value;
  }
  static Vector<T> held(const Vector<Deep>& v) { return {held(v.x), held(v.y)}; }

  template <class X, class U>
  static Vector<X> turned(const Vector<U>& v, const X& angle) {
    const Vector<X> known{X(v.x), X(v.y)};
    return cosine_of_angle(angle) * known + sine_of_angle(angle) * quarter_turn(known);
  }

  // Along the line, or the chord of the fixed circle, which is square to the normal half-way.
  template <class X>
  Vector<X> contact_gone(const Vector<X>& half_way, const X& half_gone, const X& since) const {
    if (rolling_.how == Rolls::circle_on_line) return {from_rational<X>(rolling_.r) * since, X(0)};
    const Rational towards_normal = rolling_.how == Rolls::circle_inside_circle ? -2 : 2;
    return (from_rational<X>(towards_normal * rolling_.R) * sine_of_angle(half_gone)) * quarter_turn(half_way);
  }

  template <class X>
  Vector<X> contact_to_point(const X& since) const {
    if (rolling_.how == Rolls::line_on_circle) return line_contact_to_point<X>(rolling_, X(turned_) + since);
    return circle_contact_to_point<X>(rolling_, turned(half_, half_rolled_angle(rolling_, Radians<X>{since}).value));
  }

  Rolling rolling_;
  T turned_;
  Vector<T> normal_, half_;
};

}  // namespace epure::geometry
