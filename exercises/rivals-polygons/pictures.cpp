#include "exercises/rivals-polygons/pictures.h"

#include <cassert>

#include "drawings/text/text.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::rivals_polygons {
namespace {

constexpr double caption_height = 6.6, caption_size = 2.7;  // mm

Words known(const PolygonSide& side) { return {side.label + " known", side.label + " nota"}; }

Words directions(const VectorPolygon& polygon) {
  const PolygonSide &closing = polygon.right.back(), &sought = polygon.left.back();
  if (sought.closes_alone()) return {"direction of " + sought.label, "direzione di " + sought.label};
  return format_words("directions of {} and {}", "direzioni di {} e {}", closing.label, sought.label);
}

}  // namespace

drawings::Box PicturePanel::extent(const Scale&, const Scale& vectors) const {
  constexpr double air = 2;  // mm
  drawings::Box box = extent_of(polygon_, vectors);
  box.high.y += caption_height;
  for (const Language language : {Language::english, Language::italian})
    box.high.x = std::max(box.high.x, box.low.x + drawings::measure(caption_.in(language), caption_size).width + air);
  return box;
}

std::vector<drawings::Block> PicturePanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  PolygonStage stage = stage_;
  stage.numbered = false;  // the sheet numbers its steps
  stage.language = language;
  draw_polygon(plot, polygon_, stage);
  const drawings::Box box = extent(plot.scale(), plot.vector_scale());
  const drawings::Point O = plot.at({0, 0});
  plot.mark(drawings::Writing{.text = caption_.in(language),
                              .baseline = {O.x + box.low.x, O.y + box.high.y - caption_height + 2.6},
                              .size = caption_size});
  return {};
}

std::vector<drawings::VectorEquation> PicturePanel::equations() const {
  if (!is_last()) return {};
  return {equation(polygon_)};
}

std::vector<PanelStep> PicturePanel::steps(const Plot& plot, const drawings::Box&) const {
  const auto english = steps_of(polygon_, Language::english), italian = steps_of(polygon_, Language::italian);
  const std::vector<Place> places = places_of_steps(polygon_, plot.scale());
  std::vector<PanelStep> steps;
  for (int i = stage_.first_numbered - 1; i < stage_.steps && stage_.numbered; ++i) {
    const auto at = static_cast<std::size_t>(i);
    steps.push_back({{english[at], italian[at]}, places[at]});
  }
  return steps;
}

std::optional<MeasuredTable> PicturePanel::measured(const Readings& readings) const {
  if (!is_last()) return {};
  return MeasuredTable{{}, measured_rows(readings, polygon_), {"exact", "esatto"}, {"on the sheet", "sul foglio"}};
}

void add_pictures(Panels& panels, const VectorPolygon& polygon, const std::vector<int>& figures) {
  std::vector<std::pair<PolygonStage, Words>> pictures;
  int step = 0;
  for (const PolygonSide& side : polygon.right) {
    if (!side.is_drawn()) continue;
    if (side.is_unknown()) break;
    ++step;
    pictures.push_back({{.steps = step, .first_numbered = step}, known(side)});
  }
  const int last = steps_of_sides(polygon);
  pictures.push_back({{.steps = last, .first_numbered = step + 1, .closed = false}, directions(polygon)});
  pictures.push_back({{.steps = last, .numbered = false}, {"the polygon, closed", "il poligono chiuso"}});
  assert(figures.size() <= pictures.size());
  const std::size_t without = pictures.size() - figures.size();
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    auto& [stage, caption] = pictures[i];
    if (i >= without)
      caption = caption + format_words(" (source, fig. {})", " (fonte, fig. {})", figures[i - without]);
    const std::string letter(1, static_cast<char>('a' + i));
    panels.push_back(std::make_unique<PicturePanel>(polygon, stage, letter + ")  " + caption));
  }
}

}  // namespace epure::rivals_polygons
