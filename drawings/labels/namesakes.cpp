#include "drawings/labels/namesakes.h"

#include <algorithm>

#include "drawings/labels/window.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {

namespace {

constexpr double on_it = 0.05;    // mm: the label was given the mark's own ends
constexpr double one_mark = 0.5;  // mm: nearer than this, two marks are one to the eye

double between_point(Point p, const Segment& mark) { return gap(Box{p, p}, mark.first, mark.second); }

bool is_one_mark(const Segment& first, const Segment& second) {
  const auto lies_on = [](const Segment& a, const Segment& b) {
    return between_point(between(a.first, a.second, 0.5), b) < one_mark;
  };
  return lies_on(first, second) || lies_on(second, first);
}

// Whether a label was given all of a mark, either way round.
bool is_all_of(const Segment& mark, Point at, Point to) {
  const auto ends_there = [&](Point from, Point end) {
    return distance(mark.first, from) < on_it && distance(mark.second, end) < on_it;
  };
  return ends_there(at, to) || ends_there(to, at);
}

std::optional<Point> point_of(const Mark& mark) {
  if (const auto* dot = std::get_if<Dot>(&mark)) return dot->at;
  if (const auto* cross = std::get_if<Cross>(&mark)) return cross->at;
  if (const auto* hinge = std::get_if<Hinge>(&mark)) return hinge->at;
  if (const auto* fixed = std::get_if<FixedHinge>(&mark)) return fixed->at;
  return {};
}

}  // namespace

Namesakes::Namesakes(const Figure& figure, const std::vector<Label>& labels, Box area) {
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const Mark& mark = figure.marks[i];
    const Box window = window_of(figure, i, area);
    if (const auto* arrow = std::get_if<Arrow>(&mark)) {
      add(vectors_, arrow->from, arrow->to, arrow->meaning, window);
    } else if (const auto* line = std::get_if<Line>(&mark)) {
      Point at = line->path.start;
      for (const Piece& piece : line->path.pieces) {
        if (piece.straight) add(lines_, at, piece.end, line->meaning, window);
        at = piece.end;
      }
      if (line->path.closed) add(lines_, at, line->path.start, line->meaning, window);
    } else if (const auto* angle = std::get_if<AngleMark>(&mark)) {
      arcs_.push_back({angle->at, angle->radius, angle->from, angle->to});
    } else if (const auto* turning = std::get_if<Rotation>(&mark)) {
      arcs_.push_back({turning->centre, turning->radius, std::min(turning->from, turning->to),
                       std::max(turning->from, turning->to)});
    } else if (const auto point = point_of(mark)) {
      add(points_, *point, *point, Meaning::text, window);
    }
  }
  Kind clear = vectors_;
  for (Shown& each : clear) each.seen = clear_of_shorter(vectors_, each);
  vectors_ = std::move(clear);
  for (const Label& label : labels)
    if (!label.to) add(labelled_points_, label.at, label.at, Meaning::text, area);
}

void Namesakes::add(Kind& kind, Point from, Point to, Meaning meaning, Box window) {
  if (const auto seen = clip_segment(from, to, window)) kind.push_back({{from, to}, *seen, meaning});
}

// The longest part that no shorter vector covers; all of it, where hardly any is left.
Segment Namesakes::clear_of_shorter(const Kind& vectors, const Shown& vector) {
  constexpr double told_apart = 3;  // mm
  const auto& [tail, tip] = vector.seen;
  const double whole = distance(tail, tip);
  const Point along = unit(tail, tip);
  std::vector<std::pair<double, double>> covered;
  for (const Shown& each : vectors) {
    const auto& [from, to] = each.seen;
    if (each.meaning != vector.meaning || between_point(from, vector.seen) > one_mark ||
        between_point(to, vector.seen) > one_mark || distance(from, to) > whole - told_apart)
      continue;
    covered.push_back(std::minmax(dot(from - tail, along), dot(to - tail, along)));
  }
  std::sort(covered.begin(), covered.end());
  covered.emplace_back(whole, whole);
  std::pair<double, double> longest{0, 0};
  double end = 0;
  for (const auto& [from, to] : covered) {
    if (from - end > longest.second - longest.first) longest = {end, from};
    end = std::max(end, to);
  }
  if (longest.second - longest.first < told_apart) return vector.seen;
  return {tail + longest.first * along, tail + longest.second * along};
}

