#include "exercises/kit/panels/close_up.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"

namespace epure {
namespace {

// Joints nearer than this on the paper cannot be told apart: their circles and letters cover each other.
constexpr double joints_told_apart = 6;  // mm
constexpr double worth_drawing = 2.5;    // times larger than in the whole
constexpr double same_place = 1e-4;      // of what they all span: nothing is to be seen between these
constexpr double beside_the_part = 0.3;  // of its size, around it: links that lead there
constexpr double beside_a_crowd = 0.1, least_side = 0.6;  // of its size, of a crowd on a line too

struct SmallPart {
  Place low, high;
  std::vector<Place> points;
  void widen(double x, double y) {
    low = {low.x - x, low.y - y};
    high = {high.x + x, high.y + y};
  }
};

double extent_of_places(const std::vector<Place>& points) {
  double largest = 0;
  for (const Place& P : points)
    for (const Place& Q : points) largest = std::max(largest, distance(P, Q));
  return largest;
}

double distance_to(const std::vector<Place>& points, const Place& P) {
  double least = distance(points.front(), P);
  for (const Place& Q : points) least = std::min(least, distance(Q, P));
  return least;
}

// What of a mechanism is drawn: its hinges and blocks, the ends of its links, and of its discs the centre with a
// point of the rim.
struct DrawnJoints {
  std::vector<Place> joints;
  std::vector<std::pair<Place, Place>> links, discs;

