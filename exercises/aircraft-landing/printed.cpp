#include "exercises/aircraft-landing/printed.h"

#include <cmath>

namespace epure::aircraft_landing {
namespace {

// With the static coefficient, without f_v N u, and with v_0² = 4820 m²/s².
double wheel_spun_up_by_adhesion() {
  const double f_a = 1.2, N = 9060 * 9.81 + 2 * 4820;
  return f_a * N * 0.4 / 4.9;
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  return {{"v_0", "69.44", "closed form"},
          {"N_0", "98523", "closed form", 0,
           Explanation{{"cut off, not rounded: with 250/3.6 m/s it is 98523.7 N; with 69.44 m/s, 98522.4 N",
                        "troncato, non arrotondato: con 250/3,6 m/s è 98523,7 N; con 69,44 m/s, 98522,4 N"},
                       [] { return std::floor(9060 * 9.81 + 2 * (250 / 3.6) * (250 / 3.6)); }}},
          {"a_0", "-11.94", "closed form"},
          {"omega_dot_0", "9650.8", "closed form", 0,
           Explanation{{"a fifth too large: not f_r but f_a = 1.2 stands for the friction of the sliding wheel (and "
                        "rolling friction is left out, v_0² rounded to 4820 m²/s²)",
                        "un quinto di troppo: al posto di f_r sta f_a = 1,2 nell'attrito della ruota che striscia (e "
                        "manca l'attrito volvente, con v_0² arrotondato a 4820 m²/s²)"},
                       wheel_spun_up_by_adhesion}}};
}

}  // namespace epure::aircraft_landing
