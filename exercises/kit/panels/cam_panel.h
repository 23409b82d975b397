// A cam held fast, and its roller follower in several positions round it: the motion inverted. Each axis of the
// follower touches the circle of its offset; on it the roller's centre lies as far beyond the base circle as the
// follower is lifted.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct CamFollowerPosition {
  std::string number;          // of the position: "30"
  std::string lift;            // the quantity that a ruler reads along the axis; empty: none
  Place foot, lowest, roller;  // on the axis: next to the cam's centre, at no lift, now
};
struct CamFigure {
  Place A0, A;          // centre of turning, centre of the disc
  double disc, roller;  // radii, m
  std::vector<CamFollowerPosition> positions;
  std::vector<std::pair<Words, Place>> steps;
};

class CamPanel : public Panel {
 public:
  explicit CamPanel(CamFigure cam) : cam_(std::move(cam)) {}

  double reach() const override { return 2 * (cam_.disc + 2 * cam_.roller) + distance(cam_.A0, cam_.A); }
  drawings::Box extent(const Scale& lengths, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  CamFigure cam_;
};

}  // namespace epure
