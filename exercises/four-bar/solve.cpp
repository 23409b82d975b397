// One scene for each configuration of the linkage: what is undecided in one leaves the others alone.
#include "exercises/four-bar/at_special_positions.h"
#include "exercises/four-bar/slider_crank_square.h"

namespace epure::four_bar {
namespace {

// Whoever asks first.
std::vector<RouteValue> all_of_source(Rung rung) {
  const Asked all;
  const FirstRouteOnly no(false);
  return solve(problem(Givens(givens())), rung);
}

// What the source's linkage has under names that begin so does not exist here: `why` by the construction, `analysis`
// by the closed formulas.
std::vector<RouteValue> absent(const std::string& prefix, const Words& why, const Words& analysis, Rung rung) {
  static const std::vector<RouteValue> reported = all_of_source(Rung::names), drawn = all_of_source(Rung::drawing);
  std::vector<RouteValue> values;
  for (const RouteValue& value : rung == Rung::drawing ? drawn : reported) {
    if (!value.quantity.starts_with(prefix)) continue;
    for (const auto& [route, reason] : {std::pair{"construction", why}, std::pair{"analytic", analysis}})
      values.push_back(
          {value.quantity, route, {.kind = geometry::Settled::Kind::absent, .reason = reason}, value.described});
  }
  return values;
}

// Why `find` cannot be done; empty when it can.
template <class Find>
Words complaint(const Find& find) {
  try {
    find();
    return {};
  } catch (const geometry::Impossible& proved) {
    return proved.words();
  }
}

constexpr Phrase all_in_line{
    "coupler and rocker are in line too: the linkage is at a change point, where two motions lead on",
    "anche biella e bilanciere sono allineati: il meccanismo è in un punto di cambiamento, da cui partono due moti"};

std::vector<RouteValue> solve_dead_centre(const Problem& of, Reach reach, Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const Case here = dead_centre(reach);
  const auto which = reach == Reach::extended ? analytic::DeadCentre::extended : analytic::DeadCentre::folded;
  const Words why = complaint([&] { return geometry::dead_centre<geometry::Fast>(at.lengths, reach, at.side); });
  const Words analysis = complaint([&] {
    return analytic::crank_at_dead_centre<geometry::Fast>(at.analytic_lengths(), which, at.analytic_branch());
  });
  if (!why.empty()) return absent(here.prefix, why, analysis, rung);
  if (is_change_point(of, reach)) return absent(here.prefix, all_in_line, all_in_line, rung);
  return settle(AtDeadCentre{of, here, reach}, rung);
}

std::vector<RouteValue> solve_parallel(const Problem& of, Sense sense, Side branch, Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const Case here = parallel_links(sense, branch == at.side);
  const auto which = sense == Sense::same ? analytic::Parallel::same_sense : analytic::Parallel::opposite_sense;
  const auto position = [&] { return geometry::parallel_position<geometry::Fast>(at.lengths, sense, branch); };
  const Words why = complaint(position);
  const Words analysis = complaint([&] {
    return analytic::crank_parallel_to_rocker<geometry::Fast>(at.analytic_lengths(), which, analytic_branch(branch));
  });
  if (!why.empty()) return absent(here.prefix, why, analysis, rung);
  if (!position().branch) return absent(here.prefix, all_in_line, all_in_line, rung);
  return settle(AtParallel{of, here, sense, branch}, rung);
}

std::vector<RouteValue> solve_stroke(const Problem& of, Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const Words analysis =
      complaint([&] { return analytic::rocker_stroke<geometry::Fast>(at.analytic_lengths(), at.analytic_branch()); });
  if (analysis.empty()) return settle(Stroke{of}, rung);
  const Words why{"the linkage is no crank-rocker: its rocker does not swing between two dead centres",
                  "il meccanismo non è un manovella-bilanciere: il bilanciere non oscilla tra due punti morti"};
  std::vector<RouteValue> values;
  for (const std::string& name : {rocker_swing().name, crank_rotation().name, time_ratio().name}) {
    const auto none = absent(name, why, analysis, rung);
    values.insert(values.end(), none.begin(), none.end());
  }
  return values;
}

}  // namespace

Case dead_centre(Reach reach) {
  return reach == Reach::extended
             ? Case{"dead_centre_extended.",
                    {", rocker's dead centre, extended", ", punto morto esteso del bilanciere"}}
             : Case{"dead_centre_folded.",
                    {", rocker's dead centre, folded", ", punto morto ripiegato del bilanciere"}};
}

Case parallel_links(Sense sense, bool of_this_branch) {
  const bool same = sense == Sense::same;
  return {std::string("parallel_links.") + (same ? "same_sense_" : "opposite_sense_") +
              (of_this_branch ? "main_branch_" : "other_branch_"),
          Words{", crank and rocker parallel in ", ", manovella e bilanciere paralleli "} +
              (same ? Words{"the same sense", "concordi"} : Words{"opposite senses", "discordi"}) +
              (of_this_branch ? Words{", this branch", ", questo ramo"} : Words{", other branch", ", altro ramo"})};
}

std::vector<RouteValue> solve(const Problem& of, Rung rung) {
  const Side main = of.instant.side, other = geometry::opposite(main);
  std::vector<RouteValue> all;
  const auto add = [&](const std::vector<RouteValue>& values) {
    all.insert(all.end(), values.begin(), values.end());
  };
  add(settle(AtInstant{of}, rung));
  add(solve_stroke(of, rung));
  for (const Reach reach : {Reach::extended, Reach::folded}) add(solve_dead_centre(of, reach, rung));
  for (const Sense sense : {Sense::same, Sense::opposite})
    for (const Side branch : {main, other}) add(solve_parallel(of, sense, branch, rung));
  add(settle(SliderCrankSquare{of}, rung));
  return all;
}

}  // namespace epure::four_bar
