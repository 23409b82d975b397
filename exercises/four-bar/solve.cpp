// One scene for each configuration of the linkage: what is undecided in one leaves the others alone.
#include "exercises/four-bar/at_special_positions.h"
#include "exercises/four-bar/slider_crank_square.h"

namespace epure::four_bar {
namespace {

// Every quantity whose name begins so does not exist: `why` by the construction, `analysis` by the closed formulas.
std::vector<RouteValue> absent(const std::string& prefix, const Words& why, const Words& analysis) {
  std::vector<RouteValue> values;
  for (const Quantity& spec : quantities()) {
    if (!spec.name.starts_with(prefix)) continue;
    for (const auto& [route, reason] : {std::pair{"construction", why}, std::pair{"analytic", analysis}})
      values.push_back({spec.name, route, {.kind = geometry::Settled::Kind::absent, .reason = reason}});
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

std::vector<RouteValue> solve_dead_centre(const Problem& of, const std::string& prefix, Reach reach, Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const auto which = reach == Reach::extended ? analytic::DeadCentre::extended : analytic::DeadCentre::folded;
  const Words why = complaint([&] { return geometry::dead_centre<geometry::Fast>(at.lengths, reach, at.side); });
  const Words analysis = complaint([&] {
    return analytic::crank_at_dead_centre<geometry::Fast>(at.analytic_lengths(), which, at.analytic_branch());
  });
  if (!why.empty()) return absent(prefix, why, analysis);
  if (is_change_point(of, reach)) return absent(prefix, all_in_line, all_in_line);
  return settle(AtDeadCentre{of, prefix, reach}, rung);
}

std::vector<RouteValue> solve_parallel(const Problem& of, const std::string& prefix, Sense sense, Side branch,
                                       Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const auto which = sense == Sense::same ? analytic::Parallel::same_sense : analytic::Parallel::opposite_sense;
  const auto position = [&] { return geometry::parallel_position<geometry::Fast>(at.lengths, sense, branch); };
  const Words why = complaint(position);
  const Words analysis = complaint([&] {
    return analytic::crank_parallel_to_rocker<geometry::Fast>(at.analytic_lengths(), which, analytic_branch(branch));
  });
  if (!why.empty()) return absent(prefix, why, analysis);
  if (!position().branch) return absent(prefix, all_in_line, all_in_line);
  return settle(AtParallel{of, prefix, sense, branch}, rung);
}

std::vector<RouteValue> solve_stroke(const Problem& of, Rung rung) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const FourBarInstant& at = of.instant;
  const Words analysis =
      complaint([&] { return analytic::rocker_stroke<geometry::Fast>(at.analytic_lengths(), at.analytic_branch()); });
  if (analysis.empty()) return settle(Stroke{of}, rung);
  std::vector<RouteValue> values;
  for (const char* name : {"rocker_swing", "crank_rotation_extended_to_folded", "time_ratio"}) {
    const auto none =
        absent(name,
               Words{"the linkage is no crank-rocker: its rocker does not swing between two dead centres",
                     "il meccanismo non è un manovella-bilanciere: il bilanciere non oscilla tra due punti morti"},
               analysis);
    values.insert(values.end(), none.begin(), none.end());
  }
  return values;
}

}  // namespace

std::vector<RouteValue> solve(const Problem& of, Rung rung) {
  const Side main = of.instant.side, other = geometry::opposite(main);
  std::vector<RouteValue> all;
  const auto add = [&](const std::vector<RouteValue>& values) {
    all.insert(all.end(), values.begin(), values.end());
  };
  add(settle(AtInstant{of}, rung));
  add(solve_stroke(of, rung));
  add(solve_dead_centre(of, "dead_centre_extended.", Reach::extended, rung));
  add(solve_dead_centre(of, "dead_centre_folded.", Reach::folded, rung));
  add(solve_parallel(of, "parallel_links.same_sense_other_branch_", Sense::same, other, rung));
  add(solve_parallel(of, "parallel_links.same_sense_main_branch_", Sense::same, main, rung));
  add(solve_parallel(of, "parallel_links.opposite_sense_main_branch_", Sense::opposite, main, rung));
  add(solve_parallel(of, "parallel_links.opposite_sense_other_branch_", Sense::opposite, other, rung));
  add(settle(SliderCrankSquare{of}, rung));
  return all;
}

}  // namespace epure::four_bar
