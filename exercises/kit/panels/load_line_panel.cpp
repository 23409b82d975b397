#include "exercises/kit/panels/load_line_panel.h"

#include <algorithm>
#include <cmath>

namespace epure {
namespace {

constexpr double lane_width = 12;                   // mm
constexpr double plan_letters = 9, under_line = 8;  // mm: around the plan, and down to the pole distance
constexpr double plan_longest = 90;                 // mm

Place in_lane(const Plot& plot, int lane, double height) {
  return {lane * lane_width / plot.scale().mm_per_unit, height};
}

}  // namespace

std::pair<double, double> LoadLinePanel::ends() const {
  double low = 0, high = 0;
  for (const LoadLine::Force& force : plan_.forces) {
    low = std::min({low, force.from, force.to});
    high = std::max({high, force.from, force.to});
  }
  return {low, high};
}

Panel::Vectors LoadLinePanel::vectors() const {
  const auto [low, high] = ends();
  const double wide = plan_.pole ? -plan_.pole->x : 0;
  return {plan_.unit, std::max(high - low, wide), plan_longest};
}

drawings::Box LoadLinePanel::extent(const Scale&, const Scale& vectors) const {
  const auto [low, high] = ends();
  int lanes = 0;
  for (const LoadLine::Force& force : plan_.forces) lanes = std::max(lanes, force.lane);
  Extent extent;
  extent.include(vectors, {0, low}, plan_letters);
  extent.include(vectors, {0, high}, plan_letters);
  extent.include(lanes * lane_width + plan_letters, 0);
  if (plan_.pole) extent.include(vectors, *plan_.pole, plan_letters);
  if (plan_.pole) extent.include(0, vectors.mm_per_unit * low - under_line - plan_letters);
  return extent.box();
}

void LoadLinePanel::draw_force(Plot& plot, const LoadLine::Force& force) const {
  const Place from = in_lane(plot, force.lane, force.from), to = in_lane(plot, force.lane, force.to);
  for (const Place& end : {from, to})
    if (force.lane > 0) plot.segment({0, end.y}, end, Meaning::construction);
  plot.mark(drawings::Arrow{plot.at(from), plot.at(to), force.meaning, force.quantity});
  // Letters stand to the right.
  const drawings::Label beside{.text = force.label,
                               .at = plot.at(from),
                               .to = plot.at(to),
                               .ink = force.meaning,
                               .away_from = plot.at(in_lane(plot, force.lane - 1, (force.from + force.to) / 2))};
  plot.onto().sheet.figure.labels.push_back(beside);
  if (!force.tip.empty()) plot.label(force.tip, to, from, force.meaning);
  if (!force.quantity.empty() && plot.shows(from) && plot.shows(to))
    plot.onto().measurements.push_back({force.quantity, plot.at(from), plot.at(to),
                                        plan_.si / plot.scale().mm_per_unit,
                                        force.is_signed ? Measurement::along_y : Measurement::length});
}

void LoadLinePanel::draw_pole(Plot& plot) const {
  constexpr double small = 3;  // mm
  for (const LoadLine::Ray& ray : plan_.rays) {
    plot.segment(*plan_.pole, {0, ray.corner}, Meaning::construction);
    plot.onto().sheet.figure.labels.push_back(
        {.text = ray.letter, .at = plot.at(*plan_.pole), .to = plot.at({0, ray.corner}), .size = small});
  }
  plot.dot(*plan_.pole);
  plot.label("$O$", *plan_.pole, Place{0, plan_.pole->y});
  const double low = ends().first, mm = plot.scale().mm_per_unit;
  plot.mark(drawings::Dimension{plot.at({plan_.pole->x, low}), plot.at({0, low}), -under_line, plan_.pole_distance});
  plot.segment(*plan_.pole, {plan_.pole->x, low - under_line / mm}, Meaning::construction);
}

std::vector<drawings::Block> LoadLinePanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const auto [low, high] = ends();
  plot.long_segment({0, low}, {0, high}, 3, Meaning::construction);
  if (!plan_.start.empty()) plot.label(plan_.start, {0, 0}, in_lane(plot, 1, 0));
  if (plan_.tells_scale) {
    constexpr double letters = 2.7;  // mm
    const drawings::Point foot = plot.at({0, low});
    plot.mark(drawings::Writing{plot.scale().caption, {foot.x, foot.y - plan_letters}, letters});
  }
  if (plan_.pole) draw_pole(plot);
  for (const LoadLine::Force& force : plan_.forces) draw_force(plot, force);
  return {};
}

std::vector<PanelStep> LoadLinePanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all;
  for (const LoadLine::Step& step : plan_.steps) {
    const Place at = step.at.x < 0 ? step.at : Place{step.at.x * lane_width / plot.scale().mm_per_unit, step.at.y};
    all.push_back({step.text, at, step.needs_all_others});
  }
  return all;
}

}  // namespace epure
