#include "exercises/scenes/sheets/centres_panel.h"

#include <algorithm>
#include <set>

#include "exercises/kit/panels/crossing.h"
#include "exercises/kit/panels/edge.h"

namespace epure::scenes {
namespace {

constexpr double letters_around = 9;  // mm
constexpr double axis_arrow = 8;      // mm, of the two arrows at the origin
constexpr Place plane_origin{0, 0};   // of the axes of link 1, in which coordinates are told

// Where a line leads from one of its points to a centre that is off the sheet.
Place beyond_room(const DrawnCentre& centre, const Place& from, const Arrow2& along) {
  return centre.at ? *centre.at : from + along;
}

}  // namespace

std::optional<Arrow2> along_line(const std::pair<OnLine, OnLine>& line) {
  const auto& [one, other] = line;
  if (one.at && other.at) return *other.at - *one.at;
  return one.towards ? one.towards : other.towards;
}

drawings::Box CentresPanel::extent(const Scale& lengths, const Scale&) const {
  constexpr double not_tried = 20;  // times the mechanism
  return extent_within(not_tried, lengths);
}

// The mechanism, and what lies beside it.
drawings::Box CentresPanel::extent_of_near(const Scale& lengths, const Scale&) const {
  constexpr double beside = 0.6;  // of the mechanism: farther off, it would be drawn too small
  return extent_within(beside, lengths);
}

drawings::Box CentresPanel::extent_within(double reaches, const Scale& lengths) const {
  Extent extent;
  mechanism_->include(extent, lengths);
  const std::vector<Place> corners = mechanism_->corners();
  const auto is_near = [&](const Place& P) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Place& corner) { return distance(corner, P) < reaches * mechanism_->reach(); });
  };
  for (const DrawnCentre& centre : centres_)
    if (centre.at && is_near(*centre.at)) extent.include(lengths, *centre.at, letters_around);
  if (shows_axes() && distance(mechanism_->corners().front(), plane_origin) < reaches * mechanism_->reach())
    extent.include(lengths, plane_origin, axis_arrow + letters_around);
  return extent.box();
}

bool CentresPanel::shows_axes() const {
  const std::vector<Place> corners = mechanism_->corners();
  return std::none_of(corners.begin(), corners.end(), [](const Place& P) { return P.x == 0 && P.y == 0; });
}

void CentresPanel::draw_axes(Plot& plot, const drawings::Box& room) const {
  if (!shows_axes() || !is_in(room, plot, plane_origin)) return;
  const double far = axis_arrow / plot.scale().mm_per_unit;
  for (const auto& [tip, letters] : {std::pair(Place{far, 0}, "$x$"), std::pair(Place{0, far}, "$y$")}) {
    plot.mark(drawings::Arrow{plot.at(plane_origin), plot.at(tip), Meaning::dimension, {}});
    plot.label(letters, tip, plane_origin);
  }
}

// Through what of the line lies on the sheet, a little beyond; towards the centre where that is off it.
void CentresPanel::draw_line(Plot& plot, const drawings::Box& room, const DrawnCentre& centre,
                             const std::pair<OnLine, OnLine>& line, Language language) const {
  constexpr double beyond = 4;  // mm
  std::vector<Place> shown;
  for (const OnLine* on : {&line.first, &line.second})
    if (on->at && is_in(room, plot, *on->at)) shown.push_back(*on->at);
  const bool shows_centre = centre.at && is_in(room, plot, *centre.at);
  if (shows_centre) shown.push_back(*centre.at);
  if (shown.empty()) return;
  const auto along = along_line(line);
  if (!along) return;
  const auto ahead = [&](const Place& P, const Place& Q) { return dot(*along, P - Q) < 0; };
  const auto [first, last] = std::minmax_element(shown.begin(), shown.end(), ahead);
  if (distance(*first, *last) > 0) plot.long_segment(*first, *last, beyond, Meaning::construction);
  if (!shows_centre)
    draw_towards(plot, room, shown.front(), beyond_room(centre, shown.front(), *along), centre.letters, language);
  // What is at infinity and was found before.
  for (const OnLine* on : {&line.first, &line.second})
    if (shows_centre && on->towards && !on->letters.empty())
      draw_towards(plot, room, *centre.at, *centre.at + *on->towards, on->letters, language);
  // What lies off the sheet, or beyond a close-up.
  for (const OnLine* on : {&line.first, &line.second}) {
    if (!shows_centre || !on->at || is_in(room, plot, *on->at)) continue;
    if (on->letters.empty())
      plot.segment(*centre.at, at_edge(plot, room, *centre.at, *on->at - *centre.at), Meaning::construction);
    else
      draw_towards(plot, room, *centre.at, *on->at, on->letters, language);
  }
}

