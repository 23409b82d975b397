// The hodograph of a vector: the curve that its tip runs through when it is laid off from one pole, at one scale in
// both directions, with the vector drawn at some instants.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct Hodograph {
  struct Instant {
    Place tip;
    std::string label;                       // rich text
    std::string along_x = {}, along_y = {};  // quantities that a ruler reads
    bool with_arrow = false;
    std::string letters = {};  // of the arrow
  };
  struct Curve {
    std::string name;
    std::vector<Place> points;
    Meaning meaning = Meaning::force;
  };
  std::string pole, unit;
  std::string x_letters, y_letters;
  std::vector<Curve> curves = {};
  std::vector<Instant> instants = {};
  std::vector<PanelStep> steps = {};
};

class HodographPanel : public Panel {
 public:
  explicit HodographPanel(Hodograph hodograph) : hodograph_(std::move(hodograph)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override { return hodograph_.steps; }

 private:
  Hodograph hodograph_;
};

}  // namespace epure
