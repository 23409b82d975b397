// A bar OA hinged on a block that slides on a guide.
#pragma once

#include "exercises/kit/panels/mechanism_figure.h"

namespace epure::velocity_centre {

struct CarriedBar : MechanismFigure {
  Place O{0, 0}, A{0, 0};
  double angle = 0;  // θ, from x, as it is given but for whole turns: within ±2π
  double sense = 0;  // of ω: positive counter-clockwise, 0 when the bar does not turn

  void draw(Plot& plot) const override;
  void sketch(Plot& plot) const override;
  void include(Extent& extent, const Scale& scale) const override;
  std::vector<Place> corners() const override { return {O, A}; }
  double reach() const override;

 private:
  void draw_angle(Plot& plot) const;
};

}  // namespace epure::velocity_centre
