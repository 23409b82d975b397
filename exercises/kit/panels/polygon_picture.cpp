#include "exercises/kit/panels/polygon_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/crossing.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/short_vectors.h"
#include "exercises/kit/panels/tracks.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace {

constexpr double beyond_vector = 8;  // mm: a direction line runs on past the polygon
constexpr double air = 9;            // mm around a corner, for letters

Place after(const Place& P, const Arrow2& v) { return {P.x + v.x, P.y + v.y}; }
Place between(const Place& P, const Place& Q, double t) { return {P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y)}; }

// A side and where it starts.
struct PlacedSide {
  const PolygonSide* side;
  Place from, to;
  // Where the next side begins.
  const Place& corner() const { return side->is_subtracted ? from : to; }
};
std::vector<PlacedSide> placed(const std::vector<PolygonSide>& chain) {
  std::vector<PlacedSide> sides;
  Place at{0, 0};
  for (const PolygonSide& side : chain) {
    if (!side.is_drawn()) continue;
    sides.push_back(side.is_subtracted ? PlacedSide{&side, after(at, -side.v), at}
                                       : PlacedSide{&side, at, after(at, side.v)});
    at = sides.back().corner();
  }
  return sides;
}

// The left side of a loop ends where the others begin.
std::vector<PlacedSide> placed_backwards(const std::vector<PolygonSide>& chain) {
  std::vector<PlacedSide> sides;
  Place at{0, 0};
  for (const PolygonSide& side : chain) {
    if (!side.is_drawn()) continue;
    sides.push_back({&side, after(at, -side.v), at});
    at = sides.back().from;
  }
  return sides;
}

// The right side first: it holds what is known of the driving body.
std::vector<PlacedSide> in_order(const VectorPolygon& polygon) {
  std::vector<PlacedSide> sides = placed(polygon.right);
  for (const PlacedSide& side : polygon.loop ? placed_backwards(polygon.left) : placed(polygon.left)) {
    sides.push_back(side);
  }
  return sides;
}

// Away from it letters stand outside.
Place middle_of(const VectorPolygon& polygon) {
  const auto sides = in_order(polygon);
  Place sum{0, 0};
  for (const PlacedSide& s : sides) sum = {sum.x + s.corner().x, sum.y + s.corner().y};
  const auto count = static_cast<double>(sides.size()) + 1;
  return {sum.x / count, sum.y / count};
}

// The sides, counted in order, at whose end the line of the next one starts.
std::vector<std::size_t> where_lines_start(const VectorPolygon& polygon) {
  const std::vector<PlacedSide> sides = in_order(polygon);
  const std::size_t of_left = placed(polygon.right).size();
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (const PolygonSide& next = *sides[i + 1].side; i + 1 != of_left && next.is_unknown() && !next.closes_alone())
      found.push_back(i);
  return found;
}

// How far aside its vectors stand, where they would lie on one another: the sides in order, then of each image the
// relative vector and the absolute one.
std::vector<Track> tracks_of(const VectorPolygon& polygon, const Scale& scale) {
  const auto on_paper = [&](const Place& from, const Place& to) {
    const double mm = scale.mm_per_unit;
    return VectorOnPaper{{mm * from.x, mm * from.y}, {mm * to.x, mm * to.y}};
  };
  std::vector<VectorOnPaper> vectors;
  for (const PlacedSide& s : in_order(polygon)) vectors.push_back(on_paper(s.from, s.to));
  for (const PolygonImage& image : polygon.images) {
    const Place O{0, 0}, c = after(O, image.absolute.v);
    vectors.push_back(image.draws_relative() ? on_paper(after(c, -image.relative.v), c) : VectorOnPaper{});
    vectors.push_back(image.draws_absolute() ? on_paper(O, c) : VectorOnPaper{});
  }
  const Place middle = middle_of(polygon);
  return tracks(vectors, on_paper(middle, middle).first, LyingOver::of_a_polygon, where_lines_start(polygon));
}
// In the units of the polygon.
Arrow2 aside(const Track& track, const Scale& scale) {
  return {track.by.x / scale.mm_per_unit, track.by.y / scale.mm_per_unit};
}

