// The four-bar's quantities by construction, by poles, by polar diagram and by analysis: each route writes down what
// it has found itself.
#pragma once

#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/four_bar_routes.h"
#include "exercises/kit/linkages/half_turned.h"

namespace epure::four_bar {

namespace analytic = geometry::analytic;
using geometry::from_rational;
using geometry::Point;
using geometry::Vector;

inline Quantity side(const std::string& of, const Words& meaning) { return {of, "$" + of + "$", "m", meaning}; }
inline Quantity coupler_angle() {
  return {"coupler_angle", "$θ_{3}$", "rad", {"direction from A to B", "direzione da A a B"}};
}
inline Quantity rocker_angle(const std::string& unit = "rad") {
  return {unit == "rad" ? "rocker_angle" : "rocker_angle_deg",
          "$θ_{4}$",
          unit,
          {"direction from B₀ to B", "direzione da B₀ a B"}};
}

inline constexpr Phrase no_value_of_gamma{"tan γ has no value: ω₃ and α₃ are zero",
                                          "tg γ non ha valore: ω₃ e α₃ sono zero"};
inline constexpr Phrase no_gamma{"tan γ grows beyond all bounds: ω₃ is zero",
                                 "tg γ cresce oltre ogni limite: ω₃ è zero"};

// From a right triangle with this angle: its legs beside and across.
template <class T>
T tangent_of_gamma(const T& beside, const T& across) {
  const bool is_open = geometry::sign(across) == geometry::Sign::zero;
  return Ledger<T>::ratio(across, beside, is_open ? no_value_of_gamma : no_gamma);
}
inline Quantity tan_gamma() { return {"tan_gamma", "$tan γ$", "1", {"α₃/ω₃²", "α₃/ω₃²"}}; }
inline Quantity gamma_in_degrees() {  // in (-90°, 90°)
  return {"gamma_deg", "$γ$", "deg", {"angle from a_A to the ray AK", "angolo da a_A al raggio AK"}};
}
template <class T>
void write_gamma(Ledger<T>& ledger, const T& beside, const T& across) {
  ledger.put(tan_gamma(), [&] { return tangent_of_gamma(beside, across); });
  ledger.put(gamma_in_degrees(), [&] { return in_degrees(slope_angle(Vector<T>{beside, across})); });
}

// A position of the linkage, with the plate's corner.
template <class T>
struct Configuration {
  geometry::FourBar<T> at;
  Point<T> C;

