// The four-bar linkage as it is drawn, and its polar diagrams.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/polygon_picture.h"

namespace epure {

class FourBarFigure : public MechanismFigure {
 public:
  Place A0{0, 0}, A, B, B0;
  std::optional<Place> C = {};               // corner of the coupler's plate
  std::vector<Lettered<Place>> points = {};  // others on the links, with their letters as rich text
  double sense = 1;                          // of the crank: 1 counter-clockwise, -1 clockwise
  std::vector<Place> other_B = {};           // in other positions shown: the way of B reaches them

  void draw(Plot& plot) const override;
  void sketch(Plot& plot) const override;
  void include(Extent& extent, const Scale& scale) const override;
  std::vector<Place> corners() const override;
  double reach() const override;

 private:
  void draw_links(Plot& plot) const;
  void draw_letters(Plot& plot, const std::vector<Lettered<Place>>& letters) const;
  Place middle() const;
};

// The hinges of a linkage found with many bits, rounded once.
FourBarFigure drawn_four_bar(const geometry::FourBar<geometry::Deep>& at, double sense);

// What both polar diagrams of a four-bar show: found with many bits, rounded once. Quantities as in the exercises
// ("v_A", "a_BA_n"), after `prefix`.
VectorPolygon velocity_polygon(const geometry::FourBar<geometry::Deep>& at,
                               const geometry::FourBarMotion<geometry::Deep>& motion, const std::string& prefix);
VectorPolygon acceleration_polygon(const geometry::FourBar<geometry::Deep>& at,
                                   const geometry::FourBarMotion<geometry::Deep>& motion, const std::string& prefix);

}  // namespace epure
