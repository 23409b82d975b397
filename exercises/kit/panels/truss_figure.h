// A plane truss with its loads and supports, and Cremona's plan of its forces: what two panels show of it.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/plot.h"
#include "geometry/statics/truss.h"

namespace epure {

struct TrussFigure {
  struct Bar {
    std::size_t from, to;  // joints
    double force;          // N, tension positive
    std::string quantity;  // "N_3"
  };
  struct Outside {
    std::size_t joint;
    Arrow2 f;              // N
    std::string label;     // "$\\it{R}_{A}$"
    std::string quantity;  // of its size; empty: none that is reported
  };

  std::vector<std::string> letters = {};  // of the joints: "A", "C_{3}"
  std::vector<Place> joints = {};
  std::vector<Bar> bars = {};
  std::vector<Outside> outside = {};  // the hinge's, the roller's, then the loads; one a joint at most
  geometry::BowNotation bow = {};
  std::vector<Place> plan = {};  // N, of the regions
  double roller_down = 0;        // towards its ground, radians

  // Of the plan's construction: the first draws the regions outside, each further one a region and its two bars, of
  // which the last ends what is left to draw.
  int step_of_region(std::size_t region) const {
    for (std::size_t k = 0; k < bow.steps.size(); ++k)
      if (bow.steps[k].region == region) return static_cast<int>(k) + 2;
    return 1;
  }
  int step_of_bar(std::size_t bar) const {
    for (const auto& step : bow.steps)
      if (step.bars[0] == bar || step.bars[1] == bar) return step_of_region(step.region);
    return static_cast<int>(bow.steps.size()) + 1;
  }

  // As textbooks tell them apart: what is pressed heavy, what is pulled thin; what bears nothing is dashed.
  static Meaning meaning(double force) {
    return force == 0 ? Meaning::alternative : force > 0 ? Meaning::plate : Meaning::link;
  }
  // Of tension and compression, after the number of the bar; what bears nothing has none, as "3 0" would read thirty.
  static std::string sign(double force) { return force == 0 ? "" : force > 0 ? " +" : " −"; }
};

}  // namespace epure