// The part PQ of the line that carries an unknown vector, in mm from the polygon's origin: from where the vector
// starts to past where it ends. None when nothing tells its direction.
std::optional<std::pair<drawings::Point, drawings::Point>> carrier_of(const PlacedSide& s, double mm_per_unit) {
  constexpr double shortest = 6;  // mm; a shorter vector does not show its line
  const Place& begin = s.side->is_subtracted ? s.to : s.from;
  const drawings::Point p{mm_per_unit * begin.x, mm_per_unit * begin.y};
  drawings::Point q{mm_per_unit * s.corner().x, mm_per_unit * s.corner().y};
  if (std::hypot(q.x - p.x, q.y - p.y) < shortest) {
    const double length = std::hypot(s.side->along.x, s.side->along.y);
    if (length == 0) return {};
    q = {p.x + shortest / length * s.side->along.x, p.y + shortest / length * s.side->along.y};
  }
  return std::pair{p, q};
}

// Beside a short vector there is no room for its letters and a number too: that stands where its line ends, at what
// is written there.
bool is_short(const PlacedSide& s, const Scale& scale) {
  constexpr double needs_room = 9;  // mm
  return s.side->is_unknown() && !s.side->closes_alone() && carrier_of(s, scale.mm_per_unit) &&
         distance(s.from, s.to) * scale.mm_per_unit < needs_room;
}
Place labelled_end(const PlacedSide& s, const Scale& scale) {
  const auto [p, q] = *carrier_of(s, scale.mm_per_unit);  // by value: the optional is gone
  const drawings::Point end = q + beyond_vector * drawings::unit(p, q);
  return {end.x / scale.mm_per_unit, end.y / scale.mm_per_unit};
}

void draw_carrier(Plot& plot, const PlacedSide& s) {
  const double mm_per_unit = plot.scale().mm_per_unit;
  const auto carrier = carrier_of(s, mm_per_unit);
  if (!carrier) return;
  const auto& [p, q] = *carrier;
  const Place start{p.x / mm_per_unit, p.y / mm_per_unit}, towards{q.x / mm_per_unit, q.y / mm_per_unit};
  plot.long_segment(s.side->closes_alone() ? s.from : start, towards, beyond_vector, Meaning::construction);
}

// Past its ends, for the letters that tell its direction.
void include_carrier(Extent& extent, const PlacedSide& s, const Scale& scale) {
  const auto carrier = carrier_of(s, scale.mm_per_unit);
  if (!carrier) return;
  const auto& [p, q] = *carrier;
  constexpr double letters_wide = 7, letters_high = 3;  // mm
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  const double x = (q.x - p.x) / length, y = (q.y - p.y) / length;
  extent.include(p.x - beyond_vector * x, p.y - beyond_vector * y);
  extent.include(q.x + (beyond_vector + letters_wide) * x, q.y + (beyond_vector + letters_high) * y);
}

// What is drawn of the polygon, and whether that is all.
struct Drawing {
  Plot& plot;
  const VectorPolygon& polygon;
  Place middle;
  bool whole;
  Language language;
  std::vector<Track> tracks;
};

// How far a place is from all vectors but this one; from one too short for an arrow, beside which its value stands,
// less.
double clearance(const Drawing& on, const PlacedSide& s, const Place& P) {
  constexpr double dot_below = 1, of_value = 5;  // mm
  const double mm = on.plot.scale().mm_per_unit;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Place& from, const Place& to) {
    const Arrow2 v = to - from;
    const double all = dot(v, v), part = all > 0 ? std::clamp(dot(P - from, v) / all, 0.0, 1.0) : 0;
    nearest = std::min(nearest, distance(P, between(from, to, part)));
  };
  for (const PlacedSide& other : in_order(on.polygon)) {
    if (other.side == s.side) continue;
    look_at(other.from, other.to);
    if (distance(other.from, other.to) * mm < dot_below)
      nearest = std::min(nearest, distance(P, other.to) - of_value / mm);
  }
  for (const PolygonImage& image : on.polygon.images) {
    const Place c = after({0, 0}, image.absolute.v);
    if (image.draws_absolute()) look_at({0, 0}, c);
    if (image.draws_relative()) look_at(after(c, -image.relative.v), c);
  }
  return nearest * mm;
}

// Its direction is written where its line ends past the vector; where other vectors crowd there, where it begins.
void name_carrier(const Drawing& on, const PlacedSide& s) {
  constexpr double crowded = 5;  // mm
  const double mm_per_unit = on.plot.scale().mm_per_unit;
  const auto carrier = carrier_of(s, mm_per_unit);
  if (!carrier || s.side->closes_alone()) return;
  const auto on_plane = [&](const drawings::Point& p) { return Place{p.x / mm_per_unit, p.y / mm_per_unit}; };
  const auto& [p, q] = *carrier;
  const Place past = labelled_end(s, on.plot.scale()), before = on_plane(p - beyond_vector * drawings::unit(p, q));
  const bool begins = on.whole && !is_short(s, on.plot.scale()) && clearance(on, s, past) < crowded &&
                      clearance(on, s, before) > crowded;
  on.plot.small_label(s.side->direction, begins ? before : past, on_plane(begins ? p : q));
}

