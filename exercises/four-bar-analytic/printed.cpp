// What the source printed, and why it is off where it is.
//
// Its analytic numbers were calculated; those of the polar diagrams agree with them to all digits, so these too were
// calculated and not read off a drawing: no reading error is allowed.
#include <cmath>
#include <complex>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/statement/decimal.h"

namespace epure::four_bar_analytic {
namespace {

// The exercise with the source's own givens.
const Solution& source() {
  static const Solution stated(Givens(givens()), solve(Givens(givens()), Rung::drawing));
  return stated;
}

using Complex = std::complex<double>;
constexpr Complex i{0, 1};
constexpr double AB = 0.50, B0G4 = 0.35;

// B₀G₄ as the source took it: along -θ₄ where the rocker points along θ₄ + π. Its length is right, so are |v| and
// |a|.
Complex mirrored_B0G4() { return std::polar(B0G4, -source()["theta_4"]); }
Complex mirrored_v_G4() { return i * source()["omega_4"] * mirrored_B0G4(); }
// The source also turned the sense of all its accelerations round, as the components of G₂ and G₃ show.
Complex mirrored_a_G4() { return -((i * source()["alpha_4"] - std::pow(source()["omega_4"], 2)) * mirrored_B0G4()); }

const Words of_mirrored_G4{"B₀G₄ taken along -θ₄ instead of θ₄ + π, and the acceleration with its sense reversed",
                           "B₀G₄ preso lungo -θ₄ invece che lungo θ₄ + π, e l'accelerazione col verso opposto"};

Complex v_G3A() { return 0.5 * source()["omega_3"] * i * std::polar(AB, source()["theta_3"]); }

Explanation relative_velocity(std::function<double()> evaluate) {
  return {{"the components are those of v_G3A, relative to A (4.34 with its last digits swapped), not of v_G3",
           "le componenti sono quelle di v_G3A, relativa ad A (4,34 con le ultime cifre scambiate), non di v_G3"},
          std::move(evaluate)};
}

Explanation component_with_AB(bool along) {
  return {{along ? "the component along AB, not normal to the path of G₃"
                 : "the component square to AB, not along the path of G₃",
           along ? "la componente lungo AB, non normale alla traiettoria di G₃"
                 : "la componente normale ad AB, non tangente alla traiettoria di G₃"},
          [along] {
            const Arrow2 a = source().vector("a_G3");
            const Complex parts = Complex(a.x, a.y) * std::polar(1.0, -source()["theta_3"]);
            return std::abs(along ? parts.real() : parts.imag());
          }};
}

std::vector<Printed> by_analysis() {
  return {
      {"omega_2", "41.89", "analytic"},
      {"theta_3", "1.231343147", "analytic"},
      {"theta_4", "-0.8807969084", "analytic"},
      {"theta_3_other_branch", "-1.453939572", "analytic"},
      {"theta_4_other_branch", "0.6582004834", "analytic", 0,
       cut_off([] { return source()["theta_4_other_branch"]; }, 10)},
      {"omega_4", "-10.78", "analytic"},
      {"omega_3", "-18.42", "analytic", 0, cut_off([] { return source()["omega_3"]; }, 2)},
      {"alpha_3", "-259.65", "analytic", 0, cut_off([] { return source()["alpha_3"]; }, 2)},
      {"alpha_4", "584.71", "analytic"},
      {"v_G2_x", "-1.43", "analytic"},
      {"v_G2_y", "3.94", "analytic"},
      {"v_G2", "4.19", "analytic"},
      {"v_G3_x", "4.43", "analytic", 0, relative_velocity([] { return with_last_digits_swapped(v_G3A().real()); })},
      {"v_G3_y", "-1.53", "analytic", 0, relative_velocity([] { return v_G3A().imag(); })},
      {"v_G3", "6.51", "analytic"},
      {"v_G4_x", "2.91", "analytic"},
      {"v_G4_y", "-2.40", "analytic", 0, Explanation{of_mirrored_G4, [] { return mirrored_v_G4().imag(); }}},
      {"v_G4", "3.77", "analytic"},
      {"a_G2_x", "164.88", "analytic"},
      {"a_G2_y", "60.01", "analytic"},
      {"a_G2", "175.46", "analytic"},
      {"a_G3_x", "296.81", "analytic"},
      {"a_G3_y", "221.66", "analytic", 0, cut_off([] { return -source()["a_G3_y"]; }, 2)},
      {"a_G3", "370.44", "analytic", 0, cut_off([] { return source()["a_G3"]; }, 2)},
      {"a_G4_x", "183.74", "analytic", 0, Explanation{of_mirrored_G4, [] { return mirrored_a_G4().real(); }}},
      {"a_G4_y", "-98.88", "analytic", 0, Explanation{of_mirrored_G4, [] { return mirrored_a_G4().imag(); }}},
      {"a_G4", "208.66", "analytic"},
      {"rho_G3", "0.18", "analytic"},
      {"curvature_centre_G3_x", "0.10", "analytic"},
      {"curvature_centre_G3_y", "0.36", "analytic", 0,
       Explanation{{"the distance of the centre of curvature from A₀, not its ordinate",
                    "la distanza del centro di curvatura da A₀, non la sua ordinata"},
                   [] { return std::hypot(source()["curvature_centre_G3_x"], source()["curvature_centre_G3_y"]); }}},
  };
}

std::vector<Printed> by_polar_diagram() {
  const auto a_BA_n = [] { return source()["omega_3"] * source()["omega_3"] * AB; };
  return {
      {"v_A", "8.38", "polar diagram"},
      {"v_G2", "4.19", "polar diagram"},
      {"v_B", "7.55", "polar diagram"},
      {"v_BA", "9.21", "polar diagram"},
      {"omega_3", "18.42", "polar diagram", 0,
       Explanation{{"v_BA rounded before it is divided: 9.21/0.50", "v_BA arrotondata prima di dividere: 9,21/0,50"},
                   [] { return 9.21 / AB; }}},
      {"omega_4", "10.78", "polar diagram"},
      {"v_G3", "6.51", "poles"},
      {"v_G4", "3.77", "polar diagram"},
      {"a_A", "350.92", "polar diagram"},
      {"a_G2", "175.46", "polar diagram"},
      {"a_BA_n", "169.74", "polar diagram", 0, cut_off(a_BA_n, 2)},
      {"a_BA_t", "129.83", "polar diagram"},
      {"a_B_n", "81.40", "polar diagram"},
      {"a_B_t", "409.30", "polar diagram"},
      {"a_B", "385.17", "polar diagram"},
      {"alpha_3", "259.65", "polar diagram", 0, cut_off([] { return -source()["alpha_3"]; }, 2)},
      {"alpha_4", "584.71", "polar diagram"},
      {"a_G3_component_along_AB", "307.84", "polar diagram"},
      {"a_G3_component_normal_to_AB", "206.06", "polar diagram"},
      {"a_G3_path_normal", "307.84", "polar diagram", 0, component_with_AB(true)},
      {"a_G3_path_tangential", "206.06", "polar diagram", 0, component_with_AB(false)},
      {"a_G3A_n", "84.87", "polar diagram"},
      {"a_G3A_t", "64.91", "polar diagram"},
      {"a_G4", "40.7", "polar diagram", 0,
       Explanation{{"the normal part ω₄²·B₀G₄ alone: the tangential part α₄·B₀G₄ was left out",
                    "la sola parte normale ω₄²·B₀G₄: manca la parte tangenziale α₄·B₀G₄"},
                   [] { return source()["omega_4"] * source()["omega_4"] * B0G4; }}},
      {"rho_G3", "0.18", "poles"},
      {"curvature_centre_G3_x", "0.01", "poles", 0,
       Explanation{
           {"a tenth of the abscissa: 0.01 written for 0.10", "un decimo dell'ascissa: 0,01 scritto per 0,10"},
           [] { return source()["curvature_centre_G3_x"] / 10; }}},
      {"curvature_centre_G3_y", "0.34", "poles"},
  };
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  std::vector<Printed> all = by_analysis();
  for (const Printed& number : by_polar_diagram()) all.push_back(number);
  return all;
}

}  // namespace epure::four_bar_analytic
