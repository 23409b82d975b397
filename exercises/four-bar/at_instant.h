// The scene of the instant that the exercise asks for.
#pragma once

#include "exercises/four-bar/routes.h"
#include "exercises/kit/linkages/driving_crank.h"

namespace epure::four_bar {

struct AtInstant {
  const Problem& of;
  Back back;

  explicit AtInstant(const Problem& problem)
      : of(problem),
        back{half_turned([&]<class T>() { return link_directions(of.instant.position<T>()); }),
             half_turned([&]<class T>() { return analysis<T>(of.C_side).links(); })} {}

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
    const DrivenCrank<T> crank{instant.crank, instant.n, omega_2};
    const auto here = with_plate(instant.position<T>(), of, of.C_side);
    Ledger<T> ledger("construction");
    write_crank(ledger, crank, here.at.A);
    ledger.put(AC(), [&] { return size(here.C - here.at.A); });
    ledger.put(BC(), [&] { return size(here.C - here.at.B); });
    by_construction(ledger, here, back.by_construction);
    by_poles(ledger, here, omega_2, alpha_2, instant.pole_at_infinity);
    by_polar_diagram(ledger, here, omega_2, alpha_2);
    mirrored_plate(ledger, here.at, motion_by_polar_diagram(here.at, omega_2, alpha_2).coupler);

    by_analysis(ledger, of, analysis<T>(of.C_side), back.by_analysis);
    write_crank(ledger, crank);
    ledger.put(AC(), from_rational<T>(of.AC));
    ledger.put(BC(), [&] { return by_pythagoras<T>(); });
    mirrored_plate(ledger, analysis<T>(opposite(of.C_side)));
    return ledger;
  }

 private:
  static Quantity AC() { return side("AC", {"side AC of the plate", "lato AC della piastra"}); }
  static Quantity BC() { return side("BC", {"side BC of the plate", "lato BC della piastra"}); }

  template <class T>
  Analysed<T> analysis(geometry::Side C_side) const {
    const auto crank =
        analytic::crank_at<T>(of.instant.crank, of.instant.omega_2<T>(), geometry::radians<T>(of.instant.alpha_2));
    return analysed(of, crank, of.instant.analytic_branch(), C_side);
  }
  // For signs the square.
  template <class T>
  T by_pythagoras() const {
    const Rational& AB = of.instant.lengths.AB;
    const T squared = from_rational<T>((AB - of.AC) * (AB + of.AC));
    if constexpr (signs_only<T>) {
      return squared;
    } else {
      return geometry::root(squared);
    }
  }

  template <class T>
  static void begin_mirrored(Ledger<T>& ledger) {
    ledger.begin_case("mirror_side_", {", C on the other side of AB", ", C dall'altra parte di AB"});
  }
  template <class T>
  void mirrored_plate(Ledger<T>& ledger, const geometry::FourBar<T>& at, const geometry::PlaneMotion<T>& m) const {
    const Point<T> C = with_plate(at, of, opposite(of.C_side)).C;
    begin_mirrored(ledger);
    ledger.put(point("C"), C);
    ledger.put(acceleration("C").length(), [&] { return size(m.acceleration(C)); });
    ledger.distance(distance("K", "C"), m.acceleration_pole(), C, no_acceleration_pole);
    ledger.distance(radius_of_curvature("C"), m.centre_of_curvature(C), C, unless_pole(m, C, no_curvature));
    ledger.distance(distance("P31", "C"), m.pole(), C, crank_parallel_to_rocker);
    ledger.begin_case("");
  }
  template <class T>
  void mirrored_plate(Ledger<T>& ledger, const Analysed<T>& found) const {
    const auto& C = found.C;
    const auto m = analytic::coupler(found.position, found.motion);
    begin_mirrored(ledger);
    put_point<T>(ledger, point("C"), [&] { return C; });
    put_length<T>(ledger, acceleration("C").length(), [&] { return m.acceleration(C); });
    put_length<T>(ledger, distance("K", "C"),
                  [&] { return C - present(m.acceleration_pole(), no_acceleration_pole); });
    put_length<T>(ledger, radius_of_curvature("C"),
                  [&] { return C - present(m.centre_of_curvature(C), no_curvature); });
    put_length<T>(ledger, distance("P31", "C"), [&] { return C - present(m.pole(), crank_parallel_to_rocker); });
    ledger.begin_case("");
  }
};

}  // namespace epure::four_bar
