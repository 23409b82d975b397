// What the source printed. It states 300 kg and computed with 600: with these all that it printed is right within its
// digits.
#include "exercises/boat-crane/printed.h"

#include <cmath>

namespace epure::boat_crane {
namespace {

// The source's own formulas, with the mass that gives its numbers. Millimetres, newtons, megapascals.
struct Source {
  double P = 600 * 9.80665, Y_A = 3 * P, Y_B = P - Y_A, M_C = Y_B * 3000;
  double A_1 = 300 * 200 - 195 * 290, J_x1 = (200 * std::pow(300, 3) - 195 * std::pow(290, 3)) / 12;
  double A_2 = 180 * 100 - 98 * 176;
  double sigma = -M_C / J_x1 * 150, tau = Y_B / A_1, sigma_N = -Y_A / A_2;
  static double soderberg(double range) { return range * 300 / (300 - range / 2); }
};

Printed doubled(const std::string& quantity, const std::string& text, const std::string& formula, double value) {
  const Words sentence = Words{"The source states 300 kg and computes with 600 kg, which gives the number: ",
                               "La fonte dichiara 300 kg e calcola con 600 kg, che danno il numero: "} +
                         decimal(formula) + Words{".", "."};
  return {quantity, text, "analytic", 0, Explanation{sentence, [value] { return value; }}};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  const Source source;
  constexpr double mega = 1e6;
  const double equivalent = std::hypot(source.sigma, std::sqrt(3) * source.tau);
  const std::vector<Printed> of_load{
      doubled("P", "5.884e3", "600·9.80665 N", source.P),
      doubled("Y_A", "1.765e4", "3·600·9.80665 N", source.Y_A),
      doubled("Y_B", "-1.177e4", "−2·600·9.80665 N", source.Y_B),
      doubled("M_C", "-3.53e4", "−2·600·9.80665·3 N m", source.M_C / 1000),
      doubled("N_2", "-1.765e4", "−3·600·9.80665 N", -source.Y_A),
      doubled("sigma_z_max", "98.653e6", "σ_z = 2·600·9.80665·3000·150/J_x1", mega * source.sigma),
      doubled("tau_zy", "-3.411e6", "τ_zy = −2·600·9.80665/3450", mega * source.tau),
      doubled("sigma_eq", "98.83e6", "√(98.653² + 3·3.411²) MPa", mega * equivalent),
      doubled("Delta_sigma", "98.653e6", "Δσ = σ_z", mega * source.sigma),
      doubled("sigma_m", "49.327e6", "σ_m = σ_z/2", mega * source.sigma / 2),
      doubled("Delta_sigma_eff", "118.066e6", "98.653·300/(300 − 49.327) MPa",
              mega * Source::soderberg(source.sigma)),
      doubled("sigma_zN", "-23.473e6", "−3·600·9.80665/752 MPa", mega * source.sigma_N),
      doubled("Delta_sigma_eff2", "-22.59e6", "−23.473·300/(300 + 11.737) MPa",
              mega * Source::soderberg(source.sigma_N))};
  std::vector<Printed> all{{"A_1", "3.45e-3", "analytic"},           {"J_x1", "5.368e-5", "analytic"},
                           {"J_y1", "6.67e-6", "analytic"},          {"A_2", "752e-6", "analytic"},
                           {"J_x2", "4.077e-6", "analytic"},         {"J_y2", "3.335e-7", "analytic"},
                           {"sigma_amm", "200e6", "analytic"},       {"Delta_sigma_Lamm", "133.333e6", "analytic"},
                           {"J_min", "3.335e-7", "analytic"},        {"P_cr", "2.764e4", "analytic"},
                           {"P_cr_over_Psi", "1.843e4", "analytic"}, {"X_B", "0", "analytic"},
                           {"mass_600kg.X_B", "0", "analytic"}};
  for (const Printed& each : of_load) {
    all.push_back(each);
    all.push_back({"mass_600kg." + each.quantity, each.text, each.route});
  }
  return all;
}

}  // namespace epure::boat_crane
