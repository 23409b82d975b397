// The four-bar's quantities by construction, polar diagram and poles, and by analysis.
#pragma once

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/four-bar-analytic/extremes.h"
#include "exercises/kit/linkages/four_bar_on_x.h"
#include "exercises/kit/linkages/four_bar_routes.h"

namespace epure::four_bar_analytic {

using geometry::Point;
using geometry::Vector;

inline constexpr Phrase coupler_parallel_to_frame{"the coupler is parallel to the frame",
                                                  "la biella è parallela al telaio"};

inline Quantity closure_coefficient(int i) {
  const std::string k = "k_{" + std::to_string(i) + "}";
  return {"closure_k" + std::to_string(i),
          "$" + k + "$",
          "m^2",
          {"coefficient of the equation for θ₄", "coefficiente dell'equazione per θ₄"}};
}

// Parts of G₃'s acceleration, along and across AB and its own path.
inline Quantity component_along_AB() {
  return {"a_G3_component_along_AB",
          "$a_{G3}·u_{AB}$",
          "m/s^2",
          {"component of G₃'s acceleration along A → B", "componente dell'accelerazione di G₃ lungo A → B"}};
}
inline Quantity component_normal_to_AB() {
  return {"a_G3_component_normal_to_AB",
          "$a_{G3}·k×u_{AB}$",
          "m/s^2",
          {"component of G₃'s acceleration perpendicular to A → B, on its left",
           "componente dell'accelerazione di G₃ normale ad A → B, a sinistra"}};
}
inline Quantity part_normal_to_path() {
  return {"a_G3_path_normal",
          "$a^{n}_{G3}$",
          "m/s^2",
          {"part of G₃'s acceleration normal to its path", "parte normale alla traiettoria di G₃"}};
}
inline Quantity part_along_path() {
  return {"a_G3_path_tangential",
          "$a^{t}_{G3}$",
          "m/s^2",
          {"part of G₃'s acceleration along its path", "parte tangente alla traiettoria di G₃"}};
}

template <class T>
void write_positions(Ledger<T>& ledger, const geometry::FourBar<T>& at, const Point<T>& P) {
  const Midpoints<T> G = midpoints(at);
  ledger.draws_point("A0", at.A0);
  ledger.draws_point("B0", at.B0);
  ledger.put(point("A"), at.A);
  ledger.put(point("B"), at.B);
  ledger.put(point("G2"), G.G2);
  ledger.put(point("G3"), G.G3);
  ledger.put(point("G4"), G.G4);
  ledger.put(point("P"), P);
}

// Of a product with AB, which is not zero; for signs the product itself.
template <class T>
T component(const T& product, const Vector<T>& AB) {
  if constexpr (signs_only<T>) {
    return product;
  } else {
    return geometry::quotient(product, geometry::length(AB));
  }
}

// The figures of second order that follow from the motion of the coupler.
template <class T>
void write_second_order(Ledger<T>& ledger, const geometry::FourBar<T>& at, const Point<T>& P,
                        const geometry::PlaneMotion<T>& m, const geometry::ProjectivePoint<T>& J) {
  const Point<T> G3 = midpoint(at.A, at.B);
  write_acceleration_pole<T>(ledger, m, {{"A", at.A}, {"B", at.B}, {"G3", G3}});
  write_circles(ledger, m, J);
  write_curvature<T>(ledger, m, {"G3", G3});
  write_curvature<T>(ledger, m, {"P", P});
}

// Sides of the two polygons, and the images of the midpoints and of P.
template <class T>
void by_polar_diagram(Ledger<T>& ledger, const Problem& of, const geometry::FourBar<T>& at, const Point<T>& P) {
  ledger.route("polar diagram");
  const auto motion =
      geometry::four_bar_motion(at, of.instant.omega_2<T>(), geometry::radians<T>(of.instant.alpha_2));
  const auto& v = motion.velocity;
  const auto& a = motion.acceleration;
  const Vector<T> v_A = v.first.known, v_BA = v.first.closing, v_B = v.v_X;
  const Vector<T> a_A = a.first.known, a_BA = a.first.normal + a.first.closing, a_B = a.a_X;
  const Vector<T> A0A = at.A - at.A0, AB = at.B - at.A;
  ledger.put(angular_velocity(2), [&] { return geometry::quotient(cross(A0A, v_A), length_squared(A0A)); });
  write_link_rates<T>(ledger, {v.first_rate, v.second_rate, a.first_rate, a.second_rate});
  ledger.put_length(velocity("A"), v_A);
  ledger.put_length(velocity("BA"), v_BA);
  ledger.put(velocity("B"), v_B);
  ledger.put_length(acceleration("A"), a_A);
  ledger.put_length(normal_acceleration("BA"), a.first.normal);
  ledger.put_length(tangential_acceleration("BA"), a.first.closing);
  ledger.put_length(normal_acceleration("B"), a.second.normal);
  ledger.put_length(tangential_acceleration("B"), a.second.closing);
  ledger.put(acceleration("B"), a_B);
  ledger.draws_vector("a_BA", a_BA);
  const T alpha_2 = geometry::radians<T>(of.instant.alpha_2);
  ledger.draws_vector("a_A_t", alpha_2 * quarter_turn(A0A));
  ledger.draws_vector("a_A_n", a_A - alpha_2 * quarter_turn(A0A));
  const MidpointMotion<T> images = midpoint_images(v_A, v_B, a_A, a_B);
  write_midpoint_motion(ledger, images);
  ledger.put(component_along_AB(), [&] { return component(dot(AB, images.a_G3), AB); });
  ledger.put(component_normal_to_AB(), [&] { return component(cross(AB, images.a_G3), AB); });
  ledger.put(part_normal_to_path(), [&] { return part_along(cross(images.v_G3, images.a_G3), images.v_G3); });
  ledger.put(part_along_path(), [&] { return part_along(dot(images.v_G3, images.a_G3), images.v_G3); });
  const T half = geometry::from_rational<T>(Rational(1, 2));
  ledger.put(normal_acceleration("G3A").length(), [&] { return size(half * a.first.normal); });
  ledger.put(tangential_acceleration("G3A").length(), [&] { return size(half * a.first.closing); });
  const T along = geometry::from_rational<T>(of.AP_along / of.instant.lengths.AB),
          across = geometry::from_rational<T>(of.AP_across / of.instant.lengths.AB);
  ledger.put(velocity("P"), v_A + (along * v_BA + across * quarter_turn(v_BA)));
  ledger.put(acceleration("P"), a_A + (along * a_BA + across * quarter_turn(a_BA)));
  write_second_order(ledger, at, P, motion.coupler, motion.coupler.inflection_pole());
}

// Of one configuration, the motion from the pole and the inflection circle; parts of vectors are projected on the
// bars and on the ray of G₃.
template <class T>
void by_poles(Ledger<T>& ledger, const Problem& of, const geometry::FourBar<T>& at, const Point<T>& P) {
  ledger.route("poles");
  const Point<T> G3 = midpoint(at.A, at.B);
  write_pole<T>(ledger, "P0", at.pole(), {{"A", at.A}, {"B", at.B}, {"G3", G3}}, crank_parallel_to_rocker);
  if (of.instant.pole_at_infinity) return;
  const T omega_2 = of.instant.omega_2<T>(), alpha_2 = geometry::radians<T>(of.instant.alpha_2);
  const auto found = motion_by_poles(at, omega_2, alpha_2);
  const geometry::PlaneMotion<T>& m = found.coupler;
  const Vector<T> AB = at.B - at.A, B0B = at.B - at.B0, ray = G3 - finite(at.pole());
  const Vector<T> v_BA = m.velocity(at.B) - m.v_A, a_B = m.acceleration(at.B), a_BA = a_B - m.a_A,
                  a_G3 = m.acceleration(G3), a_G3A = a_G3 - m.a_A;
  const auto projected = [](const T& product, const Vector<T>& bar) { return part_along(product, bar); };
  write_link_rates<T>(ledger, {m.omega, found.omega_4, m.alpha, found.alpha_4});
  ledger.put(velocity("A").length(), [&] { return size(m.v_A); });
  ledger.put(velocity("BA").length(), [&] { return size(v_BA); });
  ledger.put(velocity("B"), m.velocity(at.B));
  ledger.put(acceleration("A").length(), [&] { return size(m.a_A); });
  ledger.put(normal_acceleration("BA").length(), [&] { return projected(dot(AB, a_BA), AB); });
  ledger.put(tangential_acceleration("BA").length(), [&] { return projected(cross(AB, a_BA), AB); });
  ledger.put(normal_acceleration("B").length(), [&] { return projected(dot(B0B, a_B), B0B); });
  ledger.put(tangential_acceleration("B").length(), [&] { return projected(cross(B0B, a_B), B0B); });
  ledger.put(acceleration("B"), a_B);
  const geometry::PlaneMotion<T> crank = geometry::turning_about(at.A0, omega_2, alpha_2);
  write_midpoint_motion(ledger, midpoints_on_links(midpoints(at), crank, m,
                                                   geometry::turning_about(at.B0, found.omega_4, found.alpha_4)));
  ledger.put(component_along_AB(), [&] { return component(dot(AB, a_G3), AB); });
  ledger.put(component_normal_to_AB(), [&] { return component(cross(AB, a_G3), AB); });
  ledger.put(part_normal_to_path(), [&] { return part_along(dot(ray, a_G3), ray); });
  ledger.put(part_along_path(), [&] { return part_along(cross(ray, a_G3), ray); });
  ledger.put(normal_acceleration("G3A").length(), [&] { return projected(dot(AB, a_G3A), AB); });
  ledger.put(tangential_acceleration("G3A").length(), [&] { return projected(cross(AB, a_G3A), AB); });
  ledger.put(velocity("P"), m.velocity(P));
  ledger.put(acceleration("P"), m.acceleration(P));
  write_second_order(ledger, at, P, m, found.J);
  for (const auto& [name, X, centre] : {std::tuple{"A", at.A, at.A0}, std::tuple{"B", at.B, at.B0}}) {
    const auto on_ray = [&X = X, &centre = centre, &at] {
      return geometry::euler_savary_point(finite(at.pole()), X, centre);
    };
    ledger.tells(point_on_ray(name).x(), [&] { return on_ray().x; });
    ledger.tells(point_on_ray(name).y(), [&] { return on_ray().y; });
  }
}

template <class T>
void by_construction(Ledger<T>& ledger, const Problem& of, const HalfTurned& back) {
  const geometry::FourBar<T> at = of.instant.position<T>();
  const Point<T> P = coupler_point(of, at);
  ledger.route("construction");
  write_link_angles(ledger, link_directions(at), back);
  write_positions(ledger, at, P);
  // Of crank and rocker against the frame, and where the coupler's line meets that.
  ledger.draws_point("P24", meet(line(at.A, at.B), line(at.A0, at.B0)), coupler_parallel_to_frame);
  by_polar_diagram(ledger, of, at, P);
  by_poles(ledger, of, at, P);
}

template <class T>
void other_branch_by_construction(Ledger<T>& ledger, const FourBarInstant& other, const HalfTurned& back) {
  const geometry::FourBar<T> at = other.position<T>();
  const auto motion = motion_by_polar_diagram(at, other.omega_2<T>(), geometry::radians<T>(other.alpha_2));
  ledger.route("construction");
  ledger.draws_point("other_B", at.B);
  write_link_angles(ledger, link_directions(at), back, Configuration::other);
  ledger.route("polar diagram");
  write_link_rates<T>(ledger, {motion.coupler.omega, motion.omega_4, motion.coupler.alpha, motion.alpha_4},
                      Configuration::other);
}

template <class T>
struct Analysed {
  geometry::analytic::FourBarPosition<T> position;
  geometry::analytic::FourBarMotion<T> motion;

