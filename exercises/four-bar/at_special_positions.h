// The scenes of the special positions: the rocker's dead centres and the stroke between them, crank and rocker
// parallel.
#pragma once

#include "exercises/four-bar/at_instant.h"
#include "geometry/analytic/four_bar_special.h"
#include "geometry/mechanisms/four_bar_positions.h"

namespace epure::four_bar {

using geometry::Reach;
using geometry::Sense;
using geometry::Side;

inline analytic::Branch analytic_branch(Side side) {
  return side == Side::left ? analytic::Branch::left : analytic::Branch::right;
}

inline Quantity time_ratio() {
  return {"time_ratio",
          "$τ$",
          "1",
          {"time of the slower stroke over the quicker", "tempo della corsa lenta su quella rapida"}};
}
// The same angle in radians, which is reported, and in degrees.
struct AngleOfStroke {
  std::string name, symbol;
  Words meaning;
  Quantity in(const std::string& unit) const {
    return {unit == "rad" ? name : name + "_deg", symbol, unit, meaning, true};
  }
};
inline AngleOfStroke rocker_swing() {
  return {"rocker_swing",
          "$Δθ_{4}$",
          {"swing of the rocker between its dead centres", "ampiezza del moto del bilanciere"}};
}
inline AngleOfStroke crank_rotation() {
  return {"crank_rotation_extended_to_folded",
          "$Δφ$",
          {"crank from the extended to the folded dead centre, counter-clockwise",
           "manovella dal punto morto esteso al ripiegato, antioraria"}};
}

// The direction of the crank, which no given states here.
template <class T>
void write_found_crank(Ledger<T>& ledger, const Vector<T>& crank) {
  const Words meaning{"angle of the crank, within a turn", "angolo della manovella, entro un giro"};
  ledger.put(Quantity{"crank_angle", "$φ$", "rad", meaning}, [&] { return angle_within_turn(crank); });
  ledger.put(Quantity{"crank_angle_deg", "$φ$", "deg", meaning},
             [&] { return in_degrees(angle_within_turn(crank)); });
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
  Case which;
  Reach reach;
  Back back;

  AtDeadCentre(const Problem& problem, Case of_case, Reach wanted)
      : of(problem),
        which(std::move(of_case)),
        reach(wanted),
        back{half_turned([&]<class T>() { return link_directions(construction<T>().at); }),
             half_turned([&]<class T>() { return analysis(analysed_crank<T>()).links(); })} {}

  template <class T>
  Ledger<T> operator()() const {
    const T omega_2 = of.instant.omega_2<T>(), alpha_2 = geometry::radians<T>(of.instant.alpha_2);
    const auto found = construction<T>();
    const Configuration<T> here = with_plate(found.at, of, of.C_side);
    Ledger<T> ledger("construction");
    ledger.begin_case(which.prefix, which.words);
    write_found_crank(ledger, found.crank);
    write_rocker_degrees(ledger, link_directions(found.at), back.by_construction);
    by_construction(ledger, here, back.by_construction);
    by_poles(ledger, here, omega_2, alpha_2, false);
    by_polar_diagram(ledger, here, omega_2, alpha_2);

    const auto crank = analysed_crank<T>();
    const auto analysed_here = analysis(crank);
    by_analysis(ledger, of, analysed_here, back.by_analysis);
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
    const auto dead_centre = reach == Reach::extended ? analytic::DeadCentre::extended : analytic::DeadCentre::folded;
    return analytic::crank_at_dead_centre<T>(of.instant.analytic_lengths(), dead_centre,
                                             of.instant.analytic_branch());
  }
  template <class T>
  Analysed<T> analysis(const analytic::Complex<T>& crank) const {
    const auto state =
        analytic::crank_along<T>(crank, of.instant.omega_2<T>(), geometry::radians<T>(of.instant.alpha_2));
    return analysed(of, state, of.instant.analytic_branch(), of.C_side);
  }
  template <class T>
  static void write_rocker_degrees(Ledger<T>& ledger, const LinkDirections<T>& links, const HalfTurned& back) {
    ledger.put(rocker_angle("deg"), [&] { return in_degrees(angle_or_half_turn(links.rocker, back.rocker)); });
  }
};

// Crank and rocker parallel.
struct AtParallel {
  const Problem& of;
  Case which;
  Sense sense;
  Side branch;

