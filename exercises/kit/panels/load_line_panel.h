// Parallel vectors laid end to end on an upright line, side by side where they would cover each other; with a pole
// and its rays, as the funicular polygon takes its strings from them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct LoadLine {
  struct Force {
    std::string quantity, label;
    double from, to;         // upwards, in the unit of the plan
    int lane = 0;            // beside the line, to the right
    bool is_signed = false;  // its quantity is positive upwards; else a magnitude
    Meaning meaning = Meaning::force;
    std::string tip = {};  // letter at its end
  };
  struct Ray {
    double corner;
    std::string letter;  // of the string parallel to it
  };
  std::string unit;  // "N"
  double si = 1;     // one unit, in SI
  std::vector<Force> forces;
  std::string start = {};    // letter at the foot of the line
  bool tells_scale = false;  // under it, where its unit does not tell its bar from the others
  std::optional<Place> pole = {};
  std::string pole_distance = {};  // its letters
  std::vector<Ray> rays = {};
  struct Step {
    Words text;
    Place at;                       // abscissa in lanes where it is not negative
    bool needs_all_others = false;  // begins with what the steps of the other panels found
  };
  std::vector<Step> steps = {};
};

class LoadLinePanel : public Panel {
 public:
  explicit LoadLinePanel(LoadLine plan) : plan_(std::move(plan)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  std::pair<double, double> ends() const;
  void draw_force(Plot& plot, const LoadLine::Force& force) const;
  void draw_pole(Plot& plot) const;

  LoadLine plan_;
};

}  // namespace epure
