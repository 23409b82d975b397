#include "exercises/kit/panels/film_chart.h"

#include <fmt/format.h>

#include <cmath>

namespace epure {
namespace {

constexpr double micrometres = 1e6;  // of a metre

drawings::Chart chart_of(const geometry::FilmWedge<double>& film, double letters_left) {
  drawings::Chart chart;
  chart.x = {.quantity = "$x$", .unit = "m", .low = 0, .high = film.l, .to_ticks = false};
  chart.y = {.quantity = "$h$", .unit = "µm", .low = 0, .high = 1.06 * micrometres * film.h1};
  chart.letters_left = letters_left;
  chart.curves = {{.name = "h",
                   .runs = run_of(0, film.l, [&](double x) { return micrometres * film.h(x); }),
                   .meaning = Meaning::link}};
  chart.horizontals = {{.at = 0}, {.at = micrometres * film.h_bar(), .label = "$h^{*}$"}};
  chart.verticals = {{.at = film.x_bar(), .label = "$x^{*}$"}};
  return chart;
}

std::vector<ChartPanel::Read> read_of(const geometry::FilmWedge<double>& film, const FilmQuantities& quantities) {
  const auto at = [&](double x, const std::string& along_x, const std::string& along_y) {
    return ChartPanel::Read{{x, micrometres * film.h(x)}, along_x, along_y, 1, 1 / micrometres};
  };
  return {at(0, {}, quantities.inlet), at(film.l, {}, quantities.outlet),
          at(film.x_bar(), quantities.x_bar, quantities.h_bar)};
}

}  // namespace

FilmChart::FilmChart(const geometry::FilmWedge<double>& film, const FilmQuantities& quantities, double letters_left)
    : SizedChart(chart_of(film, letters_left), read_of(film, quantities), one_of_three_in_a_column) {}

std::string FilmChart::told_of(const drawings::ChartMap& map, Language language) const {
  const double times = map.x.per_mm() * micrometres / map.y.per_mm();
  const double digit = std::pow(10, std::floor(std::log10(times)) - 1);  // of two that are told
  return format_words("The film is drawn about {} times higher than long.",
                      "Il meato è disegnato circa {} volte più alto che lungo.",
                      fmt::format("{:.0f}", std::round(times / digit) * digit))
      .in(language);
}

}  // namespace epure
