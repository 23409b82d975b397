// The loads of a truss laid end to end, with pole and rays, and its reactions found by the ray parallel to the
// closing line of the funicular polygon, which the truss itself shows (TrussPanel::strings).
#pragma once

#include <memory>

#include "exercises/kit/panels/funicular_of_loads.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

class SupportPolygonPanel : public Panel {
 public:
  SupportPolygonPanel(std::shared_ptr<const TrussFigure> figure, FunicularOfLoads funicular)
      : figure_(std::move(figure)), funicular_(std::move(funicular)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<Place> lettered() const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  std::vector<Place> all_points() const;
  bool covers(std::size_t reaction, const std::vector<std::pair<Place, Place>>& sides) const;
  // So many mm beside the loads, where the reactions would lie on them; else none.
  Arrow2 aside(double mm, const Scale& vectors) const;

  std::shared_ptr<const TrussFigure> figure_;
  FunicularOfLoads funicular_;
};

}  // namespace epure
