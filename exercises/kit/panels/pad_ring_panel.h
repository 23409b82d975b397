// The ring of pads of a thrust bearing, seen along the shaft, with its dimensions.
#pragma once

#include <string>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct PadRing {
  int pads = 1;
  double inner = 0, outer = 0;               // radii, m
  double length = 0;                         // of a pad on the mean circle, m
  double pivot = 0.5;                        // in lengths of the pad, from its leading edge
  std::string mean_letters, length_letters;  // what the dimensions are called
  std::string drag_letters = {},
              couple_letters = {};  // of what the film does to each pad, and to all; empty: not shown
  std::string width_letters = {}, pivot_letters = {}, pitch_letters = {}, gap_letters = {};  // empty: not dimensioned
  std::string outer_quantity = {}, inner_quantity = {}, mean_quantity = {};                  // that a ruler reads
};

class PadRingPanel : public Panel {
 public:
  explicit PadRingPanel(PadRing ring) : ring_(std::move(ring)) {}

  double reach() const override { return ring_.outer; }
  drawings::Box extent(const Scale& scale, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  double mean() const { return (ring_.inner + ring_.outer) / 2; }
  // Of the pad's leading edge, its pivot, its trailing edge; the runner turns clockwise.
  double leading(int pad) const;
  static Place at(double radius, double angle);
  double angle() const { return ring_.length / mean(); }  // of a pad
  void draw_pads(Plot& plot) const;
  void draw_radii(Plot& plot) const;
  // An arc of the mean circle with a head at both ends.
  void dimension_arc(Plot& plot, double from, double to, const std::string& letters) const;
  void dimension_pads(Plot& plot) const;
  void draw_drags(Plot& plot) const;

  PadRing ring_;
};

}  // namespace epure
