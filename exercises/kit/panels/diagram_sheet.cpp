#include "exercises/kit/panels/diagram_sheet.h"

#include <numeric>

namespace epure {
namespace {

constexpr double mechanism_share = 0.42;  // of the room; the polygons need the larger part

double width(const drawings::Box& box) { return box.width(); }
double height(const drawings::Box& box) { return box.height(); }

// In parts as large as the polygons are wide (or high) when their longest vectors are drawn alike.
std::vector<double> parts(const std::vector<VectorPolygon>& polygons, double (*size)(const drawings::Box&)) {
  constexpr double longest = 60;  // mm
  std::vector<double> sizes;
  for (const VectorPolygon& polygon : polygons) {
    const double vector = greatest(polygon);
    sizes.push_back(size(extent_of(polygon, {vector > 0 ? longest / vector : 1, "", ""})));
  }
  const double all = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  for (double& part : sizes) part /= all;
  return sizes;
}

// Where everything stands.
struct Layout {
  drawings::Box mechanism;
  std::vector<drawings::Box> polygons;
};

Layout mechanism_above(const std::vector<VectorPolygon>& polygons, const drawings::Box& room) {
  const double divide = room.high.y - mechanism_share * room.height();
  Layout layout{{{room.low.x, divide}, room.high}, {}};
  double x = room.low.x;
  for (const double part : parts(polygons, width)) {
    const double next = x + part * room.width();
    layout.polygons.push_back({{x, room.low.y}, {next, divide}});
    x = next;
  }
  return layout;
}

Layout mechanism_beside(const std::vector<VectorPolygon>& polygons, const drawings::Box& room) {
  const double divide = room.low.x + mechanism_share * room.width();
  Layout layout{{room.low, {divide, room.high.y}}, {}};
  double y = room.high.y;
  for (const double part : parts(polygons, height)) {
    const double next = y - part * room.height();
    layout.polygons.push_back({{divide, next}, {room.high.x, y}});
    y = next;
  }
  return layout;
}

struct Fits {
  Fit mechanism;
  std::vector<Fit> polygons;
  // Of all pictures together: twice the scale of one outweighs half that of another.
  double size() const {
    double product = mechanism.scale.mm_per_unit;
    for (const Fit& polygon : polygons) product *= polygon.scale.mm_per_unit;
    return product;
  }
};

Fits fitted(const DiagramSheet& shown, const Layout& layout, const SheetRequest& request) {
  Fits fits{fit_mechanism(shown.mechanism, layout.mechanism, request), {}};
  for (std::size_t i = 0; i < layout.polygons.size(); ++i) {
    fits.polygons.push_back(fit_polygon(shown.polygons[i], layout.polygons[i], request.language));
  }
  return fits;
}

Fits best_fits(const DiagramSheet& shown, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  SheetRequest any_scale = request;
  any_scale.scale.reset();
  const Layout above = mechanism_above(shown.polygons, room), beside = mechanism_beside(shown.polygons, room);
  const bool is_better_beside = fitted(shown, beside, any_scale).size() >= fitted(shown, above, any_scale).size();
  return fitted(shown, is_better_beside ? beside : above, request);
}

void fill_column(DrawnSheet& onto, const DiagramSheet& shown, Language language) {
  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  for (const VectorPolygon& polygon : shown.polygons) column.push_back(equation(polygon));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  drawings::Steps steps;
  for (const VectorPolygon& polygon : shown.polygons) {
    for (const std::string& line : steps_of(polygon, language)) steps.lines.push_back(line);
  }
  column.push_back(steps);
  if (shown.results.empty() && !shown.table) return;
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  for (const std::string& line : shown.results) column.push_back(drawings::Paragraph{line});
  if (shown.table) column.push_back(*shown.table);
}

}  // namespace

std::vector<Plot> draw_diagram_sheet(DrawnSheet& onto, const DiagramSheet& shown, const SheetRequest& request) {
  const Language language = request.language;
  const Fits fits = best_fits(shown, request);
  Plot mechanism(onto, fits.mechanism.origin, fits.mechanism.scale);
  shown.mechanism.draw(mechanism);
  std::vector<Scale> scales{fits.mechanism.scale};
  std::vector<Plot> plots;
  PolygonStage stage;
  for (std::size_t i = 0; i < fits.polygons.size(); ++i) {
    const VectorPolygon& polygon = shown.polygons[i];
    plots.emplace_back(onto, fits.polygons[i].origin, fits.polygons[i].scale);
    draw_polygon(plots.back(), polygon, stage);
    stage.numbers_after += static_cast<int>(steps_of(polygon, language).size());
    scales.push_back(fits.polygons[i].scale);
  }
  add_scale_bars(onto, scales, request);
  fill_column(onto, shown, language);
  onto.sheet.description = in_words(shown.description, shown.values, language);
  return plots;
}

}  // namespace epure
