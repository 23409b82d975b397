#include "exercises/kit/panels/free_body_panel.h"

#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double arrow_length = 14, line_beyond = 7;  // mm of an arrow, and of its line of action past both ends
constexpr double couple_radius = 9;                   // mm

Place on_line(const Place& at, const Arrow2& along, double mm, double mm_per_unit) {
  return at + mm / mm_per_unit * along;
}

}  // namespace

double FreeBodyPanel::Force::tail() const { return ends ? -behind - arrow_length : behind; }
double FreeBodyPanel::Force::tip() const { return tail() + arrow_length; }

// One arrow after the other, where two stand on the same side of a point and would cover each other.
FreeBodyPanel& FreeBodyPanel::force(const PolygonSide& side, const Place& at, Arrow there) {
  const double size = magnitude(side.v);
  if (size == 0) return *this;
  constexpr double too_near = 0.3, gap = 3;  // radians, mm
  Force added{side.label, at, (1 / size) * side.v, 0, there == Arrow::ends};
  const Arrow2 out = added.ends ? -added.along : added.along;
  for (const Force& other : forces_) {
    const Arrow2 other_out = other.ends ? -other.along : other.along;
    const bool is_same_side = std::abs(std::atan2(cross(out, other_out), dot(out, other_out))) < too_near;
    if (distance(other.at, at) == 0 && is_same_side) added.behind = other.behind + arrow_length + gap;
  }
  forces_.push_back(added);
  return *this;
}

FreeBodyPanel& FreeBodyPanel::couple(const std::string& label, const Place& about, double sense,
                                     const std::vector<double>& clear_of) {
  if (sense != 0) couples_.push_back({label, about, sense, clear_of});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::moments(const Words& text, const Place& about) {
  steps_.push_back({text, about});
  return *this;
}

double FreeBodyPanel::middle_of(const Couple& couple) const {
  std::vector<double> occupied = couple.clear_of;
  for (const Force& force : forces_)
    if (distance(force.at, couple.about) == 0)
      occupied.push_back(std::atan2(force.along.y, force.along.x) + (force.ends ? std::numbers::pi : 0));
  return clearest_direction(occupied);
}

drawings::Box FreeBodyPanel::extent(const Scale& scale, const Scale&) const {
  constexpr double letters = 6;  // mm
  Extent extent;
  body_->include(extent, scale);
  for (const Force& force : forces_)
    for (const double end : {force.tail() - line_beyond, force.tip() + line_beyond})
      extent.include(scale, on_line(force.at, force.along, end, scale.mm_per_unit), letters);
  for (const Couple& couple : couples_) extent.include(scale, couple.about, couple_radius + letters);
  return extent.box();
}

void FreeBodyPanel::draw_force(Plot& plot, const Force& force) const {
  const double mm = plot.scale().mm_per_unit;
  const auto at = [&](double along) { return on_line(force.at, force.along, along, mm); };
  plot.segment(at(std::min(force.tail(), 0.0) - line_beyond), at(std::max(force.tip(), 0.0) + line_beyond),
               Meaning::construction);
  plot.side("", at(force.tail()), at(force.tip()), Meaning::force, force.label);
}

std::vector<drawings::Block> FreeBodyPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  body_->draw(plot);
  for (const Force& force : forces_) draw_force(plot, force);
  for (const Couple& couple : couples_)
    draw_arc_arrow(plot, couple.about,
                   {middle_of(couple), couple.sense, couple.label, couple_radius, Meaning::force});
  return {};
}

}  // namespace epure
