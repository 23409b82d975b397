#include "exercises/crane-welds/sphere_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure::crane_welds {
namespace {

constexpr double pascals = 1e6, beyond = 10;  // MPa in Pa; mm

}  // namespace

double SpherePanel::half_chord() const { return std::sqrt(std::max(0.0, radius_ * radius_ - cut_ * cut_)); }

drawings::Box SpherePanel::extent(const Scale&, const Scale& vectors) const {
  Extent extent;
  extent.include(vectors, {-radius_, -radius_}, beyond);
  extent.include(vectors, {radius_, radius_}, beyond);
  return extent.box();
}

std::vector<drawings::Block> SpherePanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const double mm = plot.scale().mm_per_unit, x = half_chord();
  const drawings::Point O = plot.at({0, 0});
  plot.long_segment({-radius_, 0}, {radius_, 0}, beyond - 4, Meaning::axis);
  plot.long_segment({0, -radius_}, {0, radius_}, beyond - 4, Meaning::axis);
  plot.label("$τ_{∥}$", {radius_ + (beyond - 4) / mm, 0}, Place{0, 0});
  plot.label("$σ_{⊥}$", {0, radius_ + (beyond - 4) / mm}, Place{0, 0});
  plot.circle({0, 0}, radius_, Meaning::construction);
  if (cut_ < radius_) {
    const double angle = std::asin(cut_ / radius_);
    for (const double turn : {0.0, std::numbers::pi})
      plot.mark(drawings::Line{drawings::arc(O, mm * radius_, turn - angle, turn + angle), Meaning::locus, {}});
    for (const double side : {-1.0, 1.0}) plot.segment({-x, side * cut_}, {x, side * cut_}, Meaning::locus);
  } else {
    plot.circle({0, 0}, radius_, Meaning::locus);
  }
  const double lower = std::sqrt(0.5) * radius_;
  plot.mark(drawings::Arrow{O, plot.at({lower, -lower}), Meaning::dimension, "fillet_allowable_1"});
  plot.onto().sheet.figure.labels.push_back({.text = "$f_{1}σ_{amm}$", .at = O, .to = plot.at({lower, -lower})});
  plot.measures("fillet_allowable_1", {0, 0}, {lower, -lower});
  plot.onto().measurements.back().per_mm *= pascals;
  if (cut_ < radius_) {
    const Place on_cut{-x / 2, cut_};
    plot.mark(drawings::Arrow{plot.at({-x / 2, 0}), plot.at(on_cut), Meaning::dimension, "fillet_allowable_2"});
    plot.onto().sheet.figure.labels.push_back(
        {.text = "$f_{2}σ_{amm}$", .at = plot.at({-x / 2, 0}), .to = plot.at(on_cut)});
    plot.measures("fillet_allowable_2", {-x / 2, 0}, on_cut);
    plot.onto().measurements.back().per_mm *= pascals;
  }
  for (const State& state : states_) {
    const Place at{state.tau, 0};
    plot.dot(at, Meaning::force);
    if (!plot.shows(at)) continue;
    plot.label(state.label, at, Place{0, 1}, Meaning::force);
    if (!state.quantity.empty())
      plot.onto().measurements.push_back({state.quantity, O, plot.at(at), pascals / mm, Measurement::along_x});
  }
  return {};
}

std::vector<PanelStep> SpherePanel::steps(const Plot&, const drawings::Box&) const {
  const double x = half_chord();
  return {
      {{"√($σ^{2}_{⊥}$ + $τ^{2}_{⊥}$ + $τ^{2}_{∥}$) ≤ $f_{1}σ_{amm}$: a sphere, cut here by the plane $τ_{⊥}$ = 0.",
        "√($σ^{2}_{⊥}$ + $τ^{2}_{⊥}$ + $τ^{2}_{∥}$) ≤ $f_{1}σ_{amm}$: una sfera, tagliata qui dal piano $τ_{⊥}$ = "
        "0."},
       Place{radius_, 0}},
      {{"$τ_{⊥}$ + $σ_{⊥}$ ≤ $f_{2}σ_{amm}$ truncates it.", "$τ_{⊥}$ + $σ_{⊥}$ ≤ $f_{2}σ_{amm}$ la mozza."},
       Place{x / 2, std::min(cut_, radius_)}},
      {{"The fillets' points: only $τ_{∥}$ acts, $σ_{⊥}$ = $τ_{⊥}$ = 0, so they lie on the axis.",
        "I punti dei cordoni: agisce solo $τ_{∥}$, $σ_{⊥}$ = $τ_{⊥}$ = 0, perciò stanno sull'asse."},
       Place{states_.front().tau, 0}}};
}

}  // namespace epure::crane_welds
