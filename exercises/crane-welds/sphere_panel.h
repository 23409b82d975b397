// The truncated sphere of fillet welds, cut by the plane of τ∥ and σ⊥: a circle, cut off above and below, in which
// the points of the stresses must lie.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure::crane_welds {

class SpherePanel : public Panel {
 public:
  struct State {
    std::string quantity, label;  // of a shear along the joint that a ruler reads, signed
    double tau;                   // MPa
  };
  // The sphere's radius and the height of the cut, in MPa.
  SpherePanel(double radius, double cut, std::vector<State> states)
      : radius_(radius), cut_(cut), states_(std::move(states)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override { return {"MPa", 2 * radius_, longest_on_paper}; }
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  static constexpr double longest_on_paper = 110;  // mm
  // Of the circle at the cut; none when the cut does not reach it.
  double half_chord() const;
  // How many times the axis below is enlarged: 1, 2, 5 times a power of ten; 1: there is none.
  double times() const;
  void draw_state(Plot& plot, const State& state) const;
  void draw_detail(Plot& plot) const;

  double radius_, cut_;
  std::vector<State> states_;
};

}  // namespace epure::crane_welds