  double extent() const {
    std::vector<Place> all = joints;
    for (const auto* pairs : {&links, &discs})
      for (const auto& [P, Q] : *pairs) all.insert(all.end(), {P, Q});
    return extent_of_places(all);
  }
};

// The link's ends that are nearest to each other and two to the eye, or what a disc spans; nothing where all are
// long.
std::vector<Place> shortest_link(const DrawnJoints& drawn, double least) {
  const auto is_joint = [&](const Place& P) { return distance_to(drawn.joints, P) <= least; };
  std::vector<Place> shortest;
  const auto take = [&](const Place& P, const Place& Q) {
    if (const double d = distance(P, Q); d > least)
      if (shortest.empty() || d < distance(shortest[0], shortest[1])) shortest = {P, Q};
  };
  for (const auto& [P, Q] : drawn.links)
    if (is_joint(P) && is_joint(Q)) take(P, Q);
  for (const auto& [low, high] : drawn.discs) take(low, high);
  return shortest;
}

// The largest of the crowds, in which each letter stands in the way of the next, and what is nearly as close to it;
// nothing where all have room. Two points that are one to the eye are a crowd too, with what is nearest to them; not
// so of vectors, where such a one has its value beside it.
std::vector<Place> largest_crowd(const std::vector<Place>& points, double mm_per_unit, double least,
                                 bool are_of_vectors) {
  constexpr double one_to_the_eye = 1.9;  // mm: their crosses lie on one another
  // Three letters find room around their points; but the sides of a polygon have letters too.
  const double in_the_way = are_of_vectors ? 6 : 4.5;  // mm
  const std::size_t crowd = are_of_vectors ? 3 : 4;
  const auto are_one = [&](const std::vector<Place>& together) {
    if (are_of_vectors) return false;
    for (std::size_t i = 0; i < together.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (distance(together[i], together[j]) * mm_per_unit < one_to_the_eye) return true;
    return false;
  };
  std::vector<Place> distinct, largest;
  for (const Place& P : points)
    if (distinct.empty() || distance_to(distinct, P) > least) distinct.push_back(P);
  while (!distinct.empty()) {
    std::vector<Place> together{distinct.back()};
    distinct.pop_back();
    for (std::size_t i = 0; i < together.size(); ++i) {
      const auto near = std::partition(distinct.begin(), distinct.end(), [&](const Place& P) {
        return distance(P, together[i]) * mm_per_unit >= in_the_way;
      });
      together.insert(together.end(), near, distinct.end());
      distinct.erase(near, distinct.end());
    }
    if (together.size() > largest.size() && (together.size() >= crowd || are_one(together)))
      largest = std::move(together);
  }
  if (largest.empty()) return {};
  if (largest.size() < crowd) {
    const Place* nearest = nullptr;
    for (const Place& P : points)
      if (distance_to(largest, P) > least && (!nearest || distance_to(largest, P) < distance_to(largest, *nearest)))
        nearest = &P;
    if (nearest) largest.push_back(*nearest);
  }
  constexpr double beside = 0.8;  // of its size
  std::vector<Place> around = largest;
  for (const Place& P : points)
    if (distance_to(largest, P) <= beside * extent_of_places(largest)) around.push_back(P);
  return around;
}

// How many of them stand so far from one another.
std::size_t count_apart(const std::vector<Place>& points, double least) {
  std::vector<Place> apart;
  for (const Place& P : points)
    if (apart.empty() || distance_to(apart, P) >= least) apart.push_back(P);
  return apart.size();
}

// Those around the nearest two: one after the other as long as the next is not far for the size of the part.
std::vector<Place> close_together(std::vector<Place> part, std::vector<Place> joints) {
  constexpr double far = 3;  // sizes of the part
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    const double limit = far * extent_of_places(part);
    for (auto P = joints.begin(); P != joints.end();) {
      if (distance_to(part, *P) > limit) {
        ++P;
        continue;
      }
      if (distance_to(part, *P) > 0) {
        part.push_back(*P);
        has_grown = true;
      }
      P = joints.erase(P);
    }
  }
  return part;
}

bool is_round(const drawings::Area& area) {
  return area.meaning == Meaning::plate && std::none_of(area.path.pieces.begin(), area.path.pieces.end(),
                                                        [](const drawings::Piece& piece) { return piece.straight; });
}

DrawnJoints joints_drawn(const PlacedPanel& placed, const SheetRequest& request) {
  DrawnSheet scratch;
  scratch.sheet.paper = request.paper;
  Plot plot(scratch, placed.origin, placed.lengths);
  plot.vectors_at(placed.vectors);
  placed.panel->draw_given(plot, placed.room, request.language);
  DrawnJoints drawn;
  for (const drawings::Mark& mark : scratch.sheet.figure.marks) {
    if (const auto* area = std::get_if<drawings::Area>(&mark); area && is_round(*area)) {
      const drawings::Box box = drawings::bounds(area->path);
      drawn.discs.push_back({plot.from_paper(box.low), plot.from_paper(box.high)});
    }
    if (const auto* hinge = std::get_if<drawings::Hinge>(&mark)) drawn.joints.push_back(plot.from_paper(hinge->at));
    if (const auto* fixed = std::get_if<drawings::FixedHinge>(&mark))
      drawn.joints.push_back(plot.from_paper(fixed->at));
    if (const auto* block = std::get_if<drawings::Slider>(&mark)) drawn.joints.push_back(plot.from_paper(block->at));
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line || line->meaning != Meaning::link) continue;
    drawings::Point from = line->path.start;
    for (const drawings::Piece& piece : line->path.pieces) {
      if (piece.straight) drawn.links.push_back({plot.from_paper(from), plot.from_paper(piece.end)});
      from = piece.end;
    }
  }
  return drawn;
}

// Joints that cannot be told apart, and what is around them.
std::vector<Place> joints_together(const PlacedPanel& placed, const SheetRequest& request) {
  const DrawnJoints drawn = joints_drawn(placed, request);
  if (drawn.joints.empty()) return {};
  std::vector<Place> part = shortest_link(drawn, same_place * drawn.extent());
  if (part.empty() || distance(part[0], part[1]) * placed.lengths.mm_per_unit >= joints_told_apart) return {};
  return close_together(std::move(part), drawn.joints);
}

// What needs a close-up at the scale that was found; none: all can be told apart.
std::optional<SmallPart> part_too_small(const PlacedPanel& placed, const SheetRequest& request) {
  if (!placed.panel->has_scale()) return {};
  std::vector<Place> part;
  if (!placed.panel->is_of_vectors()) part = joints_together(placed, request);
  const bool is_crowd = part.empty();
  if (is_crowd) {
    const std::vector<Place> lettered = placed.panel->lettered();
    part = largest_crowd(lettered, placed.plane().mm_per_unit, same_place * extent_of_places(lettered),
                         placed.panel->is_of_vectors());
  }
  if (part.empty()) return {};
  SmallPart found{part.front(), part.front(), part};
  for (const Place& P : part) {
    found.low = {std::min(found.low.x, P.x), std::min(found.low.y, P.y)};
    found.high = {std::max(found.high.x, P.x), std::max(found.high.y, P.y)};
  }
  const double size = extent_of_places(part), air = (is_crowd ? beside_a_crowd : beside_the_part) * size;
  found.widen(air, air);
  if (is_crowd)
    found.widen(std::max(0.0, least_side * size - (found.high.x - found.low.x)) / 2,
                std::max(0.0, least_side * size - (found.high.y - found.low.y)) / 2);
  return found;
}

// Where a mark stands that is a symbol or a vector; none for lines and areas, which are seen in the whole too.
std::optional<drawings::Point> place_of(const drawings::Mark& mark) {
  return std::visit(
      [](const auto& each) -> std::optional<drawings::Point> {
        using Kind = std::decay_t<decltype(each)>;
        if constexpr (std::is_same_v<Kind, drawings::Arrow>)
          return each.from;
        else if constexpr (std::is_same_v<Kind, drawings::Rotation>)
          return each.centre;
        else if constexpr (std::is_same_v<Kind, drawings::Dimension>)
          return drawings::Point{(each.from.x + each.to.x) / 2, (each.from.y + each.to.y) / 2};
        else if constexpr (requires { each.at; } && !std::is_same_v<Kind, drawings::ScaleBar>)
          return each.at;
        else
          return std::nullopt;
      },
      mark);
}

drawings::Point place_of_label(const drawings::Label& label) {
  const drawings::Point to = label.to.value_or(label.at);
  return {(label.at.x + to.x) / 2, (label.at.y + to.y) / 2};
}

// The symbol of an arc stands at its middle, away from its centre; letters of a joint may be as far from that.
bool is_symbol_of(const drawings::Label& label, const drawings::Mark& mark) {
  constexpr double same = 1e-3;  // mm
  const auto stands_at = [&](const drawings::Point& centre, double radius, double middle) {
    return label.away_from && label.away_from->x == centre.x && label.away_from->y == centre.y &&
           drawings::distance(label.at, centre + radius * drawings::direction(middle)) < same;
  };
  if (const auto* arrow = std::get_if<drawings::Rotation>(&mark))
    return stands_at(arrow->centre, arrow->radius, (arrow->from + arrow->to) / 2);
  if (const auto* arc = std::get_if<drawings::AngleMark>(&mark))
    return stands_at(arc->at, arc->radius, (arc->from + arc->to) / 2);
  return false;
}

// Of a mechanism's joints, and of points of its bodies.
std::optional<drawings::Point> place_of_joint(const drawings::Mark& mark) {
  const auto* dot = std::get_if<drawings::Dot>(&mark);
  const bool is_joint = std::holds_alternative<drawings::Hinge>(mark) ||
                        std::holds_alternative<drawings::FixedHinge>(mark) || (dot && dot->meaning == Meaning::link);
  return is_joint ? place_of(mark) : std::nullopt;
}

// The joints drawn since that the whole shows too: no other is so near that it cannot be told from this one.
std::vector<drawings::Point> joints_alone(const drawings::Figure& figure, const DrawnSoFar& before) {
  std::vector<drawings::Point> all, alone;
  for (std::size_t i = before.marks; i < figure.marks.size(); ++i)
    if (const auto at = place_of_joint(figure.marks[i])) all.push_back(*at);
  std::copy_if(all.begin(), all.end(), std::back_inserter(alone), [&](const drawings::Point& one) {
    return std::none_of(all.begin(), all.end(), [&](const drawings::Point& other) {
      const double apart = drawings::distance(one, other);
      return apart > 0 && apart < joints_told_apart;
    });
  });
  return alone;
}
bool is_one_of(const std::vector<drawings::Point>& all, const drawings::Point& P) {
  return std::any_of(all.begin(), all.end(),
                     [&](const drawings::Point& each) { return drawings::distance(each, P) == 0; });
}

using PaperEnds = std::pair<std::pair<double, double>, std::pair<double, double>>;
PaperEnds paper_ends(const drawings::Point& p, const drawings::Point& q) { return {{p.x, p.y}, {q.x, q.y}}; }

// Of each the place in the list is told.
template <class T>
void take_away(std::vector<T>& all, const std::set<std::size_t>& gone) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (gone.contains(i)) continue;
    if (kept != i) all[kept] = std::move(all[i]);
    ++kept;
  }
  all.resize(kept);
}

