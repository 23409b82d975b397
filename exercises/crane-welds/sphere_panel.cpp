#include "exercises/crane-welds/sphere_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure::crane_welds {
namespace {

constexpr double pascals = 1e6;                         // MPa in Pa
constexpr double beyond = 10, detail = 14, tick = 1.5;  // mm: around, down to the enlarged axis, its ticks

}  // namespace

double SpherePanel::half_chord() const { return std::sqrt(std::max(0.0, radius_ * radius_ - cut_ * cut_)); }

double SpherePanel::times() const {
  double most = 0;
  for (const State& state : states_) most = std::max(most, std::abs(state.tau));
  if (most == 0 || most > radius_ / 2) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(radius_ / most)));
  for (const double step : {5.0, 2.0})
    if (step * decade * most <= radius_) return step * decade;
  return decade;
}

drawings::Box SpherePanel::extent(const Scale&, const Scale& vectors) const {
  Extent extent;
  extent.include(vectors, {-radius_, -radius_}, beyond);
  extent.include(vectors, {radius_, radius_}, beyond);
  if (times() > 1) extent.include(0, -vectors.mm_per_unit * radius_ - detail - beyond);
  return extent.box();
}

void SpherePanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const double mm = plot.scale().mm_per_unit;
  plot.long_segment({-radius_, 0}, {radius_, 0}, beyond - 4, Meaning::axis);
  plot.long_segment({0, -radius_}, {0, radius_}, beyond - 4, Meaning::axis);
  plot.label("$τ_{∥}$", {radius_ + (beyond - 4) / mm, 0}, Place{0, 0});
  plot.label("$σ_{⊥}$", {0, radius_ + (beyond - 4) / mm}, Place{0, 0});
}

std::vector<drawings::Block> SpherePanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const double mm = plot.scale().mm_per_unit, x = half_chord();
  const drawings::Point O = plot.at({0, 0});
  draw_given(plot, room, language);
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
  for (const State& state : states_) plot.dot({state.tau, 0}, Meaning::force);
  draw_detail(plot);
  return {};
}

// Labelled and measured on the axis itself, or where it is enlarged.
void SpherePanel::draw_state(Plot& plot, const State& state) const {
  const double mm = plot.scale().mm_per_unit, low = times() > 1 ? -radius_ - detail / mm : 0;
  const Place zero{0, low}, at{times() * state.tau, low};
  if (!plot.shows(at)) return;
  plot.dot(at, Meaning::force);
  plot.label(state.label, at, Place{at.x, low - 1}, Meaning::force);
  plot.onto().measurements.push_back(
      {state.quantity, plot.at(zero), plot.at(at), pascals / (mm * times()), Measurement::along_x});
}

void SpherePanel::draw_detail(Plot& plot) const {
  if (times() > 1) {
    const double low = -radius_ - detail / plot.scale().mm_per_unit, up = tick / plot.scale().mm_per_unit;
    plot.segment({-radius_, low}, {radius_, low}, Meaning::axis);
    const double unit = std::pow(10.0, std::floor(std::log10(radius_ / times())));
    for (const double value : {0.0, unit}) {
      const double x = times() * value;
      plot.segment({x, low - up}, {x, low + up}, Meaning::link);
      plot.small_label(short_number(value, Language::english) + (value > 0 ? " MPa" : ""), {x, low - up},
                       Place{x, low});
    }
    plot.label("$τ_{∥}$, " + short_number(times(), Language::english) + " : 1", {radius_, low}, Place{0, low});
    for (const double side : {-1.0, 1.0})
      plot.segment({side * radius_ / times(), 0}, {side * radius_, low}, Meaning::construction);
  }
  for (const State& state : states_) draw_state(plot, state);
}

std::vector<PanelStep> SpherePanel::steps(const Plot& plot, const drawings::Box&) const {
  const double x = half_chord(), low = times() > 1 ? -radius_ - detail / plot.scale().mm_per_unit : 0;
  return {
      {{"√($σ^{2}_{⊥}$ + $τ^{2}_{⊥}$ + $τ^{2}_{∥}$) ≤ $f_{1}σ_{amm}$: a sphere, cut here by the plane $τ_{⊥}$ = 0.",
        "√($σ^{2}_{⊥}$ + $τ^{2}_{⊥}$ + $τ^{2}_{∥}$) ≤ $f_{1}σ_{amm}$: una sfera, tagliata qui dal piano $τ_{⊥}$ = "
        "0."},
       Place{radius_, 0}},
      {{"|$τ_{⊥}$| + |$σ_{⊥}$| ≤ $f_{2}σ_{amm}$ truncates it.", "|$τ_{⊥}$| + |$σ_{⊥}$| ≤ $f_{2}σ_{amm}$ la tronca."},
       Place{x / 2, std::min(cut_, radius_)}},
      {{"The fillets' points: only $τ_{∥}$ acts, $σ_{⊥}$ = $τ_{⊥}$ = 0, so they lie on the axis.",
        "I punti dei cordoni: agisce solo $τ_{∥}$, $σ_{⊥}$ = $τ_{⊥}$ = 0, perciò stanno sull'asse."},
       Place{0, low}}};
}

}  // namespace epure::crane_welds
