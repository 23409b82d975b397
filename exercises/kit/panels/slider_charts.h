// What depends on n = h1/h2 alone under a flat slider: the centre of pressure x_N/l, A of the load, k of the
// friction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

struct SliderPoint {
  double n = 1, centre = 0, load = 0, friction = 0;
};
// Between which rows someone's table is interpolated, and what its chord gives at the centre that was sought.
struct SliderChord {
  SliderPoint before, after;
  double n;
  std::string letters, quantity;
};
struct SliderCharts {
  double up_to = 4;                       // the greatest n shown
  std::vector<SliderPoint> table = {};    // of someone's table
  std::optional<SliderChord> chord = {};  // beside the root, in a detail of its own
  SliderPoint found;                      // with the quantities that a ruler reads there:
  std::string ratio_quantity, load_quantity, friction_quantity;
};

// Three charts of one abscissa, in this order, and the detail behind the first.
Panels slider_charts(const SliderCharts& of, Language language);

// What the three curves are: x_N/l, A, k. In each language the same signs.
std::vector<std::string> slider_formulas();

}  // namespace epure
