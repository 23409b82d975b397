#include "exercises/kit/panels/moving_mechanism.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "exercises/kit/panels/panels_of.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

bool is_one_place(drawings::Point a, drawings::Point b) { return a.x == b.x && a.y == b.y; }

const drawings::Arrow* vector_in(const drawings::Mark& mark, const std::set<std::string>& quantities) {
  const auto* arrow = std::get_if<drawings::Arrow>(&mark);
  return arrow && quantities.contains(arrow->name) ? arrow : nullptr;
}

// Where the sheet shows the coordinates of points asked for.
std::vector<drawings::Point> points_in(const DrawnSheet& drawn, const std::set<std::string>& quantities) {
  std::vector<drawings::Point> points;
  for (const Measurement& each : drawn.measurements)
    if (each.kind != Measurement::length && quantities.contains(each.quantity)) points.push_back(each.to);
  return points;
}

// The place of a mark that stands for a point.
struct PlaceOfPoint {
  std::optional<drawings::Point> operator()(const drawings::Dot& dot) const { return dot.at; }
  std::optional<drawings::Point> operator()(const drawings::Cross& cross) const { return cross.at; }
  template <class Other>
  std::optional<drawings::Point> operator()(const Other&) const {
    return {};
  }
};

// In which whatever it is lies on the paper: a metre, and a unit of vectors, is a millimetre.
MovingMechanism::View small_view() {
  const drawings::Box area = drawings::drawing_area(drawings::Paper::a4);
  const Scale scale = length_scale(Rational(1) / 1000);
  return {
      .origin = {(area.low.x + area.high.x) / 2, (area.low.y + area.high.y) / 2}, .lengths = scale, .vectors = scale};
}

Plot plot_of_view(DrawnSheet& onto, const MovingMechanism::View& view) {
  Plot plot(onto, view.origin, view.lengths);
  plot.vectors_at(view.vectors);
  plot.keep_within(view.room);
  return plot;
}

}  // namespace

std::optional<MovingMechanism> MovingMechanism::of(const Exercise& exercise, const std::string& sheet,
                                                   const Solution& solution, Language language) {
  auto panels = panel_sheet(exercise, sheet, solution, language);
  if (!panels) return {};
  const auto found = std::find_if(panels->panels.begin(), panels->panels.end(),
                                  [](const auto& each) { return !each->is_of_vectors() && each->has_scale(); });
  if (found == panels->panels.end()) return {};
  const SheetRequest bare{.language = language, .bare = true};
  (*found)->choose_view(figure_area(bare), bare);
  const auto place = static_cast<std::size_t>(found - panels->panels.begin());
  MovingMechanism mechanism(std::move(*panels), place, language);
  if (mechanism.drawn(small_view(), {}).marks.empty()) return {};
  return mechanism;
}

DrawnSheet MovingMechanism::solved(const View& view) const {
  DrawnSheet sheet;
  Plot plot = plot_of_view(sheet, view);
  panel().draw(plot, view.room, language_);
  return sheet;
}

drawings::Figure MovingMechanism::drawn(const View& view, const std::set<std::string>& quantities) const {
  DrawnSheet given;
  Plot plot = plot_of_view(given, view);
  panel().draw_given(plot, view.room, language_);
  drawings::Figure figure = std::move(given.sheet.figure);
  if (!quantities.empty()) add(quantities, view, figure);
  figure.windows = {view.room};
  figure.window_of.assign(figure.marks.size(), 0);
  return figure;
}

void MovingMechanism::add(const std::set<std::string>& quantities, const View& view, drawings::Figure& figure) const {
  const DrawnSheet solved = this->solved(view);
  const std::vector<drawings::Point> points = points_in(solved, quantities);
  const auto is_point = [&](drawings::Point p) {
    return std::any_of(points.begin(), points.end(), [&](drawings::Point each) { return is_one_place(each, p); });
  };
  const auto add_letters = [&](const drawings::Label& label) {
    const bool is_there = std::any_of(figure.labels.begin(), figure.labels.end(), [&](const drawings::Label& each) {
      return each.text == label.text && is_one_place(each.at, label.at);
    });
    if (!is_there) figure.labels.push_back(label);
  };
  for (const drawings::Mark& mark : solved.sheet.figure.marks) {
    if (const auto* arrow = vector_in(mark, quantities)) {
      figure.marks.push_back(*arrow);
      for (const drawings::Label& label : solved.sheet.figure.labels)
        if (label.to && is_one_place(label.at, arrow->from) && is_one_place(*label.to, arrow->to)) add_letters(label);
    } else if (const auto at = std::visit(PlaceOfPoint(), mark); at && is_point(*at)) {
      figure.marks.push_back(mark);
    }
  }
  for (const drawings::Label& label : solved.sheet.figure.labels)
    if (!label.to && is_point(label.at)) add_letters(label);
}

drawings::Box MovingMechanism::extent(const Scale& lengths, const Scale& vectors,
                                      const std::set<std::string>& quantities) const {
  constexpr double letters_around = 8;  // mm around a vector's tip
  Scale no_vectors;
  no_vectors.mm_per_unit = 0;
  const drawings::Box alone = panel().extent_of_near(lengths, no_vectors);
  Extent all;
  all.include(alone.low.x, alone.low.y);
  all.include(alone.high.x, alone.high.y);
  const View view{.origin = {}, .lengths = lengths, .vectors = vectors};
  for (const drawings::Mark& mark : solved(view).sheet.figure.marks)
    if (const auto* arrow = vector_in(mark, quantities)) {
      all.include(arrow->to.x - letters_around, arrow->to.y - letters_around);
      all.include(arrow->to.x + letters_around, arrow->to.y + letters_around);
    }
  return all.box();
}

MovingMechanism::Shown MovingMechanism::shown(const std::set<std::string>& quantities) const {
  Shown shown{.unit = panel().vectors().unit};
  const View view = small_view();
  const DrawnSheet sheet = solved(view);
  for (const drawings::Mark& mark : sheet.sheet.figure.marks)
    if (const auto* arrow = vector_in(mark, quantities)) {
      ++shown.count;
      const double length = std::hypot(arrow->to.x - arrow->from.x, arrow->to.y - arrow->from.y);
      shown.longest = std::max(shown.longest, length / view.vectors.mm_per_unit);
    }
  shown.count += points_in(sheet, quantities).size();
  return shown;
}

}  // namespace epure
