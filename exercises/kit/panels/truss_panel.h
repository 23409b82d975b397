// A truss with its supports, its loads and reactions outside of it, its bars numbered, and the regions of the plane
// lettered as Bow does: those outside lie between the lines of the forces.
#pragma once

#include <memory>
#include <optional>

#include "exercises/kit/panels/funicular_of_loads.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/truss_figure.h"

namespace epure {

class TrussPanel : public Panel {
 public:
  enum class Regions { lettered, without_letters };
  TrussPanel(std::shared_ptr<const TrussFigure> figure, Regions regions)
      : figure_(std::move(figure)), regions_(regions) {}
  // With the funicular polygon that finds the reactions, and nothing said of tension or compression.
  TrussPanel& strings(FunicularOfLoads funicular) {
    funicular_ = std::move(funicular);
    return *this;
  }

  double reach() const override;
  drawings::Box extent(const Scale& scale, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  // An arrow on paper, from its tail.
  struct OnPaper {
    Arrow2 to_tail, to_tip;  // from the joint, mm
  };
  OnPaper arrow_of(std::size_t outside) const;
  // Where it lies outside of the truss at a joint of its outline: radians, and how far counter-clockwise.
  struct Opening {
    double from, angle;
  };
  Opening outside_of(std::size_t joint) const;
  Arrow2 middle_of_outside(std::size_t joint) const;
  double hinge_down() const;
  // Solved: each bar by what it bears, with its sign; else nothing said of tension or compression.
  void draw_truss(Plot& plot, bool is_solved) const;
  void draw_force(Plot& plot, std::size_t outside) const;
  void draw_supports(Plot& plot) const;
  void letter_regions(Plot& plot) const;
  std::vector<Place> corners_of(std::size_t step) const;  // of the region that it letters
  bool has_room_for_sign(std::size_t bar, const Scale& scale) const;
  void draw_strings(Plot& plot) const;

  std::shared_ptr<const TrussFigure> figure_;
  Regions regions_;
  std::optional<FunicularOfLoads> funicular_ = {};
};

}  // namespace epure