// The letters and the dimensions drawn since that stand beyond the frame, which does not cut them.
void leave_out_beyond(const drawings::Box& room, const DrawnSoFar& before, drawings::Figure& figure) {
  std::set<std::size_t> labels, dimensions;
  for (std::size_t i = before.labels; i < figure.labels.size(); ++i)
    if (!drawings::contains(room, place_of_label(figure.labels[i]))) labels.insert(i);
  for (std::size_t i = before.marks; i < figure.marks.size(); ++i)
    if (std::holds_alternative<drawings::Dimension>(figure.marks[i]) &&
        !drawings::contains(room, *place_of(figure.marks[i])))
      dimensions.insert(i);
  take_away(figure.labels, labels);
  take_away(figure.known_of_labels, labels);
  take_away(figure.marks, dimensions);
  take_away(figure.known_of_marks, dimensions);
}

// The name of a vector or line, by which a file tells it; null: it has none.
std::string* name_of(drawings::Mark& mark) {
  auto* const arrow = std::get_if<drawings::Arrow>(&mark);
  auto* const line = std::get_if<drawings::Line>(&mark);
  std::string* const name = arrow ? &arrow->name : line ? &line->name : nullptr;
  return name && !name->empty() ? name : nullptr;
}

bool is_whole_in(const drawings::Box& room, const drawings::Mark& mark) {
  const auto* arrow = std::get_if<drawings::Arrow>(&mark);
  if (arrow) return drawings::contains(room, arrow->from) && drawings::contains(room, arrow->to);
  const drawings::Path& path = std::get<drawings::Line>(mark).path;
  return drawings::contains(room, path.start) &&
         std::all_of(path.pieces.begin(), path.pieces.end(),
                     [&](const drawings::Piece& piece) { return drawings::contains(room, piece.end); });
}

