// What the source printed. It calculated all of it but a_t, which it took from its drawing.
//
// Its numbers at φ = 3/4 π are those of φ = π/2: the wheel was drawn a quarter turn on. The mistake is carried out
// here, number by number. The cusp it declined to study. Of the involute its numbers are right, though its equation
// for x has a wrong sign.
#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"

namespace epure::cycloid_involute {
namespace {

Printed at_quarter_turn(const std::string& quantity, const std::string& text, const Words& formula,
                        std::function<double()> evaluate) {
  return {quantity, text, "poles", 0,
          Explanation{{formula.english + " at φ = π/2, not 3/4 π", formula.italian + " a φ = π/2, non 3/4 π"},
                      std::move(evaluate)}};
}
Printed same_words(const std::string& quantity, const std::string& text, const std::string& formula,
                   std::function<double()> evaluate) {
  return at_quarter_turn(quantity, text, decimal(formula), std::move(evaluate));
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  constexpr double r = 0.5, omega = 30;                                 // m, rad/s
  constexpr double half_angle = std::numbers::pi / 4;                   // φ/2, of φ = π/2
  constexpr double P0M = 0.71, MprimeM = 0.35, v_M = 21.2, rho = 1.44;  // as printed
  return {
      same_words("cycloid.P0M", "0.71", "2 r sin φ/2", [] { return 2 * r * std::sin(half_angle); }),
      same_words("cycloid.v_M", "21.2", "2 r ω sin φ/2", [] { return 2 * r * omega * std::sin(half_angle); }),
      same_words("cycloid.rho_M", "1.44", "0.71²/0.35", [] { return P0M * P0M / MprimeM; }),
      same_words("cycloid.Mprime_M", "0.35", "r sin φ/2", [] { return r * std::sin(half_angle); }),
      same_words("cycloid.a_n", "312.1", "21.2²/1.44", [] { return v_M * v_M / rho; }),
      // 318.2, read to the millimetre: on a drawing where a_M is 5 cm long (of 3 cm the same comes out).
      at_quarter_turn(
          "cycloid.a_t", "315",
          {"ω² r cos φ/2, read as 3.5 cm where a_M is 5 cm,", "ω² r cos φ/2, letta 3,5 cm dove a_M è 5 cm,"},
          [] {
            constexpr double drawn = 50;  // mm
            return std::round(drawn * std::cos(half_angle)) / drawn * omega * omega * r;
          }),
      {"cycloid.a_M", "450", "poles"},
      {"cycloid.KM", "0.5", "poles"},
      {"cycloid.inflection_diameter", "0.5", "poles"},
      {"involute.v_M_t1", "105", "analytic"},
      {"involute.a_t_t1", "750", "analytic"},
      {"involute.a_n_t1", "5250", "analytic"},
      {"involute.a_M_t1", "5303.3", "analytic"},
      {"involute.v_M_t2", "210", "analytic"},
      {"involute.a_t_t2", "750", "analytic"},
      {"involute.a_n_t2", "10500", "analytic"},
      {"involute.a_M_t2", "10526.75", "analytic"},
  };
}

}  // namespace epure::cycloid_involute
