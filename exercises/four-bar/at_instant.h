// The scene of the instant that the exercise asks for.
#pragma once

#include "exercises/four-bar/routes.h"
#include "exercises/kit/linkages/driving_crank.h"

namespace epure::four_bar {

namespace analytic = geometry::analytic;
using geometry::from_rational;

template <class T>
Configuration<T> with_plate(const geometry::FourBar<T>& at, const Problem& of, geometry::Side C_side) {
  return {at, geometry::right_angled_corner(at.A, at.B, of.instant.lengths.AB, of.AC, C_side)};
}

// The instant the exercise asks for.
struct AtInstant {
  const Problem& of;
  Back back;

  explicit AtInstant(const Problem& problem)
      : of(problem),
        back{half_turned([&]<class T>() { return link_directions(of.instant.position<T>()); }),
             half_turned([&]<class T>() { return analysis(crank_state<T>()).links(); })} {}

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const T omega_2 = instant.omega_2<T>(), alpha_2 = radians<T>(instant.alpha_2);
    const DrivenCrank<T> crank{instant.crank, instant.n, omega_2};
    const auto here = with_plate(instant.position<T>(), of, of.C_side);
    Ledger<T> ledger("construction");
    write_crank(ledger, crank, here.at.A);
    ledger.put("AC", [&] { return size(here.C - here.at.A); });
    ledger.put("BC", [&] { return size(here.C - here.at.B); });
    by_construction(ledger, here, back.by_construction, omega_2, alpha_2, instant.pole_at_infinity);
    mirrored_plate(ledger, here.at, motion_by_polar_diagram(here.at, omega_2, alpha_2).coupler);

    const auto state = crank_state<T>();
    by_analysis(ledger, analysis(state), back.by_analysis);
    write_crank(ledger, crank);
    ledger.put("AC", from_rational<T>(of.AC));
    ledger.put("BC", [&] { return side_BC<T>(); });
    mirrored_plate(ledger, state);
    return ledger;
  }

 private:
  template <class T>
  analytic::CrankState<T> crank_state() const {
    return analytic::crank_at<T>(of.instant.crank, of.instant.omega_2<T>(), radians<T>(of.instant.alpha_2));
  }
  template <class T>
  Analysed<T> analysis(const analytic::CrankState<T>& crank) const {
    return analysed(of, crank, of.instant.analytic_branch(), of.C_side);
  }
  // By Pythagoras; for signs its square.
  template <class T>
  T side_BC() const {
    const Rational& AB = of.instant.lengths.AB;
    const T squared = from_rational<T>((AB - of.AC) * (AB + of.AC));
    if constexpr (signs_only<T>) {
      return squared;
    } else {
      return geometry::root(squared);
    }
  }
  template <class T>
  void mirrored_plate(Ledger<T>& ledger, const geometry::FourBar<T>& at, const geometry::PlaneMotion<T>& m) const {
    const Point<T> C = with_plate(at, of, opposite(of.C_side)).C;
    ledger.begin_case("mirror_side_");
    ledger.point("C", C);
    ledger.put("a_C", [&] { return size(m.acceleration(C)); });
    ledger.distance("KC", m.acceleration_pole(), C, no_acceleration_pole);
    ledger.distance("rho_C", m.centre_of_curvature(C), C, unless_pole(m, C, no_curvature));
    ledger.distance("P31C", m.pole(), C, crank_parallel_to_rocker);
    ledger.begin_case("");
  }
  template <class T>
  void mirrored_plate(Ledger<T>& ledger, const analytic::CrankState<T>& crank) const {
    const auto found = analysed(of, crank, of.instant.analytic_branch(), opposite(of.C_side));
    const auto m = analytic::coupler(found.position, found.motion);
    ledger.begin_case("mirror_side_");
    put_point<T>(ledger, "C", [&] { return found.C; });
    put_length<T>(ledger, "a_C", [&] { return m.acceleration(found.C); });
    put_length<T>(ledger, "KC", [&] { return found.C - present(m.acceleration_pole(), no_acceleration_pole); });
    put_length<T>(ledger, "rho_C", [&] { return found.C - present(m.centre_of_curvature(found.C), no_curvature); });
    put_length<T>(ledger, "P31C", [&] { return found.C - present(m.pole(), crank_parallel_to_rocker); });
    ledger.begin_case("");
  }
};

}  // namespace epure::four_bar