// What a polygon and its close-up both show is named and measured once: where it is larger, but for what the frame
// cuts.
void tell_once(const drawings::Box& room, const DrawnSoFar& before, DrawnSheet& onto) {
  auto& marks = onto.sheet.figure.marks;
  std::set<std::string> larger;
  for (std::size_t i = before.marks; i < marks.size(); ++i)
    if (std::string* name = name_of(marks[i]))
      is_whole_in(room, marks[i]) ? void(larger.insert(*name)) : name->clear();
  for (std::size_t i = 0; i < before.marks; ++i)
    if (std::string* name = name_of(marks[i]); name && larger.contains(*name)) name->clear();
  std::set<std::size_t> smaller;
  for (std::size_t i = before.measurements; i < onto.measurements.size(); ++i)
    for (std::size_t k = 0; k < before.measurements; ++k)
      if (onto.measurements[k].quantity == onto.measurements[i].quantity &&
          onto.measurements[k].kind == onto.measurements[i].kind)
        smaller.insert(k);
  take_away(onto.measurements, smaller);
}

// Then it is the same picture of a mechanism again, and the whole beside it an empty frame. (Polygons of a sheet
// share a scale, at which one of them may be small as a whole.)
bool shows_all(const PlacedPanel& close_up, const PlacedPanel& whole, const SheetRequest& request) {
  if (whole.panel->is_of_vectors()) return false;
  const DrawnJoints drawn = joints_drawn(whole, request);
  std::vector<Place> points = drawn.joints;
  for (const auto& [P, Q] : drawn.links) points.insert(points.end(), {P, Q});
  const drawings::Box seen = seen_in(close_up, whole);
  const double mm = whole.plane().mm_per_unit;
  return !points.empty() && std::all_of(points.begin(), points.end(), [&](const Place& P) {
    return drawings::contains(seen, drawings::Point{whole.origin.x + mm * P.x, whole.origin.y + mm * P.y});
  });
}

// Nothing else has become so much smaller that what the close-up gains is lost there.
bool is_better(const std::vector<PlacedPanel>& before, const std::vector<PlacedPanel>& after,
               const SheetRequest& request) {
  constexpr double at_most_smaller = 2.6;  // times: a standard scale
  constexpr double told_apart = 2.5;       // mm: a vector that is shorter is a dot in the close-up too
  constexpr std::size_t fewest_apart = 3;
  auto then = before.begin();
  for (const PlacedPanel& now : after) {
    if (const auto* close_up = dynamic_cast<const CloseUp*>(now.panel)) {
      const auto whole = std::find_if(after.begin(), after.end(),
                                      [&](const PlacedPanel& each) { return each.panel == &close_up->whole(); });
      if (now.plane().mm_per_unit < worth_drawing * whole->plane().mm_per_unit || shows_all(now, *whole, request))
        return false;
      if (now.panel->is_of_vectors() &&
          count_apart(close_up->parted(), told_apart / now.plane().mm_per_unit) < fewest_apart)
        return false;
      continue;
    }
    if (at_most_smaller * now.lengths.mm_per_unit < then->lengths.mm_per_unit ||
        at_most_smaller * now.vectors.mm_per_unit < then->vectors.mm_per_unit)
      return false;
    ++then;
  }
  return true;
}