// A vector on its track, which thin lines join to where it begins and ends.
void draw_on_track(const Drawing& on, const Track& track, const std::pair<Place, Place>& ends,
                   const std::string& quantity, const std::string& letters, const Place& away_from) {
  const auto& [from, to] = ends;
  const Arrow2 by = aside(track, on.plot.scale());
  const Place p = after(from, by), q = after(to, by);
  if (track.by.x != 0 || track.by.y != 0) {
    on.plot.segment(from, p, Meaning::dimension);
    on.plot.segment(to, q, Meaning::dimension);
  }
  const Place inner = track.letters ? on.plot.from_paper(on.plot.at(between(p, q, 0.5)) - *track.letters) : away_from;
  on.plot.side(quantity, p, q, on.polygon.meaning, letters, inner);
}

// Letters stand outside the polygon. Where it has no outside, because its vectors lie in one line, those of the right
// side stand on the left of their vectors, and those of the left side on the right: so no two seem to name one.
Place away_from(const Drawing& on, const PlacedSide& s, bool of_left_side) {
  constexpr double in_line = 0.2;  // mm from the vector's line to the middle
  const drawings::Point p = on.plot.at(s.from), q = on.plot.at(s.to), m = on.plot.at(on.middle);
  const double x = q.x - p.x, y = q.y - p.y, length = std::hypot(x, y);
  if (length == 0 || std::abs(x * (m.y - p.y) - y * (m.x - p.x)) > in_line * length) return on.middle;
  const double side = of_left_side ? 1 : -1;
  return on.plot.from_paper({(p.x + q.x) / 2 - side * y, (p.y + q.y) / 2 + side * x});
}

// What is shorter than its head is a dot, and tells its value.
std::string letters_of(const Drawing& on, const PolygonSide& side) {
  if (!side.length || side.label.empty()) return side.label;
  return letters_or_value(side.label, std::abs(*side.length), magnitude(side.v) * on.plot.scale().mm_per_unit,
                          on.polygon.unit, on.language);
}

// Away from what the letters of a corner stand: from a short side at it, beside which are letters too, or else from
// the middle.
Place clear_of_sides(const Drawing& on, const PlacedSide& s, const PlacedSide* next) {
  constexpr double needs_room = 15;  // mm
  for (const PlacedSide* side : {&s, next})
    if (side && distance(side->from, side->to) * on.plot.scale().mm_per_unit < needs_room &&
        (distance(side->from, s.corner()) == 0 || distance(side->to, s.corner()) == 0))
      return between(side->from, side->to, 0.5);
  return on.middle;
}

bool are_one(const Drawing& on, const Place& P, const Place& Q) {
  constexpr double one_point = 0.05;  // mm
  return on.whole && distance(P, Q) * on.plot.scale().mm_per_unit < one_point;
}
// A vector that is zero ends at the origin.
bool is_at_origin(const Drawing& on, const PlacedSide& s) { return are_one(on, s.corner(), {0, 0}); }

// Corners and images that lie in one place are named together, by the first of them; the others have no letters.
std::string letters_in_one_place(const Drawing& on, const std::string& tip, const Place& P) {
  std::vector<std::string> there;
  const auto look_at = [&](const std::string& letters, const Place& at) {
    if (!letters.empty() && are_one(on, at, P)) there.push_back(letters);
  };
  for (const PlacedSide& s : in_order(on.polygon)) look_at(s.side->tip, s.corner());
  for (const PolygonImage& image : on.polygon.images) look_at(image.absolute.tip, after({0, 0}, image.absolute.v));
  if (there.empty()) return tip;
  if (there.front() != tip) return {};
  std::string all = tip;
  for (std::size_t i = 1; i < there.size(); ++i) all += " ≡ " + there[i];
  return all;
}

// Corners that lie there are named together with it.
std::string letters_of_origin(const Drawing& on, const std::vector<PlacedSide>& sides) {
  std::string letters = on.polygon.origin;
  for (const PlacedSide& s : sides)
    if (is_at_origin(on, s) && !s.side->tip.empty()) letters += " ≡ " + s.side->tip;
  return letters;
}

