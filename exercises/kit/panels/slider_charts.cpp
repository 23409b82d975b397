#include "exercises/kit/panels/slider_charts.h"

#include <cmath>

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure {
namespace {

using Slider = geometry::FlatSlider<double>;

// Beside n = 1 doubles lose what the curve is made of: it begins a little beyond.
constexpr double nearest_to_parallel = 1.02;
// Where n reaches farther, its axis is logarithmic: nothing of A would be seen.
constexpr double farthest_linear = 25;
constexpr ChartSize one_of_four_in_a_column{110, 34};

struct Coefficient {
  const char *symbol, *name;
  double (Slider::*value)() const;
  double SliderPoint::*of_point;
  double low, high;
};

drawings::Curve curve_of(const Coefficient& what, double from, double to) {
  auto runs = run_of(std::log(from), std::log(to), [&](double log) { return (Slider{std::exp(log)}.*what.value)(); });
  for (drawings::Datum& each : runs.front()) each.x = std::exp(each.x);
  return {.name = what.name, .runs = runs, .meaning = Meaning::locus};
}
drawings::Curve rings_of(const Coefficient& what, const std::vector<SliderPoint>& table) {
  std::vector<drawings::Datum> points;
  for (const SliderPoint& point : table) points.push_back({point.n, point.*what.of_point});
  return {.name = std::string(what.name) + "_table",
          .meaning = Meaning::construction,
          .points = points,
          .shape = drawings::PointShape::ring};
}

drawings::Chart chart_of(const Coefficient& what, const SliderCharts& of, Language language) {
  drawings::Chart chart;
  chart.x = {.quantity = "$n$", .unit = "", .low = 1, .high = of.up_to, .to_ticks = false};
  if (of.up_to > farthest_linear) chart.x.scale = drawings::AxisScale::logarithmic;
  chart.y = {.quantity = what.symbol, .unit = "", .low = what.low, .high = what.high};
  chart.letters_left = 14;
  chart.curves = {curve_of(what, nearest_to_parallel, of.up_to)};
  if (!of.table.empty()) chart.curves.push_back(rings_of(what, of.table));
  const double found = of.found.*what.of_point;
  chart.markers = {{.at = {of.found.n, found},
                    .label = std::string(what.symbol) + " = " + figures(found, 4, language),
                    .meaning = Meaning::force}};
  chart.verticals = {{.at = of.found.n, .label = "$n$ = " + figures(of.found.n, 4, language)}};
  chart.horizontals = {{.at = found}};
  return chart;
}

// n counts from the axis' zero, beyond the frame: a ruler reads how far the point lies from a number of the axis. On
// a logarithmic one it reads no more than the number's powers.
ChartPanel::Read read_of_ratio(const SliderCharts& of, double n, const std::string& quantity) {
  return {{n, of.found.centre}, of.up_to > farthest_linear ? std::string{} : quantity, {}};
}

// The chord between the two rows beside the curve, large enough to tell where each of them has the centre sought.
SizedChart detail(const Coefficient& centre, const SliderCharts& of, const SliderChord& chord, Language language) {
  const double low = std::min(chord.before.n, of.found.n), high = std::max(chord.after.n, of.found.n),
               margin = 0.2 * (high - low);
  const double from = std::max(low - margin, nearest_to_parallel), to = high + margin;
  const double lowest = std::min(Slider{from}.centre(), chord.before.centre),
               highest = std::max(Slider{to}.centre(), chord.after.centre);
  drawings::Chart chart;
  chart.x = {.quantity = "$n$", .unit = "", .low = from, .high = to, .to_ticks = false};
  chart.y = {.quantity = centre.symbol, .unit = "", .low = lowest, .high = highest};
  chart.letters_left = 14;
  chart.curves = {curve_of(centre, from, to),
                  rings_of(centre, {chord.before, chord.after}),
                  {.name = "chord",
                   .runs = {{{chord.before.n, chord.before.centre}, {chord.after.n, chord.after.centre}}},
                   .meaning = Meaning::construction,
                   .line = drawings::LineType::continuous}};
  chart.curves[0].name += "_detail";
  chart.curves[1].name += "_detail";
  chart.markers = {{.at = {of.found.n, of.found.centre}, .meaning = Meaning::force},
                   {.at = {chord.n, of.found.centre}, .meaning = Meaning::construction}};
  chart.verticals = {
      {.at = of.found.n, .label = "$n$ = " + figures(of.found.n, 4, language), .meaning = Meaning::force},
      {.at = chord.n,
       .label = chord.letters + " = " + figures(chord.n, 4, language),
       .meaning = Meaning::construction}};
  chart.horizontals = {{.at = of.found.centre}};
  return SizedChart(chart,
                    {read_of_ratio(of, of.found.n, of.ratio_quantity), read_of_ratio(of, chord.n, chord.quantity)},
                    one_of_four_in_a_column);
}

}  // namespace

Panels slider_charts(const SliderCharts& of, Language language) {
  const double most_centre = std::max(Slider{of.up_to}.centre(), of.found.centre);
  const double most_friction = 1.6 * std::max(of.found.friction < 4 ? of.found.friction : 2.5, 1.8);
  const Coefficient centre{"$x_{N}$/$l$", "centre", &Slider::centre, &SliderPoint::centre, 0.5, most_centre + 0.02},
      load{"$\\it{A}$", "load", &Slider::load, &SliderPoint::load, 0, 0.18},
      friction{"$k$",
               "friction",
               &Slider::friction,
               &SliderPoint::friction,
               0,
               std::max(most_friction, Slider{of.up_to}.friction())};
  const ChartSize size = of.chord ? one_of_four_in_a_column : one_of_three_in_a_column;
  const auto chart = [&](const Coefficient& what, const ChartPanel::Read& read) {
    return SizedChart(chart_of(what, of, language), {read}, size);
  };
  const auto along_y = [&](const Coefficient& what, const std::string& quantity) {
    return ChartPanel::Read{{of.found.n, of.found.*what.of_point}, {}, quantity};
  };
  Panels all = panels(chart(centre, read_of_ratio(of, of.found.n, of.ratio_quantity)));
  if (of.chord) all.push_back(std::make_unique<SizedChart>(detail(centre, of, *of.chord, language)));
  all.push_back(std::make_unique<SizedChart>(chart(load, along_y(load, of.load_quantity))));
  all.push_back(std::make_unique<SizedChart>(chart(friction, along_y(friction, of.friction_quantity))));
  return all;
}

std::vector<std::string> slider_formulas() {
  return {
      "$x_{N}$/$l$ = [1 + 4 $n$ − 5 $n^{2}$ + 2 $n$ ($n$ + 2) ln\u00a0$n$] / [2 ($n^{2}$ − 1) ln\u00a0$n$ − 4 ($n$ − "
      "1)$^{2}$]",
      "$\\it{A}$ = 6 [($n$ + 1) ln\u00a0$n$ − 2 ($n$ − 1)] / [($n$ + 1) ($n$ − 1)$^{2}$]",
      "$k$ = 2 [2 ($n$ + 1) ln\u00a0$n$ − 3 ($n$ − 1)] / [($n^{2}$ − 1) √$\\it{A}$]"};
}

}  // namespace epure
