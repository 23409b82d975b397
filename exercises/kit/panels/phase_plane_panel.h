// A phase plane: isoclines with the direction of motion upon them, straight trajectories, orbits, and what was
// computed step by step.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/proof/place.h"

namespace epure {

struct PhasePlane {
  using Line = std::vector<drawings::Datum>;
  struct Orbit {
    std::string name, label;
    std::vector<Line> runs = {};
    Meaning meaning = Meaning::locus;
    drawings::LineType line = drawings::LineType::continuous;
    std::vector<drawings::Datum> points = {};  // of a table: marked one by one
  };

  drawings::Axis x, y;
  // How x and y change there, in their units a second.
  std::function<Arrow2(const drawings::Datum&)> motion;
  std::vector<Line> isoclines = {};  // each crossed by strokes of its one direction
  std::vector<Orbit> orbits = {};    // straight trajectories first
  std::vector<drawings::Marker> markers = {};
  std::vector<ChartPanel::Read> read = {};
};

class PhasePlanePanel : public ChartPanel {
 public:
  explicit PhasePlanePanel(const PhasePlane& plane);
};

}  // namespace epure
