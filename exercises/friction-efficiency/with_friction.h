// What all mechanisms with friction share: the forces of the contacts turned by the friction angle against the
// sliding of the body they act on, in the direct and in the retrograde motion. Twice: by force polygons with the
// sliding of the velocity diagram, and by the equations of equilibrium with the sliding that the joints' equations
// give.
#pragma once

#include <functional>
#include <set>

#include "exercises/friction-efficiency/motion.h"
#include "exercises/friction-efficiency/problem.h"
#include "exercises/friction-efficiency/rod_in_collar.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/loaded_routes.h"
#include "exercises/kit/statement/forces.h"
#include "geometry/numbers/accurate.h"

namespace epure::friction_efficiency {

using namespace loaded;

inline constexpr Phrase no_sliding{"the bodies do not slide on each other",
                                   "i corpi non strisciano l'uno sull'altro"};
inline constexpr Phrase never_locks{"no friction angle locks it", "nessun angolo d'attrito lo rende irreversibile"};
inline constexpr Phrase no_effort{"there is no effort to compare with", "non c'è uno sforzo con cui confrontare"};
inline constexpr Phrase parallel_collar{"it is at infinity: without friction the collar's forces are parallel",
                                        "è all'infinito: senza attrito le forze del collare sono parallele"};

// +1 or -1.
template <class T>
int sense_of(const T& along) {
  const geometry::Sign sign = geometry::sign(along);
  if (sign == geometry::Sign::undecided) throw geometry::Undecided(Words{"whether ", "se "} + Words(no_sliding));
  if (sign == geometry::Sign::zero) throw geometry::Impossible(no_sliding);
  return sign == geometry::Sign::positive ? 1 : -1;
}

// The direction of a contact's force, turned from its normal against the sliding of the body it acts on, which is
// that of the direct motion.
struct Turned {
  Angle phi;
  Motion motion;

