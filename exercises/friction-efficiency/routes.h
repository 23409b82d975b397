// The mechanisms with friction: the forces of the contacts turned by the friction angle against the sliding of the
// body they act on, in the direct and in the retrograde motion. Twice: by force polygons with the sliding of the
// velocity diagram, and by the equations of equilibrium with the sliding that the joints' equations give.
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
T locks(const T& retrograde) {
  const geometry::Sign sign = geometry::sign(retrograde);
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

// ---------------------------------------------------------------------------------------------------------------------
// The wedge.

// When the wedge moves by 1 along x.
template <class T>
Vector<T> velocity_of_rod(const Wedge& of) {
  const Vector<T> v_2{T(1), T(0)}, up{T(0), T(1)},
      along_face{geometry::cosine<T>(of.theta), -geometry::sine<T>(of.theta)};
  return geometry::close_polygon(v_2, along_face, up).of_second * up;
}
template <class T>
void draw_sliding_of_wedge(Ledger<T>& ledger, const Wedge& of) {
  draw_vector(ledger, "v_21", [] { return Vector<T>{T(1), T(0)}; });
  draw_vector(ledger, "v_31", [&] { return velocity_of_rod<T>(of); });
  draw_vector(ledger, "v_32", [&] { return velocity_of_rod<T>(of) - Vector<T>{T(1), T(0)}; });
}

template <class T>
auto wedge_motions(const Problem& problem, Collar collar) {
  const Wedge of = problem.of.wedge;
  const auto constructed = [=](auto& model, const Turned& turned) {
    const T c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta);
    const Vector<T> v_2{T(1), T(0)}, up{T(0), T(1)}, left{T(-1), T(0)}, n{s, c}, v_3 = velocity_of_rod<T>(of);
    model.directed("Q", quarter());
    model.directed("R_23", turned.direction<T>(quarter() - of.theta, n, v_3 - v_2));
    model.directed("R_12", turned.direction<T>(quarter(), up, v_2));
    const bool is_one = collar == Collar::one_force;
    epure::describe(
        model, of,
        WedgeDirections<T>{turned.components<T>(n, v_3 - v_2), turned.components<T>(up, v_2),
                           turned.components<T>(is_one ? left : -left, v_3), turned.components<T>(left, v_3)},
        collar);
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const Complex<T> O{T(0), T(0)}, v_2 = velocity_of(ideal, 2, O), v_3 = velocity_of(ideal, 3, O);
    const bool is_one = collar == Collar::one_force;
    epure::describe(model, of,
                    WedgeDirections<T>{unit<T>(turned.angle<T>(quarter() - of.theta, v_3 - v_2)),
                                       unit<T>(turned.angle<T>(quarter(), v_2)),
                                       unit<T>(turned.angle<T>(is_one ? half() : Angle{}, v_3)),
                                       unit<T>(turned.angle<T>(half(), v_3))},
                    collar);
  };
  return in_all_motions<T>(3, "P", problem.phi, constructed, analysed);
}

template <class T>
void write_wedge(Ledger<T>& ledger, const Problem& problem) {
  ledger.begin_case("wedge_collar.", {", wedge and collar", ", cuneo e collare"});
  write_motions<T>(ledger, names_of_P(), wedge_motions<T>(problem, Collar::one_force), {T(1), T(0)},
                   {force_between(1, 2), force_between(1, 3), force_between(2, 3)},
                   without_effort(problem.wedge_at_limit));
  draw_sliding_of_wedge(ledger, problem.of.wedge);
  put_half(ledger, self_locking_angle(), problem.of.wedge.theta);
  put_half(ledger, jamming_angle(), quarter() - problem.of.wedge.theta);
}

