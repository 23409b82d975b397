#include "exercises/kit/panels/pad_ring_panel.h"

#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double above_ring = 10, around_ring = 2;  // mm: the sense of rotation stands above
constexpr double longest_piece = whole_turn / 180;  // of an arc: its chord is a six-thousandth of the radius within

}  // namespace

Place PadRingPanel::at(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

// The first pad stands upright above the centre.
double PadRingPanel::leading(int pad) const {
  return whole_turn / 4 + ring_.length / mean() / 2 - pad * whole_turn / ring_.pads;
}

drawings::Box PadRingPanel::extent(const Scale& scale, const Scale&) const {
  const double outer = ring_.outer * scale.mm_per_unit;
  return {{-outer - around_ring, -outer - around_ring}, {outer + around_ring, outer + above_ring}};
}

void PadRingPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  const Place O{0, 0};
  plot.circle(O, mean(), Meaning::axis);
  plot.cross(O, Meaning::text);
  plot.label("$O$", O, at(1, whole_turn / 3));
}

std::vector<drawings::Block> PadRingPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  draw_pads(plot);
  draw_given(plot, room, language);
  draw_radii(plot);
  dimension_pads(plot);
  if (!ring_.drag_letters.empty()) draw_drags(plot);
  constexpr double outside = 5, sense = 0.35;  // mm; of a right angle on both sides
  plot.mark(drawings::Rotation{plot.at({0, 0}), ring_.outer * plot.scale().mm_per_unit + outside,
                               whole_turn / 4 * (1 + sense), whole_turn / 4 * (1 - sense), Meaning::velocity});
  return {};
}

void PadRingPanel::draw_pads(Plot& plot) const {
  const int pieces = static_cast<int>(std::ceil(angle() / longest_piece));
  for (int pad = 0; pad < ring_.pads; ++pad) {
    std::vector<Place> corners;
    for (const double radius : {ring_.outer, ring_.inner})
      for (int i = 0; i <= pieces; ++i) {
        const int step = radius == ring_.outer ? i : pieces - i;
        corners.push_back(at(radius, leading(pad) - angle() * step / pieces));
      }
    plot.area(corners, Meaning::plate);
    plot.polygon(corners, Meaning::link);
    const double pivot = leading(pad) - ring_.pivot * angle();
    plot.segment(at(ring_.inner, pivot), at(ring_.outer, pivot), Meaning::axis);
    plot.cross(at(mean(), pivot), Meaning::force);
  }
}

// On circles all around, as a pad need not stand where a radius ends.
void PadRingPanel::draw_radii(Plot& plot) const {
  const Place O{0, 0};
  const auto add = [&](const std::string& letters, const std::string& quantity, double radius, double direction,
                       double beside) {
    const Place end = at(radius, direction);
    plot.mark(drawings::Arrow{plot.at(O), plot.at(end), Meaning::dimension, {}});
    plot.label(letters, at(0.5 * ring_.inner, direction), at(1, beside));
    if (!quantity.empty()) plot.measures(quantity, O, end);
  };
  for (const double radius : {ring_.outer, ring_.inner}) plot.circle(O, radius, Meaning::construction);
  add("$\\it{R}_{e}$", ring_.outer_quantity, ring_.outer, 0, -whole_turn / 4);
  add("$\\it{R}_{i}$", ring_.inner_quantity, ring_.inner, whole_turn / 2, -whole_turn / 4);
  add(ring_.mean_letters, ring_.mean_quantity, mean(), -whole_turn * 3 / 8, whole_turn / 8);
}

void PadRingPanel::dimension_arc(Plot& plot, double from, double to, const std::string& letters) const {
  const double middle = (from + to) / 2, radius = mean() * plot.scale().mm_per_unit;
  for (const double end : {from, to})
    plot.mark(drawings::Rotation{plot.at({0, 0}), radius, middle, end, Meaning::dimension});
  // Beside the first quarter: the pivot's line is beyond the middle.
  const double beside = std::max(from, to) - std::abs(to - from) / 4;
  plot.label(letters, at(mean(), beside), at(ring_.inner, beside));
}

// Each on a pad of its own, as far as there are pads, and as these are long enough for letters. Lengths of arcs: no
// ruler reads them.
void PadRingPanel::dimension_pads(Plot& plot) const {
  constexpr double least = 12;  // mm
  if (ring_.length * plot.scale().mm_per_unit < least) return;
  dimension_arc(plot, leading(0), leading(0) - angle(), ring_.length_letters);
  if (ring_.pads < 3) return;
  if (!ring_.pivot_letters.empty())
    dimension_arc(plot, leading(1), leading(1) - ring_.pivot * angle(), ring_.pivot_letters);
  if (!ring_.pitch_letters.empty()) dimension_arc(plot, leading(-1), leading(0), ring_.pitch_letters);
  if (!ring_.gap_letters.empty()) {
    const double begins = leading(0) - angle(), ends = leading(1), gap = (begins + ends) / 2;
    if ((begins - ends) * mean() * plot.scale().mm_per_unit < least)
      plot.label(ring_.gap_letters, at(ring_.outer, gap), at(mean(), gap));
    else
      dimension_arc(plot, begins, ends, ring_.gap_letters);
  }
  if (!ring_.width_letters.empty()) {
    const double beside = leading(ring_.pads / 2) - 0.9 * angle();  // beyond the pivot
    plot.mark(drawings::Dimension{plot.at(at(ring_.inner, beside)), plot.at(at(ring_.outer, beside)), 0,
                                  ring_.width_letters});
  }
}

// One length for all, of no scale: how large they are, their polygon shows. They turn with the runner, which drags
// the film. Of many pads some show it.
void PadRingPanel::draw_drags(Plot& plot) const {
  constexpr double long_on_paper = 11, apart = 13;  // mm
  const double length = long_on_paper / plot.scale().mm_per_unit;
  const int every =
      static_cast<int>(std::ceil(apart / (whole_turn / ring_.pads * mean() * plot.scale().mm_per_unit)));
  for (int pad = 0; pad < ring_.pads; pad += every) {
    const double pivot = leading(pad) - ring_.pivot * angle();
    const Place from = at(mean(), pivot), tip = from + length * Arrow2{std::sin(pivot), -std::cos(pivot)};
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
  std::vector<PanelStep> all{
      {Words{"The pads, equally spaced; their length ", "I pattini, equidistanti; la lunghezza "} +
           ring_.length_letters +
           Words{" is measured along the mean circle.", " è misurata sulla circonferenza media."},
       at((mean() + ring_.outer) / 2, leading(0) - 0.2 * angle())},
      {{"Each turns on its pivot, beyond the middle in the direction of motion (the runner turns clockwise).",
        "Ciascuno è incernierato oltre la metà, nel verso del moto (la ralla gira in senso orario)."},
       at((mean() + ring_.inner) / 2, leading(0) - (ring_.pivot + 0.15) * angle())}};
  if (!ring_.drag_letters.empty())
    all.push_back(
        {Words{"The film drags each pad along with ", "Il meato trascina ogni pattino con "} + ring_.drag_letters +
             Words{" on the mean circle (arrows not to scale): on all pads the couple ",
                   " sulla circonferenza media (frecce non in scala): su tutti i pattini la coppia "} +
             ring_.couple_letters + Words{", which the shaft must overcome.", ", che l'albero deve vincere."},
         at(0.5 * ring_.inner, -whole_turn / 8)});
  return all;
}

}  // namespace epure
