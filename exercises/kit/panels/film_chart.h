// The film of a flat pad along its length, drawn higher than it is: by how much, it tells.
#pragma once

#include <string>

#include "exercises/kit/panels/sized_chart.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure {

// Quantities that a ruler reads off it; empty: none.
struct FilmQuantities {
  std::string inlet, outlet;  // h
  std::string x_bar, h_bar;   // where the pressure is greatest
};

class FilmChart : public SizedChart {
 public:
  FilmChart(const geometry::FilmWedge<double>& film, const FilmQuantities& quantities, double letters_left);

 protected:
  std::string told_of(const drawings::ChartMap& map, Language language) const override;
};

}  // namespace epure
