#include "exercises/scenes/reached.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/proof/place.h"
#include "exercises/scenes/drive_way.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

double angle_of_direction(const Arrow2& d) { return std::atan2(d.y, d.x); }
double within_turn(double angle) {
  const double turn = 2 * std::numbers::pi;
  return angle - turn * std::floor(angle / turn);
}

// Of the direction that turns once.
double direction_now(const geometry::Drive& drive, const geometry::EveryPlace& places) {
  if (const auto* turned = std::get_if<geometry::TurnedLink>(&drive))
    return geometry::to_double(turned->angle) / places.turns();
  return std::holds_alternative<geometry::Stretched>(drive) ? std::numbers::pi / 2 : 0;
}

}  // namespace

void Reached::leave_out(const geometry::Gap& gap) {
  first_end_ = std::min(first_end_, within_turn(angle_of_direction(gap.from) - now_));
  last_begin_ = std::max(last_begin_, within_turn(angle_of_direction(gap.to) - now_));
  is_whole_ = false;
}

bool Reached::has(double angle) const {
  const double turned = within_turn(angle - now_);
  return is_whole_ || turned <= first_end_ || turned >= last_begin_;
}

bool Reached::has(const geometry::Branch& branch) const {
  const double from = angle_of_direction(branch.from);
  return branch.closed || has(from + within_turn(angle_of_direction(branch.to) - from) / 2);
}

void Reached::leave_in(geometry::Trace& trace) const {
  std::erase_if(trace.branches, [&](const geometry::Branch& branch) { return !has(branch); });
}

Reached reached(const Built& built, int point) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const geometry::EveryPlace places(built.linkage, built.steps);
  Reached all(direction_now(built.linkage.drives.front(), places));
  constexpr double wide = 10, coarse = 100;
  const double size = DriveWay(built).size();
  const Place O = geometry::CarriedOut<geometry::Fast>(built.linkage, built.steps).position().points.front();
  const geometry::Trace path =
      places.path(point, {O.x - wide * size, O.y - wide * size, O.x + wide * size, O.y + wide * size}, size / coarse);
  for (const geometry::Gap& gap : path.gaps)
    if (gap.cause == geometry::Gap::Cause::absent) all.leave_out(gap);
  return all;
}

}  // namespace epure::scenes
