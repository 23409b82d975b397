// A vector polygon as a sequence of pictures, a step a picture: a panel each.
#pragma once

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/proof/solution.h"

namespace epure::rivals_polygons {

class PicturePanel : public Panel {
 public:
  PicturePanel(VectorPolygon polygon, const PolygonStage& stage, Words caption)
      : polygon_(std::move(polygon)), stage_(stage), caption_(std::move(caption)) {}

  bool is_of_vectors() const override { return true; }
  bool is_stage() const override { return !is_last(); }
  Vectors vectors() const override { return {polygon_.unit, greatest(polygon_)}; }
  // The same for all pictures of a polygon, under the caption.
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  // The equation stands on the sheet once, with the whole polygon; its vectors are measured there.
  std::vector<drawings::VectorEquation> equations() const override;
  std::vector<double> crossings() const override { return crossings_of(polygon_); }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  bool is_last() const { return !stage_.numbered; }

  VectorPolygon polygon_;
  PolygonStage stage_;
  Words caption_;
};

// Adds the pictures: each known vector; then the lines of the unknown ones; then the polygon closed. `figures` are
// the numbers that the last pictures have in the source.
void add_pictures(Panels& panels, const VectorPolygon& polygon, const std::vector<int>& figures);

}  // namespace epure::rivals_polygons
