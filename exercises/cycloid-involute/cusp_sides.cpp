// The acceleration at a cusp, against the motion just before and with it just after.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/cycloid-involute/instants.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

struct Side {
  double middle;  // of the room's width, where it stands
  bool is_after;
  std::string label;
  Words when;
};
const Side just_before{0.24, false, "$\\vec{a}_{M}$ = $\\vec{a}^{t−}_{M}$", {"just before", "subito prima"}};
const Side just_after{0.76, true, "$\\vec{a}_{M}$ = $\\vec{a}^{t+}_{M}$", {"just after", "subito dopo"}};

// From `middle` half the way backwards and forwards along a unit vector.
struct Span {
  drawings::Point from, to;
};
Span about(drawings::Point middle, double length, const Arrow2& along) {
  const double x = length / 2 * along.x, y = length / 2 * along.y;
  return {{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}};
}

void draw_side(DrawnSheet& onto, const DrawnInstant& at, const Side& side, const Scale& accelerations,
               const drawings::Box& room, Language language) {
  const double size = magnitude(at.a);
  const Arrow2 along{at.a.x / size, at.a.y / size};
  constexpr double letters = 6, aside = 6, way = 14;  // mm
  const drawings::Point middle{room.low.x + side.middle * room.width(), (room.low.y + room.high.y) / 2};
  const Span vector = about(middle, size * accelerations.mm_per_unit, along);

  Plot plot(onto, vector.from, accelerations);
  const drawings::Point right{middle.x + aside * along.y, middle.y - aside * along.x};
  plot.side(side.is_after ? at.names("a_M") : "", {0, 0}, {at.a.x, at.a.y}, Meaning::acceleration, side.label,
            plot.from_paper(right));
  plot.dot({0, 0}, Meaning::acceleration);

  Span travel = about(right, way, along);
  if (!side.is_after) std::swap(travel.from, travel.to);
  onto.sheet.figure.marks.push_back(drawings::Arrow{travel.from, travel.to, Meaning::velocity, {}});
  onto.sheet.figure.labels.push_back(
      {.text = "$\\vec{t}$", .at = travel.from, .to = travel.to, .ink = Meaning::velocity, .away_from = middle});

  // Clear of both arrows and the letter beside the second.
  const double below =
      std::min({vector.from.y, vector.to.y, travel.from.y - letters / 2, travel.to.y - letters / 2}) - letters;
  const double value = side.is_after ? at.along_after : at.along_before;
  onto.sheet.figure.marks.push_back(drawings::Writing{
      fmt::format("{}: $a^{{t}}_{{M}}$ = {} m/s²", side.when.in(language), short_number(value, language)),
      {room.low.x + (side.middle - 0.22) * room.width(), std::max(below, room.low.y + 1)}});
}

}  // namespace

void draw_sides_of_cusp(DrawnSheet& onto, const DrawnInstant& at, const Scale& accelerations,
                        const drawings::Box& room, Language language) {
  draw_side(onto, at, just_before, accelerations, room, language);
  draw_side(onto, at, just_after, accelerations, room, language);
}

}  // namespace epure::cycloid_involute
