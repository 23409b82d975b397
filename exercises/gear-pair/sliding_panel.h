// How the flanks slide on each other, along the path of contact: their velocities along the common tangent with the
// sliding velocity between them, and below, the sliding over each flank's own velocity.
#pragma once

#include "drawings/charts/chart.h"
#include "exercises/gear-pair/pair.h"
#include "exercises/kit/panels/panel.h"

namespace epure::gear_pair {

class SlidingPanel : public Panel {
 public:
  // The pair has contact.
  explicit SlidingPanel(Pair pair) : pair_(std::move(pair)) {}

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override { return {{0, 0}, {110, 150}}; }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;

 private:
  drawings::Axis path_axis() const;
  std::vector<drawings::ReferenceLine> places(bool named) const;
  std::pair<drawings::Chart, drawings::Chart> charts(Language language) const;
  drawings::Chart velocities(Language language) const;
  drawings::Chart specific(Language language) const;
  // Along the common tangent, at a point of which the solution holds it; the sliding with its sense.
  double of_flank(int wheel, const std::string& point) const;
  double sliding(const std::string& point) const;

  Pair pair_;
};

}  // namespace epure::gear_pair
