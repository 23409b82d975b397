// The follower of an eccentric disc in closed form, by the angle θ of A₀A:
//   y = r sin θ + u,  u² = l² - d²,  d = e - r cos θ
// with the guide along y at x = e, l the sum of the radii of disc and roller, r the eccentricity. A dash is a
// derivative by θ.
//   y'  = r cos θ - d r sin θ/u
//   y'' = -r sin θ - Q/u³,  Q = r²l² sin² θ + r d cos θ (l² - d²)
// Source of the formulas: differentiation of these lines.
//
// y'' is least where y''' = -r cos θ - sin θ B/u⁵ is zero, B a polynomial of cos θ: so
//   r²c²(l² - d²)⁵ = (1 - c²) B²,  c = cos θ,
// a polynomial whose real roots are isolated.
#pragma once

#include "geometry/numbers/accurate.h"
#include "geometry/numbers/polynomial.h"

namespace epure::geometry::analytic {

struct RollerCam {
  Rational r, l, e;  // r > 0, r + |e| < l
};

template <class T>
struct FollowerLift {
  T d, u;       // AB across the guide and along it
  T y, y1, y2;  // y, y', y''
};

template <class T>
FollowerLift<T> follower_lift(const RollerCam& of, const T& c, const T& s) {
  const T r = from_rational<T>(of.r), l = from_rational<T>(of.l);
  FollowerLift<T> at;
  at.d = from_rational<T>(of.e) - r * c;
  const T u2 = (l - at.d) * (l + at.d);
  at.u = root(u2);
  at.y = r * s + at.u;
  at.y1 = r * c - quotient(at.d * r * s, at.u);
  at.y2 = -(r * s) - quotient(square(r * l * s) + r * at.d * c * u2, at.u * u2);
  return at;
}

// Where y'' is least over the whole turn: a cosine among the roots, and on which side of the x axis A lies. For e = 0
// the cam is symmetrical, and the place with cos θ >= 0 is meant.
class LeastFollowerAcceleration {
 public:
  // Throws Undecided when two places cannot be told apart.
  explicit LeastFollowerAcceleration(const RollerCam& of);

  // θ in [0, 2π), and y''. Undecided on exact numbers.
  template <class T>
  T angle() const {
    return on_balls<T>([this] { return angle_now(); });
  }
  template <class T>
  T least() const {
    return on_balls<T>([this] { return least_now(); });
  }

 private:
  struct Place {
    RealRoot cosine;
    bool is_above;  // sin θ >= 0
  };
  Deep sine(const Place& place) const;
  Deep acceleration(const Place& place) const;
  bool is_less(const Place& one, const Place& other) const;
  Deep angle_now() const;
  Deep least_now() const;

  RollerCam of_;
  std::vector<Place> place_;  // one
};

}  // namespace epure::geometry::analytic