// Only the whole polygon is measured: the same vector stands on other pictures too.
void draw_vector(const Drawing& on, const PlacedSide& s, const Track& track, const PlacedSide* next,
                 bool of_left_side) {
  draw_on_track(on, track, {s.from, s.to}, on.whole ? s.side->quantity : "", letters_of(on, *s.side),
                away_from(on, s, of_left_side));
  if (s.side->tip.empty() || is_at_origin(on, s)) return;
  if (const std::string letters = letters_in_one_place(on, s.side->tip, s.corner()); !letters.empty())
    on.plot.label(letters, s.corner(), clear_of_sides(on, s, next), on.polygon.meaning);
}

// On the other side of the line where an image is so near that its vector, which comes between the two, ends in the
// mark.
void mark_square(const Drawing& on, const PlacedSide& s, const PlacedSide& before) {
  constexpr double needs_room = 4;  // mm
  const auto ends_in_it = [&](const PolygonImage& image) {
    const double away = distance(s.from, after({0, 0}, image.absolute.v)) * on.plot.scale().mm_per_unit;
    const bool within = dot(image.absolute.v, s.from - before.from) > 0 && dot(image.absolute.v, s.from - s.to) > 0;
    return !image.absolute.tip.empty() && away < needs_room && within;
  };
  const bool is_crowded = on.whole && std::any_of(on.polygon.images.begin(), on.polygon.images.end(), ends_in_it);
  on.plot.right_angle(s.from, before.from, is_crowded ? after(s.from, s.from - s.to) : s.to);
}

// Unknown vectors appear when the polygon is closed; until then a line alone. The lines are drawn below the vectors,
// of which one may lie on a line.
void draw_sides(const Drawing& on, const std::vector<PlacedSide>& sides, const PolygonStage& stage) {
  const bool closed = stage.closed && stage.steps >= static_cast<int>(sides.size());
  const auto shows_carrier = [&](const PlacedSide& s) {
    return s.side->is_unknown() && !(closed && s.side->closes_alone());
  };
  int steps = stage.steps;
  for (const PlacedSide& s : sides)
    if (steps-- > 0 && shows_carrier(s)) draw_carrier(on.plot, s);
  steps = stage.steps;
  const PlacedSide* before = nullptr;
  std::size_t right_ones = placed(on.polygon.right).size();
  for (const PlacedSide& s : sides) {
    const bool of_left_side = right_ones == 0;
    if (!of_left_side) --right_ones;
    if (steps-- <= 0) return;
    if (shows_carrier(s)) name_carrier(on, s);
    const Track& track = on.tracks[static_cast<std::size_t>(&s - sides.data())];
    if (!s.side->is_unknown() || closed)
      draw_vector(on, s, track, &s == &sides.back() ? nullptr : &s + 1, of_left_side);
    if (s.side->square && before && closed) mark_square(on, s, *before);
    before = &s;
  }
}

void draw_image(const Drawing& on, const PolygonImage& image, const Track& relative, const Track& absolute) {
  const Place O{0, 0}, c = after(O, image.absolute.v), a = after(c, -image.relative.v);
  if (image.closes_triangle) {
    on.plot.segment(a, c, Meaning::construction);
  } else if (image.draws_relative()) {
    draw_on_track(on, relative, {a, c}, image.relative.quantity, letters_of(on, image.relative), on.middle);
  } else if (!image.relative.quantity.empty()) {
    on.plot.measures(image.relative.quantity, a, c);
  }
  if (image.draws_absolute())
    draw_on_track(on, absolute, {O, c}, image.absolute.quantity, letters_of(on, image.absolute), on.middle);
  if (image.absolute.tip.empty()) return;
  on.plot.dot(c, on.polygon.meaning);
  const std::string letters =
      are_one(on, O, c) ? image.absolute.tip : letters_in_one_place(on, image.absolute.tip, c);
  if (!letters.empty()) on.plot.label(letters, c, O, on.polygon.meaning);
}

