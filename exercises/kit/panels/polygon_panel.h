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

// The image of a point whose vector, and that relative to the first point, the solution holds.
PolygonImage image(const Solution& solution, const VectorQuantity& absolute, const VectorQuantity& relative,
                   const std::string& tip, const Words& explained);

// left = right. The sought vector alone on the left: all on the right are known.
VectorPolygon velocity_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right);
VectorPolygon acceleration_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right);

// Forces in equilibrium, right + left = 0, about the body of this letter. The unknown one alone on the left closes
// the polygon.
VectorPolygon force_polygon(const std::string& letter, std::vector<PolygonSide> left, std::vector<PolygonSide> right);
// The same force on the other of the two bodies, known from the first.
PolygonSide reaction(const PolygonSide& action, const std::string& label, const std::string& magnitude);

class PolygonPanel : public Panel {
 public:
  // Whether a table holds its vectors, as measured, against their values.
  enum class Table { none, measured };
  PolygonPanel(const Solution& solution, VectorPolygon polygon, Table table = Table::none)
      : solution_(solution), polygon_(std::move(polygon)), table_(table) {}

  // Equations that the images solve, for the column.
  PolygonPanel& with_equations(std::vector<drawings::VectorEquation> others) {
    others_ = std::move(others);
    return *this;
  }

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override { return {polygon_.unit, greatest(polygon_)}; }
  drawings::Box extent(const Scale&, const Scale& vectors) const override { return extent_of(polygon_, vectors); }
  std::vector<Place> lettered() const override { return corners_of(polygon_); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<drawings::VectorEquation> equations() const override;
  std::vector<double> crossings() const override { return crossings_of(polygon_); }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  const Solution& solution_;
  VectorPolygon polygon_;
  Table table_;
  std::vector<drawings::VectorEquation> others_ = {};
};

}  // namespace epure
