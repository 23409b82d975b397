#include "exercises/pump-flywheel/torque_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure::pump_flywheel {
namespace {

// The half circles stand left of the chart, as high as their torques: at most this share of the room's width.
constexpr double share = 0.3;

}  // namespace

std::vector<drawings::Block> TorquePanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  DrawnSheet& onto = plot.onto();
  drawings::Box right = room;
  right.low.x += share * room.width();
  const drawings::ChartMap map = drawings::draw(chart_, right, onto.sheet.figure, language);
  // At the scale of the torques, unless the circle would not find room beside them.
  const double mm = 1 / map.y.per_mm(), reach = delivery_ * mm, available = share * room.width() / 2 - 4;
  const drawings::Point O{room.low.x + share * room.width() / 2, map.at({0, 0}).y};
  const double shrunk = std::min(1.0, available / reach);
  const auto at = [&](double degrees) {  // the end of the crank, its angle from the start of the half turn
    const double alpha = degrees * std::numbers::pi / 180;
    const double radius = (degrees < 180 ? suction_ : delivery_) * mm;
    return drawings::Point{O.x + shrunk * radius * (degrees < 180 ? std::cos(alpha) : -std::cos(alpha)),
                           O.y + radius * std::abs(std::sin(alpha))};
  };
  const auto line = [&](drawings::Point from, drawings::Point to, Meaning meaning) {
    plot.mark(drawings::Line{drawings::segment(from, to), meaning, {}});
  };
  for (const bool second : {false, true}) {
    drawings::Point before = at(second ? 180 : 0);
    for (int i = 1; i <= 45; ++i) {
      const drawings::Point next = at((second ? 180 : 0) + 4 * i - (second ? 0 : 1e-9));
      line(before, next, second ? Meaning::force : Meaning::velocity);
      before = next;
    }
  }
  line({O.x - available, O.y}, {map.at({0, 0}).x, O.y}, Meaning::axis);
  for (const Projected& each : projected_) {
    const drawings::Point end = at(each.angle), there{map.x.at(each.angle), end.y};
    line(O, end, Meaning::link);
    line(end, there, Meaning::construction);
    onto.sheet.figure.labels.push_back({.text = each.letters, .at = end});
  }
  for (const Read& each : read_) {
    const drawings::Point from = map.at(each.from), to = map.at(each.to);
    const bool is_level = each.from.y == each.to.y;
    onto.measurements.push_back({each.quantity, from, to, each.si * (is_level ? map.x.per_mm() : map.y.per_mm()),
                                 is_level ? Measurement::along_x : Measurement::along_y});
  }
  return {};
}

std::vector<PanelStep> TorquePanel::steps(const Plot&, const drawings::Box&) const { return {}; }

}  // namespace epure::pump_flywheel
