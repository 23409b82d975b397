// Cremona's plan of a truss: each region a point with its letter, the forces from outside as arrows, those of the
// bars as lines between the points of their regions; drawn region by region.
#pragma once

#include <memory>

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/truss_figure.h"

namespace epure {

class ForcePlanPanel : public Panel {
 public:
  explicit ForcePlanPanel(std::shared_ptr<const TrussFigure> figure) : figure_(std::move(figure)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  // Those of the regions within; of those without the letters stand in a row beside the loads.
  std::vector<Place> lettered() const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  double longest() const;  // N, from point to point
  bool is_slender() const;

  std::shared_ptr<const TrussFigure> figure_;
};

}  // namespace epure