  LinkDirections<T> links() const { return {plane(position.coupler), plane(-position.rocker)}; }
};
template <class T>
Analysed<T> analysed(const FourBarInstant& instant) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = instant.analytic_lengths();
  const auto crank =
      analytic::crank_at<T>(instant.crank, instant.omega_2<T>(), geometry::radians<T>(instant.alpha_2));
  const auto position = analytic::position(g, crank, instant.analytic_branch());
  return {position, analytic::motion(g, crank, position)};
}

template <class T>
void write_analysed_links(Ledger<T>& ledger, const Analysed<T>& found, const HalfTurned& back, Configuration of) {
  write_link_angles(ledger, found.links(), back, of);
  const auto& m = found.motion;
  write_link_rates<T>(ledger, {m.omega_3, m.omega_4, m.alpha_3, m.alpha_4}, of);
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Problem& of, const HalfTurned& back) {
  namespace analytic = geometry::analytic;
  using Z = analytic::Complex<T>;
  const FourBarInstant& instant = of.instant;
  const analytic::FourBar g = instant.analytic_lengths();
  const Analysed<T> found = analysed<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
  const auto crank = analytic::crank(analytic::crank_at<T>(instant.crank, omega_2, alpha_2));
  const auto coupler = analytic::coupler(p, m);
  const auto rocker = analytic::rocker(g, m);
  const auto half = [](const Rational& length) { return Z{geometry::from_rational<T>(length / 2), T(0)}; };
  const Z G2 = analytic::crank_point(p, half(g.A0A)), G3 = analytic::coupler_point(p, half(g.AB)),
          G4 = analytic::rocker_point(g, p, half(g.B0B));
  const Z P = analytic::coupler_point(
      p, Z{geometry::from_rational<T>(of.AP_along), geometry::from_rational<T>(of.AP_across)});

  ledger.route("analytic");
  ledger.put(angular_velocity(2), omega_2);
  for (const auto& [name, X] : {std::pair{"A", p.A}, std::pair{"B", p.B}, std::pair{"G2", G2}, std::pair{"G3", G3},
                                std::pair{"G4", G4}, std::pair{"P", P}})
    put_point<T>(ledger, point(name), [&z = X] { return z; });
  write_analysed_links(ledger, found, back, Configuration::chosen);
  // Products of lengths and rates; G₃'s acceleration in the axes of AB and in those of its path.
  const T AB = geometry::from_rational<T>(g.AB), B0B = geometry::from_rational<T>(g.B0B),
          AG3 = geometry::from_rational<T>(g.AB / 2);
  const Z v_G3 = coupler.velocity(G3), a_G3 = coupler.acceleration(G3);
  const auto along_path = [&] {
    const T part = Ledger<T>::ratio(analytic::dot(v_G3, a_G3), analytic::dot(v_G3, v_G3), no_path);
    return part * v_G3;
  };
  ledger.put(velocity("A").length(), [&] { return size(plane(m.v_A)); });
  ledger.put(velocity("BA").length(), [&] { return size(plane(m.v_B - m.v_A)); });
  ledger.put(velocity("B"), plane(m.v_B));
  ledger.put(acceleration("A").length(), [&] { return size(plane(m.a_A)); });
  ledger.put(normal_acceleration("BA").length(), [&] { return magnitude_of(AB * geometry::square(m.omega_3)); });
  ledger.put(tangential_acceleration("BA").length(), [&] { return magnitude_of(AB * m.alpha_3); });
  ledger.put(normal_acceleration("B").length(), [&] { return magnitude_of(B0B * geometry::square(m.omega_4)); });
  ledger.put(tangential_acceleration("B").length(), [&] { return magnitude_of(B0B * m.alpha_4); });
  ledger.put(acceleration("B"), plane(m.a_B));
  const Z in_axes_of_AB = a_G3 * analytic::conjugate(p.coupler);
  ledger.put(component_along_AB(), in_axes_of_AB.re);
  ledger.put(component_normal_to_AB(), in_axes_of_AB.im);
  ledger.put(part_normal_to_path(), [&] { return size(plane(a_G3 - along_path())); });
  ledger.put(part_along_path(), [&] { return size(plane(along_path())); });
  ledger.put(normal_acceleration("G3A").length(), [&] { return magnitude_of(AG3 * geometry::square(m.omega_3)); });
  ledger.put(tangential_acceleration("G3A").length(), [&] { return magnitude_of(AG3 * m.alpha_3); });
  ledger.put(velocity("P"), plane(coupler.velocity(P)));
  ledger.put(acceleration("P"), plane(coupler.acceleration(P)));
  write_midpoint_motion<T>(ledger, {plane(crank.velocity(G2)), plane(v_G3), plane(rocker.velocity(G4)),
                                    plane(crank.acceleration(G2)), plane(a_G3), plane(rocker.acceleration(G4))});
  // k₁ cos θ₄ + k₂ sin θ₄ + k₃ = 0, with r₁ - r₂ e^{iθ₂} = r₃ e^{iθ₃} + r₄ e^{iθ₄}.
  const Z d = g.B0<T>() - p.A;
  ledger.tells(closure_coefficient(1), [&] { return T(T(-2) * B0B * d.re); });
  ledger.tells(closure_coefficient(2), [&] { return T(T(-2) * B0B * d.im); });
  ledger.tells(closure_coefficient(3),
               [&] { return T(analytic::dot(d, d) + geometry::square(B0B) - geometry::square(AB)); });
  const std::vector<Lettered<Z>> points{{"A", p.A}, {"B", p.B}, {"G3", G3}};
  write_pole<T>(ledger, "P0", coupler, points, crank_parallel_to_rocker);
  write_acceleration_pole<T>(ledger, coupler, points);
  write_circles(ledger, coupler);
  write_curvature<T>(ledger, coupler, {"G3", G3});
  write_curvature<T>(ledger, coupler, {"P", P});
}

