// What depends on n = h1/h2 alone under a flat slider: the centre of pressure x_N/l, A of the load, k of the
// friction.
#pragma once

#include <string>
#include <vector>

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

struct SliderPoint {
  double n = 1, centre = 0, load = 0, friction = 0;
};
struct SliderCharts {
  double up_to = 4;                     // the greatest n shown
  std::vector<SliderPoint> table = {};  // of someone's table
  SliderPoint found;                    // with the quantities that a ruler reads there:
  std::string load_quantity, friction_quantity;
};

// Three charts of one abscissa, in this order.
Panels slider_charts(const SliderCharts& of, Language language);

}  // namespace epure
