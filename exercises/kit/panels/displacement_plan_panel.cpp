#include "exercises/kit/panels/displacement_plan_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/short_vectors.h"

namespace epure {
namespace {

constexpr double node_letters = 9, whole_off = 7;  // mm; how far off a node its whole displacement is drawn

// On the plane of lengths, where displacements have their own scale.
Place on_plane(const Plot& plot, const Place& P) {
  return {P.x, 1000 * plot.vector_scale().mm_per_unit / plot.scale().mm_per_unit * P.y};
}

}  // namespace

Panel::Vectors DisplacementPlanPanel::vectors() const {
  constexpr double longest_on_paper = 130;  // mm
  double low = 0, high = 0;
  for (const PlannedBar& bar : bars_)
    for (const double y : {bar.corners[3].y, bar.tangent.y}) {
      low = std::min(low, y);
      high = std::max(high, y);
    }
  return {"mm", 1000 * (high - low), longest_on_paper};
}

drawings::Box DisplacementPlanPanel::extent(const Scale& lengths, const Scale& vectors) const {
  Extent extent;
  extent.include(-node_letters, 0);
  for (const PlannedBar& bar : bars_)
    for (const Place& P : {Place{bar.corners[3].x, 0}, bar.tangent, bar.corners[3]}) {
      const double x = lengths.mm_per_unit * P.x, y = 1000 * vectors.mm_per_unit * P.y;
      extent.include(x + whole_off + node_letters, y + node_letters);
      extent.include(x, y - node_letters);
    }
  return extent.box();
}

void DisplacementPlanPanel::draw_bar(Plot& plot, const PlannedBar& bar, double off, Language language) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  const auto at = [&](const Place& P) { return on_plane(plot, P); };
  const Place begin = at(bar.corners[0]), end = at(bar.corners[3]), turned = at(bar.tangent), axis{end.x, 0};
  const double per_mm = 1 / (1000 * plot.vector_scale().mm_per_unit);
  const auto letters = [&](const std::string& of, double metres) {
    return letters_or_value(of, metres, std::abs(metres) / per_mm, "m", language);
  };
  plot.segment(begin, turned, Meaning::construction);
  plot.mark(drawings::Line{
      {plot.at(begin), {{false, plot.at(at(bar.corners[1])), plot.at(at(bar.corners[2])), plot.at(end)}}},
      Meaning::locus});
  if (!bar.turned.empty()) {
    const Place level{end.x, begin.y};
    plot.segment(begin, level, Meaning::construction);
    plot.side("", level, turned, Meaning::velocity, bar.turned, begin);
  }
  const double bends = std::abs(bar.corners[3].y - bar.tangent.y);
  plot.side("", turned, end, Meaning::acceleration, bar.bent.empty() ? "" : letters(bar.bent, bends), begin);
  if (!bar.bends.empty()) {
    const Place &from = bar.bending_counts_down ? end : turned, &to = bar.bending_counts_down ? turned : end;
    plot.onto().measurements.push_back({bar.bends, plot.at(from), plot.at(to), per_mm, Measurement::along_y});
  }
  const Arrow2 aside{off * mm, 0};
  plot.segment(end, end + aside, Meaning::construction);
  plot.side("", axis + aside, end + aside, Meaning::force, letters(bar.end, bar.corners[3].y), axis);
  plot.onto().measurements.push_back({bar.rise, plot.at(axis), plot.at(end), per_mm, Measurement::along_y});
  plot.dot(end, Meaning::link);
  plot.label(bar.end_letters, axis, axis + Arrow2{0, end.y < 0 ? -mm : mm});
}

std::vector<drawings::Block> DisplacementPlanPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  plot.segment({0, 0}, {reach() + (whole_off + 3) * mm, 0}, Meaning::axis);
  constexpr double support = 6;  // mm
  plot.mark(drawings::Ground{plot.at(Place{0, support * mm}), plot.at(Place{0, -support * mm})});
  plot.label(begin_, {0, 0}, Place{mm, -mm});
  for (std::size_t i = 0; i < bars_.size(); ++i) {
    // To the left where the next end would be near.
    const double there = bars_[i].corners[3].x, next = i + 1 < bars_.size() ? bars_[i + 1].corners[3].x : HUGE_VAL;
    draw_bar(plot, bars_[i], next - there < 2 * whole_off * mm ? -whole_off : whole_off, language);
  }
  return {};
}

std::vector<PanelStep> DisplacementPlanPanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all;
  for (const PlannedBar& bar : bars_) {
    const Place begin = on_plane(plot, bar.corners[0]), turned = on_plane(plot, bar.tangent);
    if (!bar.told_turned.empty()) all.push_back({bar.told_turned, geometry::midpoint(begin, turned)});
    all.push_back({bar.told_bent, on_plane(plot, bar.corners[3])});
  }
  return all;
}

}  // namespace epure