template <class T>
void write_two_point_wedge(Ledger<T>& ledger, const Problem& problem) {
  const Wedge of = problem.of.wedge;
  const Angle phi = problem.phi;
  const VectorQuantity upper =
                           force_between(1, 3, "upper", "^{{u}}", {", at the upper end", ", all'estremo superiore"}),
                       lower =
                           force_between(1, 3, "lower", "^{{l}}", {", at the lower end", ", all'estremo inferiore"});
  ledger.begin_case("wedge_collar_two_point.", {", collar with two forces", ", collare con due forze"});
  const Motions<T> all = wedge_motions<T>(problem, Collar::two_forces);
  write_motions<T>(ledger, names_of_P(), all, {T(1), T(0)}, {force_between(1, 2), upper, lower, force_between(2, 3)},
                   without_effort(problem.wedge_at_limit));
  draw_sliding_of_wedge(ledger, of);
  put_half(ledger, self_locking_angle(), of.theta);
  for (const Motion motion : with_friction) {
    const PointQuantity K = in(
        motion,
        PointQuantity{
            "K", {" of K, where the collar's forces meet", " di K, dove si incontrano le forze del collare"}, "K"});
    const Quantity culmann =
        in(motion, Quantity{"culmann_angle",
                            "$κ$",
                            "deg",
                            {"angle of Culmann's line OK from +x", "angolo della retta di Culmann OK da +x"}});
    const Quantity culmann_deg{"culmann_angle" + suffix(motion) + "_deg", culmann.symbol, culmann.unit,
                               culmann.meaning};
    ledger.route("force polygon");
    const auto found = [=]() -> ProjectivePoint<T> {
      if (is_zero(phi)) throw geometry::Impossible(parallel_collar);
      return all.bodies.at(motion)().three_lines(3).K;
    };
    put_point(ledger, K, found, parallel_collar);
    const auto slope = [](const Vector<T>& v) {  // of a line, in (-90°, 90°]
      const geometry::Sign right = geometry::sign(v.x);
      if (right == geometry::Sign::undecided)
        throw geometry::Undecided("whether Culmann's line is upright", "se la retta di Culmann sia verticale");
      return right == geometry::Sign::negative ? -v : v;
    };
    ledger.put(culmann_deg, [&] {
      const ProjectivePoint<T> P = found();
      const Point<T> at = geometry::finite(P);
      return in_degrees(angle_of(slope({at.x, at.y})));
    });
    // K from the collar's ends: a = 2 x tan φ along it. The sum of the two forces runs from O to K.
    ledger.route("equilibrium equations");
    const T sense = motion == Motion::direct ? T(1) : T(-1);
    const auto of_K = [=] {
      if (is_zero(phi)) throw geometry::Impossible(parallel_collar);
      const T mu = sense * geometry::quotient(geometry::sine<T>(phi), geometry::cosine<T>(phi));
      return Vector<T>{geometry::quotient(number<T>((of.y_upper - of.y_lower) / 2), mu),
                       number<T>((of.y_upper + of.y_lower) / 2) - mu * number<T>(of.w / 2)};
    };
    ledger.put(K.x(), [&] { return of_K().x; });
    ledger.put(K.y(), [&] { return of_K().y; });
    ledger.put(culmann_deg, [&] {
      // In line with Q the wedge's force leaves nothing for the collar, and no sum has a direction.
      const bool is_free = motion == Motion::retrograde && of.theta == phi;
      const Vector<T> OK = of_K();
      const Equations<T>& equations = all.equations.at(motion)();
      const Vector<T> R = slope(is_free ? OK : equations.force("R_13_upper") + equations.force("R_13_lower"));
      return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{R.x, R.y}));
    });
  }
  ledger.route("force polygon");
  ledger.put(jamming_angle(), [&]() -> T {
    if constexpr (signs_only<T>)
      return T(1);
    else
      return geometry::on_balls<T>(
          [=] { return in_degrees(geometry::arc_tangent(jamming_coefficient(of), geometry::Deep(1))); });
  });
  // The cubic by its trigonometric roots.
  ledger.route("analytic");
  ledger.put(jamming_angle(), [&]() -> T {
    if constexpr (signs_only<T>) {
      return T(1);
    } else {
      const T t = geometry::quotient(geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta));
      const T w = number<T>(of.w), a = number<T>(of.y_upper - of.y_lower),
              twice_m = number<T>(of.y_upper + of.y_lower);
      const T b2 = geometry::quotient(w * t - twice_m, w), b1 = geometry::quotient(-((a + twice_m) * t), w),
              b0 = geometry::quotient(a, w);
      const T third = number<T>(Rational(1, 3));
      const T p = b1 - third * geometry::square(b2),
              q = number<T>(Rational(2, 27)) * b2 * geometry::square(b2) - third * b1 * b2 + b0;
      const geometry::Sign bends = geometry::sign(p);
      if (bends == geometry::Sign::positive || bends == geometry::Sign::zero) throw geometry::Impossible(never_jams);
      const T spread = geometry::root(-(third * p)), cube = spread * geometry::square(spread);
      const T inside = geometry::square(T(2) * cube) - geometry::square(q);
      const geometry::Sign has_three = geometry::sign(inside);
      if (has_three == geometry::Sign::negative) throw geometry::Impossible(never_jams);  // the only root is negative
      if (has_three != geometry::Sign::positive && !jams_at_one_coefficient(of))
        throw geometry::Undecided("how many friction angles jam the rod",
                                  "quanti angoli d'attrito facciano impuntare l'asta");
      const T width = has_three == geometry::Sign::positive ? geometry::root(inside) : T(0);
      const T alpha = third * geometry::arc_tangent(width, T(-q));
      // The middle one of the three: the least is negative.
      const T mu = T(2) * spread * geometry::cosine_of_angle(alpha - number<T>(Rational(2, 3)) * geometry::pi<T>()) -
                   third * b2;
      if (geometry::sign(mu) == geometry::Sign::negative) throw geometry::Impossible(never_jams);  // all three are
      return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{T(1), mu}));
    }
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// The double slider: the sliders as bodies 2 and 3, the link as the line of its force.