// Where that is better than without.
std::optional<LaidOut> with_close_ups(const LaidOut& plain, const std::vector<std::optional<SmallPart>>& parts,
                                      const drawings::Box& room, const SheetRequest& request) {
  LaidOut larger;
  std::vector<const Panel*> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    all.push_back(plain.panels[i].panel);
    if (!parts[i]) continue;
    larger.close_ups.push_back(
        std::make_unique<CloseUp>(*all.back(), parts[i]->low, parts[i]->high, parts[i]->points));
    all.push_back(larger.close_ups.back().get());
  }
  try {
    larger.panels = laid_out(all, room, request);
  } catch (const DoesNotFit&) {
    return {};
  }
  return is_better(plain.panels, larger.panels, request) ? std::optional(std::move(larger)) : std::nullopt;
}

}  // namespace

constexpr double longest_close_up = 100;  // mm

double CloseUp::reach() const { return 1000 * std::max(high_.x - low_.x, high_.y - low_.y) / longest_close_up; }

Panel::Vectors CloseUp::vectors() const {
  if (!is_of_vectors()) return whole_.vectors();
  return {whole_.vectors().unit, std::max(high_.x - low_.x, high_.y - low_.y), longest_close_up};
}

// The part, and of what else the whole shows as much as its vectors reach, with their letters.
drawings::Box CloseUp::extent(const Scale& lengths, const Scale& vectors) const {
  constexpr double letters = 10;  // mm
  const Scale& plane = is_of_vectors() ? vectors : lengths;
  const auto at = [&](const Place& P) { return drawings::Point{plane.mm_per_unit * P.x, plane.mm_per_unit * P.y}; };
  const drawings::Point low = at(low_), high = at(high_);
  const double air = letters + (is_of_vectors() ? 0 : whole_.vectors().longest * vectors.mm_per_unit);
  const drawings::Box around{{low.x - air, low.y - air}, {high.x + air, high.y + air}};
  drawings::Box seen = drawings::intersection(whole_.extent_of_near(lengths, vectors), around);
  seen.low = {std::min(seen.low.x, low.x), std::min(seen.low.y, low.y)};
  seen.high = {std::max(seen.high.x, high.x), std::max(seen.high.y, high.y)};
  return seen;
}

std::vector<drawings::Block> CloseUp::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const DrawnSoFar before(plot.onto());
  whole_.draw(plot, room, language);
  plot.in_step({});
  leave_out_beyond(room, before, plot.onto().sheet.figure);
  if (is_of_vectors()) tell_once(room, before, plot.onto());
  return {};
}

void CloseUp::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  const DrawnSoFar before(plot.onto());
  whole_.draw_given(plot, room, language);
  plot.in_step({});
  leave_out_beyond(room, before, plot.onto().sheet.figure);
}

LaidOut laid_out_with_close_ups(const Panels& panels, const drawings::Box& room, const SheetRequest& request) {
  LaidOut plain{{}, laid_out(panels, room, request)};
  if (request.scale) return plain;  // as it was asked for
  std::vector<std::optional<SmallPart>> parts;
  // In a narrower figure a second picture of a polygon takes more from the others than it gains.
  constexpr double wide_enough = 120;     // mm
  constexpr std::size_t most_panels = 8;  // for each more there are five times as many ways to divide the room
  std::size_t count = 0;
  for (const PlacedPanel& placed : plain.panels) {
    const bool has_room =
        plain.panels.size() + count < most_panels && (!placed.panel->is_of_vectors() || room.width() >= wide_enough);
    parts.push_back(has_room ? part_too_small(placed, request) : std::nullopt);
    count += parts.back() ? 1 : 0;
  }
  if (count == 0) return plain;
  if (auto all = with_close_ups(plain, parts, room, request)) return std::move(*all);
  for (std::size_t i = 0; i < parts.size() && count > 1; ++i) {
    if (!parts[i]) continue;
    std::vector<std::optional<SmallPart>> one(parts.size());
    one[i] = parts[i];
    if (auto alone = with_close_ups(plain, one, room, request)) return std::move(*alone);
  }
  return plain;
}

