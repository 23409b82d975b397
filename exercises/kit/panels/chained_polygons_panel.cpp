#include "exercises/kit/panels/chained_polygons_panel.h"

#include <algorithm>
#include <cmath>

#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr double caption_height = 6, caption_letters = 3.2;  // mm
constexpr double past_arc = 4;                               // mm of an angle's leg

// mm of its arc: a narrow one is seen farther out only.
double radius_of_angle(double from, double to) {
  constexpr double narrow = 0.25;  // radians
  return std::abs(to - from) < narrow ? 24 : 12;
}

// Letters of a corner that two polygons share stand there once.
void keep_once(std::vector<drawings::Label>& labels, std::size_t first_new) {
  constexpr double same_place = 0.5;  // mm
  const auto stands_before = [&](std::size_t i) {
    return std::any_of(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(first_new),
                       [&](const drawings::Label& old) {
                         return !old.to && !labels[i].to && old.text == labels[i].text &&
                                std::hypot(old.at.x - labels[i].at.x, old.at.y - labels[i].at.y) < same_place;
                       });
  };
  for (std::size_t i = labels.size(); i-- > first_new;)
    if (stands_before(i)) labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(i));
}

// Whether the letters of a polygon's sides would stand on the other side of it: all its corners lie that near to the
// line of its last known side.
bool is_slim(const VectorPolygon& polygon, const Scale& scale) {
  constexpr double letters_high = 6;  // mm
  const Arrow2& side = polygon.right.back().v;
  Arrow2 corner{0, 0};
  double width = 0;
  for (const PolygonSide& each : polygon.right) {
    width = std::max(width, std::abs(cross(side, corner)));
    corner = corner + each.v;
  }
  return width * scale.mm_per_unit < letters_high * magnitude(side);
}

// The side that a polygon has from one before bears the letters of both, one on either side of it; where that one is
// too slim to hold them both stand outside of it, as an equation.
void write_together(std::vector<drawings::Label>& labels, std::size_t first_new, const std::string& of_shared) {
  constexpr double same_place = 0.5;  // mm
  const auto near = [](drawings::Point p, drawings::Point q) {
    return std::hypot(p.x - q.x, p.y - q.y) < same_place;
  };
  const auto start = labels.begin() + static_cast<std::ptrdiff_t>(first_new);
  const auto shared =
      std::find_if(start, labels.end(), [&](const auto& label) { return label.to && label.text == of_shared; });
  if (shared == labels.end()) return;
  const auto other = std::find_if(labels.begin(), start, [&](const auto& label) {
    return label.to && near(label.at, *shared->to) && near(*label.to, shared->at);
  });
  if (other == start) return;
  const std::string minus = "−";
  if (shared->text != minus + other->text) other->text += " = " + minus + shared->text;
  labels.erase(shared);
}

}  // namespace

ChainedPolygonsPanel& ChainedPolygonsPanel::then(VectorPolygon polygon, const Arrow2& from) {
  links_.push_back({std::move(polygon), from});
  return *this;
}

ChainedPolygonsPanel& ChainedPolygonsPanel::over(std::vector<Arrow2> corners) {
  under_.push_back(std::move(corners));
  return *this;
}

ChainedPolygonsPanel& ChainedPolygonsPanel::captioned(const Words& caption) {
  caption_ = caption;
  return *this;
}

ChainedPolygonsPanel& ChainedPolygonsPanel::angle(const Arrow2& at, double from, double to,
                                                  const std::string& letters) {
  if (from != to) angles_.push_back({at, from, to, letters});
  return *this;
}

ChainedPolygonsPanel& ChainedPolygonsPanel::likewise(const Words& text, const Arrow2& at) {
  is_told_ = false;
  return step(text, at);
}

ChainedPolygonsPanel& ChainedPolygonsPanel::step(const Words& text, const Arrow2& at) {
  steps_.push_back({text, Place{at.x, at.y}});
  return *this;
}

Panel::Vectors ChainedPolygonsPanel::vectors() const {
  double longest = 0;
  for (const Link& link : links_) longest = std::max(longest, greatest(link.polygon));
  return {links_.front().polygon.unit, longest};
}

