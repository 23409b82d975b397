#include "exercises/kit/panels/free_body_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/arc_in_the_clear.h"
#include "exercises/kit/panels/cut_panel.h"
#include "exercises/kit/panels/short_vectors.h"
#include "exercises/kit/panels/tracks.h"

namespace epure {
namespace {

constexpr double arrow_length = 14, line_beyond = 5;  // mm of an arrow, and of its line of action past both ends
constexpr double couple_radius = 9;                   // mm
constexpr double leg = 28;                            // mm of the lines at an angle of friction

Arrow2 direction_of(double radians) { return {std::cos(radians), std::sin(radians)}; }

Place on_line(const Place& at, const Arrow2& along, double mm, double mm_per_unit) {
  return at + mm / mm_per_unit * along;
}

// The straight links on the paper, each from both its ends.
std::vector<VectorOnPaper> straight_links(const std::vector<drawings::Mark>& marks) {
  std::vector<VectorOnPaper> found;
  for (const drawings::Mark& mark : marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line || line->meaning != Meaning::link || line->path.pieces.size() != 1 ||
        !line->path.pieces.front().straight)
      continue;
    found.emplace_back(line->path.start, line->path.pieces.front().end);
    found.emplace_back(line->path.pieces.front().end, line->path.start);
  }
  return found;
}

// How far to its left a dimension line stands that would lie on an edge of a plate: outside of the plate, which the
// edges at both its ends tell.
double off_edges(const std::vector<drawings::Mark>& marks, const VectorOnPaper& line) {
  constexpr double clear = 4, one_point = 0.05;  // mm
  const std::vector<VectorOnPaper> links = straight_links(marks);
  const auto edge = std::find_if(links.begin(), links.end(),
                                 [&](const VectorOnPaper& link) { return covered(line, link).has_value(); });
  if (edge == links.end()) return 0;
  const drawings::Point left = drawings::left_of(drawings::unit(line.first, line.second));
  double inwards = 0;
  for (const auto& [corner, next] : links)
    for (const drawings::Point end : {edge->first, edge->second})
      if (drawings::distance(corner, end) < one_point) inwards += dot(next - line.first, left);
  return inwards > 0 ? -clear : clear;
}

// How far aside an arrow stands that would lie on a link, mm: to its right.
drawings::Point off_links(const std::vector<drawings::Mark>& marks, const VectorOnPaper& arrow) {
  constexpr double clear = 2;  // mm
  const std::vector<VectorOnPaper> links = straight_links(marks);
  if (std::none_of(links.begin(), links.end(),
                   [&](const VectorOnPaper& link) { return covered(arrow, link).has_value(); }))
    return {0, 0};
  const drawings::Point left = drawings::left_of(drawings::unit(arrow.first, arrow.second));
  return {-clear * left.x, -clear * left.y};
}

// As far as H, or to the edge of the room, where letters say where it leads.
void lead_to(Plot& plot, const drawings::Box& room, const Place& from, const Place& H, const std::string& letters,
             Language language, Meaning meaning) {
  const Place end = seen_end(plot, room, from, H);
  plot.segment(from, end, meaning);
  if (!is_in(room, plot, H) && is_in(room, plot, from))
    plot.small_label(Words{"to ", "verso "}.in(language) + letters, end, from);
}

}  // namespace

double FreeBodyPanel::length_of(const Force& force, const Scale& vectors) const {
  return unit_.empty() ? arrow_length : vectors.mm_per_unit * force.size;
}

FreeBodyPanel::OnPaper FreeBodyPanel::on_paper(const Force& force, const Scale& vectors) const {
  constexpr double gap = 3;  // mm
  double behind = force.clear;
  for (int i = force.after; i >= 0; i = forces_[static_cast<std::size_t>(i)].after)
    behind += length_of(forces_[static_cast<std::size_t>(i)], vectors) + gap;
  const double length = length_of(force, vectors), tail = force.ends ? -behind - length : behind;
  return {tail, tail + length};
}