template <class Model, class T>
void describe_by_link(Model& model, const DoubleSlider& of, const XY<T>& A, const XY<T>& B, const XY<T>& on_link,
                      const XY<T>& link, const XY<T>& R_12, const XY<T>& R_14) {
  model.load("Q", 2, A.x, A.y, T(0), -number<T>(of.Q));
  model.guide("R_12", 1, 2, R_12.x, R_12.y);
  model.contact("R_32", 3, 2, on_link.x, on_link.y, link.x, link.y);
  model.guide("R_14", 1, 3, R_14.x, R_14.y);
  model.effort("P", 3, B.x, B.y, T(1), T(0));
}

// The line of the link's force, from slider 4 to slider 2, turned from AB clockwise in the direct motion by the angle
// whose sine is that of two friction circles' radii over AB; its turn is told by sine and cosine.
template <class T>
struct Tilt {
  T sine, cosine;
};
template <class T>
Tilt<T> tilt_of(const Problem& problem, bool has_pins) {
  if (!has_pins) return {T(0), T(1)};
  const T s = geometry::quotient(number<T>(2 * problem.radius) * geometry::sine<T>(problem.phi),
                                 number<T>(problem.of.double_slider.l));
  return {s, geometry::root(T(1) - geometry::square(s))};
}

template <class T>
Motions<T> double_slider_motions(const Problem& problem, bool has_pins) {
  const DoubleSlider of = problem.of.double_slider;
  const auto link_at = [=](const Turned& turned) {
    const Tilt<T> tilt = tilt_of<T>(problem, has_pins && turned.motion != Motion::ideal);
    const T c = geometry::cosine<T>(of.theta), s = geometry::sine<T>(of.theta), turn = T(-turned.sense()) * tilt.sine;
    return XY<T>{c * tilt.cosine - s * turn, s * tilt.cosine + c * turn};
  };
  const auto points = [=] {
    const T l = number<T>(of.l);
    return std::pair{XY<T>{T(0), l * geometry::sine<T>(of.theta)}, XY<T>{-(l * geometry::cosine<T>(of.theta)), T(0)}};
  };
  const auto middle = [](const XY<T>& A, const XY<T>& B) {
    const T h = number<T>(Rational(1, 2));
    return XY<T>{h * (A.x + B.x), h * (A.y + B.y)};
  };
  const auto constructed = [=](auto& model, const Turned& turned) {
    const auto [A, B] = points();
    const Vector<T> right{T(1), T(0)}, up{T(0), T(1)};  // sliding of 4 and of 2
    model.directed("Q", quarter());
    if (const auto tilt = has_pins ? problem.tilt : Angle{})
      model.directed("R_32", of.theta - Rational(turned.sense()) * *tilt);
    model.directed("R_14", turned.direction<T>(quarter(), up, right));
    describe_by_link<std::decay_t<decltype(model)>, T>(model, of, A, B, middle(A, B), link_at(turned),
                                                       turned.components<T>(-right, up),
                                                       turned.components<T>(up, right));
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const auto [A, B] = points();
    const Complex<T> O{T(0), T(0)};
    describe_by_link<std::decay_t<decltype(model)>, T>(model, of, A, B, middle(A, B), link_at(turned),
                                                       unit<T>(turned.angle<T>(half(), velocity_of(ideal, 2, O))),
                                                       unit<T>(turned.angle<T>(quarter(), velocity_of(ideal, 3, O))));
  };
  return in_all_motions<T>(3, "P", problem.phi, constructed, analysed);
}

