// The four-bar's quantities by construction, polar diagram and poles, and by analysis.
#pragma once

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/four-bar-analytic/extremes.h"
#include "exercises/kit/linkages/four_bar_on_x.h"
#include "exercises/kit/linkages/four_bar_routes.h"

namespace epure::four_bar_analytic {

using geometry::Point;
using geometry::Vector;

template <class T>
void write_positions(Ledger<T>& ledger, const geometry::FourBar<T>& at, const Point<T>& P) {
  const Midpoints<T> G = midpoints(at);
  ledger.point("A", at.A);
  ledger.point("B", at.B);
  ledger.point("G2", G.G2);
  ledger.point("G3", G.G3);
  ledger.point("G4", G.G4);
  ledger.point("P", P);
}

// Velocities and accelerations of the pins, of G₃ in parts, and of P.
template <class T>
struct PinMotion {
  Vector<T> v_A, v_B, a_A, a_B, v_G3, a_G3, v_P, a_P;
  Vector<T> AB, B0B;
  LinkRates<T> rates;

  void write(Ledger<T>& ledger) const {
    using geometry::square;
    const T half = geometry::from_rational<T>(Rational(1, 2));
    ledger.put("v_A", [&] { return size(v_A); });
    ledger.put("v_BA", [&] { return size(v_B - v_A); });
    ledger.vector("v_B", v_B);
    ledger.put("a_A", [&] { return size(a_A); });
    ledger.put("a_BA_n", [&] { return size(square(rates.omega_3) * AB); });
    ledger.put("a_BA_t", [&] { return size(rates.alpha_3 * AB); });
    ledger.put("a_B_n", [&] { return size(square(rates.omega_4) * B0B); });
    ledger.put("a_B_t", [&] { return size(rates.alpha_4 * B0B); });
    ledger.vector("a_B", a_B);
    ledger.put("a_G3_component_along_AB", [&] { return component(dot(AB, a_G3)); });
    ledger.put("a_G3_component_normal_to_AB", [&] { return component(cross(AB, a_G3)); });
    ledger.put("a_G3_path_normal", [&] { return part_along(cross(v_G3, a_G3), v_G3); });
    ledger.put("a_G3_path_tangential", [&] { return part_along(dot(v_G3, a_G3), v_G3); });
    ledger.put("a_G3A_n", [&] { return size(square(rates.omega_3) * (half * AB)); });
    ledger.put("a_G3A_t", [&] { return size(rates.alpha_3 * (half * AB)); });
    ledger.vector("v_P", v_P);
    ledger.vector("a_P", a_P);
  }

 private:
  // Of a product with AB, which is not zero; for signs the product itself.
  T component(const T& product) const {
    if constexpr (signs_only<T>) {
      return product;
    } else {
      return geometry::quotient(product, geometry::length(AB));
    }
  }
};

// By whichever construction the coupler's motion was found.
template <class T>
void write_motion(Ledger<T>& ledger, const geometry::FourBar<T>& at, const Point<T>& P,
                  const CouplerAndRocker<T>& found) {
  const geometry::PlaneMotion<T>& m = found.coupler;
  const LinkRates<T> rates{m.omega, found.omega_4, m.alpha, found.alpha_4};
  const Point<T> G3 = midpoint(at.A, at.B);
  write_link_rates(ledger, rates);
  PinMotion<T>{m.v_A,          m.velocity(at.B),   m.a_A,         m.acceleration(at.B),
               m.velocity(G3), m.acceleration(G3), m.velocity(P), m.acceleration(P),
               at.B - at.A,    at.B - at.B0,       rates}
      .write(ledger);
  write_acceleration_pole<T>(ledger, m, {{"A", at.A}, {"B", at.B}, {"G3", G3}});
  write_circles(ledger, m, found.J);
  write_curvature<T>(ledger, m, {"G3", G3});
  write_curvature<T>(ledger, m, {"P", P});
}

template <class T>
void by_construction(Ledger<T>& ledger, const Problem& of, const HalfTurned& back) {
  const FourBarInstant& instant = of.instant;
  const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
  const geometry::FourBar<T> at = instant.position<T>();
  const Point<T> P = coupler_point(of, at);
  ledger.route("construction");
  write_positions(ledger, at, P);
  write_link_angles(ledger, link_directions(at), back);

  ledger.route("polar diagram");
  const auto diagram = motion_by_polar_diagram(at, omega_2, alpha_2);
  const geometry::PlaneMotion<T> crank = geometry::turning_about(at.A0, omega_2, alpha_2);
  const Vector<T> v_A = crank.velocity(at.A), a_A = crank.acceleration(at.A);
  ledger.put("omega_2", [&] { return geometry::quotient(cross(at.A - at.A0, v_A), length_squared(at.A - at.A0)); });
  write_motion(ledger, at, P, diagram);
  write_midpoint_motion(
      ledger, midpoint_images(v_A, diagram.coupler.velocity(at.B), a_A, diagram.coupler.acceleration(at.B)));

  ledger.route("poles");
  write_pole<T>(ledger, "P0", at.pole(), {{"A", at.A}, {"B", at.B}, {"G3", midpoint(at.A, at.B)}},
                crank_parallel_to_rocker);
  if (instant.pole_at_infinity) return;
  const auto poles = motion_by_poles(at, omega_2, alpha_2);
  write_motion(ledger, at, P, poles);
  write_midpoint_motion(ledger, midpoints_on_links(midpoints(at), crank, poles.coupler,
                                                   geometry::turning_about(at.B0, poles.omega_4, poles.alpha_4)));
}

template <class T>
void other_branch_by_construction(Ledger<T>& ledger, const FourBarInstant& other, const HalfTurned& back) {
  const geometry::FourBar<T> at = other.position<T>();
  const auto motion = motion_by_polar_diagram(at, other.omega_2<T>(), geometry::radians<T>(other.alpha_2));
  ledger.route("construction");
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
  ledger.put("omega_2", omega_2);
  for (const auto& [name, X] : {std::pair{"A", p.A}, std::pair{"B", p.B}, std::pair{"G2", G2}, std::pair{"G3", G3},
                                std::pair{"G4", G4}, std::pair{"P", P}})
    put_point<T>(ledger, name, [&z = X] { return z; });
  write_analysed_links(ledger, found, back, Configuration::chosen);
  PinMotion<T>{plane(m.v_A),
               plane(m.v_B),
               plane(m.a_A),
               plane(m.a_B),
               plane(coupler.velocity(G3)),
               plane(coupler.acceleration(G3)),
               plane(coupler.velocity(P)),
               plane(coupler.acceleration(P)),
               plane(p.B - p.A),
               plane(p.B - g.B0<T>()),
               {m.omega_3, m.omega_4, m.alpha_3, m.alpha_4}}
      .write(ledger);
  write_midpoint_motion<T>(
      ledger, {plane(crank.velocity(G2)), plane(coupler.velocity(G3)), plane(rocker.velocity(G4)),
               plane(crank.acceleration(G2)), plane(coupler.acceleration(G3)), plane(rocker.acceleration(G4))});
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

  explicit Routes(const Problem& problem)
      : of(problem),
        other(on_other_branch(problem.instant)),
        back(of.instant),
        other_back(other),
        by_closure{of.instant.analytic_lengths(), of.instant.analytic_branch()},
        by_centres{of.instant.lengths, of.instant.side},
        stationary_by_closure(stationary_ratio(of.instant.lengths, by_closure)),
        stationary_by_centres(stationary_ratio(of.instant.lengths, by_centres)) {}

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
    return ledger;
  }
};

}  // namespace epure::four_bar_analytic
