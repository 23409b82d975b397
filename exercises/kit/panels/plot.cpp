#include "exercises/kit/panels/plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "drawings/output.h"
#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/rounded.h"

namespace epure {
namespace {

constexpr double farthest_measured = 0x1p20;  // mm from a plane's origin: what roundings cost in OnSheet counts on it
constexpr double farthest = 1000;             // mm: more than any way across the paper

// The part of pq within `farthest` of the paper, which is all that can be seen of it; none when both ends are so far
// off that doubles no longer know where the line between them passes.
std::optional<std::pair<drawings::Point, drawings::Point>> near_paper(drawings::Point p, drawings::Point q) {
  constexpr double unknown = 1e9;  // mm: there a double is worth 1e-7 mm
  const auto size = [](drawings::Point a) { return std::max(std::abs(a.x), std::abs(a.y)); };
  if (size(p) > unknown && size(q) > unknown) return {};
  const bool swapped = size(q) < size(p);
  if (swapped) std::swap(p, q);  // from the nearer end, so that a far one costs no digits
  double from = 0, to = 1;
  for (const auto& [start, way] : {std::pair{p.x, q.x - p.x}, std::pair{p.y, q.y - p.y}}) {
    if (way == 0 && std::abs(start) > farthest) return {};
    if (way == 0) continue;
    const double a = (-farthest - start) / way, b = (farthest - start) / way;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from > to) return {};
  const auto at = [&](double t) -> drawings::Point {
    return t == 1 ? q : drawings::Point{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  };
  return swapped ? std::pair{at(to), at(from)} : std::pair{at(from), at(to)};
}

// How a straight link runs on from a point of it: both ways.
std::vector<drawings::Point> ways_along(const drawings::Line& line, drawings::Point from) {
  constexpr double on_it = 0.1, shortest = 3;  // mm
  std::vector<drawings::Point> ways;
  if (line.meaning != Meaning::link || line.path.closed || line.path.pieces.size() != 1 ||
      !line.path.pieces.front().straight)
    return ways;
  const drawings::Point p = line.path.start, q = line.path.pieces.front().end;
  const double length = drawings::distance(p, q);
  if (length < shortest) return ways;
  const drawings::Point along = drawings::unit(p, q);
  const double there = dot(from - p, along);
  if (std::abs(dot(from - p, drawings::left_of(along))) > on_it || there < -on_it || there > length + on_it)
    return ways;
  if (there > shortest) ways.push_back(p - from);
  if (there < length - shortest) ways.push_back(q - from);
  return ways;
}

bool ends_at(const drawings::Mark& mark, drawings::Point tip) {
  constexpr double on_it = 0.05;  // mm
  const auto* vector = std::get_if<drawings::Arrow>(&mark);
  return vector && drawings::distance(vector->to, tip) < on_it;
}

bool leads_to(const drawings::Mark& mark, drawings::Point tip) {
  constexpr double on_it = 0.05;  // mm
  const auto* line = std::get_if<drawings::Line>(&mark);
  if (!line || line->meaning != Meaning::construction || line->path.pieces.size() != 1) return false;
  const drawings::Point p = line->path.start, q = line->path.pieces.front().end;
  const drawings::Point along = drawings::unit(p, q);
  const double there = dot(tip - p, along);
  return there > -on_it && there < drawings::distance(p, q) + on_it &&
         std::abs(dot(tip - p, drawings::left_of(along))) < on_it;
}

// Whether a vector runs on where the link has ended: through the joint there.
bool runs_past(drawings::Point way, drawings::Point v) { return drawings::length(v) > drawings::length(way); }

// Whether a link hides most of a vector, or the joint at its end does: they part so little along it that the eye does
// not tell them apart.
bool hides(drawings::Point way, drawings::Point v) {
  constexpr double most = 0.5, told_apart = 2;  // of the vector, mm
  const double one_way = std::cos(7 * std::numbers::pi / 180);
  const double length = drawings::length(v), shared = std::min(length, drawings::length(way));
  const double sine = std::abs(dot(v, drawings::left_of(way))) / (length * drawings::length(way));
  return dot(v, way) >= one_way * length * drawings::length(way) && (shared >= most * length || runs_past(way, v)) &&
         sine * shared < told_apart;
}

// The direction in which the support of a fixed hinge stands; none without one.
std::optional<drawings::Point> support_at(const std::vector<drawings::Mark>& marks, drawings::Point at) {
  constexpr double there = 0.1;  // mm
  for (const drawings::Mark& mark : marks)
    if (const auto* fixed = std::get_if<drawings::FixedHinge>(&mark);
        fixed && drawings::distance(fixed->at, at) < there)
      return drawings::direction(fixed->down);
  return {};
}

// Whether a vector stands there already, along this one.
bool is_taken(const drawings::Mark& mark, drawings::Point from, drawings::Point to) {
  constexpr double one_line = 1;  // mm
  const auto* vector = std::get_if<drawings::Arrow>(&mark);
  const auto is_near = [&](drawings::Point end, drawings::Point p, drawings::Point q) {
    return drawings::distance(end, drawings::nearest_on(p, q, end)) < one_line;
  };
  return vector && ((is_near(from, vector->from, vector->to) && is_near(to, vector->from, vector->to)) ||
                    (is_near(vector->from, from, to) && is_near(vector->to, from, to)));
}

// How far aside a vector stands that a link would hide: on the side to which it leans, joined to the point it
// belongs to; twice as far where another stands already. Past the link's end it keeps clear of the hinge there, and
// stands on the side that its support leaves free. Where lines of the construction lead to its tip it stays there,
// and at the tip of another vector too: they are sides of a polygon.
drawings::Point aside(const std::vector<drawings::Mark>& marks, drawings::Point from, drawings::Point to) {
  constexpr double beside_link = 1.3, beside_hinge = 2.4, shortest = 4;  // mm
  const drawings::Point v = to - from;
  if (drawings::length(v) < shortest || std::any_of(marks.begin(), marks.end(), [&](const drawings::Mark& mark) {
        return leads_to(mark, to) || ends_at(mark, to) || ends_at(mark, from);
      }))
    return {0, 0};
  for (const drawings::Mark& mark : marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line) continue;
    for (const drawings::Point way : ways_along(*line, from)) {
      if (!hides(way, v)) continue;
      const auto support = runs_past(way, v) ? support_at(marks, from + way) : std::nullopt;
      const bool is_left = support ? dot(*support, drawings::left_of(v)) < 0 : dot(v, drawings::left_of(way)) >= 0;
      const double by = runs_past(way, v) ? beside_hinge : beside_link;
      const drawings::Point shift = (is_left ? by : -by) * drawings::left_of(drawings::unit({}, v));
      const bool is_second = std::any_of(marks.begin(), marks.end(), [&](const drawings::Mark& other) {
        return is_taken(other, from + shift, to + shift);
      });
      return (is_second ? 2 : 1) * shift;
    }
  }
  return {0, 0};
}

}  // namespace

void Plot::in_step(std::optional<int> number) {
  drawings::Figure& figure = onto_.sheet.figure;
  figure.known_of_marks.resize(figure.marks.size(), {.number = step_});
  figure.known_of_labels.resize(figure.labels.size(), {.number = step_});
  step_ = number;
}

void Plot::segment(const Place& P, const Place& Q, Meaning meaning, const std::string& name) {
  if (const auto seen = near_paper(at(P), at(Q))) {
    mark(drawings::Line{drawings::segment(seen->first, seen->second), meaning, name});
  }
}

bool Plot::shows(const Place& P) const {
  const drawings::Box area = room_.value_or(drawings::drawing_area(onto_.sheet.paper));
  const drawings::Point p = at(P);
  return p.x >= area.low.x && p.x <= area.high.x && p.y >= area.low.y && p.y <= area.high.y;
}

void Plot::long_segment(const Place& P, const Place& Q, double beyond, Meaning meaning) {
  const drawings::Point p = at(P), q = at(Q);
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  if (length == 0) return;
  const double dx = (q.x - p.x) / length * beyond, dy = (q.y - p.y) / length * beyond;
  segment(from_paper({p.x - dx, p.y - dy}), from_paper({q.x + dx, q.y + dy}), meaning);
}

void Plot::direction_line(const Place& P, const Place& Q, double beyond, const std::string& what) {
  const drawings::Point p = at(P), q = at(Q);
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  if (length == 0) return;
  long_segment(P, Q, beyond, Meaning::construction);
  const Place end = from_paper({q.x + (q.x - p.x) / length * beyond, q.y + (q.y - p.y) / length * beyond});
  small_label(what, end, Q);
}

void Plot::polygon(const std::vector<Place>& corners, Meaning meaning) {
  std::vector<drawings::Point> on_paper;
  for (const Place& P : corners) on_paper.push_back(at(P));
  mark(drawings::Line{drawings::polyline(on_paper, true), meaning, {}});
}

void Plot::area(const std::vector<Place>& corners, Meaning meaning) {
  std::vector<drawings::Point> on_paper;
  for (const Place& P : corners) on_paper.push_back(at(P));
  mark(drawings::Area{drawings::polyline(on_paper, true), meaning, {}});
}

void Plot::circle(const Place& centre, double radius, Meaning meaning, const std::string& name) {
  mark(drawings::Line{drawings::circle(at(centre), radius * scale_.mm_per_unit), meaning, name});
}

namespace {

// Around the point of the circle that is nearest to `middle`, as far as the paper reaches. Written from that point,
// not from the centre, so that a centre kilometres away costs no digits.
drawings::Path arc_near(drawings::Point centre, double radius, drawings::Point middle) {
  const double toward = drawings::angle_of(middle - centre);
  const drawings::Point nearest{centre.x + radius * std::cos(toward), centre.y + radius * std::sin(toward)};
  const double half = farthest / radius;
  constexpr int pieces = 8;
  const auto at = [&](double turn) -> drawings::Point {
    const double across = 2 * std::sin(turn / 2);  // the chord from `nearest`, over the radius
    return {nearest.x - radius * across * std::sin(toward + turn / 2),
            nearest.y + radius * across * std::cos(toward + turn / 2)};
  };
  drawings::Path path{at(-half), {}, false};
  const double step = 2 * half / pieces, handle = 4.0 / 3 * std::tan(step / 4) * radius;
  for (int i = 0; i < pieces; ++i) {
    const double from = -half + i * step, to = from + step;
    const drawings::Point p = at(from), q = at(to);
    path.pieces.push_back({false,
                           {p.x - handle * std::sin(toward + from), p.y + handle * std::cos(toward + from)},
                           {q.x + handle * std::sin(toward + to), q.y - handle * std::cos(toward + to)},
                           q});
  }
  return path;
}

}  // namespace

void Plot::cycle(const DrawnCycle& cycle, Meaning meaning, const std::string& name) {
  const drawings::Box area = drawings::drawing_area(onto_.sheet.paper);
  const drawings::Point middle{(area.low.x + area.high.x) / 2, (area.low.y + area.high.y) / 2};
  if (cycle.centre) {
    // Beyond this radius an arc across the paper rises by half a micrometre: it is drawn as its tangent.
    constexpr double straight = 1e9;  // mm
    const double radius = cycle.radius * scale_.mm_per_unit;
    if (radius < farthest) return circle(*cycle.centre, cycle.radius, meaning, name);
    if (radius < straight) return mark(drawings::Line{arc_near(at(*cycle.centre), radius, middle), meaning, name});
  }
  if (!cycle.on_line) return;
  const drawings::Point foot = at(*cycle.on_line);
  const double length = std::hypot(cycle.along.x, cycle.along.y);
  const double dx = cycle.along.x / length * farthest, dy = cycle.along.y / length * farthest;
  mark(drawings::Line{drawings::segment({foot.x - dx, foot.y - dy}, {foot.x + dx, foot.y + dy}), meaning, name});
}

void Plot::dot(const Place& P, Meaning meaning) {
  if (shows(P)) mark(drawings::Dot{at(P), meaning, {}});
}
void Plot::cross(const Place& P, Meaning meaning) {
  if (shows(P)) mark(drawings::Cross{at(P), meaning, {}});
}
void Plot::hinge(const Place& P) { mark(drawings::Hinge{at(P)}); }

void Plot::right_angle(const Place& P, const Place& Q, const Place& R) {
  if (!shows(P)) return;
  const drawings::Point p = at(P), q = at(Q), r = at(R);
  if (std::hypot(q.x - p.x, q.y - p.y) < 3 || std::hypot(r.x - p.x, r.y - p.y) < 3) return;  // no room for the mark
  mark(drawings::RightAngle{p, drawings::angle_of(q - p), drawings::angle_of(r - p)});
}

void Plot::side(const std::string& name, const Place& from, const Place& to, Meaning meaning,
                const std::string& label, std::optional<Place> away_from) {
  mark(drawings::Arrow{at(from), at(to), meaning, name});
  if (!label.empty()) {
    drawings::Label beside{.text = label, .at = at(from), .to = at(to), .ink = meaning};
    if (away_from) beside.away_from = at(*away_from);
    onto_.sheet.figure.labels.push_back(beside);
  }
  if (!name.empty()) measures(name, from, to);
}

Place Plot::tip(const Place& from, const Arrow2& v) const {
  const double units = vectors_.mm_per_unit / scale_.mm_per_unit;
  return {from.x + units * v.x, from.y + units * v.y};
}

void Plot::vector_on(const std::string& name, const Place& from, const Arrow2& v, Meaning meaning,
                     const std::string& label) {
  const Place to = tip(from, v);
  const drawings::Point by = aside(onto_.sheet.figure.marks, at(from), at(to)), p = at(from) + by, q = at(to) + by;
  if (by.x != 0 || by.y != 0) mark(drawings::Line{drawings::segment(at(from), p), Meaning::dimension, {}});
  mark(drawings::Arrow{p, q, meaning, name});
  onto_.sheet.figure.labels.push_back({.text = label, .at = p, .to = q, .ink = meaning});
  if (!name.empty()) measure(name, from_paper(p), from_paper(q), 1 / vectors_.mm_per_unit, Measurement::length);
}

void Plot::label(const std::string& text, const Place& P, std::optional<Place> away_from, Meaning ink) {
  if (!shows(P)) return;
  drawings::Label label{.text = text, .at = at(P), .ink = ink};
  if (away_from && shows(*away_from)) label.away_from = at(*away_from);
  onto_.sheet.figure.labels.push_back(label);
}

void Plot::small_label(const std::string& text, const Place& P, const Place& away_from, Meaning ink) {
  constexpr double small = 2.5;
  onto_.sheet.figure.labels.push_back(
      {.text = text, .at = at(P), .ink = ink, .away_from = at(away_from), .size = small});
}

void Plot::step(int number, const Place& P) {
  if (shows(P)) onto_.sheet.figure.steps.push_back({number, at(P)});
}

void Plot::measure(const std::string& name, const Place& from, const Place& to, double per_mm,
                   Measurement::Kind kind) {
  if (!shows(from) || !shows(to)) return;
  // A close-up may stand so far from its plane's origin that doubles hardly tell its points apart, or no longer do.
  const double mm = scale_.mm_per_unit;
  const drawings::Point p{mm * from.x, mm * from.y}, q{mm * to.x, mm * to.y};
  drawings::demand_drawable(p);
  drawings::demand_drawable(q);
  const double farthest_off = std::max({std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)});
  if (farthest_off < farthest_measured) onto_.measurements.push_back({name, at(from), at(to), per_mm, kind});
}

void Plot::measures(const std::string& name, const Place& P, const Place& Q) {
  measure(name, P, Q, 1 / scale_.mm_per_unit, Measurement::length);
}

void Plot::measures_abscissa(const std::string& name, const Place& P, const Place& origin) {
  measure(name, origin, P, 1 / scale_.mm_per_unit, Measurement::along_x);
}

void Plot::measures_coordinates(const std::string& name, const Place& P, const Place& origin) {
  measure(name + "_x", origin, P, 1 / scale_.mm_per_unit, Measurement::along_x);
  measure(name + "_y", origin, P, 1 / scale_.mm_per_unit, Measurement::along_y);
}

}  // namespace epure
