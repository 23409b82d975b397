// The sheets: the coefficients with the table's points; the ring, and the pad's film and pressure.
#include "exercises/kit/panels/pad_ring_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/kit/panels/slider_charts.h"
#include "exercises/michell-thrust/exercise.h"

namespace epure::michell_thrust {
namespace {

Result told(const Words& words, Language language) { return remark(words.in(language)); }

drawings::Chart along_pad(const Solution& s, const std::string& quantity, const std::string& unit, double high) {
  drawings::Chart chart;
  chart.x = {.quantity = "$x$", .unit = "m", .low = 0, .high = s["l"], .to_ticks = false};
  chart.y = {.quantity = quantity, .unit = unit, .low = 0, .high = 1.15 * high};
  chart.letters_left = 14;
  return chart;
}

SizedChart film_chart(const Solution& s, const geometry::FilmWedge<double>& film) {
  drawings::Chart chart = along_pad(s, "$h$", "m", film.h1);
  chart.curves = {
      {.name = "h", .runs = run_of(0, film.l, [&](double x) { return film.h(x); }), .meaning = Meaning::link}};
  chart.horizontals = {{.at = s["theory.h_p_max"], .label = "$h^{*}$"}};
  chart.verticals = {{.at = s["theory.x_p_max"], .label = "$x^{*}$"}};
  return SizedChart(chart,
                    {{{0, s["theory.h_1"]}, {}, "theory.h_1"},
                     {{s["l"], s["theory.h_2"]}, {}, "theory.h_2"},
                     {{s["theory.x_p_max"], s["theory.h_p_max"]}, "theory.x_p_max", "theory.h_p_max"}},
                    one_of_three_in_a_column);
}

SizedChart pressure_chart(const Solution& s, const geometry::FilmWedge<double>& film, Language language) {
  drawings::Chart chart = along_pad(s, "$p$", "Pa", s["theory.p_max"]);
  chart.curves = {{.name = "pressure",
                   .runs = run_of(0, film.l, [&](double x) { return film.pressure(x); }),
                   .meaning = Meaning::force}};
  chart.markers = {{.at = {s["theory.x_p_max"], s["theory.p_max"]},
                    .label = "$p_{max}$ = " + figures(s["theory.p_max"], 4, language) + " Pa",
                    .meaning = Meaning::force}};
  std::vector<ChartPanel::Read> read{{{s["theory.x_p_max"], s["theory.p_max"]}, {}, "theory.p_max"},
                                     {{s["x_N"], 0}, "x_N", {}}};
  for (const auto& [name, share] :
       {std::pair("theory.p_1_4", 0.25), std::pair("theory.p_1_2", 0.5), std::pair("theory.p_3_4", 0.75)}) {
    read.push_back({{share * s["l"], s[name]}, {}, name});
    chart.markers.push_back({.at = {share * s["l"], s[name]}, .meaning = Meaning::force});
  }
  chart.verticals = {{.at = s["x_N"], .label = "$x_{N}$", .meaning = Meaning::force}};
  return SizedChart(chart, read, one_of_three_in_a_column);
}

}  // namespace

PanelSheet coefficients_sheet(const Solution& s, Language language) {
  std::vector<SliderPoint> rows;
  for (const TableRow& row : table_1())
    rows.push_back(
        {CGAL::to_double(row.n), CGAL::to_double(row.x_N_over_l), CGAL::to_double(row.A), CGAL::to_double(row.k)});
  const double centre = geometry::from_rational<double>(s.givens()["x_N_over_l"]);
  std::vector<Row> exact;
  for (const TableRow& row : table_1()) {
    const std::string prefix = "table_n_" + row.name + ".";
    exact.push_back({decimal(CGAL::to_double(row.n), 2).in(language),
                     {prefix + "A", prefix + "A_n_minus_1_squared", prefix + "x_N_over_l", prefix + "k"}});
  }
  return {
      .panels = slider_charts({.up_to = 3.2,
                               .table = rows,
                               .found = {s["theory.n"], centre, s["theory.A"], s["theory.k"]},
                               .load_quantity = "theory.A",
                               .friction_quantity = "theory.k"},
                              language),
      .theory = {{{"The slider", "Il pattino"},
                  {told(
                      {"Curves: the flat slider of infinite width (Reynolds). Rings: the table of the source, which "
                       "interpolates on chords between them.",
                       "Curve: il pattino piano di larghezza infinita (Reynolds). Cerchietti: la tabella della "
                       "fonte, che interpola sulle corde tra essi."},
                      language)}},
                 {{"By the theory", "Secondo la teoria"},
                  {table({"$n$", "$\\it{A}$", "$\\it{A}$($n$−1)$^{2}$", "$x_{N}$/$l$", "$k$"}, exact)}}},
      .results = {told({"On the chord of the table:", "Sulla corda della tabella:"}, language),
                  values({"n", "A", "k"}), told({"By the theory:", "Secondo la teoria:"}, language),
                  values({"theory.n", "theory.A", "theory.k"})},
      .seen = {"Place of the load, A and k against n, with the points of the source's table",
               "Posizione del carico, A e k in funzione di n, con i punti della tabella della fonte"},
      .told = {"theory.n", "theory.A", "theory.k"},
      .without_part = {"Q", "n_g", "D_e", "D_i", "d", "mu", "z"}};
}

PanelSheet pad_sheet(const Solution& s, Language language) {
  const geometry::FilmWedge<double> film{s["l"], s["v"], s["mu"], s["theory.h_1"], s["theory.h_2"]};
  const Problem of(s.givens());
  return {.panels = panels(PadRingPanel({.pads = static_cast<int>(CGAL::to_double(of.pads)),
                                         .inner = geometry::from_rational<double>(of.D_i / 2),
                                         .outer = geometry::from_rational<double>(of.D_e / 2),
                                         .length = s["l"],
                                         .pivot = geometry::from_rational<double>(of.centre),
                                         .mean_letters = "$\\it{R}_{m}$",
                                         .length_letters = "$l$",
                                         .mean_quantity = "R_m"}),
                           film_chart(s, film), pressure_chart(s, film, language)),
          .results = {values({"R_m", "b", "l", "v"}), values({"c", "b_eff", "c_prime"}), values({"N_p", "N", "p_m"}),
                      told({"With the table:", "Con la tabella:"}, language), values({"h_2", "h_1"}),
                      values({"alpha_deg", "f_m"}), values({"T_p", "M", "dissipated_power"}),
                      told({"By the theory (drawn):", "Secondo la teoria (disegnato):"}, language),
                      values({"theory.h_2", "theory.h_1", "theory.f_m"}),
                      values({"theory.p_max", "theory.M", "theory.dissipated_power"})},
          .seen = {"The ring of pads, and film and pressure along one of them",
                   "La corona di pattini, e meato e pressioni lungo uno di essi"},
          .told = {"h_2", "h_1", "f_m", "M", "dissipated_power"}};
}

}  // namespace epure::michell_thrust
