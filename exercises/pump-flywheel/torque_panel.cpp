#include "exercises/pump-flywheel/torque_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace epure::pump_flywheel {
namespace {

// Of the room's width, for the circles; and what stands around them, in mm.
constexpr double share = 0.46, margin = 9;

double available(const drawings::Box& room) { return share * room.width() - 2 * margin; }

drawings::Point centre(const drawings::Box& room, const drawings::ChartMap& map) {
  return {room.low.x + margin, map.at({0, 0}).y};
}

// The numbers left of the frame whose height a level line has: the first of them, or none.
std::optional<double> number_at(const drawings::Figure& figure, const drawings::ChartMap& map, double y) {
  constexpr double clear = 0.5;  // mm
  for (const drawings::Mark& mark : figure.marks)
    if (const auto* number = std::get_if<drawings::Writing>(&mark); number && number->baseline.x < map.frame.low.x &&
                                                                    y > number->baseline.y - clear &&
                                                                    y < number->baseline.y + number->size + clear)
      return number->baseline.x - clear;
  return {};
}

}  // namespace

double TorquePanel::radius(const drawings::ChartMap& map, double degrees) const {
  return (degrees < 180 ? suction_ : delivery_) / map.y.per_mm();
}

drawings::Point TorquePanel::end_of_crank(const drawings::Box& room, const drawings::ChartMap& map,
                                          double degrees) const {
  const drawings::Point O = centre(room, map);
  const double r = radius(map, degrees), alpha = degrees * std::numbers::pi / 180;
  return {O.x + r * std::abs(std::cos(alpha)), O.y + r * std::abs(std::sin(alpha))};
}

std::vector<PanelStep> TorquePanel::steps(const Plot& plot, const drawings::Box& room) const {
  drawings::Figure trial;
  const drawings::ChartMap map =
      drawings::draw(chart_, room_of_chart(room, Language::english), trial, Language::english);
  constexpr double shown = 240, of_mean = 45;  // degrees
  const drawings::Point end = end_of_crank(room, map, shown);
  return {
      {{"The crank of the length $\\it{F}r$, at the scale of the torques, in its positions of the turn.",
        "La manovella lunga $\\it{F}r$, nella scala dei momenti, nelle sue posizioni lungo il giro."},
       plot.from_paper(end)},
      {{"The height of its end, $\\it{M}_{r}$ = $\\it{F}r$ sin $α$, is carried level to the ordinate of its angle.",
        "La quota del suo estremo, $\\it{M}_{r}$ = $\\it{F}r$ sen $α$, si riporta sull'ordinata del suo angolo."},
       plot.from_paper({map.x.at(shown), end.y})},
      {{"The mean line: as much area above it as is wanting below.",
        "La retta media: tanta area sopra di essa quanta ne manca sotto."},
       plot.from_paper(map.at({of_mean, chart_.horizontals.front().at}))}};
}

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
  const drawings::Point O = centre(room, map);
  const auto line = [&](drawings::Point from, drawings::Point to, Meaning meaning) {
    plot.mark(drawings::Line{drawings::segment(from, to), meaning, {}});
  };
  for (const double half : {0.0, 180.0})
    if (radius(map, half) > 0)
      plot.mark(
          drawings::Line{drawings::arc(O, radius(map, half), 0, std::numbers::pi / 2), Meaning::construction, {}});
  const double far = radius(map, 180) + margin / 2;
  line({O.x - margin / 2, O.y}, {O.x + far, O.y}, Meaning::axis);
  line({O.x, O.y - margin / 2}, {O.x, O.y + far}, Meaning::axis);
  for (const Projected& each : projected_) {
    const drawings::Point end = end_of_crank(room, map, each.angle), there{map.x.at(each.angle), end.y};
    line(O, end, Meaning::link);
    // A number of the axis is not struck through.
    const auto number = number_at(onto.sheet.figure, map, end.y);
    if (number) line(end, {*number, end.y}, Meaning::construction);
    line(number ? drawings::Point{map.frame.low.x, end.y} : end, there, Meaning::construction);
    plot.mark(drawings::Dot{there, Meaning::construction, {}});
    if (!each.letters.empty()) onto.sheet.figure.labels.push_back({.text = each.letters, .at = end});
  }
  constexpr double upright = 270;  // degrees
  onto.sheet.figure.labels.push_back({.text = "$\\it{F}_{m}r$", .at = O, .to = end_of_crank(room, map, upright)});
  for (const Read& each : read_) {
    const drawings::Point from = map.at(each.from), to = map.at(each.to);
    const bool is_level = each.from.y == each.to.y;
    onto.measurements.push_back({each.quantity, from, to, each.si * (is_level ? map.x.per_mm() : map.y.per_mm()),
                                 is_level ? Measurement::along_x : Measurement::along_y});
  }
  return {};
}

}  // namespace epure::pump_flywheel
