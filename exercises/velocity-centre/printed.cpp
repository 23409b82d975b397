// What the source printed. It calculated all of it; the velocity centre as the meet of two normals.
#include "exercises/velocity-centre/exercise.h"

namespace epure::velocity_centre {

std::vector<Printed> printed_by_the_source() {
  return {{"A_x", "0.566", "analytic"},        {"A_y", "0.566", "analytic"},   {"v_A_x", "10.303", "analytic"},
          {"v_A_y", "1.697", "analytic"},      {"a_A_x", "1.106", "analytic"}, {"a_A_y", "-6.788", "analytic"},
          {"normal_slope", "-6.071", "poles"}, {"P0_y", "4", "poles"}};
}

}  // namespace epure::velocity_centre