template <class T>
void write_double_slider(Ledger<T>& ledger, const Problem& problem) {
  const std::vector<VectorQuantity> forces{force_between(1, 2), force_between(1, 4), force_between(3, 2)};
  ledger.begin_case("double_slider.", {", double slider", ", doppio pattino"});
  write_motions<T>(ledger, names_of_P(), double_slider_motions<T>(problem, false), {T(1), T(0)}, forces,
                   without_effort(problem.double_slider_at_limit));
  put_whole(ledger, self_locking_angle(), quarter() - problem.of.double_slider.theta);
  put_whole(ledger, jamming_angle(), problem.of.double_slider.theta);
}

template <class T>
void write_double_slider_pins(Ledger<T>& ledger, const Problem& problem) {
  const std::vector<VectorQuantity> forces{force_between(1, 2), force_between(1, 4), force_between(3, 2)};
  ledger.begin_case("double_slider_pins.",
                    {", double slider with friction in the pins", ", doppio pattino con attrito nei perni"});
  write_motions<T>(ledger, names_of_P(), double_slider_motions<T>(problem, true), {T(1), T(0)}, forces,
                   without_effort(problem.pins_at_limit));
  const Quantity circle{
      "friction_circle_radius", "$ρ$", "m", {"radius of the friction circles", "raggio dei cerchi d'attrito"}};
  const Quantity tilt{"link_line_tilt_angle_deg",
                      "$δ$",
                      "deg",
                      {"angle of the link's force with AB", "angolo della forza dell'asta con AB"}};
  const Angle phi = problem.phi, theta = problem.of.double_slider.theta;
  const auto at = [=] { return tilt_of<T>(problem, true); };
  const auto tilt_deg = [=] { return in_degrees(slope_angle(Vector<T>{at().cosine, at().sine})); };
  const auto tilt_by_half = [=] {
    return part_of_turn_in_degrees(slope_by_its_half(Complex<T>{at().cosine, at().sine}));
  };
  ledger.route("construction");
  ledger.put(circle, [&] { return number<T>(problem.radius) * geometry::sine<T>(phi); });
  ledger.put(tilt, [&] { return tilt_deg(); });
  for (const Motion motion : with_friction)
    ledger.put(
        Quantity{"link_line_angle" + suffix(motion) + "_deg", motion == Motion::direct ? "$ψ$" : "$ψ'$", "deg",
                 Words{"direction of the link's force on slider 2", "direzione della forza dell'asta sul pattino 2"} +
                     words_of(motion)},
        [=] { return given_in_degrees<T>(theta) + (motion == Motion::direct ? -tilt_deg() : tilt_deg()); });
  ledger.route("analytic");
  ledger.put(circle, [&] { return number<T>(problem.radius) * geometry::cosine<T>(quarter() - phi); });
  ledger.put(tilt, [&] { return tilt_by_half(); });
  const Motions<T> all = double_slider_motions<T>(problem, true);
  const T l = number<T>(problem.of.double_slider.l), twice_r = number<T>(2 * problem.radius);
  put_limit_with_pins(ledger, self_locking_angle(), quarter() - theta, l, twice_r);
  put_limit_with_pins(ledger, jamming_angle(), theta, l, twice_r);
  ledger.route("construction");
  const Point<T> A{T(0), l * geometry::sine<T>(theta)}, B{-(l * geometry::cosine<T>(theta)), T(0)};
  ledger.draws_point("A", A);
  ledger.draws_point("B", B);
  for (const Motion motion : with_friction) {
    const auto touched = [=](const Point<T>& X) {
      return geometry::foot(X, all.bodies.at(motion)().line_of("R_32"));
    };
    ledger.draws_point("on_A" + suffix(motion), [&] { return touched(A); });
    ledger.draws_point("on_B" + suffix(motion), [&] { return touched(B); });
  }
  ledger.route("equilibrium equations");
  for (const Motion motion : with_friction)
    ledger.put("link_line_angle" + suffix(motion) + "_deg",
               [=] { return in_degrees(angle_of(all.equations.at(motion)().force("R_32"))); });
}