  std::vector<Lettered<Point<T>>> points() const { return {{"A", at.A}, {"B", at.B}, {"C", C}}; }
};
template <class T>
Configuration<T> with_plate(const geometry::FourBar<T>& at, const Problem& of, geometry::Side C_side) {
  return {at, geometry::right_angled_corner(at.A, at.B, of.instant.lengths.AB, of.AC, C_side)};
}

// The rocker from B₀ to B.
template <class T>
LinkDirections<T> link_directions(const geometry::FourBar<T>& at) {
  return {at.B - at.A, at.B - at.B0};
}

// A configuration's links along -x, by both ways to find it.
struct Back {
  HalfTurned by_construction, by_analysis;
};
template <class T>
void write_link_angles(Ledger<T>& ledger, const LinkDirections<T>& links, const HalfTurned& back) {
  ledger.put(coupler_angle(), [&] { return angle_or_half_turn(links.coupler, back.coupler); });
  ledger.put(rocker_angle(), [&] { return angle_or_half_turn(links.rocker, back.rocker); });
}

template <class T>
void by_construction(Ledger<T>& ledger, const Configuration<T>& place, const HalfTurned& back) {
  const auto& [at, C] = place;
  ledger.route("construction");
  ledger.draws_point("A0", at.A0);
  ledger.draws_point("B0", at.B0);
  for (const auto& X : place.points()) ledger.put(point(X.letter), X.at);
  write_link_angles(ledger, link_directions(at), back);
}

// Velocities from the pole, accelerations from the circles that it makes; the parts of an acceleration are what a
// set square finds along and across a link.
template <class T>
void by_poles(Ledger<T>& ledger, const Configuration<T>& place, const T& omega_2, const T& alpha_2,
              bool pole_at_infinity) {
  const geometry::FourBar<T>& at = place.at;
  const Point<T>& C = place.C;
  ledger.route("poles");
  write_pole<T>(ledger, "P31", at.pole(), place.points(), crank_parallel_to_rocker);
  ledger.draws_point("P42", [&] { return finite(meet(line(at.A, at.B), line(at.A0, at.B0))); });
  draws_builder<T>(ledger, at.pole(), {"A", at.A}, at.A0);
  draws_builder<T>(ledger, at.pole(), {"B", at.B}, at.B0);
  if (pole_at_infinity) return;
  const CouplerAndRocker<T> motion = motion_by_poles(at, omega_2, alpha_2);
  const geometry::PlaneMotion<T>& m = motion.coupler;
  const geometry::RotationAboutPole<T> turning(at.pole(), at.A, m.v_A);
  const Vector<T> v_A = turning.velocity(at.A), v_B = turning.velocity(at.B);
  ledger.put(velocity("A").length(), [&] { return size(v_A); });
  ledger.put(velocity("BA").length(), [&] { return size(v_B - v_A); });
  ledger.put(velocity("B"), v_B);
  ledger.put(velocity("C"), turning.velocity(C));
  ledger.put(angular_velocity(3), turning.omega());
  ledger.put(angular_velocity(4), motion.omega_4);

  const Vector<T> a_A = m.acceleration(at.A), a_B = m.acceleration(at.B), a_C = m.acceleration(C);
  const auto parts = [&](const std::string& of, const Vector<T>& a, const Vector<T>& normal) {
    ledger.put(normal_acceleration(of).length(), [&] { return part_along(dot(a, normal), normal); });
    ledger.put(tangential_acceleration(of).length(), [&] { return part_along(cross(a, normal), normal); });
  };
  ledger.put(acceleration("A").length(), [&] { return size(a_A); });
  ledger.put(acceleration("B"), a_B);
  ledger.put(acceleration("C"), a_C);
  parts("B", a_B, at.B - at.B0);
  parts("BA", a_B - a_A, at.B - at.A);
  parts("CA", a_C - a_A, C - at.A);
  parts("C", a_C, C - finite(at.pole()));
  ledger.put(angular_acceleration(3), m.alpha);
  ledger.put(angular_acceleration(4), motion.alpha_4);
  const geometry::ProjectivePoint<T> K = m.acceleration_pole();
  const Vector<T> ray = K.w * Vector<T>{K.x - at.A.x * K.w, K.y - at.A.y * K.w};
  write_gamma(ledger, dot(a_A, ray), cross(a_A, ray));
  write_acceleration_pole<T>(ledger, m, place.points());
  write_circles(ledger, m, motion.J);
  write_curvature<T>(ledger, m, {"C", C});
}

// The sides of both polygons, and c' by a triangle similar to ABC.
template <class T>
geometry::FourBarMotion<T> by_polygons(Ledger<T>& ledger, const Configuration<T>& place, const T& omega_2,
                                       const T& alpha_2) {
  const auto& [at, C] = place;
  const Vector<T> AB = at.B - at.A, AC = C - at.A;
  const auto image = [&](const Vector<T>& side) {
    return geometry::quotient(dot(AB, AC), length_squared(AB)) * side +
           geometry::quotient(cross(AB, AC), length_squared(AB)) * quarter_turn(side);
  };
  ledger.route("polar diagram");
  const geometry::FourBarMotion<T> motion = geometry::four_bar_motion(at, omega_2, alpha_2);
  const auto& v = motion.velocity;
  const Vector<T> v_A = v.first.known, v_BA = v.first.closing, v_CA = image(v_BA), v_C = v_A + v_CA;
  ledger.put_length(velocity("A"), v_A);
  ledger.put_length(velocity("BA"), v_BA);
  ledger.put(velocity("B"), v.v_X);
  ledger.put(velocity("C"), v_C);
  ledger.draws_vector("v_CA", v_CA);
  ledger.draws_vector("v_CB", v_CA - v_BA);
  ledger.put(angular_velocity(3), v.first_rate);
  ledger.put(angular_velocity(4), v.second_rate);

  const auto& a = motion.acceleration;
  const Vector<T> a_BA = a.first.normal + a.first.closing, a_CA_n = image(a.first.normal),
                  a_CA_t = image(a.first.closing), a_CA = a_CA_n + a_CA_t, a_C = a.first.known + a_CA;
  ledger.put_length(acceleration("A"), a.first.known);
  ledger.draws_vector("a_A_n", -(geometry::square(omega_2) * (at.A - at.A0)));
  ledger.draws_vector("a_A_t", alpha_2 * quarter_turn(at.A - at.A0));
  ledger.put_length(normal_acceleration("BA"), a.first.normal);
  ledger.put_length(tangential_acceleration("BA"), a.first.closing);
  ledger.draws_vector("a_BA", a_BA);
  ledger.put_length(normal_acceleration("B"), a.second.normal);
  ledger.put_length(tangential_acceleration("B"), a.second.closing);
  ledger.put(acceleration("B"), a.a_X);
  ledger.put_length(normal_acceleration("CA"), a_CA_n);
  ledger.put_length(tangential_acceleration("CA"), a_CA_t);
  ledger.draws_vector("a_CA", a_CA);
  ledger.draws_vector("a_CB", a_CA - a_BA);
  ledger.put(acceleration("C"), a_C);
  ledger.put(normal_acceleration("C").length(), [&] { return part_along(cross(v_C, a_C), v_C); });
  ledger.put(tangential_acceleration("C").length(), [&] { return part_along(dot(v_C, a_C), v_C); });
  ledger.put(angular_acceleration(3), a.first_rate);
  ledger.put(angular_acceleration(4), a.second_rate);
  return motion;
}

template <class T>
void by_polar_diagram(Ledger<T>& ledger, const Configuration<T>& place, const T& omega_2, const T& alpha_2) {
  const auto& [at, C] = place;
  const geometry::FourBarMotion<T> motion = by_polygons(ledger, place, omega_2, alpha_2);
  const auto& of_BA = motion.acceleration.first;
  const Vector<T> AB = at.B - at.A;
  write_gamma(ledger, -dot(of_BA.normal, AB), cross(AB, of_BA.closing));
  write_acceleration_pole<T>(ledger, motion.coupler, place.points());
  write_circles(ledger, motion.coupler, motion.coupler.inflection_pole());
  draws_builder(ledger, motion.coupler);
  write_curvature<T>(ledger, motion.coupler, {"C", C});
}

template <class T>
struct Analysed {
  analytic::FourBarPosition<T> position;
  analytic::FourBarMotion<T> motion;
  analytic::Complex<T> C;

