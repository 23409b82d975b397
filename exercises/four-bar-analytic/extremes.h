// ω₄ over a full turn of the crank at constant speed: its zeros and extremes, each found twice.
#pragma once

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/linkages/four_bar_on_x.h"
#include "geometry/analytic/four_bar_extremes.h"
#include "geometry/analytic/four_bar_special.h"
#include "geometry/mechanisms/collineation_axis.h"
#include "geometry/mechanisms/four_bar_positions.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epure::four_bar_analytic {

enum class Extreme { max, min };
inline Quantity omega_4_at(Extreme which) {
  return which == Extreme::max ? Quantity{"omega_4_max",
                                          "$ω_{4,max}$",
                                          "rad/s",
                                          {"greatest ω₄ over a turn of the crank at constant speed",
                                           "massima ω₄ in un giro della manovella a velocità costante"}}
                               : Quantity{"omega_4_min",
                                          "$ω_{4,min}$",
                                          "rad/s",
                                          {"least ω₄ over a turn of the crank at constant speed",
                                           "minima ω₄ in un giro della manovella a velocità costante"}};
}
inline Quantity theta_2_at(Extreme which) {
  const std::string index = which == Extreme::max ? "max" : "min";
  return {"theta_2_at_omega_4_" + index + "_deg",
          "$θ_{2," + index + "}$",
          "deg",
          {"crank angle there", "anomalia della manovella"}};
}
inline Quantity theta_2_at_zero(int number) {
  const std::string index = std::to_string(number);
  return {"theta_2_at_omega_4_zero_" + index + "_deg", "$θ_{2," + index + "}$", "deg",
          number == 1 ? Words{"crank angle of the first dead centre of the rocker",
                              "anomalia della manovella al primo punto morto del bilanciere"}
                      : Words{"crank angle of the second dead centre of the rocker",
                              "anomalia della manovella al secondo punto morto del bilanciere"}};
}

// For the chart: each stationary ω₄ of a configuration, where it is, and its dead centres.
inline Quantity stationary_omega_4(Configuration of, std::size_t number) {
  return in(of, {"omega_4_stationary_" + std::to_string(number), "$ω_{4}$", "rad/s", {"extreme", "estremo"}});
}
inline Quantity stationary_theta_2(Configuration of, std::size_t number) {
  return in(of, {"theta_2_stationary_" + std::to_string(number), "$θ_{2}$", "deg", {"crank angle", "anomalia"}});
}
inline Quantity dead_centre_theta_2(Configuration of, geometry::Reach reach) {
  const std::string which = reach == geometry::Reach::extended ? "extended" : "folded";
  return in(of, {"theta_2_dead_centre_" + which, "$θ_{2}$", "deg", {"dead centre", "punto morto"}});
}

// By the closure equation: the ratio ω₄/ω₂, and the directions in which it is stationary.
struct RatioByClosure {
  geometry::analytic::FourBar linkage;
  geometry::analytic::Branch branch;

  using Stationary = geometry::analytic::StationaryCrank;
  std::vector<Stationary> stationary() const { return geometry::analytic::stationary_cranks(linkage, branch); }
  template <class T>
  static geometry::Vector<T> crank(const Stationary& at) {
    return plane(at.direction<T>());
  }
  template <class T>
  T ratio(const geometry::Vector<T>& crank) const {
    const geometry::analytic::CrankState<T> state{crank.x, crank.y, T(1), T(0)};
    return geometry::analytic::motion(linkage, state, geometry::analytic::position(linkage, state, branch)).omega_4;
  }
};

// By the instant centres, and Freudenstein's theorem.
struct RatioByCentres {
  geometry::FourBarLengths of;
  geometry::Side side;

  using Stationary = geometry::StationaryPosition;
  std::vector<Stationary> stationary() const { return geometry::stationary_positions(of, side); }
  template <class T>
  static geometry::Vector<T> crank(const Stationary& at) {
    return at.crank<T>();
  }
  template <class T>
  T ratio(const geometry::Vector<T>& crank) const {
    return geometry::velocity_ratio_by_centres(geometry::four_bar(of, crank, side));
  }
};

