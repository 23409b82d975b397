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
          .tip = tip,
          .length = solution.has(quantity.name) ? solution.value(quantity.name) : std::nullopt};
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

VectorPolygon force_polygon(const std::string& letter, std::vector<PolygonSide> left,
                            std::vector<PolygonSide> right) {
  VectorPolygon forces = polygon(Meaning::force, letter, "N", std::move(left), std::move(right));
  forces.loop = true;
  return forces;
}

PolygonSide reaction(const PolygonSide& action, const std::string& label, const std::string& magnitude) {
  return {
      .label = label, .direction = action.direction, .magnitude = magnitude, .v = -action.v, .length = action.length};
}

// A vector that starts at the origin, or in a loop ends there, shows its components too, where these are reported.
std::vector<drawings::Block> PolygonPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  PolygonStage whole;
  whole.numbered = false;
  whole.language = language;
  draw_polygon(plot, polygon_, whole);
  for (const auto* chain : {&polygon_.left, &polygon_.right}) {
    const PolygonSide& first = chain->front();
    if (!solution_.is_reported(first.quantity + "_x") || !solution_.is_reported(first.quantity + "_y")) continue;
    const bool ends_there = polygon_.loop && chain == &polygon_.left;
    const Place from = ends_there ? Place{-first.v.x, -first.v.y} : Place{0, 0};
    plot.measures_coordinates(first.quantity, from + first.v, from);
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

std::vector<PanelStep> PolygonPanel::steps(const Plot& plot, const drawings::Box&) const {
  const std::vector<std::string> english = steps_of(polygon_, Language::english),
                                 italian = steps_of(polygon_, Language::italian);
  const std::vector<Place> places = places_of_steps(polygon_, plot.scale());
  std::vector<PanelStep> steps;
  for (std::size_t i = 0; i < english.size(); ++i) steps.push_back({{english[i], italian[i]}, places[i]});
  return steps;
}

std::optional<MeasuredTable> PolygonPanel::measured(const Readings& readings) const {
  if (table_ == Table::none) return {};
  return MeasuredTable{{}, measured_rows(readings, polygon_), {"exact", "esatto"}, {"on the sheet", "sul foglio"}};
}

}  // namespace epure
