#include "exercises/pump-flywheel/torque_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure::pump_flywheel {
namespace {

// Of the room's width, for the circles; and what stands around them, in mm.
constexpr double share = 0.46, margin = 9;

double available(const drawings::Box& room) { return share * room.width() - 2 * margin; }

}  // namespace

drawings::Box TorquePanel::room_of_chart(const drawings::Box& room, Language language) const {
  drawings::Box box = room;
  box.low.x += share * room.width();
  drawings::Figure trial;
  const drawings::ChartMap map = drawings::draw(chart_, box, trial, language);
  const double frame = map.frame.height(), reach = delivery_ / map.y.per_mm();
  const double spare = frame * (1 - std::min(1.0, available(room) / reach));
  box.low.y += spare / 2;
  box.high.y -= spare / 2;
  return box;
}

void TorquePanel::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  drawings::draw_axes(chart_, room_of_chart(room, language), plot.onto().sheet.figure, language);
}

std::vector<drawings::Block> TorquePanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  DrawnSheet& onto = plot.onto();
  const drawings::ChartMap map = drawings::draw(chart_, room_of_chart(room, language), onto.sheet.figure, language);
  const drawings::Point O{room.low.x + margin, map.at({0, 0}).y};
  const auto radius = [&](double degrees) { return (degrees < 180 ? suction_ : delivery_) / map.y.per_mm(); };
  const auto at = [&](double degrees) {
    const double alpha = degrees * std::numbers::pi / 180;
    return drawings::Point{O.x + radius(degrees) * std::abs(std::cos(alpha)),
                           O.y + radius(degrees) * std::abs(std::sin(alpha))};
  };
  const auto line = [&](drawings::Point from, drawings::Point to, Meaning meaning) {
    plot.mark(drawings::Line{drawings::segment(from, to), meaning, {}});
  };
  for (const double half : {0.0, 180.0})
    if (radius(half) > 0)
      plot.mark(drawings::Line{drawings::arc(O, radius(half), 0, std::numbers::pi / 2), Meaning::construction, {}});
  line({O.x - margin / 2, O.y}, {O.x + radius(180) + margin / 2, O.y}, Meaning::axis);
  line({O.x, O.y - margin / 2}, {O.x, O.y + radius(180) + margin / 2}, Meaning::axis);
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

}  // namespace epure::pump_flywheel
