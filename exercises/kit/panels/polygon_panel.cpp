#include "exercises/kit/panels/polygon_panel.h"

namespace epure {
namespace {

VectorPolygon polygon(Meaning meaning, const std::string& letter, const std::string& unit,
                      std::vector<PolygonSide> left, std::vector<PolygonSide> right) {
  return {.meaning = meaning,
          .unit = unit,
          .origin = "$O_{" + letter + "}$",
          .left = std::move(left),
          .right = std::move(right)};
}

}  // namespace

PolygonSide side(const Solution& solution, const VectorQuantity& quantity, const std::string& direction,
                 const std::string& magnitude, const std::string& tip) {
  return {.quantity = quantity.name,
          .label = quantity.arrow(),
          .direction = direction,
          .magnitude = magnitude,
          .v = solution.vector(quantity.name),
          .tip = tip};
}

PolygonImage image(const Solution& solution, const VectorQuantity& absolute, const VectorQuantity& relative,
                   const std::string& tip, const Words& explained) {
  return {.absolute = side(solution, absolute, {}, {}, tip),
          .relative = side(solution, relative, {}, {}),
          .explained = explained};
}

VectorPolygon velocity_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right) {
  return polygon(Meaning::velocity, "v", "m/s", std::move(left), std::move(right));
}
VectorPolygon acceleration_polygon(std::vector<PolygonSide> left, std::vector<PolygonSide> right) {
  return polygon(Meaning::acceleration, "a", "m/s²", std::move(left), std::move(right));
}

// A vector that starts at the origin shows its components too, where these are reported.
std::vector<drawings::Block> PolygonPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  PolygonStage whole;
  whole.numbered = false;
  draw_polygon(plot, polygon_, whole);
  for (const auto* chain : {&polygon_.left, &polygon_.right}) {
    const PolygonSide& first = chain->front();
    if (solution_.is_reported(first.quantity + "_x"))
      plot.measures_coordinates(first.quantity, {first.v.x, first.v.y}, {0, 0});
  }
  for (const PolygonImage& image : polygon_.images)
    if (solution_.is_reported(image.absolute.quantity + "_x"))
      plot.measures_coordinates(image.absolute.quantity, {image.absolute.v.x, image.absolute.v.y}, {0, 0});
  return {};
}

std::vector<drawings::VectorEquation> PolygonPanel::equations() const {
  std::vector<drawings::VectorEquation> all{equation(polygon_)};
  all.insert(all.end(), others_.begin(), others_.end());
  return all;
}

std::vector<PanelStep> PolygonPanel::steps(const Plot&, const drawings::Box&) const {
  const std::vector<std::string> english = steps_of(polygon_, Language::english),
                                 italian = steps_of(polygon_, Language::italian);
  const std::vector<Place> places = places_of_steps(polygon_);
  std::vector<PanelStep> steps;
  for (std::size_t i = 0; i < english.size(); ++i) steps.push_back({{english[i], italian[i]}, places[i]});
  return steps;
}

std::optional<MeasuredTable> PolygonPanel::measured(const Readings& readings) const {
  if (table_ == Table::none) return {};
  return MeasuredTable{{}, measured_rows(readings, polygon_), {"exact", "esatto"}, {"on the sheet", "sul foglio"}};
}

}  // namespace epure
