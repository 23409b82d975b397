// Film, gradients and pressures along the slider.
#include "exercises/kit/panels/film_chart.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/michell-bearing/along_film.h"
#include "exercises/michell-bearing/exercise.h"

namespace epure::michell_bearing {
namespace {

using drawings::Datum;

constexpr double letters_left = 16;  // mm, of all three
constexpr double mega = 1e6;         // both charts and the table beside them have MPa
constexpr double load_arrow = 0.6;   // of the greatest pressure: where the arrow of the load ends

drawings::Chart chart_along(const Solution& s, const std::string& quantity, const std::string& unit, double low,
                            double high) {
  if (low == high)
    throw geometry::Undecided("gradients and pressures that cannot be told from zero for the drawing",
                              "gradienti e pressioni che per il disegno non si distinguono da zero");
  const double air = 0.06 * (high - low);
  drawings::Chart chart;
  chart.x = {.quantity = "$x$", .unit = "m", .low = 0, .high = geometry::from_rational<double>(s.givens()["l"])};
  chart.x.to_ticks = false;
  chart.y = {.quantity = quantity, .unit = unit, .low = low < 0 ? low - air : low, .high = high + air};
  chart.letters_left = letters_left;
  chart.horizontals = {{.at = 0}};
  chart.verticals = {{.at = s[of_film("x_bar")], .label = "$x^{*}$"}};
  return chart;
}

// Those stations of the table that are on the pad.
std::vector<ChartPanel::Read> read_at_stations(const Solution& s, const std::string& of) {
  std::vector<ChartPanel::Read> all;
  for (const Station& at : stations()) {
    const std::string quantity = of_film(at_station(of, at.name).name);
    if (!s.has(quantity)) continue;
    if (const auto value = s.value(quantity))
      all.push_back({{CGAL::to_double(at.x), *value / mega}, {}, quantity, 1, mega});
  }
  return all;
}
std::vector<Datum> points_of(const std::vector<ChartPanel::Read>& read) {
  std::vector<Datum> points;
  for (const ChartPanel::Read& each : read) points.push_back(each.at);
  return points;
}

std::vector<std::vector<Datum>> run_in_mega(const Film& film, OfFilm of) {
  auto runs = run_along(film, of);
  for (auto& run : runs)
    for (Datum& each : run) each.y /= mega;
  return runs;
}

SizedChart gradient_chart(const Solution& s, const Film& film) {
  const auto read = read_at_stations(s, "dp_dx");
  const auto runs = run_in_mega(film, &DeepWedge::gradient);
  const double first = runs.front().front().y, last = runs.front().back().y;
  drawings::Chart chart = chart_along(s, "$p'$", "MPa/m", last, first > 0 ? 1.3 * first : 0);
  chart.curves = {{.name = "gradient", .runs = runs, .meaning = Meaning::locus, .points = points_of(read)}};
  return SizedChart(chart, read, one_of_three_in_a_column);
}

MarkedChart pressure_chart(const Solution& s, const Film& film, Language language) {
  auto read = read_at_stations(s, "p_bezout");
  const double greatest = s[of_film("p_max")] / mega;
  drawings::Chart chart = chart_along(s, "$p$", "MPa", 0, 1.12 * greatest);
  chart.curves = {{.name = "pressure", .runs = run_in_mega(film, &DeepWedge::pressure), .meaning = Meaning::force},
                  {.name = "bezout", .meaning = Meaning::construction, .points = points_of(read)}};
  chart.markers = {{.at = {s[of_film("x_bar")], greatest},
                    .label = "$p_{max}$ = " + figures(greatest, 4, language) + " MPa",
                    .meaning = Meaning::force}};
  chart.verticals.push_back({.at = s[of_film("x_N")], .label = "$x_{N}$", .meaning = Meaning::construction});
  read.push_back({{s[of_film("x_bar")], greatest}, of_film("x_bar"), of_film("p_max"), 1, mega});
  read.push_back({{s[of_film("x_N")], 0}, of_film("x_N"), {}});
  return MarkedChart(chart, read, one_of_three_in_a_column,
                     force_at(s[of_film("x_N")], load_arrow * greatest,
                              "$\\it{N}$ = " + figures(s[of_film("N")], 4, language) + " N/m", "N"));
}

// Where the shear vanishes on a wall, if it does anywhere.
std::vector<FilmSection> sections_without_shear(const Solution& s) {
  std::vector<FilmSection> all;
  for (const auto& [name, letters] :
       {std::pair("x_shear_zero_fixed", "$x_{0}$"), std::pair("x_shear_zero_moving", "$x_{h}$")})
    if (const auto x = s.value(of_film(name))) all.push_back({*x, letters, of_film(name)});
  return all;
}

std::vector<Row> rows(const Solution& s) {
  std::vector<Row> all;
  for (const Station& at : stations()) {
    const std::string& x = at.name;
    if (!s.value(of_film(at_station("h", x).name)) || at.x == 0) continue;
    all.push_back({geometry::to_text(at.x * 1000),
                   {of_film(at_station("dp_dx", x).name), of_film(at_station("p_bezout", x).name)},
                   "–",
                   true});
  }
  return all;
}

}  // namespace

PanelSheet pressures_sheet(const Solution& s, Language language) {
  const Film film = Problem(s.givens()).film;
  return {
      .panels = panels(
          FilmChart(film.wedge<double>(), {.quantities = {.x_bar = of_film("x_bar"), .h_bar = of_film("h_bar")},
                                           .speed_letters = "$\\it{V}$",
                                           .sections = sections_without_shear(s),
                                           .letters_left = letters_left}),
          gradient_chart(s, film), pressure_chart(s, film, language)),
      .theory =
          {{{"The film", "Il meato"},
            {told({"$h$ = $h_{1}$ − ($h_{1}$ − $h_{2}$)·$x$/$l$; $p'$ = 6 $μ$ $\\it{V}$ ($h$ − $h^{*}$)/$h^{3}$ is "
                   "zero where $h$ = $h^{*}$ = 2 $h_{1}$ $h_{2}$/($h_{1}$ + $h_{2}$).",
                   "$h$ = $h_{1}$ − ($h_{1}$ − $h_{2}$)·$x$/$l$; $p'$ = 6 $μ$ $\\it{V}$ ($h$ − $h^{*}$)/$h^{3}$ si "
                   "annulla dove $h$ = $h^{*}$ = 2 $h_{1}$ $h_{2}$/($h_{1}$ + $h_{2}$)."},
                  language),
             remark("$p$ = 6 $μ$ $\\it{V}$ ($h_{1}$ − $h_{2}$) $x$ ($l$ − $x$) / [$l$ ($h_{1}$ + $h_{2}$) $h^{2}$]"),
             told({"$h^{*}$, $x^{*}$ are $h$ and $x$ with a bar in the source. The depth $z$ is counted from the "
                   "pad. The shear is zero at $x_{0}$ on the pad, at $x_{h}$ on the moving wall, where these exist.",
                   "$h^{*}$, $x^{*}$ sono $h$ e $x$ con la linea sopra nella fonte. La quota $z$ si conta dal "
                   "pattino. Lo sforzo si annulla in $x_{0}$ sul pattino, in $x_{h}$ sulla parete mobile, se "
                   "esistono."},
                  language),
             told({"Points of the pressure: Bezout's formula, each strip with the mean of the gradients at its ends. "
                   "The curve is the true one. The arrow $\\it{N}$ is not to scale.",
                   "Punti della pressione: formula di Bezout, ogni striscia con la media dei gradienti ai suoi "
                   "estremi. La curva è quella esatta. La freccia $\\it{N}$ non è in scala."},
                  language)}}},
      .results = {table({"$x$ (mm)", "$p'$ (MPa/m)", "$p_{B}$ (MPa)"}, rows(s)), workshop_values({of_film("h_bar")}),
                  values({of_film("x_bar")}), workshop_values({of_film("p_max")}),
                  values({of_film("N"), of_film("x_N")})},
      .seen = {"Film, gradients and pressures along the slider, one above the other",
               "Meato, gradienti e pressioni lungo la slitta, l'uno sopra l'altro"},
      .told = {of_film("h_bar"), of_film("x_bar"), of_film("p_max"), of_film("N"), of_film("x_N")},
      .without_part = {"P", "speed", "pads", "r_m", "l_pad", "b", "x_N", "mu_pad", "h_ref", "x_1", "x_3"}};
}

}  // namespace epure::michell_bearing
