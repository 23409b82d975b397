#include "exercises/kit/panels/pad_ring_panel.h"

#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double around_ring = 14;  // mm around the ring

}  // namespace

Place PadRingPanel::at(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

// The first pad stands upright above the centre.
double PadRingPanel::leading(int pad) const {
  return whole_turn / 4 + ring_.length / mean() / 2 - pad * whole_turn / ring_.pads;
}

drawings::Box PadRingPanel::extent(const Scale& scale, const Scale&) const {
  Extent extent;
  for (const double side : {-1.0, 1.0}) extent.include(scale, {side * ring_.outer, side * ring_.outer}, around_ring);
  return extent.box();
}

std::vector<drawings::Block> PadRingPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const double angle = ring_.length / mean();
  constexpr int pieces = 12;  // of an arc
  for (int pad = 0; pad < ring_.pads; ++pad) {
    std::vector<Place> corners;
    for (const double radius : {ring_.outer, ring_.inner})
      for (int i = 0; i <= pieces; ++i) {
        const int step = radius == ring_.outer ? i : pieces - i;
        corners.push_back(at(radius, leading(pad) - angle * step / pieces));
      }
    plot.area(corners, Meaning::plate);
    plot.polygon(corners, Meaning::link);
    const double pivot = leading(pad) - ring_.pivot * angle;
    plot.segment(at(ring_.inner, pivot), at(ring_.outer, pivot), Meaning::axis);
    plot.cross(at(mean(), pivot), Meaning::force);
  }
  const Place O{0, 0};
  plot.circle(O, mean(), Meaning::axis);
  plot.cross(O, Meaning::text);
  plot.label("$O$", O, at(1, whole_turn / 3));
  const Place right = at(ring_.outer, 0), left = at(ring_.inner, whole_turn / 2);
  plot.segment(O, right, Meaning::dimension);
  plot.segment(O, left, Meaning::dimension);
  plot.label("$\\it{R}_{e}$", {0.5 * ring_.inner, 0}, at(1, -whole_turn / 4));
  plot.label("$\\it{R}_{i}$", {-0.5 * ring_.inner, 0}, at(1, -whole_turn / 4));
  const double below = -whole_turn * 3 / 8;
  plot.segment(O, at(mean(), below), Meaning::dimension);
  plot.label(ring_.mean_letters, at(0.5 * ring_.inner, below), at(1, whole_turn / 8));
  // The length is one of the arc: no ruler reads it.
  plot.mark(
      drawings::Line{drawings::arc(plot.at(O), mean() * plot.scale().mm_per_unit, leading(0) - angle, leading(0)),
                     Meaning::locus,
                     {}});
  plot.label(ring_.length_letters, at(mean(), leading(0) - 0.25 * angle), at(ring_.inner, leading(0) - 0.25 * angle),
             Meaning::locus);
  constexpr double outside = 5, sense = 0.35;  // mm; of a right angle on both sides
  plot.mark(drawings::Rotation{plot.at(O), ring_.outer * plot.scale().mm_per_unit + outside,
                               whole_turn / 4 * (1 + sense), whole_turn / 4 * (1 - sense), Meaning::velocity});
  if (!ring_.outer_quantity.empty()) plot.measures(ring_.outer_quantity, O, right);
  if (!ring_.inner_quantity.empty()) plot.measures(ring_.inner_quantity, O, left);
  if (!ring_.mean_quantity.empty()) plot.measures(ring_.mean_quantity, O, at(mean(), below));
  return {};
}

std::vector<PanelStep> PadRingPanel::steps(const Plot&, const drawings::Box&) const {
  const double angle = ring_.length / mean();
  return {{Words{"The pads, equally spaced; their length ", "I pattini, equidistanti; la lunghezza "} +
               ring_.length_letters +
               Words{" is measured along the mean circle.", " è misurata sulla circonferenza media."},
           at((mean() + ring_.outer) / 2, leading(0) - 0.2 * angle)},
          {{"Each turns on its pivot, beyond the middle in the direction of motion (the runner turns clockwise).",
            "Ciascuno è incernierato oltre la metà, nel verso del moto (la ralla gira in senso orario)."},
           at((mean() + ring_.inner) / 2, leading(0) - ring_.pivot * angle - 0.15 * angle)}};
}

}  // namespace epure
