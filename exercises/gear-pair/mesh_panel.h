// The mesh around the pitch point, with all that the construction leaves on the paper.
#pragma once

#include "exercises/gear-pair/teeth.h"
#include "exercises/kit/panels/panel.h"

namespace epure::gear_pair {

class MeshPanel : public Panel {
 public:
  explicit MeshPanel(Pair pair) : pair_(std::move(pair)) {}

  bool is_in_millimetres() const override { return true; }
  bool is_cut() const override { return true; }
  double reach() const override;
  drawings::Box extent(const Scale& scale, const Scale&) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  Pair pair_;
};

}  // namespace epure::gear_pair
