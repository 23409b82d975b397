// The scenes of the special positions: the rocker's dead centres and the stroke between them, crank and rocker
// parallel.
#pragma once

#include "exercises/four-bar/at_instant.h"
#include "geometry/analytic/four_bar_special.h"
#include "geometry/mechanisms/four_bar_positions.h"

namespace epure::four_bar {

namespace analytic = geometry::analytic;
using geometry::from_rational;
using geometry::Reach;
using geometry::Sense;
using geometry::Side;

inline analytic::Branch analytic_branch(Side side) {
  return side == Side::left ? analytic::Branch::left : analytic::Branch::right;
}

template <class T>
void write_found_crank(Ledger<T>& ledger, const Vector<T>& crank) {
  ledger.put("crank_angle", [&] { return angle_within_turn(crank); });
  ledger.put("crank_angle_deg", [&] { return in_degrees(angle_within_turn(crank)); });
}

// Whether the rocker is in line with a crank and coupler that are: then the position is a change point. Throws
// Impossible when there is no such dead centre.
inline bool is_change_point(const Problem& of, Reach reach) {
  return geometry::decide([&]<class T>() {
           const auto at = geometry::dead_centre<T>(of.instant.lengths, reach, of.instant.side).at;
           return cross(at.B - at.A, at.B - at.B0);
         }).sign == geometry::Sign::zero;
}

// The rocker at rest.
struct AtDeadCentre {
  const Problem& of;
  std::string prefix;
  Reach reach;
  Back back;

  AtDeadCentre(const Problem& problem, std::string named, Reach wanted)
      : of(problem),
        prefix(std::move(named)),
        reach(wanted),
        back{half_turned([&]<class T>() { return link_directions(construction<T>().at); }),
             half_turned([&]<class T>() { return analysis(analysed_crank<T>()).links(); })} {}

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const auto found = construction<T>();
    Ledger<T> ledger("construction");
    ledger.begin_case(prefix);
    write_found_crank(ledger, found.crank);
    write_rocker_degrees(ledger, link_directions(found.at), back.by_construction);
    by_construction(ledger, with_plate(found.at, of, of.C_side), back.by_construction, instant.omega_2<T>(),
                    radians<T>(instant.alpha_2), false);

    const auto crank = analysed_crank<T>();
    const auto analysed_here = analysis(crank);
    by_analysis(ledger, analysed_here, back.by_analysis);
    write_found_crank(ledger, plane(crank));
    write_rocker_degrees(ledger, analysed_here.links(), back.by_analysis);
    return ledger;
  }

 private:
  template <class T>
  geometry::FourBarPosition<T> construction() const {
    return geometry::dead_centre<T>(of.instant.lengths, reach, of.instant.side);
  }
  template <class T>
  analytic::Complex<T> analysed_crank() const {
    const auto which = reach == Reach::extended ? analytic::DeadCentre::extended : analytic::DeadCentre::folded;
    return analytic::crank_at_dead_centre<T>(of.instant.analytic_lengths(), which, of.instant.analytic_branch());
  }
  template <class T>
  Analysed<T> analysis(const analytic::Complex<T>& crank) const {
    const auto state = analytic::crank_along<T>(crank, of.instant.omega_2<T>(), radians<T>(of.instant.alpha_2));
    return analysed(of, state, of.instant.analytic_branch(), of.C_side);
  }
  template <class T>
  static void write_rocker_degrees(Ledger<T>& ledger, const LinkDirections<T>& links, const HalfTurned& back) {
    ledger.put("rocker_angle_deg", [&] { return in_degrees(angle_or_half_turn(links.rocker, back.rocker)); });
  }
};

