#include "exercises/kit/panels/slider_charts.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure {
namespace {

using Slider = geometry::FlatSlider<double>;

// Beside n = 1 doubles lose what the curve is made of: it begins a little beyond.
constexpr double nearest_to_parallel = 1.02;

struct Coefficient {
  const char *symbol, *name;
  double (Slider::*value)() const;
  double SliderPoint::*of_point;
  double low, high;
};

drawings::Chart chart_of(const Coefficient& what, const SliderCharts& of, Language language) {
  drawings::Chart chart;
  chart.x = {.quantity = "$n$", .unit = "", .low = 1, .high = of.up_to, .to_ticks = false};
  chart.y = {.quantity = what.symbol, .unit = "", .low = what.low, .high = what.high};
  chart.letters_left = 14;
  chart.curves = {{.name = what.name,
                   .runs = run_of(nearest_to_parallel, of.up_to, [&](double n) { return (Slider{n}.*what.value)(); }),
                   .meaning = Meaning::locus}};
  if (!of.table.empty()) {
    std::vector<drawings::Datum> points;
    for (const SliderPoint& point : of.table) points.push_back({point.n, point.*what.of_point});
    chart.curves.push_back({.name = std::string(what.name) + "_table",
                            .meaning = Meaning::construction,
                            .points = points,
                            .shape = drawings::PointShape::ring});
  }
  const double found = of.found.*what.of_point;
  chart.markers = {{.at = {of.found.n, found},
                    .label = std::string(what.symbol) + " = " + figures(found, 4, language),
                    .meaning = Meaning::force}};
  chart.verticals = {{.at = of.found.n, .label = "$n$ = " + figures(of.found.n, 4, language)}};
  chart.horizontals = {{.at = found}};
  return chart;
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
  const auto chart = [&](const Coefficient& what, const std::string& quantity) {
    std::vector<ChartPanel::Read> read;
    if (!quantity.empty()) read.push_back({{of.found.n, of.found.*what.of_point}, {}, quantity});
    return SizedChart(chart_of(what, of, language), read, one_of_three_in_a_column);
  };
  return panels(chart(centre, {}), chart(load, of.load_quantity), chart(friction, of.friction_quantity));
}

}  // namespace epure
