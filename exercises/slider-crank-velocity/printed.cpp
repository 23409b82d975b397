// What the source printed, and why it is off where it is.
//
// Reading errors: half a millimetre for each point set and each length read, added in absolute value, first order.
//   Figure with poles: its scale is not printed; 1 : 10 is assumed, the scale of the source's polodes, so e = 5 mm.
//     A set aside by e turns the crank by e/r, which lifts P₀ by x_B (e/r)/cos² φ = 22 mm; B set aside moves it by
//     (e, e tan φ); each X is set and read with e more. A product or quotient adds the relative errors.
//   Velocity polygon: 3 cm for v_A, so 2.513 m/s a cm; 0.05 cm for the ruler and 0.05/3 of v for v_A laid off. What
//     follows from v_BA carries its error in proportion.
#include "exercises/slider-crank-velocity/exercise.h"

namespace epure::slider_crank_velocity {

std::vector<Printed> printed_by_the_source() {
  return {
      {"omega_2", "37.7", "analytic"},
      {"crank_angle_phi", "0.5236", "analytic"},
      {"crank_angle_phi_deg", "30", "analytic"},
      {"v_A", "7.54", "analytic"},
      {"P0A", "0.58", "poles", 0.0268},
      {"P0B", "0.41", "poles", 0.0299},
      {"P0C", "0.29", "poles", 0.0222},
      {"P0M", "0.43", "poles", 0.0330},
      {"omega_3", "13", "poles", 0.63},
      {"v_B", "5.33", "poles", 0.64},
      {"v_C", "3.77", "poles", 0.47},
      {"v_M", "5.59", "poles", 0.70},
      {"omega_3", "13", "polar diagram", 0.47},
      {"v_BA", "6.50", "polar diagram", 0.236},
      {"v_CA", "3.90", "polar diagram", 0.142},
      {"v_MA", "3.25", "polar diagram", 0.118},
      {"v_B", "5.25", "polar diagram", 0.210},
      {"v_C", "3.75", "polar diagram", 0.187},
      {"v_M", "5.50", "polar diagram", 0.217},
  };
}

}  // namespace epure::slider_crank_velocity
