// A pad of a thrust bearing and the runner below it, cut along the mean circle: the film between them, drawn higher
// than it is by as much as it tells, and the sense of the motion.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct PadSection {
  double length = 0;        // of the pad, m
  double pivot = 0.5;       // in lengths of the pad, from its leading edge
  double h_1 = 0, h_2 = 0;  // films at its edges, m
  std::string length_letters, pivot_letters, speed_letters;
  std::string inlet_quantity, outlet_quantity;  // that a ruler reads
};

// Of no scale: the pad is as long on any paper, and the film as high at its inlet.
class PadSectionPanel : public Panel {
 public:
  explicit PadSectionPanel(PadSection section) : section_(std::move(section)) {}

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  double outlet() const;  // how high the film is drawn there
  void draw_pad(Plot& plot, Language language) const;
  void dimension(Plot& plot) const;

  PadSection section_;
};

}  // namespace epure
