// What the source printed, and why it is off where it is.
//
// Reading errors: half a millimetre on the source's drawings, as in N.4: 10 N for wedge and double slider, 5 N for
// the levers. Efficiencies and couples were calculated from what was read.
#include <cmath>
#include <numbers>

#include "exercises/friction-efficiency/exercise.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::friction_efficiency {
namespace {

double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

Explanation of_printed(const std::string& of, double numerator, double denominator) {
  return {Words{"follows from the printed forces: ", "segue dalle forze stampate: "} + decimal(of),
          [=] { return numerator / denominator; }};
}

// The double slider's 64 N and 53 N are half a millimetre, 10 N, off; but within a newton of those of a friction
// angle of 1.8°.
Explanation of_small_angles(const std::string& of, double numerator, double denominator) {
  constexpr double drawn = 1.8, theta = 69;
  const auto told = [&](double angle) {
    return format_words("150 cot {}° = {} N", "150 cotg {}° = {} N", decimal(angle, 3),
                        decimal(150 / tangent_of(angle), 3));
  };
  const Explanation printed = of_printed(of, numerator, denominator);
  return {
      printed.sentence + format_words("; the friction angles were drawn as {}° rather than 5°, which gives {} and {}",
                                      "; gli angoli d'attrito furono disegnati di {}° anziché 5°, che danno {} e {}",
                                      decimal(drawn, 2), told(theta - drawn), told(theta + drawn)),
      printed.evaluate};
}

// The figure with the shorter lever, to which the source's polygons belong; `turned`: by φ, in the direct motion -φ.
struct ShorterLever {
  static constexpr double degree = std::numbers::pi / 180, AC = 0.423, AB = 0.2, CD = 0.714, theta = 23.5 * degree,
                          phi = 5 * degree;
  double turned;

  // B from A: `along` the lever, AC sin θ across it.
  double along() const { return std::sqrt(AB * AB - std::pow(AC * std::sin(theta), 2)); }
  double F_23() const {
    return 50 * CD * std::cos(theta + turned) / ((AC * std::cos(theta) + along()) * std::cos(phi - turned));
  }
  double d() const { return along() * std::cos(turned) - AC * std::sin(theta) * std::sin(turned); }
};
constexpr double half_mm = 1.25;  // N

double retrograde_couple_on_a_shorter_lever() {
  const ShorterLever of{ShorterLever::phi};
  return half_mm * std::round(of.F_23() / half_mm) * of.d();
}
double direct_couple_on_a_shorter_lever() {
  const ShorterLever of{-ShorterLever::phi};
  return (of.F_23() - half_mm) * std::round(100 * of.d()) / 100;
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  constexpr double sliders = 10, levers = 5;  // N
  const std::string polygon = "force polygon";
  const Words one_pair{"only the friction of wedge on rod turned a force: 200 tan(41° ",
                       "solo l'attrito tra cuneo e asta ha ruotato una forza: 200 tg(41° "};
  return {
      {"wedge_collar.P_i", "174", polygon, sliders},
      {"wedge_collar.P_direct", "210", polygon, sliders,
       Explanation{one_pair + Words{"+ 5°) is 207 N, read to half a millimetre, 10 N",
                                    "+ 5°) è 207 N, letta al mezzo millimetro, 10 N"},
                   [] { return 10 * std::round(200 * tangent_of(46) / 10); }}},
      {"wedge_collar.P_retrograde", "145", polygon, sliders,
       Explanation{one_pair + Words{"− 5°)", "− 5°)"}, [] { return 200 * tangent_of(36); }}},
      {"wedge_collar.eta_direct", "0.83", polygon, 0, of_printed("174/210", 174, 210)},
      {"wedge_collar.eta_retrograde", "0.83", polygon, 0, of_printed("145/174", 145, 174)},
      {"double_slider.P_i", "60", polygon, sliders},
      {"double_slider.P_direct", "64", polygon, sliders},
      {"double_slider.P_retrograde", "53", polygon, sliders},
      {"double_slider.eta_direct", "0.94", polygon, 0, of_small_angles("60/64", 60, 64)},
      {"double_slider.eta_retrograde", "0.88", polygon, 0, of_small_angles("53/60", 53, 60)},
      {"sliding_levers.P_i", "490", polygon, levers},
      {"sliding_levers.P_direct", "508", polygon, levers},
      {"sliding_levers.P_retrograde", "462", polygon, levers},
      {"sliding_levers.eta_direct", "0.96", polygon, 0, of_printed("490/508", 490, 508)},
      {"sliding_levers.eta_retrograde", "0.94", polygon, 0, of_printed("462/490", 462, 490)},
      {"fairbairn.M_i", "7.3", polygon, 0,
       Explanation{{"follows from F23 = 66 N of N.4, which belongs to another figure: 66·0.11",
                    "segue dalla F23 = 66 N della N.4, che appartiene a un'altra figura: 66·0,11"},
                   [] { return 66 * 0.11; }}},
      {"fairbairn.M_direct", "8.2", polygon, 0,
       Explanation{{"the polygon belongs to the figure with the shorter lever (8.45 N m): F23 = 69.4 N, read half a "
                    "millimetre short, 1.25 N, times its arm 0.122 m, read as 0.12 m",
                    "il poligono appartiene alla figura con la leva più corta (8,45 N m): F23 = 69,4 N, letta mezzo "
                    "millimetro in meno, 1,25 N, per il braccio 0,122 m, letto 0,12 m"},
                   direct_couple_on_a_shorter_lever}},
      {"fairbairn.M_retrograde", "5.9", polygon, 0,
       Explanation{{"the polygon belongs to the figure with the shorter lever (CD = 0.714 m, AC = 0.423 m, θ = "
                    "23.5°): F'23 = 63.3 N, read to half a millimetre, 1.25 N, times its arm 0.0924 m",
                    "il poligono appartiene alla figura con la leva più corta (CD = 0,714 m, AC = 0,423 m, θ = "
                    "23,5°): F'23 = 63,3 N, letta al mezzo millimetro, 1,25 N, per il braccio 0,0924 m"},
                   retrograde_couple_on_a_shorter_lever}},
      {"fairbairn.eta_direct", "0.9", polygon, 0, of_printed("7.3/8.2", 7.3, 8.2)},
      {"fairbairn.eta_retrograde", "0.8", polygon, 0, of_printed("5.9/7.3", 5.9, 7.3)},
  };
}

}  // namespace epure::friction_efficiency