  template <class T>
  Ledger<T> operator()() const {
    const FourBarInstant& instant = of.instant;
    const T omega_2 = instant.omega_2<T>(), alpha_2 = geometry::radians<T>(instant.alpha_2);
    const auto found = geometry::parallel_position<T>(instant.lengths, sense, branch);
    const Configuration<T> here = with_plate(found.at, of, of.C_side);
    const auto& at = here.at;
    Ledger<T> ledger("construction");
    ledger.begin_case(which.prefix, which.words);
    write_found_crank(ledger, found.crank);
    for (const auto& X : here.points()) ledger.put(point(X.letter), X.at);
    ledger.draws_point("A0", at.A0);
    ledger.draws_point("B0", at.B0);
    ledger.draws_point("Q", at.A + (at.B0 - at.B));
    ledger.route("poles");
    const geometry::RotationAboutPole<T> turning(at.pole(), at.A, omega_2 * quarter_turn(at.A - at.A0));
    const Vector<T> v_B = turning.velocity(at.B);
    ledger.put(angular_velocity(3), turning.omega());
    ledger.put(angular_velocity(4), rate_of_rocker(at, v_B));
    ledger.put(velocity("B"), v_B);
    ledger.put(velocity("C"), turning.velocity(here.C));
    ledger.route("polar diagram");
    by_polygons(ledger, here, omega_2, alpha_2);

    const auto which_one = sense == Sense::same ? analytic::Parallel::same_sense : analytic::Parallel::opposite_sense;
    const auto crank =
        analytic::crank_parallel_to_rocker<T>(instant.analytic_lengths(), which_one, analytic_branch(branch));
    const auto analysis =
        analysed(of, analytic::crank_along<T>(crank, omega_2, alpha_2), analytic_branch(branch), of.C_side);
    ledger.route("analytic");
    write_found_crank(ledger, plane(crank));
    for (const auto& X : analysis.points()) put_point<T>(ledger, point(X.letter), [&] { return X.at; });
    links_by_analysis(ledger, of, analysis);
    return ledger;
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
    const Point<T>& B0 = extended.at.B0;
    Ledger<T> ledger("construction");
    const auto swing = [&] { return angle_between(extended.at.B - B0, folded.at.B - B0); };
    const Vector<T> turn{dot(extended.crank, folded.crank), cross(extended.crank, folded.crank)};
    const auto rotation = [&] { return angle_within_turn(turn); };
    ledger.put(rocker_swing().in("rad"), swing);
    ledger.put(crank_rotation().in("rad"), rotation);
    ledger.put(time_ratio(), [&] { return slower_to_quicker(rotation()); });
    ledger.tells(rocker_swing().in("deg"), [&] { return in_degrees(swing()); });
    ledger.tells(crank_rotation().in("deg"), [&] { return in_degrees(rotation()); });

    ledger.route("analytic");
    const auto put = [&](const Quantity& quantity, const T analytic::RockerStroke<T>::*part) {
      ledger.put(quantity, [&]() -> T {
        if constexpr (signs_only<T>) {
          throw geometry::Undecided("an angle has no exact value", "un angolo non ha un valore esatto");
        } else {
          return analytic::rocker_stroke<T>(instant.analytic_lengths(), instant.analytic_branch()).*part;
        }
      });
    };
    put(rocker_swing().in("rad"), &analytic::RockerStroke<T>::swing);
    put(crank_rotation().in("rad"), &analytic::RockerStroke<T>::crank_rotation);
    put(time_ratio(), &analytic::RockerStroke<T>::time_ratio);
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