FreeBodyPanel& FreeBodyPanel::force(const PolygonSide& side, const Place& at, Arrow there) {
  return add(side, at, there, Given::nothing);
}
FreeBodyPanel& FreeBodyPanel::load(const PolygonSide& side, const Place& at, Arrow there) {
  return add(side, at, there, Given::all);
}
FreeBodyPanel& FreeBodyPanel::effort(const PolygonSide& side, const Place& at, Arrow there) {
  return add(side, at, there, Given::line);
}

// One arrow after the other, where two stand on the same side of a point and would cover each other.
FreeBodyPanel& FreeBodyPanel::add(const PolygonSide& side, const Place& at, Arrow there, Given given) {
  const double size = magnitude(side.v);
  if (size == 0) return *this;
  constexpr double too_near = 0.3;  // radians
  constexpr double off_hinge = 2;   // mm
  Force added{side.label,
              at,
              (1 / size) * side.v,
              size,
              -1,
              there != Arrow::starts,
              there == Arrow::ends_at_hinge ? off_hinge : 0,
              side.quantity,
              given,
              side.length};
  const Arrow2 out = added.ends ? -added.along : added.along;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const Force& other = forces_[i];
    const Arrow2 other_out = other.ends ? -other.along : other.along;
    const bool is_same_side = std::abs(std::atan2(cross(out, other_out), dot(out, other_out))) < too_near;
    if (distance(other.at, at) == 0 && is_same_side) added.after = static_cast<int>(i);
  }
  forces_.push_back(added);
  return *this;
}

FreeBodyPanel& FreeBodyPanel::to_scale(const std::string& unit) {
  unit_ = unit;
  return *this;
}

FreeBodyPanel& FreeBodyPanel::larger() {
  is_larger_ = true;
  return *this;
}

double FreeBodyPanel::reach() const {
  double reach = circles_.empty() ? body_->reach() : 0;
  for (const FrictionCircle& each : circles_) reach = std::max(reach, 2 * distance(each.X, each.T));
  return std::max(reach, least_reach_);
}

FreeBodyPanel& FreeBodyPanel::at_most(double mm_per_metre) {
  least_reach_ = 1000 / mm_per_metre;
  return *this;
}