// One configuration's links along -x, by both ways to find it.
struct Back {
  HalfTurned by_construction, by_analysis;

  explicit Back(const FourBarInstant& at)
      : by_construction(half_turned([&]<class T>() { return link_directions(at.position<T>()); })),
        by_analysis(half_turned([&]<class T>() { return analysed<T>(at).links(); })) {}
};

// What belongs to the whole turn is searched for once, and what is decided is decided once, for all numbers.
struct Routes {
  Problem of;
  FourBarInstant other;
  Back back, other_back;
  RatioByClosure by_closure;
  RatioByCentres by_centres;
  StationaryRatio<RatioByClosure> stationary_by_closure;
  StationaryRatio<RatioByCentres> stationary_by_centres;
  StationaryRatio<RatioByClosure> stationary_of_other;

  explicit Routes(const Problem& problem)
      : of(problem),
        other(on_other_branch(problem.instant)),
        back(of.instant),
        other_back(other),
        by_closure{of.instant.analytic_lengths(), of.instant.analytic_branch()},
        by_centres{of.instant.lengths, of.instant.side},
        stationary_by_closure(stationary_ratio(of.instant.lengths, by_closure)),
        stationary_by_centres(stationary_ratio(of.instant.lengths, by_centres)),
        stationary_of_other(
            stationary_ratio(other.lengths, RatioByClosure{other.analytic_lengths(), other.analytic_branch()})) {}

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    by_construction(ledger, of, back.by_construction);
    other_branch_by_construction(ledger, other, other_back.by_construction);
    ledger.route("construction");
    write_zeros_by_construction(ledger, of.instant);
    ledger.route("instant centres");
    write_extremes(ledger, by_centres, stationary_by_centres, of.instant);
    by_analysis(ledger, of, back.by_analysis);
    write_analysed_links(ledger, analysed<T>(other), other_back.by_analysis, Configuration::other);
    write_zeros_by_analysis(ledger, of.instant);
    write_extremes(ledger, by_closure, stationary_by_closure, of.instant);
    const geometry::FourBar<T> at = of.instant.position<T>();
    ledger.tells(theta_2_within_turn(), [&] { return degrees_for_drawing(at.A - at.A0); });
    write_for_chart(ledger, Configuration::chosen, by_closure, stationary_by_closure, of.instant);
    const RatioByClosure other_ratio{other.analytic_lengths(), other.analytic_branch()};
    write_for_chart(ledger, Configuration::other, other_ratio, stationary_of_other, other);
    return ledger;
  }
};

}  // namespace epure::four_bar_analytic
