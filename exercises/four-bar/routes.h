// The four-bar's quantities by polar diagram, by poles and by analysis.
#pragma once

#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/four_bar_routes.h"
#include "exercises/kit/linkages/half_turned.h"

namespace epure::four_bar {

using geometry::Point;
using geometry::Vector;

// With its sign, in (-90°, 90°).
template <class T>
T gamma(const T& omega_3, const T& alpha_3) {
  return in_degrees(slope_angle(Vector<T>{geometry::square(omega_3), alpha_3}));
}

inline constexpr Phrase no_value_of_gamma{"tan γ has no value: ω₃ and α₃ are zero",
                                          "tan γ non ha valore: ω₃ e α₃ sono zero"};
inline constexpr Phrase no_gamma{"tan γ grows beyond all bounds: ω₃ is zero",
                                 "tan γ cresce oltre ogni limite: ω₃ è zero"};
template <class T>
void write_velocities(Ledger<T>& ledger, const Vector<T>& v_A, const Vector<T>& v_B, const Vector<T>& v_C,
                      const T& omega_3, const T& omega_4) {
  ledger.put("v_A", [&] { return size(v_A); });
  ledger.put("omega_3", omega_3);
  ledger.put("omega_4", omega_4);
  ledger.put("v_BA", [&] { return size(v_B - v_A); });
  ledger.vector("v_B", v_B);
  ledger.vector("v_C", v_C);
}

// All accelerations, from the motion of the coupler and the rates of the rocker.
template <class T>
struct Accelerations {
  Vector<T> a_A, a_B, a_C, v_C, AB, AC, B0B;
  T omega_3, alpha_3, omega_4, alpha_4;

  void write(Ledger<T>& ledger) const {
    using geometry::square;
    ledger.put("alpha_3", alpha_3);
    ledger.put("alpha_4", alpha_4);
    ledger.put("tan_gamma", [&] {
      const bool is_open = geometry::sign(alpha_3) == geometry::Sign::zero;
      return ledger.ratio(alpha_3, square(omega_3), is_open ? no_value_of_gamma : no_gamma);
    });
    ledger.put("gamma_deg", [&] { return gamma(omega_3, alpha_3); });
    ledger.put("a_A", [&] { return size(a_A); });
    ledger.put("a_B_n", [&] { return size(square(omega_4) * B0B); });
    ledger.put("a_B_t", [&] { return size(alpha_4 * B0B); });
    ledger.put("a_BA_n", [&] { return size(square(omega_3) * AB); });
    ledger.put("a_BA_t", [&] { return size(alpha_3 * AB); });
    ledger.put("a_CA_n", [&] { return size(square(omega_3) * AC); });
    ledger.put("a_CA_t", [&] { return size(alpha_3 * AC); });
    ledger.put("a_C_n", [&] { return part_along(cross(v_C, a_C), v_C); });
    ledger.put("a_C_t", [&] { return part_along(dot(v_C, a_C), v_C); });
    ledger.vector("a_B", a_B);
    ledger.vector("a_C", a_C);
  }
};

// A position of the linkage, found by construction or by analysis, with the plate's corner.
template <class T>
struct Configuration {
  geometry::FourBar<T> at;
  Point<T> C;
};

// By whichever construction the motion was found.
template <class T>
void write_motion(Ledger<T>& ledger, const Configuration<T>& place, const CouplerAndRocker<T>& motion) {
  const auto& [at, C] = place;
  const geometry::PlaneMotion<T>& m = motion.coupler;
  write_velocities(ledger, m.v_A, m.velocity(at.B), m.velocity(C), m.omega, motion.omega_4);
  Accelerations<T>{m.a_A,         m.acceleration(at.B), m.acceleration(C), m.velocity(C), at.B - at.A,
                   C - at.A,      at.B - at.B0,         m.omega,           m.alpha,       motion.omega_4,
                   motion.alpha_4}
      .write(ledger);
  write_acceleration_pole<T>(ledger, m, {{"A", at.A}, {"B", at.B}, {"C", C}});
  write_circles(ledger, m, motion.J);
  write_curvature<T>(ledger, m, {"C", C});
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
  ledger.put("coupler_angle", [&] { return angle_or_half_turn(links.coupler, back.coupler); });
  ledger.put("rocker_angle", [&] { return angle_or_half_turn(links.rocker, back.rocker); });
}

// Position, and the motion by both constructions.
template <class T>
void by_construction(Ledger<T>& ledger, const Configuration<T>& place, const HalfTurned& back, const T& omega_2,
                     const T& alpha_2, bool pole_at_infinity) {
  const auto& [at, C] = place;
  ledger.route("construction");
  ledger.point("A", at.A);
  ledger.point("B", at.B);
  ledger.point("C", C);
  write_link_angles(ledger, link_directions(at), back);
  ledger.route("poles");
  write_pole<T>(ledger, "P31", at.pole(), {{"A", at.A}, {"B", at.B}, {"C", C}}, crank_parallel_to_rocker);
  if (!pole_at_infinity) write_motion(ledger, place, motion_by_poles(at, omega_2, alpha_2));
  ledger.route("polar diagram");
  write_motion(ledger, place, motion_by_polar_diagram(at, omega_2, alpha_2));
}

template <class T>
struct Analysed {
  geometry::analytic::FourBarPosition<T> position;
  geometry::analytic::FourBarMotion<T> motion;
  geometry::analytic::Complex<T> C, B0;

  LinkDirections<T> links() const { return {plane(position.coupler), plane(position.rocker)}; }
};

// `C_side` apart, so that the plate's mirror image can be asked for.
template <class T>
Analysed<T> analysed(const Problem& of, const geometry::analytic::CrankState<T>& crank,
                     geometry::analytic::Branch branch, geometry::Side C_side) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = of.instant.analytic_lengths();
  const auto position = analytic::position(g, crank, branch);
  const auto side = C_side == geometry::Side::left ? analytic::Side::left : analytic::Side::right;
  const auto C = analytic::coupler_point(position, analytic::right_angled_plate_point<T>(g, of.AC, side));
  return {position, analytic::motion(g, crank, position), C, g.B0<T>()};
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Analysed<T>& found, const HalfTurned& back) {
  namespace analytic = geometry::analytic;
  const auto& p = found.position;
  const auto& m = found.motion;
  const analytic::PlaneMotion<T> coupler = analytic::coupler(p, m);
  ledger.route("analytic");
  put_point<T>(ledger, "A", [&] { return p.A; });
  put_point<T>(ledger, "B", [&] { return p.B; });
  put_point<T>(ledger, "C", [&] { return found.C; });
  write_link_angles(ledger, found.links(), back);
  const std::vector<Lettered<analytic::Complex<T>>> points{{"A", p.A}, {"B", p.B}, {"C", found.C}};
  write_pole<T>(ledger, "P31", coupler, points, crank_parallel_to_rocker);
  const Vector<T> v_C = plane(coupler.velocity(found.C));
  write_velocities(ledger, plane(m.v_A), plane(m.v_B), v_C, m.omega_3, m.omega_4);
  Accelerations<T>{plane(m.a_A),
                   plane(m.a_B),
                   plane(coupler.acceleration(found.C)),
                   v_C,
                   plane(p.B - p.A),
                   plane(found.C - p.A),
                   plane(p.B - found.B0),
                   m.omega_3,
                   m.alpha_3,
                   m.omega_4,
                   m.alpha_4}
      .write(ledger);
  write_acceleration_pole<T>(ledger, coupler, points);
  write_circles(ledger, coupler);
  write_curvature<T>(ledger, coupler, {"C", found.C});
}

}  // namespace epure::four_bar
