#include "exercises/pump-flywheel/printed.h"

#include <cmath>
#include <numbers>

namespace epure::pump_flywheel {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
// Of the source, rounded as it printed them.
constexpr double n = 206, omega = 21.57, L_r = 5227, mean = 832, coefficient = 2379, tau = 0.07, Delta_T = 2438,
                 J_crank = 104.8, J_motor = 0.514, k_m = 6.44, g = 9.81;

double by_twenty_degrees() {
  const double alpha_1 = full_turn / 18, alpha_2 = full_turn / 2 - alpha_1;
  return 2 * coefficient * std::cos(alpha_1) - mean * (alpha_2 - alpha_1);
}

Printed chained(const char* quantity, const char* text, const Words& sentence, double (*evaluate)()) {
  return {quantity, text, "closed form", 0, Explanation{sentence, evaluate}};
}
Printed right(const char* quantity, const char* text) { return {quantity, text, "closed form"}; }

}  // namespace

std::vector<Printed> printed_by_the_source() {
  return {
      right("V", "9.7e-3"),
      right("n_rpm", "206"),
      chained("omega", "21.57", {"of the rounded n = 206 rpm", "con n = 206 giri/min, arrotondato"},
              [] { return full_turn * n / 60; }),
      chained(
          "L_r", "5227",
          {"of the area rounded to 346 cm², with kgf = 9.81 N", "con l'area arrotondata a 346 cm² e kgf = 9,81 N"},
          [] { return 5.5e4 * g * 0.0346 * 0.28; }),
      chained("M_r_mean", "832", {"of the printed L_r = 5227 J", "con L_r = 5227 J, come stampato"},
              [] { return L_r / full_turn; }),
      chained("W_r", "17.946",
              {"in kW: 5227 J times 206/60 cycles per second are 17946 W, written with a comma between the thousands",
               "in kW: 5227 J per 206/60 cicli al secondo sono 17946 W, scritti con la virgola delle migliaia"},
              [] { return L_r * n / 60 / 1000; }),
      right("tau", "0.07"),
      right("M_r_suction_coefficient", "238"),
      chained("M_r_delivery_coefficient", "-2379",
              {"p_m V/2 with the rounded V = 9.7 l, and kgf = 9.81 N",
               "p_m V/2 con V = 9,7 l, arrotondato, e kgf = 9,81 N"},
              [] { return -5e4 * g * 9.7e-3 / 2; }),
      right("k_m", "6.44"),
      right("n_t", "1.225"),
      right("n_1", "0.07"),
      right("n_30", "2.1"),
      chained("M_inertia_max", "228", {"with the printed ω = 21.57 rad/s", "con ω = 21,57 rad/s, come stampato"},
              [] { return 50 * 0.14 * 0.14 * omega * omega / 2; }),
      right("alpha_1_deg", "20"),
      right("alpha_2_deg", "160"),
      chained("Delta_T_max", "2438",
              {"between the rounded 20° and 160°, with 2379 N m and 832 N m",
               "tra 20° e 160°, arrotondati, con 2379 N m e 832 N m"},
              by_twenty_degrees),
      chained("J_crank", "104.8",
              {"of the printed 2438 J and 21.57 rad/s", "con 2438 J e 21,57 rad/s, come stampati"},
              [] { return Delta_T / (0.05 * omega * omega); }),
      chained("J_motor_shaft", "0.514",
              {"104.8 kg m² times the square of τ rounded to 0.07",
               "104,8 kg m² per il quadrato di τ arrotondato a 0,07"},
              [] { return J_crank * tau * tau; }),
      chained("n_t_flywheel", "0.041",
              {"of the printed 0.514 kg m² and 6.44 N m s", "con 0,514 kg m² e 6,44 N m s, come stampati"},
              [] { return k_m / (J_motor * full_turn * 2910 / 60); })};
}

}  // namespace epure::pump_flywheel