// The positions in which the ratio is stationary, the least ratio first, found once for all numbers; or why there are
// none.
template <class Ratio>
struct StationaryRatio {
  std::vector<typename Ratio::Stationary> positions = {};
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
StationaryRatio<Ratio> stationary_ratio(const geometry::FourBarLengths& of, const Ratio& ratio) {
  Words why_not = why_no_extremes(of);
  if (!why_not.empty()) return {{}, std::move(why_not)};
  return {ratio.stationary(), {}};
}

template <class T, class Ratio>
void write_extremes(Ledger<T>& ledger, const Ratio& ratio, const StationaryRatio<Ratio>& stationary,
                    const FourBarInstant& at) {
  const bool is_forward = geometry::sign_of(at.n) > 0;
  for (const auto& [which, is_last] : {std::pair{Extreme::max, is_forward}, {Extreme::min, !is_forward}}) {
    const auto direction = [&, last = is_last] {
      if (!stationary.why_not.empty()) throw geometry::Impossible(stationary.why_not);
      const auto& all = stationary.positions;
      return Ratio::template crank<T>(all.at(last ? all.size() - 1 : 0));
    };
    ledger.put(omega_4_at(which), [&] { return T(at.omega_2<T>() * ratio.ratio(direction())); });
    ledger.put(theta_2_at(which), [&] { return in_degrees(angle_within_turn(direction())); });
  }
}

inline Quantity theta_2_within_turn() {
  return {"theta_2_within_turn_deg", "$θ_{2}$", "deg", {"crank angle", "anomalia della manovella"}};
}

// A crank that no number of bits tells from +x is drawn there.
template <class T>
T degrees_for_drawing(const geometry::Vector<T>& crank) {
  try {
    return in_degrees(angle_within_turn(crank));
  } catch (const geometry::Undecided&) {
    return T(0);
  }
}

// Beside a fold, however near, with as many bits as the linkage takes to close.
template <class Find>
geometry::Deep for_drawing(const Find& find) {
  try {
    return find();
  } catch (const geometry::Undecided&) {
    return geometry::with_enough_bits(find);
  }
}

template <class T>
void write_for_chart(Ledger<T>& ledger, Configuration of, const RatioByClosure& ratio,
                     const StationaryRatio<RatioByClosure>& stationary, const FourBarInstant& at) {
  if constexpr (std::is_same_v<T, geometry::Deep>) {
    for (std::size_t i = 0; i < stationary.positions.size(); ++i) {
      const auto crank = [&] { return RatioByClosure::crank<T>(stationary.positions[i]); };
      ledger.tells(stationary_omega_4(of, i),
                   [&] { return for_drawing([&] { return T(at.omega_2<T>() * ratio.ratio(crank())); }); });
      ledger.tells(stationary_theta_2(of, i), [&] { return degrees_for_drawing(crank()); });
    }
    for (const geometry::Reach reach : {geometry::Reach::extended, geometry::Reach::folded})
      ledger.tells(dead_centre_theta_2(of, reach), [&] {
        const auto dead_centre = geometry::dead_centre<T>(at.lengths, reach, at.side);
        if (!dead_centre.branch) throw geometry::Impossible("no such dead centre", "non c'è questo punto morto");
        return degrees_for_drawing(dead_centre.crank);
      });
  }
}

// The dead centres of the branch as they follow in a turn from +x: the extended one lies above the frame when B is on
// the left of A -> B₀, the folded one below. (`extended` and `folded` throw Impossible where there is none.)
template <class T, class Extended, class Folded>
void write_zeros(Ledger<T>& ledger, bool extended_first, const Extended& extended, const Folded& folded) {
  const auto zero = [&](std::size_t number) {
    std::vector<geometry::Vector<T>> found;
    std::vector<Words> why_not;
    for (const bool is_extended : {extended_first, !extended_first}) {
      try {
        const geometry::Vector<T> crank = is_extended ? extended() : folded();
        if (geometry::sign(crank.y) == geometry::Sign::zero)
          throw geometry::Impossible("all hinges are in line, and omega_4 is not determined",
                                     "tutte le cerniere sono allineate, e omega_4 non è determinata");
        found.push_back(crank);
      } catch (const geometry::Impossible& none) {
        why_not.push_back(none.words());
      }
    }
    if (number >= found.size()) throw geometry::Impossible(why_not[number - found.size()]);
    return in_degrees(angle_within_turn(found[number]));
  };
  ledger.put(theta_2_at_zero(1), [&] { return zero(0); });
  ledger.put(theta_2_at_zero(2), [&] { return zero(1); });
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
