// The displacement plan of a chain of bars, unfolded: each bar first turns with the end of the one before, along its
// tangent, and then bends away from it. Ways along the chain at the scale of lengths, displacements upwards at one of
// their own.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct PlannedBar {
  std::array<Place, 4> corners;  // of the bar's polygon: along the whole chain and upwards, m
  Place tangent;                 // where the first tangent ends
  std::string turned;            // letters of what the turn alone gives; empty: it does not turn
  std::string bends, bent;       // the quantity of what bending adds (empty: none that is reported), its letters
  bool bending_counts_down = true;
  std::string rise, end, end_letters;  // the quantity of the end's displacement, its letters; the end's letters
  Words told_turned, told_bent;        // steps; the first is empty where the bar does not turn
};

class DisplacementPlanPanel : public Panel {
 public:
  DisplacementPlanPanel(std::string begin, std::vector<PlannedBar> bars)
      : begin_(std::move(begin)), bars_(std::move(bars)) {}

  double reach() const override { return bars_.back().corners[3].x; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  // `off`: where the end's whole displacement is drawn, mm to the right of it.
  void draw_bar(Plot& plot, const PlannedBar& bar, double off, Language language) const;

  std::string begin_;
  std::vector<PlannedBar> bars_;
};

}  // namespace epure
