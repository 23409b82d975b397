#include "exercises/kit/panels/edge.h"

#include <algorithm>
#include <limits>

#include "drawings/paths/vectors.h"

namespace epure {

bool is_in(const drawings::Box& room, const Plot& plot, const Place& P) {
  return drawings::contains(room, plot.at(P));
}

Place at_edge(const Plot& plot, const drawings::Box& room, const Place& X, const Arrow2& direction) {
  const drawings::Point p = plot.at(X);
  double reach = std::numeric_limits<double>::infinity();  // in units of the direction
  if (direction.x != 0) reach = std::min(reach, ((direction.x > 0 ? room.high.x : room.low.x) - p.x) / direction.x);
  if (direction.y != 0) reach = std::min(reach, ((direction.y > 0 ? room.high.y : room.low.y) - p.y) / direction.y);
  reach = std::max(reach, 0.0);  // X itself may stand at the border
  return plot.from_paper({p.x + reach * direction.x, p.y + reach * direction.y});
}

Place ray_to_edge(const Plot& plot, const drawings::Box& room, const Place& X, const Arrow2& direction) {
  constexpr double from_border = 4;  // mm
  const drawings::Box inner{{room.low.x + from_border, room.low.y + from_border},
                            {room.high.x - from_border, room.high.y - from_border}};
  return at_edge(plot, inner, X, direction);
}

Place draw_towards(Plot& plot, const drawings::Box& room, const Place& X, const Place& beyond,
                   const std::string& letters, Language language) {
  const Place end = ray_to_edge(plot, room, X, beyond - X);
  plot.segment(X, end, Meaning::construction);
  plot.small_label(Words{"to ", "verso "}.in(language) + letters, end, X);
  return end;
}

DrawnCycle circle_through(const Place& X, const Place& centre) {
  return {.centre = centre, .radius = distance(X, centre), .on_line = X, .along = {X.y - centre.y, centre.x - X.x}};
}

void OffSheet::point(const std::string& letters, const std::optional<Place>& P) {
  if (P && !is_in(room_, plot_, *P)) found_.push_back({letters, letters});
}

void OffSheet::circle(const Words& part, const DrawnCycle& cycle) {
  if (!cycle.centre) return;
  const drawings::Point centre = plot_.at(*cycle.centre);
  const double radius = cycle.radius * plot_.scale().mm_per_unit;
  const bool is_whole = drawings::contains(
      room_, drawings::Box{{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}});
  if (!is_whole) found_.push_back(part);
}

std::string OffSheet::sentence(Language language) const {
  if (found_.empty()) return "";
  std::string text = Words{"Off the sheet: ", "Fuori del foglio: "}.in(language);
  for (std::size_t i = 0; i < found_.size(); ++i) text += (i == 0 ? "" : ", ") + found_[i].in(language);
  return text + ".";
}

}  // namespace epure
