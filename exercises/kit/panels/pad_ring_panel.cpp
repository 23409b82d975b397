#include "exercises/kit/panels/pad_ring_panel.h"

#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double around_ring = 10;  // mm around the ring

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

void PadRingPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const Place O{0, 0};
  plot.circle(O, mean(), Meaning::axis);
  plot.cross(O, Meaning::text);
  plot.label("$O$", O, at(1, whole_turn / 3));
}

std::vector<drawings::Block> PadRingPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
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
  draw_given(plot, room, language);
  const Place O{0, 0};
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
  if (!ring_.drag_letters.empty()) draw_drags(plot);
  constexpr double outside = 5, sense = 0.35;  // mm; of a right angle on both sides
  plot.mark(drawings::Rotation{plot.at(O), ring_.outer * plot.scale().mm_per_unit + outside,
                               whole_turn / 4 * (1 + sense), whole_turn / 4 * (1 - sense), Meaning::velocity});
  if (!ring_.outer_quantity.empty()) plot.measures(ring_.outer_quantity, O, right);
  if (!ring_.inner_quantity.empty()) plot.measures(ring_.inner_quantity, O, left);
  if (!ring_.mean_quantity.empty()) plot.measures(ring_.mean_quantity, O, at(mean(), below));
  return {};
}

// One length for all: how large they are, their polygon shows. They turn with the runner, which drags the film.
void PadRingPanel::draw_drags(Plot& plot) const {
  constexpr double long_on_paper = 11;  // mm
  const double length = long_on_paper / plot.scale().mm_per_unit;
  for (int pad = 0; pad < ring_.pads; ++pad) {
    const double angle = leading(pad) - ring_.pivot * ring_.length / mean();
    const Place from = at(mean(), angle), tip = from + length * Arrow2{std::sin(angle), -std::cos(angle)};
    plot.mark(drawings::Arrow{plot.at(from), plot.at(tip), Meaning::force, {}});
    if (pad == 0) plot.label(ring_.drag_letters, tip, from, Meaning::force);
  }
  constexpr double share = 0.5, half_arc = 0.5;  // of the inner radius; radians, about downwards
  plot.mark(drawings::Rotation{plot.at({0, 0}), share * ring_.inner * plot.scale().mm_per_unit,
                               -whole_turn / 4 + half_arc, -whole_turn / 4 - half_arc, Meaning::force});
  plot.label(ring_.couple_letters, at(share * ring_.inner, -whole_turn / 4), at(0.1, -whole_turn / 4),
             Meaning::force);
}

std::vector<PanelStep> PadRingPanel::steps(const Plot&, const drawings::Box&) const {
  const double angle = ring_.length / mean();
  std::vector<PanelStep> all{
      {Words{"The pads, equally spaced; their length ", "I pattini, equidistanti; la lunghezza "} +
           ring_.length_letters +
           Words{" is measured along the mean circle.", " è misurata sulla circonferenza media."},
       at((mean() + ring_.outer) / 2, leading(0) - 0.2 * angle)},
      {{"Each turns on its pivot, beyond the middle in the direction of motion (the runner turns clockwise).",
        "Ciascuno è incernierato oltre la metà, nel verso del moto (la ralla gira in senso orario)."},
       at((mean() + ring_.inner) / 2, leading(0) - ring_.pivot * angle - 0.15 * angle)}};
  if (!ring_.drag_letters.empty())
    all.push_back(
        {Words{"The film drags each pad along with ", "Il meato trascina ogni pattino con "} + ring_.drag_letters +
             Words{" on the mean circle: on all pads the couple ",
                   " sulla circonferenza media: su tutti i pattini la coppia "} +
             ring_.couple_letters + Words{", which the shaft must overcome.", ", che l'albero deve vincere."},
         at(0.5 * ring_.inner, -whole_turn / 8)});
  return all;
}

}  // namespace epure
