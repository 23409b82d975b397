#include "exercises/rivals-polygons/mechanism.h"

#include <algorithm>
#include <cmath>

namespace epure::rivals_polygons {
namespace {

constexpr double guide_behind = 14, guide_ahead = 10;  // mm of hatched guide beside the slider's pin
constexpr double axis_beyond = 4;                      // mm past the crank's circle, or the slider's pin

}  // namespace

void Mechanism::draw_links(Plot& plot) const {
  plot.segment(A0, A, Meaning::link);
  plot.segment(A, B, Meaning::link);
  plot.segment(A, G, Meaning::link);  // beyond A or B, when G lies there
}

void Mechanism::write_letters(Plot& plot) const {
  const Place middle{(A0.x + A.x + B.x) / 3, (A0.y + A.y + B.y) / 3};
  plot.label("$A_{0}$", A0, A);
  plot.label("$A$", A, middle);
  plot.label("$B$", B, A);
  plot.label("$G$", G, middle);
}

void Mechanism::draw(Plot& plot) const {
  const double r = std::hypot(A.x, A.y);
  plot.long_segment({std::min(-r, B.x), 0}, {std::max(r, B.x), 0}, axis_beyond, Meaning::axis);
  plot.circle(A0, r, Meaning::axis);
  const drawings::Point b = plot.at(B);
  plot.mark(drawings::Guide{{b.x - guide_behind, b.y}, {b.x + guide_ahead, b.y}});
  draw_links(plot);
  plot.mark(drawings::Slider{b, 0});
  plot.mark(drawings::FixedHinge{plot.at(A0), direction_of_support(A0, A)});
  for (const Place& P : {A, B}) plot.hinge(P);
  plot.dot(G, Meaning::link);
  draw_sense_of_crank(plot, A0, A, sense);
  write_letters(plot);
}

void Mechanism::sketch(Plot& plot) const {
  draw_links(plot);
  for (const Place& P : corners()) plot.dot(P, Meaning::link);
  write_letters(plot);
}

void Mechanism::include(Extent& extent, const Scale& scale) const {
  const double r = std::hypot(A.x, A.y);
  extent.include(scale, {-r, -r}, axis_beyond);
  extent.include(scale, {r, r}, axis_beyond);
  extent.include(scale, A0, 11);  // its support and the arc arrow
  extent.include(scale, G, 7);
  const drawings::Point b{scale.mm_per_unit * B.x, scale.mm_per_unit * B.y};
  extent.include(b.x - guide_behind, b.y - 6);
  extent.include(b.x + guide_ahead, b.y + 6);
}

double Mechanism::reach() const {
  const double r = std::hypot(A.x, A.y);
  return r + std::max(std::hypot(B.x, B.y), std::hypot(G.x, G.y));
}

}  // namespace epure::rivals_polygons
