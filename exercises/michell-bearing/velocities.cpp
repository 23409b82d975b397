// Velocities across the film at three sections: Couette's line and Poiseuille's parabola added.
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/michell-bearing/exercise.h"

namespace epure::michell_bearing {
namespace {

using drawings::Datum;

constexpr double micrometres = 1e6;  // of a metre

struct CrossSection {
  std::string station, letters;
  double x;
};

std::vector<CrossSection> sections(const Solution& s) {
  return {{"x_1", "$x_{1}$", geometry::from_rational<double>(s.givens()["x_1"])},
          {"x_2", "$x_{2}$ ≡ $x_{N}$", s[of_film("x_N")]},
          {"x_3", "$x_{3}$", geometry::from_rational<double>(s.givens()["x_3"])}};
}

std::vector<ChartPanel::Read> read_at_depths(const Solution& s, const std::string& station, double h) {
  std::vector<ChartPanel::Read> all;
  for (const Depth& depth : depths()) {
    const std::string quantity = of_film(velocity_at(station, depth.name).name);
    if (!s.has(quantity)) continue;
    if (const auto u = s.value(quantity)) all.push_back({{*u, micrometres * CGAL::to_double(depth.z)}, quantity, {}});
  }
  const std::string middle = of_film(velocity_at(station, mid_film).name);
  all.push_back({{s[middle], micrometres * h / 2}, middle, {}});
  return all;
}

// Of all three, so that they have one scale.
struct Speeds {
  double low = 0, high = 0;
};
Speeds speeds(const Solution& s, const geometry::FilmWedge<double>& film) {
  Speeds found{0, film.V};
  constexpr int steps = 200;
  for (const CrossSection& at : sections(s))
    for (int i = 0; i <= steps; ++i) {
      const double z = film.h(at.x) * i / steps;
      for (const double u : {film.velocity(at.x, z), film.velocity(at.x, z) - film.V * z / film.h(at.x)}) {
        found.low = std::min(found.low, u);
        found.high = std::max(found.high, u);
      }
    }
  return found;
}

SizedChart profile(const Solution& s, const geometry::FilmWedge<double>& film, const CrossSection& at,
                   const Speeds& speeds) {
  const double h = s[of_film(at_station("h", at.station).name)];
  const auto over = [&](const auto& u) {
    auto runs = run_of(0, h, u);
    for (Datum& each : runs.front()) each = {each.y, micrometres * each.x};
    return runs;
  };
  const auto couette = [&](double z) { return film.V * z / h; };
  const auto whole = [&](double z) { return film.velocity(at.x, z); };
  const auto read = read_at_depths(s, at.station, h);
  std::vector<Datum> points;
  for (const ChartPanel::Read& each : read) points.push_back(each.at);
  drawings::Chart chart;
  chart.x = {.quantity = "$u$(" + at.letters + ")", .unit = "m/s", .low = speeds.low, .high = 1.05 * speeds.high};
  chart.y = {.quantity = "$z$",
             .unit = "µm",
             .low = 0,
             .high = 1.04 * micrometres * film.h(std::min({at.x, sections(s)[0].x}))};
  chart.curves = {
      {.name = "velocity_" + at.station, .runs = over(whole), .meaning = Meaning::velocity, .points = points},
      {.name = "couette_" + at.station,
       .runs = over(couette),
       .meaning = Meaning::construction,
       .line = drawings::LineType::dashed},
      {.name = "poiseuille_" + at.station,
       .runs = over([&](double z) { return whole(z) - couette(z); }),
       .meaning = Meaning::locus,
       .line = drawings::LineType::dash_dotted}};
  chart.horizontals = {{.at = micrometres * h, .label = "$h$"}};
  chart.verticals = {{.at = 0}};
  return SizedChart(chart, read, one_of_three_in_a_row);
}

}  // namespace

PanelSheet velocities_sheet(const Solution& s, Language language) {
  const auto film = Problem(s.givens()).film.wedge<double>();
  const Speeds all = speeds(s, film);
  const std::vector<CrossSection> at = sections(s);
  std::vector<Row> rows;
  struct Head {
    const char *words, *of;
    bool is_in_workshop_units;
  };
  for (const Head& head :
       {Head{"$h$ (mm)", "h", true}, Head{"$p'$ (Pa/m)", "dp_dx", false}, Head{"$p$ (MPa)", "p", true},
        Head{"$τ_{0}$ (Pa)", "tau_0", false}, Head{"$τ_{h}$ (Pa)", "tau_h", false}}) {
    rows.push_back({head.words, {}, "–", head.is_in_workshop_units});
    for (const CrossSection& each : at) rows.back().names.push_back(of_film(at_station(head.of, each.station).name));
  }
  rows.push_back({"$u$($h$/2) (m/s)", {}, "–"});
  for (const CrossSection& each : at) rows.back().names.push_back(of_film(velocity_at(each.station, mid_film).name));
  return {
      .panels = panels(profile(s, film, at[0], all), profile(s, film, at[1], all), profile(s, film, at[2], all)),
      .theory = {{{"Across the film", "Attraverso il meato"},
                  {told({"Dashed: Couette's line $\\it{V}$·$z$/$h$. Dash-dotted: Poiseuille's parabola "
                         "−$p'$·($h$ − $z$)·$z$/(2 $μ$), which slows the film where $p'$ > 0. Their sum is $u$.",
                         "Tratteggiata: la retta di Couette $\\it{V}$·$z$/$h$. A tratto e punto: la parabola di "
                         "Poiseuille −$p'$·($h$ − $z$)·$z$/(2 $μ$), che frena dove $p'$ > 0. La somma è $u$."},
                        language),
                   told({"The slope at the walls is that of the shear: it vanishes on the fixed wall where $h$ = "
                         "3/2 $h^{*}$, on the moving one where $h$ = 3/4 $h^{*}$, if $n$ ≥ 2. Nearer to the inlet "
                         "the film then runs back along the fixed wall.",
                         "La pendenza alle pareti è quella dello sforzo: si annulla sulla parete fissa dove $h$ = "
                         "3/2 $h^{*}$, su quella mobile dove $h$ = 3/4 $h^{*}$, se $n$ ≥ 2. Più verso l'imbocco il "
                         "fluido allora torna indietro lungo la parete fissa."},
                        language)}}},
      .results = {table({"", "$x_{1}$", "$x_{2}$", "$x_{3}$"}, rows),
                  values({of_film("x_shear_zero_fixed"), of_film("x_shear_zero_moving")}),
                  values({of_film("T"), of_film("T_fixed")}), values({of_film("f_m"), of_film("flow_rate")})},
      .seen = {"Velocities across the film at three sections", "Velocità attraverso il meato in tre sezioni"},
      .told = {of_film("x_N"), of_film("T"), of_film("T_fixed"), of_film("f_m")},
      .without_part = {"P", "speed", "pads", "r_m", "l_pad", "b", "x_N", "mu_pad", "h_ref", "dx"}};
}

}  // namespace epure::michell_bearing
