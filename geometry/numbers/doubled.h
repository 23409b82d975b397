// An enclosure with twice the digits of a double: a double and an interval of doubles around what it lacks.
//
// All its functions need an Arithmetic<Bounded>, and throw Undecided for what Bounded would: a sign that is not
// certain where one is needed, a result without bounds.
#pragma once

#include "geometry/numbers/number.h"

#include <optional>

namespace epure::geometry {

class Doubled {
 public:
  Doubled(double value = 0) : near_(value), rest_(0) {}
  explicit Doubled(const Bounded& value) : Doubled(0, value) {}
  // The sum of both. Throws Undecided when it is not bounded.
  Doubled(double part, const Bounded& rest);

  // A double in or next to it.
  double near() const { return near_; }
  // The interval around all of it.
  Bounded value() const { return Bounded(near_) + rest_; }

  // The double nearest to the true value, if it is certain (ties to even).
  std::optional<double> certain_double() const;
  // The doubles on either side of the true value, or twice the one that is the value, if they are certain.
  std::optional<Bounded> certain_bounds() const;

  Doubled operator-() const;
  friend Doubled operator+(const Doubled& a, const Doubled& b);
  friend Doubled operator-(const Doubled& a, const Doubled& b) { return a + -b; }
  friend Doubled operator*(const Doubled& a, const Doubled& b);
  friend Doubled operator/(const Doubled& a, const Doubled& b);
  friend Doubled square(const Doubled& x);
  friend Doubled root(const Doubled& x);

 private:
  Bounded roomy_rest() const;

  double near_;
  Bounded rest_;
};

Sign sign(const Doubled& x);
Doubled widened(const Doubled& x, const Doubled& by);

Doubled doubled(const Rational& value);
Doubled doubled_pi();
Doubled doubled_cosine(const Turn& turn);
Doubled doubled_sine(const Turn& turn);
Doubled cosine_of_angle(const Doubled& angle);
Doubled sine_of_angle(const Doubled& angle);
// In (-π, π].
Doubled arc_tangent(const Doubled& y, const Doubled& x);

}  // namespace epure::geometry
