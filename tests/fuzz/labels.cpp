// A crowd of labels among lines, on a sheet or in a small window: each place is within the area and as large as its
// label; what is said to touch nothing touches nothing, point by point; the same places twice.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "drawings/labels/labels.h"
#include "drawings/paths/vectors.h"
#include "tests/fuzz/bytes.h"

using namespace epure::drawings;
using epure::tests::Bytes;

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

// To a tenth of a millimetre; now and then far outside.
double length(Bytes& in) {
  const int high = in.byte();
  if (high > 250) return (high - 253) * 1e7;
  return (256 * (high % 12) + in.byte()) / 10.0;
}
Point point(Bytes& in) {
  const double x = length(in);
  return {x, length(in)};
}

struct Crowd {
  Box area;
  std::vector<Obstacle> lines = {};
  std::vector<LabelBox> labels = {};
};

Crowd crowd(Bytes& in) {
  Crowd made{in.byte() % 2 == 0 ? drawing_area(Paper::a4) : Box{{20, 20}, {20.0 + in.byte(), 20.0 + in.byte()}}};
  while (in.has_more()) {
    const int kind = in.byte() % 8;
    const Point from = point(in);
    if (kind < 3) {
      made.lines.push_back({from, kind == 0 ? from : point(in), (in.byte() % 4) / 4.0, kind == 2, kind});
      continue;
    }
    LabelBox label{.width = 1 + in.byte() / 4.0, .height = 2 + in.byte() / 32.0, .at = from};
    if (kind > 4) label.to = point(in);
    if (kind == 7) label.away_from = point(in);
    if (kind < 5) {
      label.step = kind - 2;
      label.number = kind == 3 ? LabelBox::Number::at_point : LabelBox::Number::on_line;
      if (kind == 4) label.along = Segment{from, point(in)};
    }
    if (kind % 2 == 0 && !made.lines.empty()) {
      label.naming = Naming{{from, label.to.value_or(from)}, {}};
      for (const Obstacle& line : made.lines)
        (line.heavy ? label.naming->not_between : label.naming->others).emplace_back(line.from, line.to);
    }
    made.labels.push_back(label);
  }
  return made;
}

std::vector<Place> placed(const Crowd& of) {
  Obstacles obstacles(of.area);
  for (const Obstacle& line : of.lines) obstacles.add(line);
  return place_labels(of.labels, obstacles, of.area);
}

constexpr double rounding = 1e-9;

bool is_in(Box box, Point p) {
  return p.x > box.low.x + rounding && p.x < box.high.x - rounding && p.y > box.low.y + rounding &&
         p.y < box.high.y - rounding;
}
bool is_crossed(Box box, const Obstacle& line) {
  const int points = 1 + static_cast<int>(std::min(distance(line.from, line.to), 1e4) / 0.5);
  for (int i = 0; i <= points; ++i)
    if (is_in(box, between(line.from, line.to, static_cast<double>(i) / points))) return true;
  return false;
}
bool is_same(const Place& a, const Place& b) {
  return a.found == b.found && a.box.low.x == b.box.low.x && a.box.low.y == b.box.low.y &&
         a.leader.has_value() == b.leader.has_value() && a.touches == b.touches;
}
bool tells(const Place& place, std::size_t other) {
  return std::find(place.touches.begin(), place.touches.end(), other) != place.touches.end();
}

void look_at(const Crowd& of, const std::vector<Place>& places, std::size_t i) {
  const Place& place = places[i];
  if (!place.found) return demand(place.touches.empty() && !place.leader);
  demand(contains(grown(of.area, rounding), place.box));
  demand(std::abs(place.box.width() - of.labels[i].width) < rounding &&
         std::abs(place.box.height() - of.labels[i].height) < rounding);
  if (!place.touches_drawing)
    for (const Obstacle& line : of.lines) demand(!is_crossed(place.box, line));
  if (place.leader) {
    demand(distance(nearest_in(place.box, place.leader->first), place.leader->first) < 1);
    demand(contains(grown(of.area, 1), Box{place.leader->second, place.leader->second}));
  }
  for (std::size_t j = 0; j < places.size(); ++j) {
    if (j == i || !places[j].found) continue;
    demand(tells(place, j) == tells(places[j], i));
    if (tells(place, j)) continue;
    demand(apart(place.box, places[j].box));
    if (place.leader) demand(!is_crossed(places[j].box, {place.leader->first, place.leader->second}));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 600;
  if (count > most) return 0;
  Bytes in(bytes, count);
  const Crowd of = crowd(in);
  const std::vector<Place> places = placed(of), again = placed(of);
  demand(places.size() == of.labels.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    demand(is_same(places[i], again[i]));
    look_at(of, places, i);
  }
  return 0;
}
