// Velocities across the film at three sections: Couette's line and Poiseuille's parabola added, depth by depth as
// vectors; the tangents at the walls, which tell the shear; where the film runs back.
#include "exercises/kit/panels/marked_chart.h"
#include "exercises/kit/panels/sheet.h"
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

// One section: u over z, both parts of it, and the tangents at the walls.
struct VelocityProfile {
  CrossSection at;
  geometry::FilmWedge<double> film;
  double h, tau_0, tau_h;
  std::vector<Datum> points = {};  // where a ruler reads u

  double couette(double z) const { return film.V * z / h; }
  double whole(double z) const { return film.velocity(at.x, z); }
  double poiseuille(double z) const { return whole(z) - couette(z); }

  // The tangents reach as far into the film as they can and stay on the chart.
  double reach() const { return h / 4; }
  double tangent_at_pad() const { return tau_0 / film.mu * reach(); }
  double tangent_at_runner() const { return film.V - tau_h / film.mu * reach(); }
  bool runs_back() const { return tau_0 < 0; }
};

VelocityProfile profile(const Solution& s, const geometry::FilmWedge<double>& film, const CrossSection& at) {
  const auto value = [&](const char* of) { return s[of_film(at_station(of, at.station).name)]; };
  return {at, film, value("h"), value("tau_0"), value("tau_h")};
}

// Of all three, so that they have one scale.
struct Speeds {
  double low = 0, high = 0;
  void include(double u) {
    low = std::min(low, u);
    high = std::max(high, u);
  }
};
Speeds speeds(const std::vector<VelocityProfile>& all) {
  Speeds found{0, all.front().film.V};
  constexpr int steps = 200;
  for (const VelocityProfile& each : all) {
    for (int i = 0; i <= steps; ++i) {
      const double z = each.h * i / steps;
      found.include(each.whole(z));
      found.include(each.poiseuille(z));
    }
    found.include(each.tangent_at_pad());
    found.include(each.tangent_at_runner());
  }
  return found;
}

// u < 0, from the pad to where the film stands still: nothing where it does not run back.
std::vector<Datum> backflow(const VelocityProfile& of) {
  constexpr int steps = 200;
  std::vector<Datum> border;
  for (int i = 0; i <= steps; ++i) {
    const double z = of.h * i / steps, u = of.whole(z);
    if (i > 0 && u >= 0) break;
    border.push_back({u, micrometres * z});
  }
  if (border.size() > 1) border.push_back({0, border.back().y});
  return border;
}

void hatch(Plot& plot, const drawings::ChartMap& map, const VelocityProfile& of) {
  constexpr double apart = 1.5;  // mm
  for (double y = map.y.at(0) + apart; y < map.y.at(micrometres * of.h); y += apart) {
    const double u = of.whole(map.y.value(y) / micrometres);
    if (u < 0) plot.mark(drawings::Line{drawings::segment({map.x.at(u), y}, {map.x.at(0), y}), Meaning::velocity});
  }
}

// Head to tail, where u is read: first Couette's part, then Poiseuille's, whose tip lies on the curve.
void add_vectors(Plot& plot, const drawings::ChartMap& map, const VelocityProfile& of) {
  for (const Datum& point : of.points) {
    const auto at = [&](double u) { return map.at({u, point.y}); };
    const double couette = of.couette(point.y / micrometres);
    plot.mark(drawings::Arrow{at(0), at(couette), Meaning::construction, "couette_part"});
    plot.mark(drawings::Arrow{at(couette), at(point.x), Meaning::locus, "poiseuille_part"});
  }
}

// The shear is μ times how far a tangent runs aside over how deep it reaches.
void add_tangents(Plot& plot, const drawings::ChartMap& map, const VelocityProfile& of) {
  const double per_mm = of.film.mu * map.x.per_mm() / of.reach();
  const auto add = [&](const char* shear, const Datum& wall, const Datum& tip, const drawings::Point& from,
                       const drawings::Point& to) {
    plot.mark(drawings::Line{drawings::segment(map.at(wall), map.at(tip)), Meaning::acceleration,
                             shear + ("_" + of.at.station)});
    plot.onto().measurements.push_back(
        {of_film(at_station(shear, of.at.station).name), from, to, per_mm, Measurement::along_x});
  };
  const double top = micrometres * of.h, reach = micrometres * of.reach();
  const Datum near_pad{of.tangent_at_pad(), reach}, near_runner{of.tangent_at_runner(), top - reach};
  add("tau_0", {0, 0}, near_pad, map.at({0, reach}), map.at(near_pad));
  add("tau_h", {of.film.V, top}, near_runner, map.at(near_runner), map.at({of.film.V, top - reach}));
}