const Namesakes::Shown* Namesakes::on_one(const Kind& kind, Point at, Point to) {
  const auto found = std::find_if(kind.begin(), kind.end(), [&](const Shown& each) {
    return between_point(at, each.whole) < on_it && between_point(to, each.whole) < on_it;
  });
  return found == kind.end() ? nullptr : &*found;
}

void Namesakes::add_others(Naming& naming, const Kind& kind, const Label& label, const Shown& own, double reach) {
  const Box around = grown(include(include(nothing(), own.seen.first), own.seen.second), reach);
  for (const Shown& each : kind) {
    if (each.meaning != own.meaning || is_beyond(0, around, each.seen.first, each.seen.second)) continue;
    if (is_one_mark(own.seen, each.seen) || (!label.to && between_point(label.at, each.seen) < one_mark)) continue;
    naming.others.push_back(each.seen);
  }
}

bool Namesakes::is_on(const Arc& arc, Point at) {
  if (std::abs(distance(arc.centre, at) - arc.radius) > on_it) return false;
  constexpr double turn = 2 * std::numbers::pi;
  const double there = angle_of(at - arc.centre) - arc.from;
  return there - turn * std::floor(there / turn) <= arc.to - arc.from;
}

bool Namesakes::add_arcs(Naming& naming, Point at, double reach) const {
  const auto own = std::find_if(arcs_.begin(), arcs_.end(), [&](const Arc& arc) { return is_on(arc, at); });
  if (own == arcs_.end()) return false;
  add_passing(naming, lines_, Meaning::link, at, reach);
  constexpr double chord = 0.1;  // radians
  const Box around = grown(Box{at, at}, reach);
  double nearest = INFINITY;
  for (const Arc& arc : arcs_) {
    const auto pieces = static_cast<int>(std::ceil((arc.to - arc.from) / chord));
    const auto on_arc = [&](int i) {
      return arc.centre + arc.radius * direction(arc.from + (arc.to - arc.from) * i / pieces);
    };
    for (int i = 0; i < pieces; ++i) {
      const Segment piece{on_arc(i), on_arc(i + 1)};
      if (&arc == &*own) {
        if (between_point(at, piece) < nearest) {
          nearest = between_point(at, piece);
          naming.own = piece;
        }
      } else if (!is_beyond(0, around, piece.first, piece.second)) {
        naming.others.push_back(piece);
      }
    }
  }
  return true;
}

void Namesakes::add_passing(Naming& naming, const Kind& kind, std::optional<Meaning> of, Point at, double reach) {
  for (const Shown& each : kind) {
    const double away = between_point(at, each.whole);
    if ((!of || each.meaning == *of) && away > one_mark && away < reach) naming.not_between.push_back(each.whole);
  }
}

Naming Namesakes::of(const Label& label, double width) const {
  constexpr double farthest_off = 6;  // mm: from what they name, without a leader, with what is clearly nearer
  const double reach = width + farthest_off;
  const Point at = label.at, to = label.to.value_or(label.at);
  Naming naming{{at, to}, {}};
  const auto is_among = [&](const Kind& kind) {
    const Shown* own = on_one(kind, at, to);
    if (!own) return false;
    if (!label.to || is_all_of(own->whole, at, to)) naming.own = own->seen;
    add_others(naming, kind, label, {{at, to}, label.to ? naming.own : Segment{at, to}, own->meaning}, reach);
    return true;
  };
  if (label.to) {
    if (!is_among(vectors_)) is_among(lines_);
  } else {
    const bool is_point = on_one(points_, at, at) != nullptr, is_line = !is_point && is_among(lines_);
    const bool is_arc = !is_point && !is_line && add_arcs(naming, at, reach);
    if (!is_line) {
      const Shown point{{at, at}, {at, at}, Meaning::text};
      add_others(naming, points_, label, point, reach);
      add_others(naming, labelled_points_, label, point, reach);
    }
    if (is_point || is_line || is_arc) {  // and no caption
      add_passing(naming, vectors_, {}, at, reach);
      add_passing(naming, lines_, Meaning::axis, at, reach);
    }
  }
  return naming;
}

}  // namespace epure::drawings
