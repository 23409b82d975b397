#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

// A circle larger than this many times the mechanism is shown as an arc that leaves the frame.
constexpr double whole_circle_limit = 3;

void include_circle(Extent& extent, const Scale& scale, const DrawnCycle& cycle, double size) {
  if (!cycle.centre || 2 * cycle.radius > whole_circle_limit * size) return;
  const auto& [x, y] = *cycle.centre;
  const double r = cycle.radius;
  extent.include(scale, {x - r, y - r}, 5);
  extent.include(scale, {x + r, y + r}, 5);
}

drawings::Box extent_of(const CouplerFigure& f, const Scale& scale) {
  Extent extent;
  for (const Place& P : f.mechanism->corners()) extent.include(scale, P, 7);
  const double size = f.mechanism->reach();
  include_circle(extent, scale, f.inflection, size);
  include_circle(extent, scale, f.stationarity, size);
  for (const auto& P : {f.P0, f.K}) {
    if (f.is_near(P, whole_circle_limit)) extent.include(scale, *P, 8);
  }
  return extent.box();
}

void draw_builder(Plot& plot, const CouplerFigure& f, const CircleBuilder& X) {
  plot.segment(X.from, *f.P0, Meaning::construction);
  plot.segment(X.from, X.at, Meaning::construction);
  const bool is_a_hinge = distance(X.from, X.at) * plot.scale().mm_per_unit < 0.5;
  if (is_a_hinge || X.label.empty()) return;
  plot.dot(X.at, Meaning::locus);
  plot.label(X.label, X.at, X.from, Meaning::locus);
}

void draw_inflection_circle(Plot& plot, const CouplerFigure& f) {
  plot.cycle(f.inflection, Meaning::locus, "inflection_circle");
  if (!f.P0 || !f.J) return;
  for (const CircleBuilder& X : f.builders) draw_builder(plot, f, X);
  plot.segment(*f.P0, *f.J, Meaning::axis);
  plot.cross(*f.J);
  plot.label("$J$", *f.J, f.P0, Meaning::locus);
  plot.cross(*f.inflection.centre);
  plot.label("$F$", *f.inflection.centre, f.P0, Meaning::locus);
  const Place O = f.mechanism->corners().front();
  plot.measures(f.prefix + "inflection_diameter", *f.P0, *f.J);
  plot.measures_coordinates(f.prefix + "inflection_pole", *f.J, O);
  plot.measures_coordinates(f.prefix + "inflection_centre", *f.inflection.centre, O);
  if (!f.builders.empty()) plot.step(1, f.builders.front().at);
  plot.step(2, *f.J);
}

void draw_stationarity_circle(Plot& plot, const CouplerFigure& f) {
  plot.cycle(f.stationarity, Meaning::second_locus, "stationarity_circle");
  if (!f.P0 || !f.stationarity.centre) return;
  const Place S = *f.stationarity.centre, opposite{2 * S.x - f.P0->x, 2 * S.y - f.P0->y};
  plot.segment(*f.P0, opposite, Meaning::axis);
  plot.cross(S, Meaning::second_locus);
  plot.label("$S$", S, f.P0, Meaning::second_locus);
  plot.cross(opposite, Meaning::second_locus);
  plot.label("$S'$", opposite, f.P0, Meaning::second_locus);
  plot.measures(f.prefix + "stationarity_diameter", *f.P0, opposite);
  plot.measures_coordinates(f.prefix + "stationarity_centre", S, f.mechanism->corners().front());
  if (f.J) {
    plot.right_angle(*f.P0, *f.J, opposite);
    plot.segment(*f.J, opposite, Meaning::construction);
  }
  plot.step(3, opposite);
}

void draw_poles_of_motion(Plot& plot, const CouplerFigure& f) {
  const Place O = f.mechanism->corners().front();
  if (f.P0) {
    plot.cross(*f.P0);
    plot.label(f.pole_label(), *f.P0, f.middle(), Meaning::locus);
    plot.measures_coordinates(f.prefix + f.pole, *f.P0, O);
  }
  if (f.K) {
    plot.cross(*f.K, Meaning::acceleration);
    plot.label("$K$", *f.K, f.middle(), Meaning::acceleration);
    plot.measures_coordinates(f.prefix + "K", *f.K, O);
    plot.step(4, *f.K);
  }
}

std::string left_out(const Plot& plot, const CouplerFigure& f, const drawings::Box& room, Language language) {
  OffSheet off(plot, room);
  for (const auto& [letters, P] :
       {std::pair{f.pole_label(), f.P0}, std::pair{std::string("$J$"), f.J}, std::pair{std::string("$K$"), f.K},
        std::pair{std::string("$F$"), f.inflection.centre}, std::pair{std::string("$S$"), f.stationarity.centre}})
    off.point(letters, P);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, f.inflection);
  off.circle({"part of the stationarity circle", "parte della circonferenza di stazionarietà"}, f.stationarity);
  return off.sentence(language);
}

drawings::Table coordinates(const CouplerFigure& f, Language language) {
  const auto num = [&](const std::optional<Place>& P, bool x) {
    return P ? figures(x ? P->x : P->y, 4, language) : std::string("∞");
  };
  drawings::Table table{{"", "$x$ (m)", "$y$ (m)"}, {}};
  for (const auto& [name, P] :
       {std::pair{f.pole_label(), f.P0}, std::pair{std::string("$J$"), f.J}, std::pair{std::string("$K$"), f.K},
        std::pair{std::string("$F$"), f.inflection.centre}, std::pair{std::string("$S$"), f.stationarity.centre}}) {
    table.rows.push_back({name, num(P, true), num(P, false)});
  }
  return table;
}

}  // namespace

void draw_circles_sheet(DrawnSheet& onto, const CouplerFigure& f, const SheetRequest& request,
                        const SheetWords& words) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const Fit fit = fit_lengths(room, request, 1000 / f.mechanism->reach(),
                              [&](const Scale& scale) { return extent_of(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_inflection_circle(plot, f);
  draw_stationarity_circle(plot, f);
  f.mechanism->sketch(plot);
  draw_poles_of_motion(plot, f);
  // A circle that is larger than the paper ends above the scale bars.
  onto.sheet.figure.windows = {room};
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  add_scale_bars(onto, {plot.scale()}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(words.steps);
  if (const std::string off = left_out(plot, f, room, language); !off.empty())
    column.push_back(drawings::Paragraph{off});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(coordinates(f, language));
  if (f.inflection.centre) {
    column.push_back(drawings::Paragraph{
        fmt::format("$δ_{{F}}$ = {} m", figures(2 * f.inflection.radius, 4, language)) +
        (f.stationarity.centre ? fmt::format(",  $δ_{{S}}$ = {} m", figures(2 * f.stationarity.radius, 4, language))
                               : "")});
  }
  std::vector<Value> values;
  for (const auto& [name, P] :
       {std::pair{f.pole, f.P0}, std::pair{std::string("J"), f.J}, std::pair{std::string("K"), f.K}}) {
    if (P)
      values.insert(values.end(), {{fmt::format("x_{}", name), P->x, "m"}, {fmt::format("y_{}", name), P->y, "m"}});
  }
  onto.sheet.description = in_words(words.description, values, language);
}

}  // namespace epure
