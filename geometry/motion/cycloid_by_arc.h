// The instant at which the rim point M of a wheel that rolls on a line has travelled a given arc s.
//
// Every arch is 8 r long. What is left of the arc to the top of its arch is twice the chord from M to the highest
// point H of the wheel (Wren, 1658): so M is found on the wheel with the compass opened to that half, about H. The
// triangle P₀MH is right-angled at M (Thales), P₀ being the point of contact.
#pragma once

#include "geometry/motion/rolling.h"

namespace epure::geometry {

// Required (else a caller's mistake): r > 0, s >= 0. Lengths in any unit.
struct CycloidArc {
  Rational r, s;

  // How many whole arches lie behind M.
  Rational arches() const { return whole_turns({s / (Rational(8) * r)}); }
  // Since the last cusp: from 0 to below 8 r.
  Rational since_cusp() const { return s - Rational(8) * r * arches(); }
  bool is_at_cusp() const { return since_cusp() == 0; }
  // HM, negative where M has passed the top of its arch.
  Rational to_top() const { return (Rational(4) * r - since_cusp()) / Rational(2); }
};

// P₀M, the other leg: √(4 r² - HM²), without the cancelling beside a cusp.
template <class T>
T contact_distance(const CycloidArc& arc) {
  const Rational s = arc.since_cusp();
  return root(from_rational<T>(s * (Rational(8) * arc.r - s) / Rational(4)));
}

// φ, the angle the wheel has turned through. Off a cusp Exact throws LeavesTheTower, Generic and Calcium Undecided.
template <class T>
T turned_angle(const CycloidArc& arc) {
  const T whole = radians<T>(Angle{arc.arches()});
  if (arc.is_at_cusp()) return whole;
  if constexpr (std::is_same_v<T, Exact>)
    throw LeavesTheTower("the angle that belongs to an arc", "l'angolo che corrisponde a un arco");
  if constexpr (std::is_same_v<T, Generic> || std::is_same_v<T, Calcium>)
    throw Undecided("the angle that belongs to an arc is no number of turns",
                    "l'angolo che corrisponde a un arco non è un numero di giri");
  if constexpr (NumberWithAngles<T>)
    return whole + T(2) * arc_tangent(contact_distance<T>(arc), from_rational<T>(arc.to_top()));
}

// In axes through the contact; for a constant angular velocity omega, positive when the wheel goes towards +x.
// M is the right angle's corner: P₀M²/2r above the line, and HM P₀M/2r behind the contact.
template <class T>
RollingInstant<T> rolling_instant(const CycloidArc& arc, const T& omega) {
  const Rolling wheel{.how = Rolls::circle_on_line, .r = arc.r, .d = arc.r};
  RollingInstant<T> instant = rolling_instant<T>(wheel, Angle{arc.arches()}, omega, T(0));
  const T P0M = contact_distance<T>(arc), diameter = from_rational<T>(Rational(2) * arc.r);
  instant.by_normal = {-quotient(from_rational<T>(arc.to_top()) * P0M, diameter), quotient(square(P0M), diameter)};
  instant.M = instant.motion.A + from_contact_axes(instant.n, instant.by_normal);
  instant.is_at_cusp = arc.is_at_cusp();
  return instant;
}

}  // namespace epure::geometry
