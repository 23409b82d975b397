#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

// K is drawn when it lies no farther away than the figure can bear.
bool shows_K(const CouplerFigure& f) { return f.is_near(f.K, 4); }

drawings::Box extent_of(const CouplerFigure& f, const Scale& lengths, const Scale& accelerations) {
  Extent extent;
  f.mechanism->include(extent, lengths);
  if (shows_K(f)) extent.include(lengths, *f.K, 10);
  for (const CouplerPoint& X : f.points) {
    const double x = lengths.mm_per_unit * X.at.x + accelerations.mm_per_unit * X.a.x;
    const double y = lengths.mm_per_unit * X.at.y + accelerations.mm_per_unit * X.a.y;
    extent.include(x - 7, y - 7);
    extent.include(x + 7, y + 7);
  }
  return extent.box();
}

void draw_rays(Plot& plot, const CouplerFigure& f) {
  for (const CouplerPoint& X : f.points) {
    plot.segment(*f.K, X.at, Meaning::construction);
    plot.measures(f.prefix + "K" + X.letter, *f.K, X.at);
  }
  plot.cross(*f.K, Meaning::acceleration);
  plot.label("$K$", *f.K, f.middle(), Meaning::acceleration);
  plot.measures_coordinates(f.prefix + "K", *f.K, f.mechanism->corners().front());
}

// γ at X: from the ray XK to the acceleration.
void mark_gamma(Plot& plot, const CouplerFigure& f, const CouplerPoint& X) {
  const drawings::Point c = plot.at(X.at), k = plot.at(*f.K), tip = plot.at(plot.tip(X.at, X.a));
  const double ray = std::atan2(k.y - c.y, k.x - c.x), vector = std::atan2(tip.y - c.y, tip.x - c.x);
  const double turn = std::remainder(vector - ray, 2 * M_PI);
  constexpr double radius = 13, shortest_arc = 2;      // mm
  if (std::abs(turn) * radius < shortest_arc) return;  // no arc to see: γ = 0 where α₃ = 0
  plot.mark(
      drawings::AngleMark{c, radius, turn > 0 ? ray : ray + turn, turn > 0 ? ray + turn : ray, Meaning::dimension});
  const double middle = ray + turn / 2;
  plot.label("$γ$", plot.from_paper({c.x + radius * std::cos(middle), c.y + radius * std::sin(middle)}), X.at);
}

drawings::Table distances_from_K(const CouplerFigure& f, Language language) {
  drawings::Table table{{"$X$", "$KX$ (m)", "$a_{X}$ (m/s²)"}, {}};
  for (const CouplerPoint& X : f.points) {
    table.rows.push_back({"$" + X.written() + "$", f.K ? figures(distance(*f.K, X.at), 4, language) : "∞",
                          figures(magnitude(X.a), 4, language)});
  }
  return table;
}

// By poles from the rays measured here; by the polar diagram as measured there.
std::vector<Comparison> comparisons(const DrawnSheet& here, const CouplerFigure& f, const SheetRequest& request,
                                    const std::function<void(DrawnSheet&, const SheetRequest&)>& compared) {
  if (!compared || f.points.empty()) return {};
  DrawnSheet other;
  other.sheet.paper = request.paper;
  SheetRequest own_scale = request;
  own_scale.scale.reset();
  compared(other, own_scale);
  const Readings poles(here), diagram(other);
  const CouplerPoint& driven = f.points.front();
  const std::string unit = f.prefix + "K" + driven.letter;
  std::vector<Comparison> rows;
  if (!poles.is_unit(unit)) return rows;
  for (const CouplerPoint& X : f.points) {
    const std::string drawn_there = f.prefix + "a_" + X.letter, ray = f.prefix + "K" + X.letter;
    if (&X == &driven || !diagram.has(drawn_there) || !poles.has(ray)) continue;
    rows.push_back({fmt::format("$a_{{{}}}$ (m/s²)", X.letter), poles[ray] / poles[unit] * magnitude(driven.a),
                    diagram[drawn_there]});
  }
  return rows;
}

}  // namespace

void draw_acceleration_pole_sheet(DrawnSheet& onto, const CouplerFigure& f, const SheetRequest& request,
                                  const SheetWords& words,
                                  const std::function<void(DrawnSheet&, const SheetRequest&)>& compared) {
  constexpr double longest_vector = 45;  // mm
  const Language language = request.language;
  const bool english = language == Language::english;
  const double greatest = f.greatest_acceleration();  // 0 when nothing is accelerated: then any scale will do
  const Scale accelerations = largest_vector_scale(longest_vector / (greatest > 0 ? greatest : 1), "m/s²", language);
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / f.mechanism->reach(),
                              [&](const Scale& lengths) { return extent_of(f, lengths, accelerations); });
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(accelerations);
  if (shows_K(f)) draw_rays(plot, f);
  f.mechanism->draw(plot);
  for (const CouplerPoint& X : f.points) {
    plot.vector_on(f.prefix + "a_" + X.letter, X.at, X.a, Meaning::acceleration,
                   fmt::format("$\\vec{{a}}_{{{}}}$", X.letter));
  }
  if (shows_K(f) && !f.points.empty()) {
    const CouplerPoint &driven = f.points.front(), &last = f.points.back();
    mark_gamma(plot, f, last);
    plot.step(1, *f.K);
    plot.step(2, {(f.K->x + driven.at.x) / 2, (f.K->y + driven.at.y) / 2});
    plot.step(3, plot.tip(last.at, last.a));
    plot.step(4, last.at);
  }
  add_scale_bars(onto, {plot.scale(), accelerations}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(words.steps);
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(distances_from_K(f, language));
  if (const auto rows = comparisons(onto, f, request, compared); !rows.empty()) {
    column.push_back(drawings::Heading{english ? "The two methods, as measured" : "I due metodi, come misurati"});
    column.push_back(comparison_table(rows, {"poles", "poli"}, {"diagram", "diagramma"}, language));
  }
  std::vector<Value> values;
  for (const CouplerPoint& X : f.points) values.push_back({"a_" + X.letter, magnitude(X.a), "m/s²"});
  onto.sheet.description = in_words(words.description, values, language);
}

}  // namespace epure
