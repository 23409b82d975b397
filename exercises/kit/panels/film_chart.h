// The film of a flat pad along its length, drawn higher than it is: by how much, it tells. The pad, inclined and
// hatched, rests; the flat runner below it moves towards the narrow end.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/marked_chart.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure {

// Quantities that a ruler reads off it; empty: none.
struct FilmQuantities {
  std::string inlet = {}, outlet = {};  // h
  std::string x_bar = {}, h_bar = {};   // where the pressure is greatest
};
// A section that the film shows, and the quantity that tells where it is.
struct FilmSection {
  double x;
  std::string letters, quantity;
};
struct FilmShown {
  FilmQuantities quantities;
  std::string speed_letters;  // of the runner
  std::vector<FilmSection> sections = {};
  double letters_left = 0;
};

// How many times the scale of its height is that of its length.
Words film_exaggeration(double times);

class FilmChart : public MarkedChart {
 public:
  FilmChart(const geometry::FilmWedge<double>& film, const FilmShown& shown);

 protected:
  std::string told_of(const drawings::ChartMap& map, Language language) const override;

 private:
  std::string speed_letters_;
};

}  // namespace epure
