#include "exercises/velocity-centre/carried_bar.h"

#include <algorithm>
#include <cmath>

namespace epure::velocity_centre {
namespace {

constexpr double guide_behind = 14, guide_ahead = 26;  // mm of hatched guide beside the hinge
constexpr double axis_ahead = 28;                      // mm of the x axis
constexpr double half_block = 5, block_top = 3;        // mm from the hinge

}  // namespace

// θ, from the x axis.
void CarriedBar::draw_angle(Plot& plot) const {
  constexpr double radius = 19, shortest_arc = 4;  // mm
  if (std::abs(angle) * radius < shortest_arc || plot.scale().mm_per_unit * reach() < radius) return;
  plot.mark(drawings::AngleMark{plot.at(O), radius, std::min(0.0, angle), std::max(0.0, angle), Meaning::dimension});
  const double out = radius / plot.scale().mm_per_unit;
  plot.label("$θ$", {out * std::cos(angle / 2), out * std::sin(angle / 2)}, O);
}

void CarriedBar::draw(Plot& plot) const {
  const drawings::Point o = plot.at(O);
  plot.mark(drawings::Line{drawings::segment({o.x - guide_behind, o.y}, {o.x + axis_ahead, o.y}), Meaning::axis, {}});
  plot.mark(drawings::Guide{{o.x - guide_behind, o.y}, {o.x + guide_ahead, o.y}});
  plot.mark(drawings::Slider{o, 0});
  plot.segment(O, A, Meaning::link);
  plot.hinge(O);
  plot.dot(A, Meaning::link);
  draw_angle(plot);
  if (sense != 0) draw_sense_of_turning(plot, O, A, sense, "$ω$");
  // At the block's upper corner, on the side that the bar leaves free: inside the block letters would be lost.
  const double corner = A.x > 0 ? -half_block : half_block;
  plot.label("$O$", plot.from_paper({o.x + corner, o.y + block_top}), O);
  plot.label("$A$", A, O);
  plot.label("$x$", plot.from_paper({o.x + axis_ahead, o.y}), O);
}

void CarriedBar::sketch(Plot& plot) const {
  plot.segment(O, A, Meaning::link);
  for (const Place& P : corners()) plot.dot(P, Meaning::link);
  plot.label("$O$", O, A);
  plot.label("$A$", A, O);
}

void CarriedBar::include(Extent& extent, const Scale& scale) const {
  extent.include(-guide_behind, -11);
  extent.include(axis_ahead + 5, 12);
  extent.include(scale, A, 7);
}

double CarriedBar::reach() const { return std::hypot(A.x, A.y); }

}  // namespace epure::velocity_centre