MarkedChart chart_of(const Solution& s, VelocityProfile of, const Speeds& speeds, double highest) {
  const auto over = [&](const auto& u) {
    auto runs = run_of(0, of.h, u);
    for (Datum& each : runs.front()) each = {each.y, micrometres * each.x};
    return runs;
  };
  const auto read = read_at_depths(s, of.at.station, of.h);
  for (const ChartPanel::Read& each : read) of.points.push_back(each.at);
  drawings::Chart chart;
  chart.x = {.quantity = "$u$(" + of.at.letters + ")", .unit = "m/s", .low = speeds.low, .high = 1.05 * speeds.high};
  // In fifties, as the depths of the table are.
  chart.y = {.quantity = "$z$",
             .unit = "µm",
             .low = 0,
             .high = 1.04 * micrometres * highest,
             .steps = {50, 100, 500, 1000},
             .to_ticks = false};
  if (of.runs_back()) chart.areas = {{backflow(of), Meaning::velocity}};
  const std::string& station = of.at.station;
  chart.curves = {{.name = "velocity_" + station,
                   .runs = over([&](double z) { return of.whole(z); }),
                   .meaning = Meaning::velocity,
                   .points = of.points},
                  {.name = "couette_" + station,
                   .runs = over([&](double z) { return of.couette(z); }),
                   .meaning = Meaning::construction,
                   .line = drawings::LineType::dashed},
                  {.name = "poiseuille_" + station,
                   .runs = over([&](double z) { return of.poiseuille(z); }),
                   .meaning = Meaning::locus,
                   .line = drawings::LineType::dash_dotted}};
  chart.horizontals = {{.at = micrometres * of.h, .label = "$h$"}};
  chart.verticals = {{.at = 0}};
  return MarkedChart(chart, read, one_of_three_in_a_row, [of](Plot& plot, const drawings::ChartMap& map) {
    if (of.runs_back()) hatch(plot, map, of);
    add_vectors(plot, map, of);
    add_tangents(plot, map, of);
  });
}

}  // namespace

PanelSheet velocities_sheet(const Solution& s, Language language) {
  const auto film = Problem(s.givens()).film.wedge<double>();
  const std::vector<CrossSection> at = sections(s);
  std::vector<VelocityProfile> profiles;
  for (const CrossSection& each : at) profiles.push_back(profile(s, film, each));
  const Speeds shown = speeds(profiles);
  const auto chart = [&](std::size_t i) {
    return chart_of(s, profiles[i], shown, std::max(profiles[i].h, profiles[0].h));
  };
  std::vector<Row> rows;
  struct Head {
    const char *words, *of;
    bool is_in_workshop_units;
  };
  for (const Head& head :
       {Head{"$h$ (mm)", "h", true}, Head{"$p'$ (MPa/m)", "dp_dx", true}, Head{"$p$ (MPa)", "p", true},
        Head{"$τ_{0}$ (Pa)", "tau_0", false}, Head{"$τ_{h}$ (Pa)", "tau_h", false}}) {
    rows.push_back({head.words, {}, "–", head.is_in_workshop_units});
    for (const CrossSection& each : at) rows.back().names.push_back(of_film(at_station(head.of, each.station).name));
  }
  rows.push_back({"$u$($h$/2) (m/s)", {}, "–"});
  for (const CrossSection& each : at) rows.back().names.push_back(of_film(velocity_at(each.station, mid_film).name));
  const bool runs_back =
      std::any_of(profiles.begin(), profiles.end(), [](const VelocityProfile& each) { return each.runs_back(); });
  const Words hatched{"Hatched: the film that runs back.", "A tratteggio: il fluido che torna indietro."};
  return {
      .panels = panels(chart(0), chart(1), chart(2)),
      .theory = {{{"Across the film", "Attraverso il meato"},
                  {told({"Dashed: Couette's line $\\it{V}$·$z$/$h$. Dash-dotted: Poiseuille's parabola −$p'$·($h$ − "
                         "$z$)·$z$/(2 $μ$), which slows the film where $p'$ > 0. Their sum is $u$.",
                         "Tratteggiata: la retta di Couette $\\it{V}$·$z$/$h$. A tratto e punto: la parabola di "
                         "Poiseuille −$p'$·($h$ − $z$)·$z$/(2 $μ$), che frena dove $p'$ > 0. La somma è $u$."},
                        language),
                   told({"At the dots both parts are added as vectors. $z$ is counted from the pad, which rests "
                         "(here below).",
                         "Nei punti le due parti si sommano come vettori. $z$ si conta dal pattino, che è fermo (qui "
                         "in basso)."},
                        language),
                   told({"The tangents at the walls have the slope $τ$/$μ$. It vanishes at the pad where $h$ = 3/2 "
                         "$h^{*}$ ($x_{0}$), at the moving wall where $h$ = 3/4 $h^{*}$ ($x_{h}$), if $n$ ≥ 2. "
                         "Nearer to the inlet than $x_{0}$ the film runs back along the pad.",
                         "Le tangenti alle pareti hanno la pendenza $τ$/$μ$. Si annulla al pattino dove $h$ = 3/2 "
                         "$h^{*}$ ($x_{0}$), alla parete mobile dove $h$ = 3/4 $h^{*}$ ($x_{h}$), se $n$ ≥ 2. Più "
                         "verso l'imbocco di $x_{0}$ il fluido torna indietro lungo il pattino."},
                        language),
                   told(runs_back ? hatched : Words{}, language),
                   told({"$\\it{T}$ = $\\it{T}_{0}$ + $\\it{N}$ ($h_{1}$ − $h_{2}$)/$l$: the pad is inclined.",
                         "$\\it{T}$ = $\\it{T}_{0}$ + $\\it{N}$ ($h_{1}$ − $h_{2}$)/$l$: il pattino è inclinato."},
                        language)}}},
      .results = {table({"", "$x_{1}$", "$x_{2}$", "$x_{3}$"}, rows),
                  values({of_film("x_shear_zero_fixed"), of_film("x_shear_zero_moving")}),
                  values({of_film("T"), of_film("T_fixed")}), values({of_film("f_m"), of_film("flow_rate")})},
      .seen = {"Velocities across the film at three sections", "Velocità attraverso il meato in tre sezioni"},
      .told = {of_film("x_N"), of_film("T"), of_film("T_fixed"), of_film("f_m")},
      .without_part = {"P", "speed", "pads", "r_m", "l_pad", "b", "x_N", "mu_pad", "h_ref", "dx"}};
}

}  // namespace epure::michell_bearing
