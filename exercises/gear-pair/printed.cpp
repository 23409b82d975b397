// What the source printed. It calculated all of it; lengths are in mm there.
#include <cmath>
#include <numbers>

#include "exercises/gear-pair/problem.h"

namespace epure::gear_pair {
namespace {

// The source's formula for the path of approach is right, and gives 23.634 mm.
double approach_with_rounded_sine() {
  const double m = 0.010, z2 = 40, sine = std::sin(22 * std::numbers::pi / 180), rounded = 0.3746;
  return m / 2 * (std::sqrt(z2 * z2 * sine * sine + 4 * z2 + 4) - z2 * rounded);
}

Explanation difference_of_magnitudes(double value) {
  return {{"The source subtracts magnitudes, 15.7 − 7.85 = 7.85 rad/s, and has the sliding velocities from that; but "
           "external wheels turn in opposite senses: $ω_{2}$ is negative, $ω_{r}$ = $ω_{1}$ − $ω_{2}$ = 23.56 rad/s.",
           "La fonte sottrae i moduli, 15,7 − 7,85 = 7,85 rad/s, e ne trae le velocità di strisciamento; ma le ruote "
           "esterne girano in versi opposti: $ω_{2}$ è negativa, $ω_{r}$ = $ω_{1}$ − $ω_{2}$ = 23,56 rad/s."},
          [value] { return value; }};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  const std::string by = "analytic";
  const Explanation rounded_sine{{"sin 22° rounded to 0.3746 in the second term only, while the root was taken with "
                                  "more digits (a conjecture): $m$/2·(19.7111 − 40·0.3746).",
                                  "sen 22° arrotondato a 0,3746 nel solo secondo termine, la radice con più cifre "
                                  "(una congettura): $m$/2·(19,7111 − 40·0,3746)."},
                                 approach_with_rounded_sine};
  return {{"r1", "0.100", by},
          {"r2", "0.200", by},
          {"r_tip_1", "0.110", by},
          {"r_root_1", "0.0875", by},
          {"r_tip_2", "0.210", by},
          {"r_root_2", "0.1875", by},
          {"addendum", "0.010", by},
          {"dedendum", "0.0125", by},
          {"clearance", "0.0025", by},
          {"tooth_height", "0.0225", by},
          {"z1", "20", by},
          {"z2", "40", by},
          {"circular_pitch", "0.03142", by},
          {"path_of_approach", "0.02364", by, 0, rounded_sine},
          {"path_of_recess", "0.02173", by},
          {"arc_of_approach", "0.0255", by},
          {"arc_of_recess", "0.0234", by},
          {"arc_of_action", "0.0489", by},
          {"contact_ratio", "1.56", by},
          {"omega_1", "15.7", by},
          {"omega_2", "7.85", by},
          {"omega_relative", "7.85", by, 0, difference_of_magnitudes(15.7 - 7.85)},
          {"sliding_velocity_approach", "0.186", by, 0, difference_of_magnitudes(7.85 * 0.02364)},
          {"sliding_velocity_recess", "0.171", by, 0, difference_of_magnitudes(7.85 * 0.02173)}};
}

}  // namespace epure::gear_pair
