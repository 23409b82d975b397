// What the source printed, and where its pressures and velocities come from.
#include <cmath>

#include "exercises/michell-bearing/exercise.h"

namespace epure::michell_bearing {
namespace {

// Of the source, in SI units: with the h_bar that its gradients were computed with.
constexpr double l = 0.4, V = 2.4, mu = 0.04, h_1 = 0.0004, h_2 = 0.00016, rounded_h_bar = 0.00022857;

double film(double x) { return h_1 - (h_1 - h_2) * x / l; }
double gradient(double x) { return 6 * mu * V * (film(x) - rounded_h_bar) / std::pow(film(x), 3); }

// The table's last column, up to its row: the step is a millimetre there, a centimetre in the first column.
double pressure_with_tenth_of_step(int row) {
  constexpr double step = 0.01, step_taken = 0.001;
  double p = 0;
  for (int i = 1; i <= row; ++i) p += step_taken * (gradient((i - 1) * step) + gradient(i * step)) / 2;
  return p;
}

Printed of_gradient(const std::string& station, const std::string& text, double x) {
  return {"inverse.dp_dx_at_" + station, text, "closed form", 0,
          Explanation{{"h_bar was rounded to 0.22857 mm", "h_bar è stato arrotondato a 0,22857 mm"},
                      [x] { return gradient(x); }}};
}
Printed of_pressure(const std::string& quantity, const std::string& text, int row) {
  return {"inverse." + quantity, text, "graphical integration", 0,
          Explanation{{"ten times too small: the step was taken as 0.001 m, and the table's is 0.01 m (h_bar as for "
                       "the gradients). The load of 94636.6 N/m, by the formula, is right: with the table's "
                       "pressures it would be a tenth",
                       "dieci volte troppo piccola: il passo è stato preso di 0,001 m, e quello della tabella è 0,01 "
                       "m (h_bar come per i gradienti). La portanza di 94636,6 N/m, dalla formula, è giusta: con le "
                       "pressioni della tabella sarebbe un decimo"},
                      [row] { return pressure_with_tenth_of_step(row); }}};
}
// `straight`: the film of the line that a whole column of the source follows.
Printed of_velocity(const std::string& station, const std::string& depth, const std::string& text, double z,
                    double straight) {
  const Words h = decimal(1000 * straight, 5);
  return {
      "inverse.u_at_" + station + "_z_" + depth, text, "closed form", 0,
      Explanation{Words{"the part of the pressure is left out: the whole column at ",
                        "manca la parte dovuta alla pressione: l'intera colonna in "} +
                      station + Words{" is the straight line V·z/h, with h = ", " è la retta V·z/h, con h = "} + h +
                      (station == "x_2" ? Words{" mm, the film at x = 0.23 m", " mm, il meato in x = 0,23 m"}
                                        : Words{" mm (fitted to the column)", " mm (adattato alla colonna)"}),
                  [=] { return V * z / straight; }}};
}
Printed plain(const std::string& quantity, const std::string& text) { return {quantity, text, "closed form"}; }

// The direct problem with the source's rounded numbers.
double n_of_rounded_pivot() {
  const auto centre = [](double n) {
    const double ln = std::log(n);
    return (1 + 4 * n - 5 * n * n + 2 * n * (n + 2) * ln) / ((n * n - 1) * ln - 2 * (n - 1) * (n - 1)) / 2;
  };
  double low = 2, high = 5;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (centre(middle) < 0.612 ? low : high) = middle;
  }
  return low;
}
double pressure_on_sector() { return 10000 / (0.5 * (0.130 * 0.130 - 0.070 * 0.070) * 2 * M_PI / 8); }
// 73.5 mm with its first two digits exchanged: 37.5 mm.
double length_with_digits_exchanged() {
  constexpr int tenths_of_mm = 735, first = tenths_of_mm / 100, second = tenths_of_mm / 10 % 10;
  return (100 * second + 10 * first + tenths_of_mm % 10) / 1e4;
}
double friction_with_both_factors() { return 2.429 * 1.813 * std::sqrt(35e-3 * 8.378 / 74906.37); }

}  // namespace