void CentresPanel::draw_earlier(Plot& plot, const drawings::Box& room) const {
  std::set<std::string> drawn{""};
  for (const DrawnCentre& centre : centres_) drawn.insert(centre.letters);
  for (const DrawnCentre& centre : centres_)
    for (const auto& [one, other] : centre.lines)
      for (const OnLine* on : {&one, &other})
        if (on->at && is_in(room, plot, *on->at) && drawn.insert(on->letters).second) {
          plot.cross(*on->at, Meaning::construction);
          plot.label(on->letters, *on->at, mechanism_->corners().front());
        }
}

std::vector<drawings::Block> CentresPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  for (const DrawnCentre& centre : centres_)
    for (const auto& line : centre.lines) draw_line(plot, room, centre, line, language);
  draw_axes(plot, room);
  mechanism_->draw(plot);
  draw_earlier(plot, room);
  const Place from = mechanism_->corners().front();  // of a list that does not stay
  for (const DrawnCentre& centre : centres_) {
    if (!centre.at || !is_in(room, plot, *centre.at)) continue;
    plot.cross(*centre.at);
    plot.label(centre.letters, *centre.at, from, Meaning::locus);
    plot.measures_coordinates(centre.quantity, *centre.at, plane_origin);
  }
  return {};
}

std::vector<Place> CentresPanel::lettered() const {
  std::vector<Place> all = points_;
  for (const DrawnCentre& centre : centres_)
    if (centre.at) all.push_back(*centre.at);
  return all;
}

std::vector<double> CentresPanel::crossings() const {
  std::vector<double> angles;
  for (const DrawnCentre& centre : centres_) {
    if (centre.lines.size() != 2) continue;
    const auto one = along_line(centre.lines[0]), other = along_line(centre.lines[1]);
    if (one && other && magnitude(*one) > 0 && magnitude(*other) > 0) angles.push_back(crossing_angle(*one, *other));
  }
  return angles;
}

std::vector<PanelStep> CentresPanel::steps(const Plot& plot, const drawings::Box& room) const {
  std::vector<PanelStep> all;
  if (!joints_.empty()) all.push_back({joints_, {}});
  for (const DrawnCentre& centre : centres_) {
    PanelStep step{centre.step, centre.at};
    if (!centre.at || !is_in(room, plot, *centre.at))
      if (const auto leaving = where_it_leaves(plot, room, centre)) step.at = leaving;
    all.push_back(std::move(step));
  }
  return all;
}

// Of a centre off the sheet: on the last of its lines, where that goes on towards it and away from the joints.
std::optional<Place> CentresPanel::where_it_leaves(const Plot& plot, const drawings::Box& room,
                                                   const DrawnCentre& centre) const {
  constexpr double of_the_way = 0.7;  // to the edge
  std::optional<Place> found;
  // What a close-up leaves out is on the whole.
  if (!std::all_of(points_.begin(), points_.end(), [&](const Place& P) { return is_in(room, plot, P); }))
    return found;
  for (const auto& line : centre.lines)
    for (const OnLine* on : {&line.first, &line.second})
      if (const auto along = along_line(line); along && on->at && is_in(room, plot, *on->at)) {
        const Place edge = ray_to_edge(plot, room, *on->at, beyond_room(centre, *on->at, *along) - *on->at);
        found = *on->at + of_the_way * (edge - *on->at);
      }
  return found;
}

}  // namespace epure::scenes
