// At which friction the rod of the wedge jams in a collar that holds it at two points.
#pragma once

#include "exercises/kit/linkages/loaded_mechanisms.h"
#include "geometry/constructions/plane.h"
#include "geometry/numbers/deep.h"

namespace epure::friction_efficiency {

inline constexpr Phrase never_jams{"no friction angle jams it", "nessun angolo d'attrito lo fa impuntare"};

// Positive as long as the rod moves at the friction coefficient μ: K, where the collar's forces meet, times μ,
// against the wedge's force. A cubic in μ that is positive without friction.
template <class T>
T room_of_rod(const Wedge& of, const T& mu) {
  using geometry::Point;
  using geometry::Vector;
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta), half_w = number(of.w / 2);
  const geometry::Line<T> upper = line(Point<T>{-half_w, number(of.y_upper)}, Vector<T>{T(1), -mu}),
                          lower = line(Point<T>{half_w, number(of.y_lower)}, Vector<T>{T(-1), -mu});
  const geometry::ProjectivePoint<T> K = meet(upper, lower);
  return geometry::cross(Vector<T>{s + c * mu, c - s * mu}, Vector<T>{K.x, K.y});
}

// Whether the rod jams at one coefficient alone, and moves again beyond it: decided exactly. Throws Undecided.
bool jams_at_one_coefficient(const Wedge& of);

// The least μ at which the rod has no room. Throws Impossible(never_jams); Undecided.
geometry::Deep jamming_coefficient(const Wedge& of);

}  // namespace epure::friction_efficiency