FreeBodyPanel& FreeBodyPanel::meeting(const std::string& name, const std::string& letters,
                                      const std::optional<Place>& H) {
  if (H) meetings_.push_back({name, letters, *H});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::sliding(const Place& X, const Arrow2& v, const Arrow2& from,
                                      const std::string& letters) {
  if (magnitude(v) == 0 || magnitude(from) == 0) return *this;
  sliding_.push_back({X, (1 / magnitude(v)) * v, (1 / magnitude(from)) * from, letters});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::otherwise(const std::string& name, const std::string& letters,
                                        const std::optional<Place>& H, const std::vector<LineOfForce>& lines,
                                        bool makes_room) {
  otherwise_.push_back({name, letters, H, lines, makes_room});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::friction_circle(const Place& X, const Place& T, const std::string& letters) {
  if (distance(X, T) > 0) circles_.push_back({X, T, letters});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::string(const Place& from, const Place& to, const std::string& letters) {
  strings_.push_back({from, to, letters});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::line_to(const Place& from, const Place& to, const std::string& letters) {
  lines_.push_back({from, to, letters});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::turned(const Place& X, double normal, double force, const std::string& angle,
                                     const std::string& letters, bool is_cone) {
  turned_.push_back({X, normal, force, angle, letters, is_cone});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::arm(const Place& about, const Place& on_line, const Arrow2& along,
                                  const std::string& letters, const std::string& quantity, double left) {
  if (magnitude(along) == 0) return *this;
  const Arrow2 u = (1 / magnitude(along)) * along;
  arms_.push_back({about, on_line, on_line + dot(about - on_line, u) * u, letters, quantity, left});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::step(const Words& text, const Place& at) {
  steps_.push_back({text, at});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::couple(const std::string& label, const Place& about, double sense,
                                     const std::vector<double>& clear_of) {
  if (sense != 0) couples_.push_back({label, about, sense, clear_of});
  return *this;
}

FreeBodyPanel& FreeBodyPanel::step_at_couple(const Words& text, const Place& about, const std::string& label) {
  steps_at_couples_.push_back({steps_.size(), about, label});
  return step(text, about);
}

std::vector<PanelStep> FreeBodyPanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all = steps_;
  for (const StepAtCouple& each : steps_at_couples_)
    for (const Couple& couple : couples_)
      if (couple.label == each.label && distance(couple.about, each.about) == 0) {
        const ArcArrow arc = arc_of(couple);
        all[each.step].at = on_line(couple.about, direction_of(arc.middle), arc.radius, plot.scale().mm_per_unit);
      }
  return all;
}

FreeBodyPanel& FreeBodyPanel::moments(const Words& text, const Place& about) { return step(text, about); }

double FreeBodyPanel::middle_of(const Couple& couple) const {
  std::vector<double> occupied = couple.clear_of;
  for (const Force& force : forces_)
    if (distance(force.at, couple.about) == 0)
      occupied.push_back(std::atan2(force.along.y, force.along.x) + (force.ends ? std::numbers::pi : 0));
  for (const Couple* each = couples_.data(); each != &couple; ++each)
    if (distance(each->about, couple.about) == 0) occupied.push_back(middle_of(*each));
  return clearest_direction(occupied);
}

ArcArrow FreeBodyPanel::arc_of(const Couple& couple) const {
  return {middle_of(couple), couple.sense, couple.label, radius_of(couple), Meaning::force};
}

// Several about one point stand one outside of the other.
double FreeBodyPanel::radius_of(const Couple& couple) const {
  constexpr double apart = 5;  // mm
  double radius = couple_radius;
  for (const Couple* each = couples_.data(); each != &couple; ++each)
    if (distance(each->about, couple.about) == 0) radius += apart;
  return radius;
}

double FreeBodyPanel::radius_of(const Turned& turned) {
  constexpr double largest = 24, arc = 16;  // mm
  return std::min(largest, arc / std::abs(turned.force - turned.normal));
}
// Of a cone as of all others; of an angle alone as far as its arc.
double FreeBodyPanel::leg_of(const Turned& turned) {
  constexpr double beyond = 5;  // mm
  return turned.is_cone ? leg : std::min(leg, radius_of(turned) + beyond);
}

Panel::Vectors FreeBodyPanel::vectors() const {
  if (unit_.empty() || forces_.empty()) return {};
  double longest = 0;
  for (const Force& force : forces_) longest = std::max(longest, force.size);
  constexpr double longest_on_paper = 60;  // mm: longer they say no more
  return {unit_, longest, longest_on_paper};
}

drawings::Box FreeBodyPanel::extent_of_near(const Scale& scale, const Scale& vectors) const {
  constexpr double letters = 6;  // mm
  Extent extent;
  body_->include(extent, scale);
  for (const Force& force : forces_) {
    const OnPaper arrow = on_paper(force, vectors);
    std::vector<double> ends{arrow.tail - line_beyond, arrow.tip + line_beyond};
    if (force.given == Given::line) ends.insert(ends.end(), {-arrow_length, arrow_length});
    for (const double end : ends)
      extent.include(scale, on_line(force.at, force.along, end, scale.mm_per_unit), letters);
  }
  for (const Couple& couple : couples_) extent.include(scale, couple.about, radius_of(couple) + letters);
  for (const FrictionCircle& each : circles_)
    extent.include(scale, each.X, distance(each.X, each.T) * scale.mm_per_unit + letters);
  for (const String& each : strings_)
    for (const Place& P : {each.from, each.to}) extent.include(scale, P, letters);
  for (const Turned& each : turned_)
    for (const double side : {each.force, each.is_cone ? 2 * each.normal - each.force : each.normal})
      extent.include(scale, on_line(each.X, direction_of(side), leg_of(each) + letters, scale.mm_per_unit), 0);
  for (const Sliding& each : sliding_) {
    constexpr double reached = 14;  // mm of the arrow along the surface
    extent.include(scale, on_line(each.X, each.along, reached, scale.mm_per_unit), letters);
  }
  for (const Arm& each : arms_) {
    const drawings::Point p{scale.mm_per_unit * each.about.x, scale.mm_per_unit * each.about.y},
        q{scale.mm_per_unit * each.foot.x, scale.mm_per_unit * each.foot.y};
    for (const Place& P : {each.about, each.foot}) extent.include(scale, P, letters);
    if (each.left == 0 || drawings::distance(p, q) == 0) continue;
    const drawings::Point aside = each.left * drawings::left_of(drawings::unit(p, q));  // where it is dimensioned
    for (const drawings::Point& end : {p + aside, q + aside}) extent.include(end.x, end.y);
  }
  return extent.box();
}

drawings::Box FreeBodyPanel::extent(const Scale& scale, const Scale& vectors) const {
  constexpr double letters = 8;  // mm
  const drawings::Box near = extent_of_near(scale, vectors);
  Extent extent;
  extent.include(near.low.x, near.low.y);
  extent.include(near.high.x, near.high.y);
  for (const Meeting& each : meetings_) extent.include(scale, each.H, letters);
  for (const Otherwise& each : otherwise_)
    if (each.H && each.makes_room) extent.include(scale, *each.H, letters);
  return extent.box();
}

// So long, whatever the force is: how large it is found to be, the line must not tell.
void FreeBodyPanel::draw_line_of_action(Plot& plot, const Force& force) const {
  const double mm = plot.scale().mm_per_unit;
  plot.segment(on_line(force.at, force.along, -arrow_length, mm), on_line(force.at, force.along, arrow_length, mm),
               Meaning::construction);
}

// What is too short for an arrow tells its value, where one is reported, and its sense: by a sign, or the nearest of
// eight arrows.
std::string FreeBodyPanel::letters_of(const Force& force, const Scale& vectors, Language language) const {
  if (unit_.empty() || !force.value) return force.label;
  const std::string letters = letters_or_value(force.label, *force.value, length_of(force, vectors), unit_, language);
  if (letters == force.label || *force.value < 0) return letters;
  constexpr std::array<const char*, 8> arrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};
  const double eighths = std::atan2(force.along.y, force.along.x) / (std::numbers::pi / 4);
  return letters + "\u2009" + arrows[static_cast<std::size_t>(std::lround(eighths) + 8) % 8];
}

void FreeBodyPanel::draw_force(Plot& plot, const Force& force, Language language) const {
  const double mm = plot.scale().mm_per_unit;
  const OnPaper arrow = on_paper(force, plot.vector_scale());
  const auto at = [&](double along) { return on_line(force.at, force.along, along, mm); };
  if (unit_.empty()) {
    const VectorOnPaper drawn{plot.at(at(arrow.tail)), plot.at(at(arrow.tip))};
    const drawings::Point by = off_links(plot.onto().sheet.figure.marks, drawn);
    const auto aside = [&](const drawings::Point& P) { return plot.from_paper({P.x + by.x, P.y + by.y}); };
    plot.side("", aside(drawn.first), aside(drawn.second), Meaning::force, force.label);
  } else {
    plot.vector_on(force.quantity, at(arrow.tail), force.size * force.along, Meaning::force,
                   letters_of(force, plot.vector_scale(), language));
  }
  // Its line of action after it, and not beneath: a link that hides the arrow moves it aside.
  plot.segment(at(std::min(arrow.tail, 0.0) - line_beyond), at(arrow.tail), Meaning::construction);
  plot.segment(at(arrow.tip), at(std::max(arrow.tip, 0.0) + line_beyond), Meaning::construction);
}

// Whether a dashed line of another motion leaves X in this direction.
bool FreeBodyPanel::is_line_otherwise(const Place& X, double direction) const {
  constexpr double same = 0.01;  // radians
  const Arrow2 along = direction_of(direction);
  const auto lies_there = [&](const Otherwise& motion, const LineOfForce& line) {
    if (distance(line.at, X) > 0 || magnitude(line.along) == 0) return false;
    return std::abs(cross(along, line.along)) < same * magnitude(line.along) &&
           (!motion.H || dot(*motion.H - X, along) > 0);
  };
  return std::any_of(otherwise_.begin(), otherwise_.end(), [&](const Otherwise& motion) {
    return std::any_of(motion.lines.begin(), motion.lines.end(),
                       [&](const LineOfForce& line) { return lies_there(motion, line); });
  });
}

// The arc so far out that it can be seen.
void FreeBodyPanel::draw_turned(Plot& plot, const Turned& turned) const {
  constexpr double clear = 2;  // mm
  const double mm = plot.scale().mm_per_unit, radius = radius_of(turned), leg = leg_of(turned);
  const auto at = [&](double direction, double along) {
    return on_line(turned.X, direction_of(direction), along, mm);
  };
  plot.segment(at(turned.normal, -line_beyond), at(turned.normal, leg), Meaning::axis);
  plot.segment(turned.X, at(turned.force, leg), Meaning::construction);
  const double other_edge = 2 * turned.normal - turned.force;
  if (turned.is_cone && !is_line_otherwise(turned.X, other_edge))
    plot.segment(turned.X, at(other_edge, leg), Meaning::construction);
  const auto [from, to] = std::minmax(turned.force, turned.normal);
  plot.mark(drawings::AngleMark{plot.at(turned.X), radius, from, to, Meaning::dimension});
  plot.small_label(turned.angle, at((from + to) / 2, radius + clear), turned.X);
  if (!turned.letters.empty()) plot.small_label(turned.letters, at(turned.normal, leg), turned.X);
}

// The right angle is marked inside of the corner of dimension line and line of action, where it leaves most of a
// short one free.
void FreeBodyPanel::draw_arm(Plot& plot, const Arm& arm) const {
  constexpr double shortest = 3, mark = 2.2;  // mm
  const double length = distance(arm.about, arm.foot) * plot.scale().mm_per_unit;
  if (length < shortest) return;
  plot.segment(arm.on_line, arm.foot, Meaning::construction);
  const VectorOnPaper line{plot.at(arm.about), plot.at(arm.foot)};
  const double left = arm.left != 0 ? arm.left : off_edges(plot.onto().sheet.figure.marks, line);
  const drawings::Point back = drawings::unit(line.second, line.first),
                        aside = drawings::left_of(drawings::unit(line.first, line.second));
  const double away = dot(plot.at(arm.on_line) - line.second, aside);
  const double inwards = left != 0 ? -left : away;  // along the line of action, to where it runs
  if (length >= 3 * mark)
    plot.mark(drawings::RightAngle{line.second + left * aside, drawings::angle_of(back),
                                   drawings::angle_of((inwards < 0 ? -1.0 : 1.0) * aside)});
  plot.mark(drawings::Dimension{line.first, line.second, left, arm.letters});
  if (!arm.quantity.empty()) plot.measures(arm.quantity, arm.about, arm.foot);
}

void FreeBodyPanel::draw_friction_circle(Plot& plot, const FrictionCircle& circle) {
  plot.circle(circle.X, distance(circle.X, circle.T), Meaning::axis);
  plot.segment(circle.X, circle.T, Meaning::construction);
  plot.dot(circle.T);
  plot.label(circle.letters, circle.X + 0.5 * (circle.T - circle.X));
}

void FreeBodyPanel::draw_sliding(Plot& plot, const Sliding& sliding) {
  constexpr double clear = 3, start = 4, length = 9;  // mm from the surface, and along it
  const double mm = plot.scale().mm_per_unit;
  const Place beside = on_line(sliding.X, sliding.from, clear, mm);
  plot.side("", on_line(beside, sliding.along, start, mm), on_line(beside, sliding.along, start + length, mm),
            Meaning::velocity, sliding.letters);
}

void FreeBodyPanel::draw_otherwise(Plot& plot, const drawings::Box& room, const Otherwise& motion,
                                   Language language) {
  const double mm = plot.scale().mm_per_unit;
  for (const LineOfForce& line : motion.lines) {
    const double size = magnitude(line.along);
    if (size == 0) continue;
    const Arrow2 along = (1 / size) * line.along;
    if (motion.H)
      lead_to(plot, room, line.at, *motion.H, motion.letters, language, Meaning::alternative);
    else
      plot.segment(on_line(line.at, along, -leg, mm), on_line(line.at, along, leg, mm), Meaning::alternative);
  }
  if (!motion.H || !is_in(room, plot, *motion.H)) return;
  plot.cross(*motion.H, Meaning::force);
  plot.label(motion.letters, *motion.H, {}, Meaning::force);
  if (!motion.name.empty()) plot.measures_coordinates(motion.name, *motion.H, {0, 0});
}

void FreeBodyPanel::draw_given(Plot& plot, const drawings::Box&, Language language) const {
  body_->draw(plot);
  for (const Force& force : forces_) {
    if (force.given == Given::all) draw_force(plot, force, language);
    if (force.given != Given::line) continue;
    draw_line_of_action(plot, force);
    plot.label(force.label,
               on_line(force.at, force.along, force.ends ? -arrow_length : arrow_length, plot.scale().mm_per_unit),
               force.at, Meaning::force);
  }
}

// Lines that pass by it are not drawn there.
void FreeBodyPanel::draw_meeting(Plot& plot, const drawings::Box& room, const Meeting& meeting,
                                 Language language) const {
  constexpr double same = 1e-9;  // of the distance: what doubles leave of a line through H
  for (const Force& force : forces_) {
    const Arrow2 to = meeting.H - force.at;
    if (std::abs(cross(force.along, to)) > same * (magnitude(to) + body_->reach())) continue;
    lead_to(plot, room, force.at, meeting.H, meeting.letters, language, Meaning::construction);
  }
  if (!is_in(room, plot, meeting.H)) return;
  plot.cross(meeting.H, Meaning::force);
  plot.label(meeting.letters, meeting.H, {}, Meaning::force);
  if (!meeting.name.empty()) plot.measures_coordinates(meeting.name, meeting.H, {0, 0});
}

std::vector<drawings::Block> FreeBodyPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  body_->draw(plot);
  for (const Otherwise& each : otherwise_) draw_otherwise(plot, room, each, language);
  for (const Meeting& each : meetings_) draw_meeting(plot, room, each, language);
  for (const String& each : strings_) {
    plot.segment(each.from, each.to, Meaning::construction);
    if (each.letters.empty()) continue;
    plot.label(each.letters, each.from + 0.5 * (each.to - each.from), {}, Meaning::construction);
    plot.dot(each.to);
  }
  for (const Line& each : lines_) {
    const Place end = seen_end(plot, room, each.from, each.to);
    plot.segment(each.from, end, Meaning::construction);
    plot.label(each.letters, each.from + 0.5 * (end - each.from));
  }
  for (const Turned& each : turned_) draw_turned(plot, each);
  for (const Arm& each : arms_) draw_arm(plot, each);
  for (const FrictionCircle& each : circles_) draw_friction_circle(plot, each);
  for (const Sliding& each : sliding_) draw_sliding(plot, each);
  for (const Force& force : forces_) {
    if (force.given == Given::line) draw_line_of_action(plot, force);
    draw_force(plot, force, language);
  }
  for (const Couple& couple : couples_)
    draw_arc_arrow(plot, couple.about,
                   arc_in_the_clear(arc_of(couple), plot.at(couple.about), plot.onto().sheet.figure.marks));
  return {};
}

}  // namespace epure