// `from`: the letter of the corner; empty: the end of the vector before.
std::string known_vector(const PolygonSide& side, const std::string& from, Language language) {
  if (side.is_subtracted) {
    const Words end = from.empty() ? Words{"there", "di seguito"} : Words{"in " + from, "in " + from};
    return format_words("The known {}, {}, is subtracted: its tip lies {}.",
                        "La {} nota, {}, si sottrae: la sua punta sta {}.", side.label, side.direction, end)
        .in(language);
  }
  const Words start = from.empty() ? Words{"At its tip", "Di seguito"} : Words{"From " + from, "Da " + from};
  return language == Language::english
             ? fmt::format("{} the known {}, {}.", start.english, side.label, side.direction)
             : fmt::format("{} la {} nota, {}.", start.italian, side.label, side.direction);
}
std::string carrying_line(const PolygonSide& side, const std::string& from, bool is_after_subtracted,
                          Language language) {
  const Words start = !from.empty()         ? Words{"Through " + from, "Per " + from}
                      : is_after_subtracted ? Words{"Through its start", "Per la sua origine"}
                                            : Words{"Through its tip", "Per il suo estremo"};
  return language == Language::english
             ? fmt::format("{} the line {}: the direction of {}.", start.english, side.direction, side.label)
             : fmt::format("{} la retta {}: dà la direzione della {}.", start.italian, side.direction, side.label);
}
// Between two corners, which may have no letters: then it starts at the tip of the vector before, or ends where the
// polygon began.
std::string closing(const PolygonSide& side, const std::string& from, const std::string& to, Language language) {
  Words way;
  if (!from.empty()) way = way + Words{" from ", " da "} + from;
  if (!to.empty()) way = way + (from.empty() ? Words{" back to ", " e torna in "} : Words{" to ", " a "}) + to;
  if (language == Language::english)
    return from.empty() ? fmt::format("{} closes the polygon{}.", side.label, way.english)
                        : fmt::format("{},{}, closes the polygon.", side.label, way.english);
  return from.empty() ? fmt::format("La {} chiude il poligono{}.", side.label, way.italian)
                      : fmt::format("La {},{}, chiude il poligono.", side.label, way.italian);
}
std::string meeting(const std::string& corner, Language language) {
  if (corner.empty()) return {};
  return language == Language::english ? fmt::format(" The two lines meet at {}.", corner)
                                       : fmt::format(" Le due rette si incontrano in {}.", corner);
}

}  // namespace

drawings::VectorEquation equation(const VectorPolygon& polygon) {
  drawings::VectorEquation written;
  const auto add = [&](const std::vector<PolygonSide>& chain, const char* first) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const std::string before = i == 0 ? first : "+", minus = "−";
      if (before == "+" && chain[i].label.starts_with(minus)) {
        written.terms.push_back({chain[i].label.substr(minus.size()), chain[i].direction, chain[i].magnitude, minus});
        continue;
      }
      const std::string sign = !chain[i].is_subtracted ? before : before == "=" ? "= −" : "−";
      written.terms.push_back({chain[i].label, chain[i].direction, chain[i].magnitude, sign});
    }
  };
  if (polygon.loop) {
    add(polygon.right, "");
    add(polygon.left, "+");
    written.terms.push_back({"0", "", "", "="});
  } else {
    add(polygon.left, "");
    add(polygon.right, "=");
  }
  return written;
}

std::vector<std::string> steps_of(const VectorPolygon& polygon, Language language) {
  std::vector<std::string> lines;
  const std::string& corner = polygon.right.back().tip;
  for (const auto* chain : {&polygon.right, &polygon.left}) {
    std::string from = polygon.origin;
    bool is_after_subtracted = false;
    for (const PolygonSide& side : *chain) {
      if (!side.is_drawn()) continue;
      lines.push_back(side.closes_alone()
                          ? closing(side, polygon.loop ? corner : from, polygon.loop ? from : corner, language)
                      : side.is_unknown() ? carrying_line(side, from, is_after_subtracted, language)
                                          : known_vector(side, from, language));
      from = side.tip;
      is_after_subtracted = side.is_subtracted;
    }
  }
  if (!lines.empty() && !polygon.left.back().closes_alone()) lines.back() += meeting(corner, language);
  for (const PolygonImage& image : polygon.images)
    if (!image.explained.empty()) lines.push_back(image.explained.in(language));
  return lines;
}

std::vector<Place> places_of_steps(const VectorPolygon& polygon, const Scale& scale) {
  constexpr double along_side = 0.3, along_sum = 0.7;  // clear of the vector's own letters, at its middle
  std::vector<Place> places;
  const std::vector<Track> tracks = tracks_of(polygon, scale);
  for (const PlacedSide& s : in_order(polygon))
    places.push_back(is_short(s, scale)
                         ? labelled_end(s, scale)
                         : after(between(s.from, s.to, along_side), aside(tracks[places.size()], scale)));
  for (const PolygonImage& image : polygon.images)
    if (!image.explained.empty())
      places.push_back(after({0, 0}, (image.absolute.tip.empty() ? along_sum : 1) * image.absolute.v));
  return places;
}

