#include "exercises/kit/panels/section_panel.h"

#include <algorithm>

namespace epure {
namespace {

constexpr double diagram_longest = 34, diagram_gap = 12, section_letters = 8;  // mm
constexpr double depth_aside = 9, width_below = 5;                             // mm, of the dimension lines

}  // namespace

SectionPanel& SectionPanel::diagram(StressDiagram added) {
  double low = 0, high = 0;
  for (const Place& P : added.border) {
    low = std::min(low, P.x);
    high = std::max(high, P.x);
  }
  const double range = high > low ? high - low : 1;
  const Scale scale = largest_vector_scale(diagram_longest / range, unit_, language_);
  diagrams_.push_back({std::move(added), scale, -scale.mm_per_unit * low, scale.mm_per_unit * high});
  return *this;
}

std::vector<Scale> SectionPanel::own_scales() const {
  std::vector<Scale> all;
  for (const Placed& each : diagrams_) {
    all.push_back(each.scale);
    all.back().caption += " (" + each.diagram.name + ")";
  }
  return all;
}

double SectionPanel::axis(std::size_t diagram, const Scale& lengths) const {
  double x = lengths.mm_per_unit * width_ / 2;
  for (std::size_t i = 0; i <= diagram; ++i)
    x += diagram_gap + diagrams_[i].left + (i == 0 ? 0 : diagrams_[i - 1].right);
  return x;
}

drawings::Box SectionPanel::extent(const Scale& lengths, const Scale&) const {
  const double half = lengths.mm_per_unit * depth_ / 2;
  return {
      {-lengths.mm_per_unit * width_ / 2 - depth_aside - section_letters, -half - section_letters},
      {axis(diagrams_.size() - 1, lengths) + diagrams_.back().right + 2 * section_letters, half + section_letters}};
}

Place SectionPanel::place(const Plot& plot, std::size_t diagram, const Place& at) const {
  const double mm = axis(diagram, plot.scale()) + diagrams_[diagram].scale.mm_per_unit * at.x;
  return {mm / plot.scale().mm_per_unit, at.y};
}

void SectionPanel::draw_section(Plot& plot) const {
  const double b = width_ / 2, s = wall_ / 2, H = depth_ / 2, h = H - wall_;
  const std::vector<Place> outline{{-b, H}, {b, H},   {b, h},   {s, h},   {s, -h}, {b, -h},
                                   {b, -H}, {-b, -H}, {-b, -h}, {-s, -h}, {-s, h}, {-b, h}};
  plot.area(outline, Meaning::plate);
  plot.polygon(outline, Meaning::link);
  // Past the section only: within thin walls an axis would cover them.
  const double beyond = 4 / plot.scale().mm_per_unit;
  for (const double side : {-1.0, 1.0}) plot.segment({0, side * H}, {0, side * (H + beyond)}, Meaning::axis);
  const drawings::Point corner = plot.at({-b, -H});
  plot.mark(drawings::Dimension{corner, plot.at({-b, H}), depth_aside, dimensions_[0]});
  plot.mark(drawings::Dimension{corner, plot.at({b, -H}), -width_below, dimensions_[1]});
  plot.small_label(dimensions_[2], {s, -h / 2}, Place{0, -h / 2});
}

void SectionPanel::draw_diagram(Plot& plot, std::size_t i) const {
  const StressDiagram& of = diagrams_[i].diagram;
  const auto at = [&](const Place& P) { return place(plot, i, P); };
  const double H = depth_ / 2, mm = diagrams_[i].scale.mm_per_unit;
  std::vector<Place> border;
  for (const Place& P : of.border) border.push_back(at(P));
  plot.area(border, Meaning::plate);
  plot.polygon(border, Meaning::force);
  plot.segment(at({0, -H}), at({0, H}), Meaning::link);
  plot.label(of.name, at({0, -H}), at({0, 0}));
  for (const StressDiagram::Read& read : of.reads) {
    const Place from = at({0, read.at.y}), to = at(read.at);
    plot.mark(drawings::Line{drawings::segment(plot.at(from), plot.at(to)), Meaning::force, read.quantity});
    plot.onto().sheet.figure.labels.push_back(
        {.text = read.label, .at = plot.at(to), .ink = Meaning::force, .away_from = plot.at(from)});
    if (!read.quantity.empty() && plot.shows(from) && plot.shows(to))
      plot.onto().measurements.push_back({read.quantity, plot.at(from), plot.at(to), si_ / mm, Measurement::along_x});
  }
}

void SectionPanel::draw_given(Plot& plot, const drawings::Box&, Language) const { draw_section(plot); }

std::vector<drawings::Block> SectionPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const std::size_t last = diagrams_.size() - 1;
  const double right = place(plot, last, {0, 0}).x + diagrams_[last].right / plot.scale().mm_per_unit;
  for (const auto& [height, text] : levels_) {
    plot.segment({-width_ / 2, height}, {right, height}, Meaning::construction);
    plot.label(text, {-width_ / 2, height}, Place{0, height});
  }
  draw_section(plot);
  for (std::size_t i = 0; i < diagrams_.size(); ++i) draw_diagram(plot, i);
  return {};
}

std::vector<PanelStep> SectionPanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all;
  for (const Step& step : steps_) all.push_back({step.text, place(plot, step.diagram, step.at)});
  return all;
}

}  // namespace epure
