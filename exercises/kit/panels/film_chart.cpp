#include "exercises/kit/panels/film_chart.h"

#include <cmath>

#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double micrometres = 1e6;               // of a metre
constexpr double runner = 0.16, above_pad = 0.2;  // of h1: how much of the chart is below zero, and above the pad

drawings::Chart chart_of(const geometry::FilmWedge<double>& film, const FilmShown& shown) {
  const double h1 = micrometres * film.h1, h2 = micrometres * film.h2;
  drawings::Chart chart;
  chart.x = {.quantity = "$x$", .unit = "m", .low = 0, .high = film.l, .to_ticks = false};
  chart.y = {.quantity = "$h$", .unit = "µm", .low = -runner * h1, .high = (1 + above_pad) * h1, .to_ticks = false};
  chart.letters_left = shown.letters_left;
  chart.areas = {{{{0, 0}, {film.l, 0}, {film.l, h2}, {0, h1}}, Meaning::velocity},
                 {{{0, 0}, {film.l, 0}, {film.l, -runner * h1}, {0, -runner * h1}}, Meaning::plate}};
  chart.curves = {{.name = "h", .runs = {{{0, h1}, {film.l, h2}}}, .meaning = Meaning::link},
                  {.name = "runner",
                   .runs = {{{0, 0}, {film.l, 0}}},
                   .meaning = Meaning::link,
                   .line = drawings::LineType::continuous}};
  chart.horizontals = {{.at = micrometres * film.h_bar(), .label = "$h^{*}$"}};
  chart.verticals = {{.at = film.x_bar(), .label = "$x^{*}$"}};
  chart.markers = {{.at = {0, h1}, .label = "$h_{1}$"}, {.at = {film.l, h2}, .label = "$h_{2}$"}};
  for (const FilmSection& section : shown.sections)
    chart.verticals.push_back({.at = section.x, .label = section.letters, .meaning = Meaning::construction});
  return chart;
}

std::vector<ChartPanel::Read> read_of(const geometry::FilmWedge<double>& film, const FilmShown& shown) {
  const auto at = [&](double x, const std::string& along_x, const std::string& along_y) {
    return ChartPanel::Read{{x, micrometres * film.h(x)}, along_x, along_y, 1, 1 / micrometres};
  };
  std::vector<ChartPanel::Read> all{at(0, {}, shown.quantities.inlet), at(film.l, {}, shown.quantities.outlet),
                                    at(film.x_bar(), shown.quantities.x_bar, shown.quantities.h_bar)};
  for (const FilmSection& section : shown.sections) all.push_back(at(section.x, section.quantity, {}));
  return all;
}

// The hatching on the side of the pad that is away from the film; the arrow, of no scale, within the runner.
MarkedChart::Marks marks_of(const geometry::FilmWedge<double>& film, const std::string& speed_letters) {
  return [=](Plot& plot, const drawings::ChartMap& map) {
    plot.mark(drawings::Ground{map.at({film.l, micrometres * film.h2}), map.at({0, micrometres * film.h1})});
    constexpr double from_edge = 5, length = 16;  // mm
    const double height = map.at({0, -runner / 2 * micrometres * film.h1}).y;
    const drawings::Point tail{map.frame.low.x + from_edge, height}, tip{tail.x + length, height};
    plot.mark(drawings::Arrow{tail, tip, Meaning::velocity, "runner_speed"});
    write_beside(plot, speed_letters, tip, tail, Meaning::velocity);
  };
}

}  // namespace

FilmChart::FilmChart(const geometry::FilmWedge<double>& film, const FilmShown& shown)
    : MarkedChart(chart_of(film, shown), read_of(film, shown), one_of_three_in_a_column,
                  marks_of(film, shown.speed_letters)),
      speed_letters_(shown.speed_letters) {}

Words film_exaggeration(double times) {
  constexpr double countable = 1e6;
  const double larger = std::max(times, 1 / times),
               digit = std::max(1.0, std::pow(10, std::floor(std::log10(larger)) - 1));
  const double two_digits = std::round(larger / digit) * digit;  // one below ten: "about 3 times"
  if (two_digits == 1)
    return {"The film is drawn about as high as it is, beside its length.",
            "Il meato è disegnato con altezza e lunghezza quasi alla stessa scala."};
  const auto number = [&](Language language) { return short_number(two_digits, language); };
  const Words told = larger < countable
                         ? Words{"about " + number(Language::english), "circa " + number(Language::italian)}
                         : Words{"more than a million", "più di un milione di"};
  return times > 1 ? format_words("The film is drawn {} times higher than long.",
                                  "Il meato è disegnato {} volte più alto che lungo.", told)
                   : format_words("The film is drawn {} times longer than high.",
                                  "Il meato è disegnato {} volte più lungo che alto.", told);
}

std::string FilmChart::told_of(const drawings::ChartMap& map, Language language) const {
  const Words walls = format_words(
      "The pad rests (hatched); below it the flat runner moves at {} to the narrow end. ",
      "Il pattino è fermo (campito); sotto, la parete piana scorre con {} verso l'estremo stretto. ", speed_letters_);
  return (walls + film_exaggeration(map.x.per_mm() * micrometres / map.y.per_mm())).in(language);
}

}  // namespace epure
