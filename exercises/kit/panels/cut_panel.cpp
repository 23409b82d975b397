#include "exercises/kit/panels/cut_panel.h"

#include <algorithm>

#include "exercises/kit/panels/origin_showing.h"

namespace epure {

drawings::Point CutPanel::origin(const drawings::Box& room, const drawings::Box& needed, const Scale& lengths) const {
  constexpr double worth_showing = 40;  // reaches
  return origin_showing(covered(lengths, worth_showing, worth_showing), needed, room);
}

void CutPanel::include(Extent& extent, const Scale& lengths, const std::optional<Place>& P, double reaches) const {
  constexpr double letters = 8;  // mm
  if (is_near(P, reaches)) extent.include(lengths, *P, letters);
}

void CutPanel::include(Extent& extent, const Scale& lengths, const DrawnCycle& circle, double reaches) const {
  constexpr double air = 4;  // mm
  if (!circle.centre || 2 * circle.radius > reaches * mechanism_->reach()) return;
  const auto& [x, y] = *circle.centre;
  extent.include(lengths, {x - circle.radius, y - circle.radius}, air);
  extent.include(lengths, {x + circle.radius, y + circle.radius}, air);
}

bool CutPanel::dwarfs_mechanism(const DrawnCycle& circle) const {
  constexpr double far_larger = 2;
  return circle.centre && 2 * circle.radius > far_larger * mechanism_->reach();
}

double CutPanel::reach_of_overview(const DrawnCycle& circle) const {
  constexpr double longest = 150, metre = 1000;  // mm
  if (!dwarfs_mechanism(circle)) return mechanism_->reach();
  return metre / longest * std::min(2 * circle.radius, far() * mechanism_->reach());
}

Place CutPanel::middle() const {
  const std::vector<Place> corners = mechanism_->corners();
  Place sum{0, 0};
  for (const Place& P : corners) sum = {sum.x + P.x, sum.y + P.y};
  const auto count = static_cast<double>(corners.size());
  return {sum.x / count, sum.y / count};
}

DrawnCycle cycle_of(const Solution& solution, const std::string& centre, const std::string& diameter) {
  DrawnCycle cycle{.centre = solution.point(centre), .on_line = solution.point(centre + "_nearest")};
  if (const auto across = solution.value(diameter)) cycle.radius = *across / 2;
  if (const auto along = solution.point(centre + "_along")) cycle.along = {along->x, along->y};
  return cycle;
}

void draw_named(Plot& plot, const std::optional<Place>& P, const std::string& letters, const Place& away_from,
                Meaning ink) {
  if (!P) return;
  plot.cross(*P, ink);
  plot.label(letters, *P, away_from, ink);
}

Place seen_end(const Plot& plot, const drawings::Box& room, const Place& P, const Place& Q) {
  return is_in(room, plot, Q) ? Q : ray_to_edge(plot, room, P, Q - P);
}

void draw_to(Plot& plot, const drawings::Box& room, const Place& P, const Place& Q, const std::string& letters,
             Language language, Meaning meaning) {
  plot.segment(P, Q, meaning);
  if (is_in(room, plot, Q) || !is_in(room, plot, P)) return;
  plot.small_label(Words{"to ", "verso "}.in(language) + letters, ray_to_edge(plot, room, P, Q - P), P);
}

}  // namespace epure