// ---------------------------------------------------------------------------------------------------------------------
// The levers: friction in C.

// The lever that P drives turns as P does, the other so that they stay in touch.
template <class T>
Vector<T> sliding_in_C(const Levers& of, const LeverPoints<T>& at) {
  const Point<T>&h_P = of.driven() == 2 ? at.A0 : at.B0, &h_Q = of.loaded == 2 ? at.A0 : at.B0;
  const T omega_P = of.arm_P > 0 ? T(1) : T(-1);
  const T omega_Q =
      geometry::quotient(omega_P * geometry::cross(at.C - h_P, at.n), geometry::cross(at.C - h_Q, at.n));
  return omega_Q * geometry::quarter_turn(at.C - h_Q) - omega_P * geometry::quarter_turn(at.C - h_P);
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
void write_levers(Ledger<T>& ledger, const Problem& problem, const Levers& of, bool is_at_limit) {
  const LeverPoints<T> at = points_of<T>(of);
  const Angle phi = problem.phi;
  const auto constructed = [=](auto& model, const Turned& turned) {
    const Vector<T> sliding = sliding_in_C(of, at);
    if (is_at_limit && turned.motion == Motion::retrograde)
      model.through(of.contact(), "R_1" + std::to_string(of.driven()));
    epure::describe(
        model, of,
        LeversAt<T>{xy(at.C), turned.components<T>(at.n, sliding), turned.direction<T>(of.nu, at.n, sliding)});
  };
  const Complex<T> C{number<T>(of.x_C), number<T>(of.y_C)};
  const auto angle = [=](const Turned& turned, const Equations<T>* ideal) {
    return turned.angle<T>(of.nu, velocity_of(ideal, of.loaded, C) - velocity_of(ideal, of.driven(), C));
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    const Angle along = angle(turned, ideal);
    epure::describe(model, of, LeversAt<T>{{C.re, C.im}, unit<T>(along), along});
  };
  const Motions<T> all = in_all_motions<T>(3, "P", phi, constructed, analysed);
  const VectorQuantity contact = force_between(of.driven(), of.loaded);
  ledger.route("construction");
  for (const auto& [name, P] : {std::pair{"A0", at.A0}, std::pair{"B0", at.B0}, std::pair{"C", at.C},
                                std::pair{"A", at.A}, std::pair{"B", at.B}})
    ledger.draws_point(name, P);
  write_motions<T>(ledger, names_of_P(), all, unit<T>(of.direction_P),
                   {force_between(1, 2), force_between(1, 3), contact}, without_effort(is_at_limit));
  draw_vector(ledger, "sliding", [&] { return sliding_in_C(of, at); });
  for (const Motion motion : with_friction) {
    const Quantity direction{
        "contact_force_angle" + suffix(motion) + "_deg",
        "$ν_{" + std::string(motion == Motion::direct ? "D" : "R") + "}$", "deg",
        Words{"direction of the contact's force", "direzione della forza di contatto"} + words_of(motion)};
    ledger.route("force polygon");
    ledger.put(direction, [&] { return in_degrees(angle_of(all.bodies.at(motion)().force(contact.name))); });
    ledger.route("equilibrium equations");
    ledger.put(direction, [&] {
      const Angle found = geometry::within_one_turn(angle({phi, motion}, &all.equations.at(Motion::ideal)()));
      return given_in_degrees<T>(sign_of(half() - found) < 0 ? found - Angle{1} : found);
    });
    for (const int lever : {2, 3}) {
      const PointQuantity H = in(
          motion, PointQuantity{"H_" + std::to_string(lever), Words{" of the meeting point of the forces on lever ",
                                                                    " del punto d'incontro delle forze sulla leva "} +
                                                                  std::to_string(lever)});
      ledger.route("force polygon");
      put_point(
          ledger, H, [&] { return all.bodies.at(motion)().H(lever); }, parallel_forces);
      ledger.route("equilibrium equations");
      put_point(
          ledger, H,
          [=] {
            const bool is_loaded = lever == of.loaded;
            if (geometry::are_parallel(angle({phi, motion}, &all.equations.at(Motion::ideal)()),
                                       is_loaded ? of.direction_Q : of.direction_P))
              throw geometry::Impossible(parallel_forces);
            const XY<T> X = is_loaded ? XY<T>{number<T>(of.x_Q), T(0)} : foot_of_P<T>(of);
            return on_reaction<T>({number<T>(of.hinge(lever)), T(0)},
                                  all.equations.at(motion)().force("R_1" + std::to_string(lever)), complex(X),
                                  complex(unit<T>(is_loaded ? of.direction_Q : of.direction_P)));
          },
          parallel_forces);
    }
  }
  put_locking_angle(ledger, [&] {
    const Vector<T> sliding = sliding_in_C(of, at), left = geometry::quarter_turn(at.n);
    return to_line<T>(at.n, at.C - (of.driven() == 2 ? at.A0 : at.B0), T(sense_of<T>(geometry::dot(sliding, left))));
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Fairbairn's mechanism: friction of block 3 on the lever, of block 5 in the slot, of the ram in its guide.

// The guide presses on the ram against the friction of block 5.
template <class T>
T pressing(const T& upwards) {
  const geometry::Sign sign = geometry::sign(upwards);
  if (sign == geometry::Sign::undecided)
    throw geometry::Undecided("on which side the guide presses on the ram",
                              "da che lato la guida prema sulla slitta");
  return sign == geometry::Sign::positive ? T(-1) : T(1);
}

// With the crank across it the lever rests, and nothing but friction loads the crank.
inline std::set<Motion> at_dead_centre(const Fairbairn& of, const Angle& phi) {
  if (!of.touches) return {};
  return is_zero(phi) ? std::set<Motion>(motions.begin(), motions.end()) : std::set{Motion::ideal};
}

// How the blocks slide when the crank turns by 1: 5 on the ram, the lever on block 3, the ram in its guide.
template <class T>
struct SlidingOfFairbairn {
  Vector<T> v_56, v_43, v_61;
};
template <class T>
SlidingOfFairbairn<T> sliding_of(const Fairbairn& of, const FairbairnPoints<T>& at) {
  using geometry::quarter_turn;
  const auto [along, turning] = geometry::close_polygon(quarter_turn(at.B - at.A), at.lever, quarter_turn(at.lever));
  const T omega_4 = of.touches ? T(0) : geometry::quotient(turning, geometry::dot(at.B - at.C, at.lever));
  const Vector<T> v_D5 = omega_4 * quarter_turn(at.D - at.C), v_D6{v_D5.x, T(0)};
  return {v_D5 - v_D6, along * at.lever, v_D6};
}

template <class T>
void write_fairbairn(Ledger<T>& ledger, const Problem& problem, const Fairbairn& of, const std::string& name) {
  const Angle phi = problem.phi;
  const auto at = once([=] { return points_of<T>(of); });
  const auto require_sliding = [=](const Turned& turned) {
    if (turned.motion != Motion::ideal && !is_zero(turned.phi) && (of.touches || is_zero(of.theta)))
      throw geometry::Impossible(why_no_sliding(of, name));
  };
  const auto constructed = [=](auto& model, const Turned& turned) {
    require_sliding(turned);
    const FairbairnPoints<T>& P = at();
    const Vector<T> across = geometry::quarter_turn(P.lever), x{T(1), T(0)}, y{T(0), T(1)};
    const auto [v_56, v_43, v_61] = sliding_of(of, P);
    const XY<T> R_56 = turned.components<T>(-x, -v_56);
    model.directed("F", Angle{});
    model.directed("R_56", turned.direction<T>(half(), -x, -v_56));
    model.directed("R_34", turned.direction<T>(half() - of.theta, across, v_43));
    epure::describe(model, of,
                    FairbairnAt<T>{xy(P.A), xy(P.B), xy(P.D), turned.components<T>(across, v_43), R_56,
                                   turned.components<T>(pressing<T>(R_56.y) * y, v_61)});
  };
  const auto by_sines = [=] {
    const T CD = number<T>(of.CD);
    return std::pair{crank_by_sines<T>(of) + Complex<T>{T(0), number<T>(of.AC)},
                     Complex<T>{CD * geometry::sine<T>(of.theta), CD * geometry::cosine<T>(of.theta)}};
  };
  // Of R_56 and R_34.
  const auto angles = [=](const Turned& turned, const Equations<T>* ideal) {
    const auto [B, D] = by_sines();
    const auto slides = [&](int j, int i, const Complex<T>& X) {
      return velocity_of(ideal, j, X) - velocity_of(ideal, i, X);
    };
    return std::pair{turned.angle<T>(half(), slides(6, 5, D)), turned.angle<T>(half() - of.theta, slides(4, 3, B))};
  };
  const auto analysed = [=](auto& model, const Turned& turned, const Equations<T>* ideal) {
    require_sliding(turned);
    const auto [B, D] = by_sines();
    const auto [of_R_56, of_R_34] = angles(turned, ideal);
    const XY<T> R_56 = unit<T>(of_R_56);
    const Angle R_16 = geometry::sign(pressing<T>(R_56.y)) == geometry::Sign::positive ? quarter() : -quarter();
    epure::describe(model, of,
                    FairbairnAt<T>{{T(0), number<T>(of.AC)},
                                   {B.re, B.im},
                                   {D.re, D.im},
                                   unit<T>(of_R_34),
                                   R_56,
                                   unit<T>(turned.angle<T>(R_16, velocity_of(ideal, 6, D)))});
  };
  const Motions<T> all = in_all_motions<T>(6, "M", phi, constructed, analysed);
  ledger.route("construction");
  ledger.draws_point("A", [&] { return at().A; });
  ledger.draws_point("B", [&] { return at().B; });
  ledger.draws_point("C", [&] { return at().C; });
  ledger.draws_point("D", [&] { return at().D; });
  draw_vector(ledger, "v_56", [&] { return sliding_of(of, at()).v_56; });
  draw_vector(ledger, "v_43", [&] { return sliding_of(of, at()).v_43; });
  write_motions<T>(ledger, names_of_M(), all, {T(1), T(0)},
                   {force_between(5, 6), force_between(1, 6), force_between(1, 4), force_between(3, 4)},
                   at_dead_centre(of, phi));
  for (const Motion motion : with_friction) {
    const Quantity F_23 =
        in(motion,
           Quantity{"F_23", "$\\it{F}_{23}$", "N", {"force between crank and lever", "forza tra manovella e leva"}});
    const Quantity d =
        in(motion, Quantity{"d", "$d$", "m", {"arm of F23 about A", "braccio della F23 rispetto ad A"}});
    const PointQuantity H = in(motion, PointQuantity{"H",
                                                     {" of the meeting point of the forces on the lever",
                                                      " del punto d'incontro delle forze sulla leva"}});
    ledger.route("force polygon");
    ledger.put(F_23, [&] { return size(all.bodies.at(motion)().force("R_23")); });
    ledger.put(d, [&] {
      return geometry::distance(at().A, geometry::foot(at().A, all.bodies.at(motion)().line_of("R_23")));
    });
    put_point(
        ledger, H, [&] { return all.bodies.at(motion)().H(4); }, parallel_forces);
    ledger.route("equilibrium equations");
    ledger.put(F_23, [&] { return size(all.equations.at(motion)().force("R_23")); });
    ledger.put(d, [&] {
      const Equations<T>& equations = all.equations.at(motion)();
      return geometry::quotient(magnitude_of<T>(equations.forces.at("M").m), size(equations.force("R_23")));
    });
    put_point(
        ledger, H,
        [=] {
          const Equations<T>& equations = all.equations.at(motion)();
          const auto [of_R_56, of_R_34] = angles({phi, motion}, &all.equations.at(Motion::ideal)());
          if (geometry::are_parallel(of_R_56, of_R_34)) throw geometry::Impossible(parallel_forces);
          return on_reaction<T>({T(0), T(0)}, equations.force("R_14"), by_sines().second,
                                complex(xy(equations.force("R_56"))));
        },
        parallel_forces);
  }
  put_locking_angle(ledger, [&] {
    const FairbairnPoints<T>& P = at();
    const Vector<T> across = geometry::quarter_turn(P.lever), v_B2 = geometry::quarter_turn(P.B - P.A);
    const T along = geometry::close_polygon(v_B2, P.lever, across).of_first;  // the lever on the block, along it
    return to_line<T>(across, P.B - P.A, T(sense_of<T>(-along)));
  });
  put_half(ledger, jamming_angle(), quarter());
}

template <class T>
void write_friction(Ledger<T>& ledger, const Angle& phi) {
  const Quantity friction{"friction_coefficient", "$f$", "1", {"friction coefficient", "coefficiente d'attrito"}};
  const T c = geometry::cosine<T>(phi), s = geometry::sine<T>(phi);
  ledger.put(friction, [&] { return geometry::quotient(s, c); });
  ledger.route("analytic");
  ledger.put(friction, [&] {  // by the half angle
    const T h = geometry::quotient(s, T(1) + c);
    return geometry::quotient(T(2) * h, T(1) - geometry::square(h));
  });
}

// One case.
struct Routes {
  Problem problem;
  std::string of_case;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    if (of_case.empty()) write_friction(ledger, problem.phi);
    if (of_case == "wedge_collar") write_wedge(ledger, problem);
    if (of_case == "wedge_collar_two_point") write_two_point_wedge(ledger, problem);
    if (of_case == "double_slider") write_double_slider(ledger, problem);
    if (of_case == "double_slider_pins") write_double_slider_pins(ledger, problem);
    if (of_case == "sliding_levers") {
      ledger.begin_case("sliding_levers.", {", sliding levers", ", leve striscianti"});
      write_levers(ledger, problem, problem.of.levers, problem.levers_at_limit);
    }
    if (of_case == "sliding_levers_Q_on_2") {
      ledger.begin_case("sliding_levers_Q_on_2.",
                        {", sliding levers with Q on 2", ", leve striscianti con Q sulla 2"});
      write_levers(ledger, problem, problem.of.levers_Q_on_2, problem.levers_Q_on_2_at_limit);
    }
    if (of_case == "fairbairn") {
      ledger.begin_case("fairbairn.", {", Fairbairn's mechanism", ", guida di Fairbairn"});
      write_fairbairn(ledger, problem, problem.of.fairbairn, of_case);
    }
    if (of_case == "fairbairn_short_lever") {
      ledger.begin_case("fairbairn_short_lever.",
                        {", Fairbairn's mechanism, shorter lever", ", guida di Fairbairn, leva più corta"});
      write_fairbairn(ledger, problem, problem.of.fairbairn_short_lever, of_case);
    }
    return ledger;
  }
};

}  // namespace epure::friction_efficiency