drawings::Box ChainedPolygonsPanel::extent(const Scale&, const Scale& vectors) const {
  Extent extent;
  for (const Link& link : links_) {
    const drawings::Box box = extent_of(link.polygon, vectors);
    for (const drawings::Point corner : {box.low, box.high})
      extent.include(corner.x + vectors.mm_per_unit * link.from.x, corner.y + vectors.mm_per_unit * link.from.y);
  }
  for (const Angle& each : angles_) {
    constexpr double letters = 3;  // mm
    const double leg = radius_of_angle(each.from, each.to) + past_arc + letters;
    for (const double side : {each.from, each.to})
      extent.include(vectors.mm_per_unit * each.at.x + leg * std::cos(side),
                     vectors.mm_per_unit * each.at.y + leg * std::sin(side));
  }
  for (const auto& corners : under_)
    for (const Arrow2& corner : corners)
      extent.include(vectors.mm_per_unit * corner.x, vectors.mm_per_unit * corner.y);
  drawings::Box box = extent.box();
  if (!caption_.empty()) box.low.y -= caption_height;
  return box;
}

std::vector<Place> ChainedPolygonsPanel::lettered() const {
  std::vector<Place> all;
  for (const Link& link : links_)
    for (const Place& corner : corners_of(link.polygon)) all.push_back(corner + link.from);
  return all;
}

void ChainedPolygonsPanel::draw_angle(Plot& plot, const Angle& angle) {
  const double radius = radius_of_angle(angle.from, angle.to), leg = radius + past_arc;  // mm
  const drawings::Point corner = plot.at({angle.at.x, angle.at.y});
  const auto at = [&](double direction, double along) {
    return plot.from_paper({corner.x + along * std::cos(direction), corner.y + along * std::sin(direction)});
  };
  plot.segment(at(angle.from, 0), at(angle.from, leg), Meaning::axis);
  plot.mark(drawings::AngleMark{corner, radius, std::min(angle.from, angle.to), std::max(angle.from, angle.to),
                                Meaning::dimension});
  plot.small_label(angle.letters, at((angle.from + angle.to) / 2, radius), at(angle.from, 0));
}

std::vector<drawings::Block> ChainedPolygonsPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  for (const auto& corners : under_)
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      plot.segment({corners[i].x, corners[i].y}, {corners[i + 1].x, corners[i + 1].y}, Meaning::alternative);
  for (const Angle& each : angles_) draw_angle(plot, each);
  for (const Link& link : links_) {
    Plot moved(plot.onto(), plot.at({link.from.x, link.from.y}), plot.scale());
    auto& labels = plot.onto().sheet.figure.labels;
    const std::size_t before = labels.size();
    PolygonStage whole;
    whole.numbered = false;
    whole.language = language;
    draw_polygon(moved, link.polygon, whole);
    keep_once(labels, before);
    if (&link != &links_.front() && is_slim(links_.front().polygon, plot.scale()))
      write_together(labels, before, link.polygon.right.front().label);
  }
  if (caption_.empty()) return {};
  const drawings::Box covered = extent(plot.scale(), plot.scale());
  const std::string& caption = caption_.in(language);
  const double width = drawings::measure(caption, caption_letters).width;
  plot.mark(drawings::Writing{
      caption, plot.at({0, 0}) + drawings::Point{(covered.low.x + covered.high.x - width) / 2, covered.low.y + 1.5},
      caption_letters});
  return {};
}

std::vector<drawings::VectorEquation> ChainedPolygonsPanel::equations() const {
  std::vector<drawings::VectorEquation> all;
  if (!is_told_) return all;
  for (const Link& link : links_) all.push_back(equation(link.polygon));
  return all;
}

std::vector<double> ChainedPolygonsPanel::crossings() const {
  std::vector<double> all;
  for (const Link& link : links_)
    for (const double angle : crossings_of(link.polygon)) all.push_back(angle);
  return all;
}

std::vector<PanelStep> ChainedPolygonsPanel::steps(const Plot& plot, const drawings::Box&) const {
  if (!is_told_) return steps_;
  std::vector<PanelStep> all;
  for (const Link& link : links_) {
    const std::vector<std::string> english = steps_of(link.polygon, Language::english),
                                   italian = steps_of(link.polygon, Language::italian);
    const std::vector<Place> places = places_of_steps(link.polygon, plot.scale());
    for (std::size_t i = 0; i < english.size(); ++i) all.push_back({{english[i], italian[i]}, places[i] + link.from});
  }
  all.insert(all.end(), steps_.begin(), steps_.end());
  return all;
}

}  // namespace epure
