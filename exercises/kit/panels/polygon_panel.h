// The polygon of a vector equation as a part of a sheet.
#pragma once

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A side by the quantity it shows, with its direction and magnitude as the course writes them ("∥ $x$", "$ω$·$OA$";
// "?" when unknown) and the letter at its tip.
PolygonSide side(const Solution& solution, const VectorQuantity& quantity, const std::string& direction,
                 const std::string& magnitude, const std::string& tip = {});

// left = right. The sought vector alone on the left: all on the right are known.
VectorPolygon velocity_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right);
VectorPolygon acceleration_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right);

class PolygonPanel : public Panel {
 public:
  // Whether a table holds its vectors, as measured, against their values.
  enum class Table { none, measured };
  PolygonPanel(const Solution& solution, VectorPolygon polygon, Table table = Table::none)
      : solution_(solution), polygon_(std::move(polygon)), table_(table) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override { return {polygon_.unit, greatest(polygon_)}; }
  drawings::Box extent(const Scale&, const Scale& vectors) const override { return extent_of(polygon_, vectors); }
  void draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<drawings::VectorEquation> equations() const override { return {equation(polygon_)}; }
  std::vector<PanelStep> steps(const Plot& plot) const override;
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  const Solution& solution_;
  VectorPolygon polygon_;
  Table table_;
};

}  // namespace epure