// Crank and rocker parallel.
struct AtParallel {
  const Problem& of;
  std::string prefix;
  Sense sense;
  Side branch;

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const T omega_2 = instant.omega_2<T>(), alpha_2 = radians<T>(instant.alpha_2);
    const auto found = geometry::parallel_position<T>(instant.lengths, sense, branch);
    Ledger<T> ledger("construction");
    ledger.begin_case(prefix);
    write_found_crank(ledger, found.crank);
    ledger.point("A", found.at.A);
    ledger.point("B", found.at.B);
    ledger.route("poles");
    const Vector<T> v_A = omega_2 * quarter_turn(found.at.A - found.at.A0);
    const geometry::RotationAboutPole<T> turning(found.at.pole(), found.at.A, v_A);
    ledger.put("omega_3", turning.omega());
    ledger.put("omega_4", rate_of_rocker(found.at, turning.velocity(found.at.B)));
    ledger.route("polar diagram");
    const auto motion = motion_by_polar_diagram(found.at, omega_2, alpha_2);
    write_rates(ledger, motion.coupler.omega, motion.omega_4, motion.coupler.alpha, motion.alpha_4);

    const auto which = sense == Sense::same ? analytic::Parallel::same_sense : analytic::Parallel::opposite_sense;
    const auto crank =
        analytic::crank_parallel_to_rocker<T>(instant.analytic_lengths(), which, analytic_branch(branch));
    const auto analysis =
        analysed(of, analytic::crank_along<T>(crank, omega_2, alpha_2), analytic_branch(branch), of.C_side);
    ledger.route("analytic");
    write_found_crank(ledger, plane(crank));
    put_point<T>(ledger, "A", [&] { return analysis.position.A; });
    put_point<T>(ledger, "B", [&] { return analysis.position.B; });
    const auto& m = analysis.motion;
    write_rates(ledger, m.omega_3, m.omega_4, m.alpha_3, m.alpha_4);
    return ledger;
  }

 private:
  template <class T>
  static void write_rates(Ledger<T>& ledger, const T& omega_3, const T& omega_4, const T& alpha_3, const T& alpha_4) {
    ledger.put("omega_3", omega_3);
    ledger.put("omega_4", omega_4);
    ledger.put("alpha_3", alpha_3);
    ledger.put("alpha_4", alpha_4);
  }
};

// From one dead centre to the other.
struct Stroke {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const auto extended = geometry::dead_centre<T>(instant.lengths, Reach::extended, instant.side);
    const auto folded = geometry::dead_centre<T>(instant.lengths, Reach::folded, instant.side);
    const auto& [A0, A, B, B0] = extended.at;
    Ledger<T> ledger("construction");
    ledger.put("rocker_swing", angle_between(B - B0, folded.at.B - B0));
    const Vector<T> turn{dot(extended.crank, folded.crank), cross(extended.crank, folded.crank)};
    const T rotation = angle_within_turn(turn);
    ledger.put("crank_rotation_extended_to_folded", rotation);
    ledger.put("time_ratio", [&] { return slower_to_quicker(rotation); });

    ledger.route("analytic");
    const auto of_stroke = [&](const T analytic::RockerStroke<T>::*part) -> T {
      if constexpr (signs_only<T>) {
        throw geometry::Undecided("an angle has no exact value", "un angolo non ha un valore esatto");
      } else {
        return analytic::rocker_stroke<T>(instant.analytic_lengths(), instant.analytic_branch()).*part;
      }
    };
    ledger.put("rocker_swing", [&] { return of_stroke(&analytic::RockerStroke<T>::swing); });
    ledger.put("crank_rotation_extended_to_folded",
               [&] { return of_stroke(&analytic::RockerStroke<T>::crank_rotation); });
    ledger.put("time_ratio", [&] { return of_stroke(&analytic::RockerStroke<T>::time_ratio); });
    return ledger;
  }

 private:
  template <class T>
  static T slower_to_quicker(const T& rotation) {
    if constexpr (signs_only<T>) {
      return T(1);
    } else {
      // Both strokes differ from a half turn by as much, which may be nothing.
      const T half_turn = geometry::pi<T>(), more = geometry::root(geometry::square(rotation - half_turn));
      return geometry::quotient(half_turn + more, half_turn - more);
    }
  }
};

}  // namespace epure::four_bar