int steps_of_sides(const VectorPolygon& polygon) { return static_cast<int>(in_order(polygon).size()); }

std::vector<Comparison> measured_rows(const Readings& readings, const VectorPolygon& polygon) {
  std::vector<Comparison> rows;
  for (const PlacedSide& s : in_order(polygon)) {
    if (!readings.is_unit(s.side->quantity)) continue;
    rows.push_back({fmt::format("{} ({})", without_arrow(s.side->label), polygon.unit),
                    std::hypot(s.side->v.x, s.side->v.y), readings[s.side->quantity]});
  }
  for (const PolygonImage& image : polygon.images)
    for (const PolygonSide* side : {&image.relative, &image.absolute})
      if (!side->label.empty() && readings.is_unit(side->quantity))
        rows.push_back({fmt::format("{} ({})", without_arrow(side->label), polygon.unit), magnitude(side->v),
                        readings[side->quantity]});
  return rows;
}

drawings::Table measured_table(const DrawnSheet& sheet, const VectorPolygon& polygon, Language language) {
  return comparison_table(measured_rows(Readings(sheet), polygon), {"exact", "esatto"},
                          {"on the sheet", "sul foglio"}, language);
}

std::vector<Place> corners_of(const VectorPolygon& polygon) {
  std::vector<Place> corners{{0, 0}};
  for (const PlacedSide& s : in_order(polygon)) corners.push_back(s.corner());
  for (const PolygonImage& image : polygon.images)
    if (image.draws_absolute()) corners.push_back(after({0, 0}, image.absolute.v));
  return corners;
}

std::vector<double> crossings_of(const VectorPolygon& polygon) {
  std::vector<Arrow2> lines;
  for (const auto* side : {&polygon.left, &polygon.right})
    for (const PolygonSide& each : *side)
      if (each.is_unknown() && !each.closes_alone()) lines.push_back(magnitude(each.v) > 0 ? each.v : each.along);
  if (lines.size() != 2) return {};
  return {crossing_angle(lines[0], lines[1])};
}

double greatest(const VectorPolygon& polygon) {
  double longest = 0;
  const auto look_at = [&](const Arrow2& v) { longest = std::max(longest, std::hypot(v.x, v.y)); };
  for (const PlacedSide& s : in_order(polygon)) look_at(s.side->v);
  for (const PolygonImage& image : polygon.images) look_at(image.absolute.v);
  return longest;
}

drawings::Box extent_of(const VectorPolygon& polygon, const Scale& scale) {
  Extent extent;
  extent.include(scale, {0, 0}, air);
  for (const PlacedSide& s : in_order(polygon)) {
    extent.include(scale, s.corner(), air);
    if (s.side->is_unknown()) include_carrier(extent, s, scale);
  }
  for (const PolygonImage& image : polygon.images) extent.include(scale, after({0, 0}, image.absolute.v), air);
  return extent.box();
}

void draw_polygon(Plot& plot, const VectorPolygon& polygon, const PolygonStage& stage) {
  const auto sides = in_order(polygon);
  const auto all = static_cast<int>(sides.size());
  const Place O{0, 0}, middle = middle_of(polygon);
  const Drawing on{
      plot, polygon, middle, stage.closed && stage.steps >= all, stage.language, tracks_of(polygon, plot.scale())};
  draw_sides(on, sides, stage);
  int left = stage.steps - all;
  std::size_t track = sides.size();
  int step = all - stage.first_numbered + 1;  // of the picture
  for (const PolygonImage& image : polygon.images) {
    const bool is_step = !image.explained.empty();
    if (is_step) plot.in_step(++step);
    if (left-- > 0) draw_image(on, image, on.tracks[track], on.tracks[track + 1]);
    if (is_step) plot.in_step({});
    track += 2;
  }
  plot.dot(O, polygon.meaning);
  plot.label(letters_of_origin(on, sides), O, middle, polygon.meaning);
  if (!stage.numbered) return;
  int number = 1;
  for (const Place& P : places_of_steps(polygon, plot.scale())) {
    if (number >= stage.first_numbered && number <= stage.steps) plot.step(stage.numbers_after + number, P);
    ++number;
  }
}

}  // namespace epure
