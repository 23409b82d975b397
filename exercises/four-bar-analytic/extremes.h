// ω₄ over a full turn of the crank at constant speed: its zeros and extremes, each found twice.
#pragma once

#include "exercises/kit/angles.h"
#include "exercises/kit/four_bar.h"
#include "geometry/analytic/four_bar_special.h"
#include "geometry/curves/zeros.h"
#include "geometry/mechanisms/collineation_axis.h"
#include "geometry/mechanisms/four_bar_positions.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epure::four_bar_analytic {

// By the closure equation: the ratio ω₄/ω₂, and its derivative by the crank's angle, which is α₄ at ω₂ = 1, α₂ = 0.
struct RatioByClosure {
  geometry::analytic::FourBar linkage;
  geometry::analytic::Branch branch;

  template <class T>
  geometry::analytic::FourBarMotion<T> at(const geometry::Vector<T>& crank) const {
    const geometry::analytic::CrankState<T> state{crank.x, crank.y, T(1), T(0)};
    return geometry::analytic::motion(linkage, state, geometry::analytic::position(linkage, state, branch));
  }
  template <class T>
  T ratio(const geometry::Vector<T>& crank) const {
    return at(crank).omega_4;
  }
  template <class T>
  T operator()(const geometry::Vector<T>& crank) const {
    return at(crank).alpha_4;
  }
};

// By the instant centres, and Freudenstein's theorem.
struct RatioByCentres : geometry::CollineationAxisAcrossCoupler {
  template <class T>
  T ratio(const geometry::Vector<T>& crank) const {
    return geometry::velocity_ratio_by_centres(geometry::four_bar(of, crank, side));
  }
};

// The directions in which the ratio is stationary, found once for all numbers; or why it has no extremes.
struct StationaryRatio {
  geometry::Zeros directions = {};
  Words why_not = {};
};

inline Words why_no_extremes(const geometry::FourBarLengths& of) {
  if (!geometry::crank_turns_fully(of))
    return {"the crank cannot turn fully: omega_4 grows beyond all bounds towards its limit positions",
            "la manovella non può fare un giro completo: omega_4 cresce oltre ogni limite verso le posizioni limite"};
  if (geometry::grashof(of).is == geometry::LinkageClass::change_point)
    return {"the linkage folds flat within a turn, and omega_4 is not determined there",
            "il meccanismo si appiattisce entro un giro, e lì omega_4 non è determinata"};
  return {};
}

template <class Ratio>
StationaryRatio stationary_ratio(const geometry::FourBarLengths& of, const Ratio& ratio) {
  Words why_not = why_no_extremes(of);
  if (!why_not.empty()) return {{}, std::move(why_not)};
  geometry::Zeros directions = geometry::zeros(ratio);
  geometry::place_on_axes(ratio, directions);
  return {std::move(directions), {}};
}

enum class Extreme { greatest, least };

// Where ω₄ is extreme. Throws Undecided when the search left something open, or two extremes cannot be told apart.
template <class T, class Ratio>
geometry::Vector<T> direction_of_extreme(const Ratio& ratio, const StationaryRatio& stationary, Extreme which,
                                         const T& omega_2) {
  if (!stationary.why_not.empty()) throw geometry::Impossible(stationary.why_not);
  if (!stationary.directions.open.empty() || stationary.directions.found.empty())
    throw geometry::Undecided("where the rocker's speed is stationary",
                              "dove sia stazionaria la velocità del bilanciere");
  std::optional<geometry::Vector<T>> best;
  for (const geometry::Zero& zero : stationary.directions.found) {
    const auto here = geometry::direction_of<T>(ratio, zero);
    if (!best) {
      best = here;
      continue;
    }
    const geometry::Sign greater = geometry::sign(omega_2 * (ratio.ratio(here) - ratio.ratio(*best)));
    if (greater == geometry::Sign::undecided || greater == geometry::Sign::zero)
      throw geometry::Undecided("which of two extremes of the rocker's speed is the greater",
                                "quale di due estremi della velocità del bilanciere sia il maggiore");
    if ((greater == geometry::Sign::positive) == (which == Extreme::greatest)) best = here;
  }
  return *best;
}

template <class T, class Ratio>
void write_extremes(Ledger<T>& ledger, const Ratio& ratio, const StationaryRatio& stationary, const T& omega_2) {
  for (const auto& [name, which] : {std::pair{"omega_4_max", Extreme::greatest}, {"omega_4_min", Extreme::least}}) {
    const auto direction = [&, extreme = which] {
      return direction_of_extreme<T>(ratio, stationary, extreme, omega_2);
    };
    ledger.put(name, [&] { return T(omega_2 * ratio.ratio(direction())); });
    ledger.put(std::string("theta_2_at_") + name + "_deg",
               [&] { return in_degrees(angle_within_turn(direction())); });
  }
}

// The dead centres of the branch as they follow in a turn from +x: the extended one lies above the frame when B is on
// the left of A -> B₀, the folded one below. (`extended` and `folded` throw Impossible where there is none.)
template <class T, class Extended, class Folded>
void write_zeros(Ledger<T>& ledger, bool extended_first, const Extended& extended, const Folded& folded) {
  const auto zero = [&](std::size_t number) {
    std::vector<geometry::Vector<T>> found;
    Words why_not;
    for (const bool is_extended : {extended_first, !extended_first}) {
      try {
        const geometry::Vector<T> crank = is_extended ? extended() : folded();
        if (geometry::sign(crank.y) == geometry::Sign::zero)
          throw geometry::Impossible("all hinges are in line, and omega_4 is not determined",
                                     "tutte le cerniere sono allineate, e omega_4 non è determinata");
        found.push_back(crank);
      } catch (const geometry::Impossible& none) {
        why_not = none.words();
      }
    }
    if (number >= found.size()) throw geometry::Impossible(why_not);
    return in_degrees(angle_within_turn(found[number]));
  };
  ledger.put("theta_2_at_omega_4_zero_1_deg", [&] { return zero(0); });
  ledger.put("theta_2_at_omega_4_zero_2_deg", [&] { return zero(1); });
}

template <class T>
void write_zeros_by_construction(Ledger<T>& ledger, const FourBarInstant& at) {
  const auto direction = [&](geometry::Reach reach) {
    return [&at, reach] { return geometry::dead_centre<T>(at.lengths, reach, at.side).crank; };
  };
  write_zeros(ledger, at.side == geometry::Side::left, direction(geometry::Reach::extended),
              direction(geometry::Reach::folded));
}

template <class T>
void write_zeros_by_analysis(Ledger<T>& ledger, const FourBarInstant& at) {
  using geometry::analytic::DeadCentre;
  const auto direction = [&](DeadCentre which) {
    return [&at, which] {
      return plane(geometry::analytic::crank_at_dead_centre<T>(at.analytic_lengths(), which, at.analytic_branch()));
    };
  };
  write_zeros(ledger, at.side == geometry::Side::left, direction(DeadCentre::extended),
              direction(DeadCentre::folded));
}

}  // namespace epure::four_bar_analytic