const PlacedPanel* close_up_of(const PlacedPanel& whole, const std::vector<PlacedPanel>& panels) {
  for (const PlacedPanel& each : panels)
    if (const auto* close_up = dynamic_cast<const CloseUp*>(each.panel);
        close_up && &close_up->whole() == whole.panel)
      return &each;
  return nullptr;
}

drawings::Box seen_in(const PlacedPanel& close_up, const PlacedPanel& whole) {
  const double ratio = whole.plane().mm_per_unit / close_up.plane().mm_per_unit;
  const auto at = [&](const drawings::Point& p) {
    return drawings::Point{whole.origin.x + ratio * (p.x - close_up.origin.x),
                           whole.origin.y + ratio * (p.y - close_up.origin.y)};
  };
  constexpr double least = 8;  // mm: a smaller frame is not seen, and symbols there do not shrink
  drawings::Box seen{at(close_up.room.low), at(close_up.room.high)};
  const double wider = std::max(0.0, least - seen.width()) / 2, higher = std::max(0.0, least - seen.height()) / 2;
  seen.low = {seen.low.x - wider, seen.low.y - higher};
  seen.high = {seen.high.x + wider, seen.high.y + higher};
  return seen;
}

void leave_to_close_up(const PlacedPanel& close_up, const PlacedPanel& whole, const DrawnSoFar& before,
                       DrawnSheet& onto) {
  const drawings::Box seen = seen_in(close_up, whole);
  // Of a polygon a long side that begins or ends there is seen in the whole.
  const auto leads_out = [&](const drawings::Mark& mark) {
    const auto* arrow = std::get_if<drawings::Arrow>(&mark);
    return arrow && whole.panel->is_of_vectors() &&
           !(drawings::contains(seen, arrow->from) && drawings::contains(seen, arrow->to));
  };
  drawings::Figure& figure = onto.sheet.figure;
  std::set<std::size_t> marks, labels, measurements;
  std::set<PaperEnds> vectors, stay;
  const std::vector<drawings::Point> alone = joints_alone(figure, before);
  for (std::size_t i = before.marks; i < figure.marks.size(); ++i) {
    if (leads_out(figure.marks[i])) {
      const auto& arrow = std::get<drawings::Arrow>(figure.marks[i]);
      stay.insert(paper_ends(arrow.from, arrow.to));
      continue;
    }
    const auto at = place_of(figure.marks[i]);
    if (!at || !drawings::contains(seen, *at)) continue;
    if (place_of_joint(figure.marks[i]) && is_one_of(alone, *at)) continue;
    marks.insert(i);
    if (const auto* arrow = std::get_if<drawings::Arrow>(&figure.marks[i]))
      vectors.insert(paper_ends(arrow->from, arrow->to));
  }
  for (std::size_t i = before.labels; i < figure.labels.size(); ++i) {
    const drawings::Label& label = figure.labels[i];
    const drawings::Point to = label.to.value_or(label.at);
    if (stay.contains(paper_ends(label.at, to))) continue;
    if (!label.to && label.ink == Meaning::text && is_one_of(alone, label.at)) continue;
    if (drawings::contains(seen, place_of_label(label)) || vectors.contains(paper_ends(label.at, to)) ||
        std::any_of(marks.begin(), marks.end(),
                    [&](std::size_t mark) { return is_symbol_of(label, figure.marks[mark]); }))
      labels.insert(i);
  }
  for (std::size_t i = before.measurements; i < onto.measurements.size(); ++i)
    if (vectors.contains(paper_ends(onto.measurements[i].from, onto.measurements[i].to))) measurements.insert(i);
  take_away(figure.marks, marks);
  take_away(figure.window_of, marks);
  take_away(figure.known_of_marks, marks);
  take_away(figure.labels, labels);
  take_away(figure.known_of_labels, labels);
  take_away(onto.measurements, measurements);
}

void draw_frame(const drawings::Box& frame, const std::string& scale, DrawnSheet& onto) {
  const auto& [low, high] = frame;
  constexpr double letters = 2.7;  // mm
  const drawings::Point corner{low.x + 1, high.y - 1}, outside{low.x, high.y};
  if (!scale.empty())
    onto.sheet.figure.labels.push_back({.text = scale, .at = corner, .away_from = outside, .size = letters});
  onto.sheet.figure.marks.push_back(drawings::Line{
      drawings::polyline({low, {high.x, low.y}, high, {low.x, high.y}}, true), Meaning::dimension, {}});
}

}  // namespace epure