  LinkDirections<T> links() const { return {plane(position.coupler), plane(position.rocker)}; }
  analytic::PlaneMotion<T> coupler() const { return analytic::coupler(position, motion); }
  std::vector<Lettered<analytic::Complex<T>>> points() const {
    return {{"A", position.A}, {"B", position.B}, {"C", C}};
  }
};

// `C_side` apart, so that the plate's mirror image can be asked for.
template <class T>
Analysed<T> analysed(const Problem& of, const analytic::CrankState<T>& crank, analytic::Branch branch,
                     geometry::Side C_side) {
  const analytic::FourBar g = of.instant.analytic_lengths();
  const auto position = analytic::position(g, crank, branch);
  const auto side = C_side == geometry::Side::left ? analytic::Side::left : analytic::Side::right;
  const auto C = analytic::coupler_point(position, analytic::right_angled_plate_point<T>(g, of.AC, side));
  return {position, analytic::motion(g, crank, position), C};
}

// ω² and α times the lengths of the links.
template <class T>
void links_by_analysis(Ledger<T>& ledger, const Problem& of, const Analysed<T>& found) {
  using geometry::square;
  const analytic::FourBarMotion<T>& m = found.motion;
  const analytic::PlaneMotion<T> coupler = found.coupler();

  const geometry::FourBarLengths& lengths = of.instant.lengths;
  const auto times = [&](const Quantity& quantity, const T& factor, const Rational& length) {
    ledger.put(quantity, [&] { return size(Vector<T>{factor * from_rational<T>(length), T(0)}); });
  };
  const analytic::Complex<T> v_C = coupler.velocity(found.C), a_C = coupler.acceleration(found.C);
  put_length<T>(ledger, velocity("A").length(), [&] { return m.v_A; });
  times(velocity("BA").length(), m.omega_3, lengths.AB);
  ledger.put(velocity("B"), plane(m.v_B));
  ledger.put(velocity("C"), plane(v_C));
  ledger.put(angular_velocity(3), m.omega_3);
  ledger.put(angular_velocity(4), m.omega_4);

  const T turning_3 = square(m.omega_3);
  put_length<T>(ledger, acceleration("A").length(), [&] { return m.a_A; });
  ledger.put(acceleration("B"), plane(m.a_B));
  ledger.put(acceleration("C"), plane(a_C));
  times(normal_acceleration("B").length(), square(m.omega_4), lengths.B0B);
  times(tangential_acceleration("B").length(), m.alpha_4, lengths.B0B);
  times(normal_acceleration("BA").length(), turning_3, lengths.AB);
  times(tangential_acceleration("BA").length(), m.alpha_3, lengths.AB);
  times(normal_acceleration("CA").length(), turning_3, of.AC);
  times(tangential_acceleration("CA").length(), m.alpha_3, of.AC);
  // a/v tells by its real part how the speed grows, by the imaginary one how the velocity turns.
  const auto part_of_a_C = [&](const Quantity& quantity, T analytic::Complex<T>::*part) {
    put_length<T>(ledger, quantity, [&] {
      const analytic::Complex<T> share = conjugate(v_C) * a_C;
      return ledger.ratio(share.*part, squared_modulus(v_C), no_path) * v_C;
    });
  };
  part_of_a_C(normal_acceleration("C").length(), &analytic::Complex<T>::im);
  part_of_a_C(tangential_acceleration("C").length(), &analytic::Complex<T>::re);
  ledger.put(angular_acceleration(3), m.alpha_3);
  ledger.put(angular_acceleration(4), m.alpha_4);
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Problem& of, const Analysed<T>& found, const HalfTurned& back) {
  const analytic::FourBarMotion<T>& m = found.motion;
  const analytic::PlaneMotion<T> coupler = found.coupler();
  const auto points = found.points();
  const T turning_3 = geometry::square(m.omega_3);
  ledger.route("analytic");
  for (const auto& X : points) put_point<T>(ledger, point(X.letter), [&] { return X.at; });
  write_link_angles(ledger, found.links(), back);
  write_pole<T>(ledger, "P31", coupler, points, crank_parallel_to_rocker);
  links_by_analysis(ledger, of, found);
  ledger.put(tan_gamma(), [&] { return tangent_of_gamma(turning_3, m.alpha_3); });
  ledger.put(gamma_in_degrees(), [&] {
    if (geometry::sign(turning_3) == geometry::Sign::zero && geometry::sign(m.alpha_3) == geometry::Sign::zero)
      throw geometry::Impossible(no_value_of_gamma);
    return part_of_turn_in_degrees(slope_by_its_half(analytic::Complex<T>{turning_3, m.alpha_3}));
  });
  write_acceleration_pole<T>(ledger, coupler, points);
  write_circles(ledger, coupler);
  write_curvature<T>(ledger, coupler, {"C", found.C});
}

}  // namespace epure::four_bar
