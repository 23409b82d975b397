// The slider-crank with a plain bar for its coupler, and a point G on it.
#pragma once

#include "exercises/kit/panels/mechanism_figure.h"

namespace epure::rivals_polygons {

struct Mechanism : MechanismFigure {
  Place A0{0, 0}, A{0, 0}, B{0, 0}, G{0, 0};
  double sense = 1;  // of the crank: positive counter-clockwise

  void draw(Plot& plot) const override;
  void sketch(Plot& plot) const override;
  void include(Extent& extent, const Scale& scale) const override;
  std::vector<Place> corners() const override { return {A0, A, B, G}; }
  double reach() const override;

 private:
  void draw_links(Plot& plot) const;
  void write_letters(Plot& plot) const;
};

}  // namespace epure::rivals_polygons