  int sense() const { return motion == Motion::ideal ? 0 : motion == Motion::direct ? 1 : -1; }
  // To the left of n, +1; to the right, -1; 0 without friction.
  template <class T>
  int side(const Vector<T>& n, const Vector<T>& sliding) const {
    if (motion == Motion::ideal || is_zero(phi)) return 0;
    return -sense() * sense_of<T>(geometry::dot(sliding, geometry::quarter_turn(n)));
  }
  template <class T>
  XY<T> components(const Vector<T>& n, const Vector<T>& sliding) const {
    const int turn = side(n, sliding);
    if (turn == 0) return xy(n);
    return xy(geometry::cosine<T>(phi) * n + T(turn) * (geometry::sine<T>(phi) * geometry::quarter_turn(n)));
  }
  // The angle of these components, where that of n is known.
  template <class T>
  Angle direction(const Angle& of_n, const Vector<T>& n, const Vector<T>& sliding) const {
    return of_n + Rational(side(n, sliding)) * phi;
  }
  // The same of a normal known by its angle.
  template <class T>
  Angle angle(const Angle& n, const Complex<T>& sliding) const {
    if (motion == Motion::ideal || is_zero(phi)) return n;
    const Complex<T> left{-geometry::sine<T>(n), geometry::cosine<T>(n)};
    return n - Rational(sense() * sense_of<T>(analytic::dot(sliding, left))) * phi;
  }
};

inline Angle quarter() { return {Rational(1, 4)}; }
inline Angle half() { return {Rational(1, 2)}; }

// A mechanism in its three motions, by both routes.
template <class T>
struct Motions {
  std::map<Motion, std::function<const geometry::FreeBodies<T>&()>> bodies;
  std::map<Motion, std::function<const Equations<T>&()>> equations;
};
template <class T, class Constructed, class Analysed>
Motions<T> in_all_motions(int bodies, const std::string& driven, const Angle& phi, const Constructed& constructed,
                          const Analysed& analysed) {
  Motions<T> all;
  const auto ideal = solved_equations<T>(bodies, driven, [=](auto& model) {
    analysed(model, Turned{phi, Motion::ideal}, nullptr);
  });
  for (const Motion motion : motions) {
    const Turned turned{phi, motion};
    all.bodies[motion] = solved_bodies<T>(bodies, [=](auto& model) { constructed(model, turned); });
    if (motion == Motion::ideal)
      all.equations[motion] = ideal;
    else
      all.equations[motion] =
          solved_equations<T>(bodies, driven, [=](auto& model) { analysed(model, turned, &ideal()); });
  }
  return all;
}

// What moves in the direct motion, by the equations; nothing of the ideal mechanism, whose forces need no sliding.
template <class T>
Complex<T> velocity_of(const Equations<T>* ideal, int body, const Complex<T>& P) {
  return ideal ? analytic::velocity_at<T>(ideal->velocities.at(body), P) : Complex<T>{T(0), T(0)};
}

// The effort, efficiencies and forces of all motions.
struct Names {
  VectorQuantity effort;  // "P", or "M" for its name and letters
  bool is_couple = false;
};
inline Quantity effort(const Names& names, Motion motion) {
  const Quantity plain{names.effort.name, "$\\it{" + names.effort.name + "}$", names.is_couple ? "N*m" : "N",
                       names.is_couple
                           ? Words{"couple on the crank", "coppia sulla manovella"}
                           : Words{"driving force, along its direction", "forza motrice, lungo la sua direzione"}};
  if (motion == Motion::ideal)
    return {plain.name + "_i", "$\\it{" + names.effort.name + "}_{i}$", plain.unit,
            plain.meaning + Words{", ideal", ", ideale"}};
  return in(motion, plain);
}
inline Quantity efficiency(Motion motion) {
  return {"eta" + suffix(motion), motion == Motion::direct ? "$η_{D}$" : "$η_{R}$", "1",
          Words{"efficiency", "rendimento"} + words_of(motion)};
}
inline Quantity self_locking() {
  return {"self_locking", "SL", "1", {"self-locking: 1 yes, 0 no", "irreversibile: 1 sì, 0 no"}};
}
inline Quantity self_locking_angle() {
  return {"self_locking_friction_angle_deg",
          "$φ_{R}$",
          "deg",
          {"friction angle from which it locks", "angolo d'attrito dal quale è irreversibile"}};
}
inline Quantity jamming_angle() {
  return {"jamming_friction_angle_deg",
          "$φ_{D}$",
          "deg",
          {"friction angle at which it jams", "angolo d'attrito al quale s'impunta"}};
}

// P, or M, in all motions by one route; `find(motion)` gives it.
template <class T, class Find>
void put_efforts(Ledger<T>& ledger, const Names& names, const Find& find) {
  for (const Motion motion : motions) ledger.put(effort(names, motion), [&] { return find(motion); });
  ledger.put(efficiency(Motion::direct),
             [&] { return Ledger<T>::ratio(find(Motion::ideal), find(Motion::direct), no_effort); });
  ledger.put(efficiency(Motion::retrograde),
             [&] { return Ledger<T>::ratio(find(Motion::retrograde), find(Motion::ideal), no_effort); });
}
template <class T>
T locks(const T& effort) {
  const geometry::Sign sign = geometry::sign(effort);
  if (sign == geometry::Sign::undecided)
    throw geometry::Undecided("whether it is self-locking", "se sia irreversibile");
  return sign == geometry::Sign::positive ? T(0) : T(1);
}

// Exactly at the limit of self-locking P is zero.
inline std::set<Motion> without_effort(bool is_at_limit) {
  return is_at_limit ? std::set{Motion::retrograde} : std::set<Motion>{};
}

// `without`: the motions in which the effort is known to be zero.
template <class T>
void write_motions(Ledger<T>& ledger, const Names& names, const Motions<T>& all, const XY<T>& along,
                   const std::vector<VectorQuantity>& forces, const std::set<Motion>& without = {}) {
  const std::string name = names.effort.name;
  const bool is_couple = names.is_couple;
  const auto constructed = [&](Motion motion) -> T {
    if (without.contains(motion)) return T(0);
    const auto& model = all.bodies.at(motion)();
    return is_couple ? model.moment(name) : model.along(name);
  };
  const auto computed = [&](Motion motion) -> T {
    if (without.contains(motion)) return T(0);
    const Equations<T>& equations = all.equations.at(motion)();
    return is_couple ? equations.forces.at(name).m
                     : analytic::dot(complex(along), complex(xy(equations.force(name))));
  };
  ledger.route("force polygon");
  put_efforts(ledger, names, constructed);
  ledger.put(self_locking(), [&] { return locks<T>(constructed(Motion::retrograde)); });
  ledger.route("equilibrium equations");
  put_efforts(ledger, names, computed);
  ledger.put(self_locking(), [&] { return locks<T>(computed(Motion::retrograde)); });
  for (const VectorQuantity& R : forces)
    for (const Motion motion : with_friction) {
      ledger.route("force polygon");
      put_vector(ledger, in(motion, R), [&] { return all.bodies.at(motion)().force(R.name); });
      ledger.route("equilibrium equations");
      put_vector(ledger, in(motion, R), [&] { return all.equations.at(motion)().force(R.name); });
    }
  ledger.route("force polygon");
  const std::string load = is_couple ? "F" : "Q";
  draw_vector(ledger, load, [&] { return all.bodies.at(Motion::ideal)().force(load); });
  for (const Motion motion : motions) {
    const std::string of = motion == Motion::ideal ? "_ideal" : suffix(motion);
    for (const VectorQuantity& R : forces)
      if (motion == Motion::ideal)
        draw_vector(ledger, R.name + of, [&] { return all.bodies.at(motion)().force(R.name); });
    if (!is_couple) draw_vector(ledger, name + of, [&] { return all.bodies.at(motion)().force(name); });
  }
}

inline Names names_of_P() { return {applied_force("P", {})}; }
inline Names names_of_M() { return {applied_force("M", {}), true}; }

// A limit that is half of a given angle, constructed as the bisector.
template <class T>
void put_half(Ledger<T>& ledger, const Quantity& limit, const Angle& whole) {
  ledger.route("construction");
  ledger.put(limit, [&] {
    return in_degrees(angle_of(Vector<T>{T(1) + geometry::cosine<T>(whole), geometry::sine<T>(whole)}));
  });
  ledger.route("analytic");
  ledger.put(limit, [&] { return given_in_degrees<T>(Rational(1, 2) * whole); });
}
template <class T>
void put_whole(Ledger<T>& ledger, const Quantity& limit, const Angle& angle) {
  ledger.route("construction");
  ledger.put(limit, [&] {
    return in_degrees(angle_of(Vector<T>{geometry::cosine<T>(angle), geometry::sine<T>(angle)}));
  });
  ledger.route("analytic");
  ledger.put(limit, [&] { return given_in_degrees<T>(angle); });
}

// A limit of the link with friction in its pins: in the triangle of the sides l and 2 r, whose directions stand at
// `whole`, the angle beside 2 r. Constructed, and by the law of tangents.
template <class T>
void put_limit_with_pins(Ledger<T>& ledger, const Quantity& limit, const Angle& whole, const T& l, const T& twice_r) {
  const T c = geometry::cosine<T>(whole), s = geometry::sine<T>(whole);
  ledger.route("construction");
  ledger.put(limit, [&] { return in_degrees(slope_angle(Vector<T>{twice_r + l * c, l * s})); });
  ledger.route("analytic");
  ledger.put(limit, [&] {
    const Complex<T> half_difference{(l + twice_r) * (T(1) + c), (l - twice_r) * s};
    return given_in_degrees<T>(Rational(1, 2) * whole) + part_of_turn_in_degrees(slope_by_its_half(half_difference));
  });
}

// From `n`, turning as the force does in the retrograde motion, to the line through X and the hinge; the tangent of
// the angle as a right triangle.
template <class T>
Vector<T> to_line(const Vector<T>& n, const Vector<T>& from_hinge, const T& turn) {
  const T across = -(turn * geometry::cross(from_hinge, n)), beside = geometry::dot(from_hinge, n);
  const geometry::Sign sign = geometry::sign(beside);
  if (sign == geometry::Sign::undecided)
    throw geometry::Undecided("whether a friction angle locks it", "se un angolo d'attrito lo renda irreversibile");
  const Vector<T> triangle =
      sign == geometry::Sign::negative ? Vector<T>{-beside, -across} : Vector<T>{beside, across};
  const geometry::Sign ahead = geometry::sign(triangle.y);
  if (ahead == geometry::Sign::undecided)
    throw geometry::Undecided("whether a friction angle locks it", "se un angolo d'attrito lo renda irreversibile");
  if (ahead != geometry::Sign::positive) throw geometry::Impossible(never_locks);
  return triangle;
}
template <class T, class Find>
void put_locking_angle(Ledger<T>& ledger, const Find& triangle) {
  ledger.route("construction");
  ledger.put(self_locking_angle(), [&] { return in_degrees(slope_angle(Vector<T>(triangle()))); });
  ledger.route("analytic");
  ledger.put(self_locking_angle(), [&] {
    const Vector<T> v = triangle();
    return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{v.x, v.y}));
  });
}

template <class T>
void write_friction(Ledger<T>& ledger, const Problem& problem) {
  const Angle& phi = problem.phi;
  const Quantity friction{"friction_coefficient", "$f$", "1", {"friction coefficient", "coefficiente d'attrito"}};
  const T c = geometry::cosine<T>(phi), s = geometry::sine<T>(phi);
  ledger.put(friction, [&] { return geometry::quotient(s, c); });
  ledger.route("analytic");
  ledger.put(friction, [&] {  // by the half angle
    const T h = geometry::quotient(s, T(1) + c);
    return geometry::quotient(T(2) * h, T(1) - geometry::square(h));
  });
}

}  // namespace epure::friction_efficiency
