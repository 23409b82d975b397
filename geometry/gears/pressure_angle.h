// A pressure angle by its tangent, cosine and sine: so it stays exact where they are.
#pragma once

#include "geometry/gears/involute.h"
#include "geometry/gears/pair_data.h"

namespace epure::geometry {

template <class T>
struct PressureAngle {
  T tangent, cosine, sine;
};

template <class T>
PressureAngle<T> pressure_angle(const Angle& angle) {
  const T c = cosine<T>(angle), s = sine<T>(angle);
  return {quotient(s, c), c, s};
}

// Between 0 and 90 degrees, from its tangent >= 0.
template <class T>
PressureAngle<T> pressure_angle_of_tangent(const T& tangent) {
  const T c = quotient(T(1), root(T(1) + square(tangent)));
  return {tangent, c, tangent * c};
}

// Of the point of an involute at the radius r >= r_b: its tangent is the length of the tangent to the base circle,
// over r_b. Throws Impossible when r < r_b: the involute begins at the base circle.
template <class T>
PressureAngle<T> pressure_angle_at(const T& r, const T& r_b) {
  const T squared = (r - r_b) * (r + r_b);
  const Sign beyond = sign(squared);
  if (beyond == Sign::undecided)
    throw Undecided("whether a circle reaches the base circle", "se una circonferenza raggiunga quella di base");
  if (beyond == Sign::negative)
    throw Impossible("the circle lies inside the base circle, where no involute is",
                     "la circonferenza sta dentro quella di base, dove non c'è evolvente");
  return {quotient(root(squared), r_b), quotient(r_b, r), quotient(root(squared), r)};
}

// α_w, with   inv α_w = inv α + 2 tan α · shift_per_tooth.   Throws Impossible as gear_pair.
template <class T>
PressureAngle<T> working_pressure_angle(const PressureAngle<T>& alpha, const Rational& shift_per_tooth) {
  if (shift_per_tooth == 0) return alpha;
  const T involute_w = involute(alpha.tangent) + from_rational<T>(2 * shift_per_tooth) * alpha.tangent;
  switch (sign(involute_w)) {
    case Sign::undecided:
      throw Undecided("whether the wheels have a working pressure angle",
                      "se le ruote abbiano un angolo di pressione di lavoro");
    case Sign::negative:
      throw Impossible(
          "the wheels cannot mesh: for these profile shifts no working pressure angle exists",
          "le ruote non possono ingranare: con queste correzioni non esiste alcun angolo di pressione di lavoro");
    default:
      return pressure_angle_of_tangent(tangent_of_involute(involute_w));
  }
}

}  // namespace epure::geometry