std::vector<Printed> printed_by_the_source() {
  std::vector<Printed> all{
      plain("inverse.n", "2.5"),     plain("inverse.h_bar", "0.00023"), of_pressure("p_max", "38518.08", 29),
      plain("inverse.N", "94636.6"), plain("inverse.x_N", "0.236"),     plain("inverse.T", "175"),
      plain("inverse.f_m", "0.0018")};
  struct TableRow {
    const char *station, *h, *gradient, *pressure;
    int row;
  };
  for (const TableRow& at : std::initializer_list<TableRow>{{"0p00", "0.0004", "1542870", "", 0},
                                                            {"0p05", "0.00037", "1608270", "7888.591024", 5},
                                                            {"0p10", "0.00034", "1633006", "16014.57433", 10},
                                                            {"0p15", "0.00031", "1574424", "24079.00847", 15},
                                                            {"0p20", "0.00028", "1349475", "31480.1529", 20},
                                                            {"0p25", "0.00025", "789995.5", "37014.26749", 25},
                                                            {"0p29", "0.000226", "-128242", "38518.08", 29},
                                                            {"0p30", "0.00022", "-463591", "38222.16335", 30},
                                                            {"0p35", "0.00019", "-3239003", "29849.55637", 35},
                                                            {"0p40", "0.00016", "-9642656", "-159.6467957", 40}}) {
    const std::string station = at.station;
    all.push_back(plain("inverse.h_at_" + station, at.h));
    all.push_back(of_gradient(station, at.gradient, at.row * 0.01));
    if (at.row > 0) all.push_back(of_pressure("p_bezout_at_" + station, at.pressure, at.row));
  }
  struct Column {
    const char* station;
    double straight;
    std::vector<const char*> velocities;
  };
  for (const Column& at : {Column{"x_1", 0.00031066, {"0.39", "0.77", "1.16", "1.55", "1.93", "2.32"}},
                           Column{"x_2", 0.000262, {"0.46", "0.92", "1.37", "1.83", "2.29"}},
                           Column{"x_3", 0.00018995, {"0.63", "1.26", "1.90"}}})
    for (std::size_t i = 0; i < at.velocities.size(); ++i)
      all.push_back(of_velocity(at.station, depths()[i].name, at.velocities[i], 0.00005 * static_cast<double>(i + 1),
                                at.straight));
  const std::vector<Printed> direct{
      plain("direct.omega", "83.78"),
      plain("direct.V", "8.378"),
      plain("direct.N", "166.667e3"),
      {"direct.l", "0.0375", "closed form", 0,
       Explanation{{"in the formula of h_2 the first two digits of 0.0735 are exchanged; a misprint only: with "
                    "0.0735 h_2 is the printed 37 µm, with 0.0375 it would be 19 µm",
                    "nella formula di h_2 le prime due cifre di 0,0735 sono scambiate; solo un refuso: con 0,0735 "
                    "h_2 è il 37 µm stampato, con 0,0375 sarebbe 19 µm"},
                   length_with_digits_exchanged}},
      plain("direct.x_N_over_l", "0.612"),
      {"direct.n", "3.15", "closed form", 0,
       Explanation{{"x_N/l was rounded to 0.612", "x_N/l è stato arrotondato a 0,612"}, n_of_rounded_pivot}},
      plain("direct.A", "0.144"),
      plain("direct.k", "1.813"),
      plain("direct.h_2", "0.000037"),
      plain("direct.f_m", "0.0024"),
      {"direct.p_mean", "2.12e6", "closed form", 0,
       Explanation{{"on an eighth of the whole ring, gaps included, instead of the pad's b·l",
                    "su un ottavo dell'intera corona, vani compresi, anziché sull'area b·l del pattino"},
                   pressure_on_sector}},
      plain("direct.c", "2.225"),
      plain("direct.c_prime", "2.429"),
      plain("direct.N_side_leakage", "74.9e3"),
      {"direct.f_m_side_leakage", "0.0087", "closed form", 0,
       Explanation{
           {"not c'·f_m, as the text says: N' stands for N under the root as well, which counts the leakage twice",
            "non c'·f_m, come dice il testo: anche sotto radice sta N' al posto di N, e la fuoriuscita conta due "
            "volte"},
           friction_with_both_factors}},
      plain("direct.R_outer", "0.130"),
      plain("direct.R_inner", "0.070")};
  all.insert(all.end(), direct.begin(), direct.end());
  return all;
}

}  // namespace epure::michell_bearing
