// The sheets: the coefficients with the table's points; the pad's film and pressure; the ring and its forces.
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/film_chart.h"
#include "exercises/kit/panels/pad_ring_panel.h"
#include "exercises/kit/panels/pad_section_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/kit/panels/slider_charts.h"
#include "exercises/michell-thrust/exercise.h"

namespace epure::michell_thrust {
namespace {

constexpr double letters_left = 14;  // mm, of both charts

Result told(const Words& words, Language language) { return remark(words.in(language)); }

drawings::Chart along_pad(const Solution& s, const std::string& quantity, const std::string& unit, double high) {
  drawings::Chart chart;
  chart.x = {.quantity = "$x$", .unit = "m", .low = 0, .high = s["l"], .to_ticks = false};
  chart.y = {.quantity = quantity, .unit = unit, .low = 0, .high = 1.15 * high};
  chart.letters_left = letters_left;
  return chart;
}

// p is x (l - x)/h² times a constant: of nearly parallel walls a double holds that, and not what they narrow by.
MarkedChart pressure_chart(const Solution& s, const geometry::FilmWedge<double>& film, Language language) {
  constexpr double mega = 1e6;
  const double greatest = s["theory.p_max"] / mega;
  drawings::Chart chart = along_pad(s, "$p$", "MPa", greatest);
  const auto shape = [&](double x) { return x * (film.l - x) / geometry::square(film.h(x)); };
  const double constant = greatest / shape(s["theory.x_p_max"]);
  chart.curves = {{.name = "pressure",
                   .runs = run_of(0, film.l, [&](double x) { return constant * shape(x); }),
                   .meaning = Meaning::force}};
  chart.markers = {{.at = {s["theory.x_p_max"], greatest},
                    .label = "$p_{max}$ = " + figures(greatest, 4, language) + " MPa",
                    .meaning = Meaning::force}};
  std::vector<ChartPanel::Read> read{{{s["theory.x_p_max"], greatest}, {}, "theory.p_max", 1, mega},
                                     {{s["x_N"], 0}, "x_N", {}}};
  for (const auto& [name, share] :
       {std::pair("theory.p_1_4", 0.25), std::pair("theory.p_1_2", 0.5), std::pair("theory.p_3_4", 0.75)}) {
    const drawings::Datum at{share * s["l"], s[name] / mega};
    read.push_back({at, {}, name, 1, mega});
    chart.markers.push_back({.at = at, .meaning = Meaning::force});
  }
  chart.verticals = {{.at = s["x_N"], .label = "$x_{N}$", .meaning = Meaning::construction}};
  constexpr double load_arrow = 0.6;  // of the greatest pressure
  return MarkedChart(
      chart, read, one_of_three_in_a_column,
      force_at(s["x_N"], load_arrow * greatest, "$\\it{N}$ = " + figures(s["N"], 4, language) + " N/m", "N"));
}

// N_p upwards, T_p across, each at a scale of its own; φ as far as that lets it be seen.
MarkedChart force_triangle(const Solution& s) {
  const double N = s["N_p"], T = s["theory.T_p"];
  drawings::Chart chart;
  chart.x = {.quantity = "$\\it{T}_{p}$", .unit = "N", .low = -0.2 * T, .high = 1.3 * T};
  chart.y = {.quantity = "$\\it{N}_{p}$", .unit = "N", .low = 0, .high = 1.1 * N};
  constexpr ChartSize beside_the_ring{40, 100};
  const auto forces = [=](Plot& plot, const drawings::ChartMap& map) {
    const drawings::Point foot = map.at({0, 0}), corner = map.at({0, N}), tip = map.at({T, N});
    const auto add = [&](const char* name, const char* letters, drawings::Point from, drawings::Point to) {
      plot.mark(drawings::Arrow{from, to, Meaning::force, name});
      plot.onto().sheet.figure.labels.push_back({letters, from, to, Meaning::force});
    };
    add("N_p", "$\\it{N}_{p}$", foot, corner);
    add("T_p", "$\\it{T}_{p}$", corner, tip);
    add("R", "$\\it{R}$", foot, tip);
    constexpr double share = 0.45;  // of N_p, where the arc is wide enough for a letter
    const double radius = share * (corner.y - foot.y), upwards = std::numbers::pi / 2,
                 along = std::atan2(tip.y - foot.y, tip.x - foot.x), middle = (upwards + along) / 2;
    plot.mark(drawings::AngleMark{foot, radius, along, upwards, Meaning::force});
    write_beside(plot, "$φ$", {foot.x + radius * std::cos(middle), foot.y + radius * std::sin(middle)}, foot,
                 Meaning::force);
  };
  return MarkedChart(chart, {{{T, N}, "theory.T_p", "N_p"}}, beside_the_ring, forces);
}

SliderPoint point_of(const TableRow& row) {
  return {CGAL::to_double(row.n), CGAL::to_double(row.x_N_over_l), CGAL::to_double(row.A), CGAL::to_double(row.k)};
}
Result chord_told(const Solution& s, Language language) {
  return told(
      s.value("n")
          ? Words{"Detail: at the $x_{N}$/$l$ of the pivot the chord between two rings gives $n_{c}$, the curve $n$.",
                  "Dettaglio: alla $x_{N}$/$l$ della cerniera la corda tra due cerchietti dà $n_{c}$, la curva $n$."}
          : Words{"The pivot is outside the table: there is no chord.",
                  "La cerniera è fuori della tabella: non c'è corda."},
      language);
}
// The heading of what the table's chord gives, where there is one.
Result on_chord(const Solution& s, const Words& heading, Language language) {
  return told(s.value("n") ? heading : Words{}, language);
}
// None where the pivot is off the table.
std::optional<SliderChord> chord_of(const Solution& s) {
  const Problem of(s.givens());
  if (!of.beside) return {};
  return SliderChord{point_of(*of.beside->before), point_of(*of.beside->after), s["n"], "$n_{c}$", "n"};
}

}  // namespace

PanelSheet coefficients_sheet(const Solution& s, Language language) {
  std::vector<SliderPoint> rows;
  for (const TableRow& row : table_1()) rows.push_back(point_of(row));
  const double centre = geometry::from_rational<double>(s.givens()["x_N_over_l"]);
  std::vector<Row> exact;
  for (const TableRow& row : table_1()) {
    const std::string prefix = "table_n_" + row.name + ".";
    exact.push_back({decimal(CGAL::to_double(row.n), 2).in(language),
                     {prefix + "A", prefix + "A_n_minus_1_squared", prefix + "x_N_over_l", prefix + "k"}});
  }
  return {.panels = slider_charts({.up_to = std::max(3.2, 1.25 * s["theory.n"]),
                                   .table = rows,
                                   .chord = chord_of(s),
                                   .found = {s["theory.n"], centre, s["theory.A"], s["theory.k"]},
                                   .ratio_quantity = "theory.n",
                                   .load_quantity = "theory.A",
                                   .friction_quantity = "theory.k"},
                                  language),
          .theory = {{{"The slider", "Il pattino"},
                      {told({"Curves: the flat slider of infinite width (Reynolds). Rings: the table of the source, "
                             "which interpolates on chords between them.",
                             "Curve: il pattino piano di larghezza infinita (Reynolds). Cerchietti: la tabella della "
                             "fonte, che interpola sulle corde tra essi."},
                            language),
                       chord_told(s, language), remark(slider_formulas()[0]), remark(slider_formulas()[1]),
                       remark(slider_formulas()[2])}},
                     {{"By the theory", "Secondo la teoria"},
                      {table({"$n$", "$\\it{A}$", "$\\it{A}$($n$−1)$^{2}$", "$x_{N}$/$l$", "$k$"}, exact)}}},
          .results = {on_chord(s, {"On the chord of the table ($c$):", "Sulla corda della tabella ($c$):"}, language),
                      values({"n", "A", "k"}), told({"By the theory:", "Secondo la teoria:"}, language),
                      values({"theory.n", "theory.A", "theory.k"})},
          .seen = {"Place of the load, A and k against n, with the points of the source's table",
                   "Posizione del carico, A e k in funzione di n, con i punti della tabella della fonte"},
          .told = {"theory.n", "theory.A", "theory.k"},
          .without_part = {"Q", "n_g", "D_e", "D_i", "d", "mu", "z"}};
}

PanelSheet pad_sheet(const Solution& s, Language language) {
  const geometry::FilmWedge<double> film{s["l"], s["v"], s["mu"], s["theory.h_1"], s["theory.h_2"]};
  return {.panels =
              panels(FilmChart(film, {.quantities = {"theory.h_1", "theory.h_2", "theory.x_p_max", "theory.h_p_max"},
                                      .speed_letters = "$v$",
                                      .letters_left = letters_left}),
                     pressure_chart(s, film, language)),
          .theory = {{{"The film", "Il meato"},
                      {remark("$h_{2}$ = $l$ √($\\it{A}$ $μ$ $v$/$\\it{N}$), $h_{1}$ = $n$ $h_{2}$, $α$ = "
                              "arctan(($h_{1}$ − $h_{2}$)/$l$)")}}},
          .results = {values({"l", "v", "N"}), on_chord(s, {"With the table:", "Con la tabella:"}, language),
                      workshop_values({"h_2", "h_1"}), values({"alpha_deg"}),
                      told({"By the theory (drawn):", "Secondo la teoria (disegnato):"}, language),
                      workshop_values({"theory.h_2", "theory.h_1"}), values({"theory.alpha_deg"}),
                      workshop_values({"theory.x_p_max", "theory.h_p_max"}), workshop_values({"theory.p_max", "p_m"}),
                      told({"$p_{m}$ is the mean over the whole pad, $b$·$l$; $p_{max}$ is that of the film, whose "
                            "load $\\it{N}$ (its arrow is not to scale) acts on $b'$ alone.",
                            "$p_{m}$ è la media su tutto il pattino, $b$·$l$; $p_{max}$ è quella del meato, il cui "
                            "carico $\\it{N}$ (la freccia non è in scala) agisce sulla sola $b'$."},
                           language),
                      on_chord(
                          s, {"Without side leakage, with the table:", "Senza fuoriuscite laterali, con la tabella:"},
                          language),
                      workshop_values({"no_side_leakage.h_2", "no_side_leakage.h_1"})},
          .seen = {"Film and pressure along a pad", "Meato e pressioni lungo un pattino"},
          .told = {"h_2", "h_1", "theory.h_2", "theory.h_1", "theory.p_max"},
          .without_part = {"D_e", "D_i", "d", "z"}};
}

PanelSheet forces_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  return {
      .panels = panels(PadRingPanel({.pads = static_cast<int>(CGAL::to_double(of.pads)),
                                     .inner = geometry::from_rational<double>(of.D_i / 2),
                                     .outer = geometry::from_rational<double>(of.D_e / 2),
                                     .length = s["l"],
                                     .pivot = geometry::from_rational<double>(of.centre),
                                     .mean_letters = "$\\it{R}_{m}$",
                                     .length_letters = "$l$",
                                     .drag_letters = "$\\it{T}_{p}$",
                                     .couple_letters = "$\\it{M}$",
                                     .width_letters = "$b$",
                                     .gap_letters = "$d$",
                                     .mean_quantity = "R_m"}),
                       PadSectionPanel({.length = s["l"],
                                        .pivot = geometry::from_rational<double>(of.centre),
                                        .h_1 = s["theory.h_1"],
                                        .h_2 = s["theory.h_2"],
                                        .length_letters = "$l$",
                                        .pivot_letters = "$x_{N}$",
                                        .speed_letters = "$v$",
                                        .inlet_quantity = "theory.h_1",
                                        .outlet_quantity = "theory.h_2"}),
                       force_triangle(s)),
      .theory = {{{"Forces", "Forze"},
                  {remark("$c$ = $b$/($b$ + $l$), $b'$ = $c$ $b$, $c'$ = √((4 $l$ + $b$)/$b$), $\\it{N}$ = "
                          "$\\it{N}_{p}$/$b'$, $f_{m}$ = $k$ $c'$ √($μ$ $v$/$\\it{N}$)"),
                   told(
                       {"$\\it{T}_{p}$ = $f_{m}$ $\\it{N}_{p}$ turns the pad's force by the friction angle $φ$, tan "
                        "$φ$ = $f_{m}$. The triangle has another scale across than upwards: $φ$ would not be seen. "
                        "$\\it{M}$ = $z$ $\\it{T}_{p}$ $\\it{R}_{m}$, $\\it{W}$ = $\\it{M}$ $ω$.",
                        "$\\it{T}_{p}$ = $f_{m}$ $\\it{N}_{p}$ ruota la forza del pattino dell'angolo d'attrito $φ$, "
                        "tg $φ$ = $f_{m}$. Il triangolo ha una scala diversa in orizzontale e in verticale: $φ$ non "
                        "si vedrebbe. $\\it{M}$ = $z$ $\\it{T}_{p}$ $\\it{R}_{m}$, $\\it{W}$ = $\\it{M}$ $ω$."},
                       language)}}},
      .results = {values({"R_m", "b", "l"}), values({"v", "omega"}), values({"c", "b_eff", "c_prime"}),
                  values({"N_p", "N"}), on_chord(s, {"With the table:", "Con la tabella:"}, language),
                  values({"f_m", "T_p"}), values({"M", "dissipated_power"}),
                  told({"By the theory (drawn):", "Secondo la teoria (disegnato):"}, language),
                  values({"theory.f_m", "theory.T_p"}), values({"theory.M", "theory.dissipated_power"})},
      .seen = {"The ring of pads with the friction on each, a pad and the runner in section, and the triangle of a "
               "pad's forces",
               "La corona di pattini con l'attrito su ciascuno, un pattino e la ralla in sezione, e il triangolo "
               "delle forze di un pattino"},
      .told = {"N_p", "f_m", "T_p", "M", "dissipated_power"}};
}

}  // namespace epure::michell_thrust
