// The accelerations of a scene's points, with the points of its links that have none.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exercises/kit/panels/vectors_panel.h"

namespace epure::scenes {

class AccelerationsPanel : public VectorsPanel {
 public:
  struct Centre {
    std::string quantity, letters;  // "K_3", "$K_{3}$"
    Place at;
  };
  AccelerationsPanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism,
                     const std::vector<std::string>& points, std::vector<Centre> centres)
      : VectorsPanel(solution, mechanism, acceleration, points),
        mechanism_(std::move(mechanism)),
        centres_(std::move(centres)) {}

  // A centre far from the mechanism is told, and not drawn.
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  std::vector<Centre> centres_;
};

}  // namespace epure::scenes
