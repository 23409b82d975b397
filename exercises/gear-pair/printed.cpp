// What the source printed. It calculated all of it; lengths are in mm there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/problem.h"

namespace epure::gear_pair {
namespace {

constexpr double m = 0.010, z2 = 40;

// The source's formula for the path of approach is right, and gives 23.634 mm.
double approach_with_rounded_sine() {
  const double sine = std::sin(22 * std::numbers::pi / 180), rounded = 0.3746;
  return m / 2 * (std::sqrt(z2 * z2 * sine * sine + 4 * z2 + 4) - z2 * rounded);
}

std::string with_commas(std::string formula) {
  std::replace(formula.begin(), formula.end(), '.', ',');
  return formula;
}

Explanation difference_of_magnitudes(const char* formula, double value) {
  const std::string of = formula;
  return {{"ω_r = ω₁ − ω₂ with magnitudes: but external wheels turn in opposite senses, and ω_r = ω₁ + ω₂ = "
           "23.56 rad/s; " +
               of,
           "ω_r = ω₁ − ω₂ con i moduli: ma le ruote esterne girano in versi opposti, e ω_r = ω₁ + ω₂ = "
           "23,56 rad/s; " +
               with_commas(of)},
          [value] { return value; }};
}

std::vector<Printed> printed_elements() {
  return {{"r1", "0.100", "analytic"},
          {"r2", "0.200", "analytic"},
          {"r_tip_1", "0.110", "analytic"},
          {"r_root_1", "0.0875", "analytic"},
          {"r_tip_2", "0.210", "analytic"},
          {"r_root_2", "0.1875", "analytic"},
          {"addendum", "0.010", "analytic"},
          {"dedendum", "0.0125", "analytic"},
          {"clearance", "0.0025", "analytic"},
          {"tooth_height", "0.0225", "analytic"},
          {"z1", "20", "analytic"},
          {"z2", "40", "analytic"},
          {"circular_pitch", "0.03142", "analytic"}};
}

std::vector<Printed> printed_contact() {
  return {{"path_of_approach", "0.02364", "analytic", 0,
           Explanation{{"sin 22° rounded to 0.3746 in the second term only, while the root was taken with more "
                        "digits (a conjecture): m/2·(19.7111 − 40·0.3746)",
                        "sen 22° arrotondato a 0,3746 nel solo secondo termine, la radice con più cifre (una "
                        "congettura): m/2·(19,7111 − 40·0,3746)"},
                       approach_with_rounded_sine}},
          {"path_of_recess", "0.02173", "analytic"},
          {"arc_of_approach", "0.0255", "analytic"},
          {"arc_of_recess", "0.0234", "analytic"},
          {"arc_of_action", "0.0489", "analytic"},
          {"contact_ratio", "1.56", "analytic"}};
}

std::vector<Printed> printed_sliding() {
  return {
      {"omega_1", "15.7", "analytic"},
      {"omega_2", "7.85", "analytic"},
      {"omega_relative", "7.85", "analytic", 0, difference_of_magnitudes("15.7 − 7.85", 15.7 - 7.85)},
      {"sliding_velocity_approach", "0.186", "analytic", 0, difference_of_magnitudes("7.85·0.02364", 7.85 * 0.02364)},
      {"sliding_velocity_recess", "0.171", "analytic", 0, difference_of_magnitudes("7.85·0.02173", 7.85 * 0.02173)}};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  std::vector<Printed> all = printed_elements();
  for (const auto& numbers : {printed_contact(), printed_sliding()})
    all.insert(all.end(), numbers.begin(), numbers.end());
  return all;
}

}  // namespace epure::gear_pair
