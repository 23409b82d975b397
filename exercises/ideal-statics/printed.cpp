// What the source printed, and why it is off where it is.
//
// Reading errors: half a millimetre for each point set and each length read, half a degree for each direction drawn,
// added in absolute value, first order.
//   Forces: wedge 200 N a centimetre and double slider 200 N a centimetre (150 N = 0.75 cm): half a millimetre is
//     10 N. Levers 100 N a centimetre: 5 N. Fairbairn 25 N a centimetre: 1.25 N.
//   Levers at 1 : 5, half a millimetre is 2.5 mm: P by arms of 228 mm and 112 mm read with it is off by
//     2.5/228 + 2.5/112 of 485 N, which is 16 N, the other four lengths left out.
//   Fairbairn at 1 : 10, half a millimetre is 5 mm. CB changes by 2.08 of an error of AB, by 0.21 of one of AC and by
//     8.1 mm for half a degree of θ, in all 19.6 mm; over cos θ, and 5 mm for the ruler: P24C 26 mm, P24A as much and
//     5 mm of AC. d changes by 2.08 of AB, 0.71 of AC, 6.6 mm of θ, and 5 mm for the ruler: 26 mm.
#include <cmath>
#include <numbers>

#include "exercises/ideal-statics/exercise.h"
#include "exercises/kit/statement/decimal.h"

namespace epure::ideal_statics {
namespace {

constexpr double sine_of(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }
constexpr double cosine_of(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

// F23 on the figure with the shorter lever.
double F_23_on_a_shorter_lever() {
  const double AC = 0.423, AB = 0.2, CD = 0.714, s = sine_of(23.5), c = cosine_of(23.5);
  return 50 * CD * c / (AC * c + std::sqrt(AB * AB - AC * s * AC * s));
}

// 2 R'13 taken from R''13 would leave 1 - 0.035/0.085 = 0.588 of R''13 - R'13. That it was so is a conjecture.
constexpr double drawn_too_small = 0.59;
Explanation too_small(std::function<double()> value, const Words& more) {
  return {Words{"a conjecture: the collar's two forces are right, but R'13 was taken twice from R''13, which leaves "
                "0.588 of R''13 - R'13 and with it, drawn as 0.59, of the wedge's triangle: ",
                "una congettura: le due forze del collare sono giuste, ma R'13 fu tolta due volte da R''13, il che "
                "lascia 0,588 di R''13 - R'13 e con essa, disegnato come 0,59, del triangolo del cuneo: "} +
              more,
          std::move(value)};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  constexpr double wedge = 10, slider = 10, levers = 5, fairbairn = 1.25;  // N
  const std::string polygon = "force polygon";
  const Words not_balanced{" (the whole mechanism upright: R12 must carry Q = 200 N)",
                           " (l'intero meccanismo in verticale: R12 deve portare Q = 200 N)"};
  return {
      {"wedge_collar.P", "174", polygon, wedge},
      {"wedge_collar.R_12", "200", polygon, wedge},
      {"wedge_collar.R_13", "174", polygon, wedge},
      {"wedge_collar.P_virtual_work", "174", "velocity diagram"},
      {"wedge_collar_two_point.P", "103", polygon, wedge,
       too_small([] { return drawn_too_small * 174; }, {"0.59·174", "0,59·174"})},
      {"wedge_collar_two_point.R_12", "120", polygon, wedge,
       too_small([] { return 10 * std::round(drawn_too_small * 200 / 10); },
                 Words{"0.59·200, read to half a millimetre, 10 N", "0,59·200, letta al mezzo millimetro, 10 N"} +
                     not_balanced)},
      {"wedge_collar_two_point.R_13_upper", "72", polygon, wedge},
      {"wedge_collar_two_point.R_13_lower", "245", polygon, wedge},
      {"double_slider.P", "60", polygon, slider},
      {"double_slider.R_12", "60", polygon, slider},
      {"double_slider.R_14", "150", polygon, slider},
      {"double_slider.P_virtual_work", "58", "poles"},
      {"sliding_levers.P", "490", polygon, levers},
      {"sliding_levers.R_12", "436", polygon, levers},
      {"sliding_levers.R_13", "120", polygon, levers},
      {"sliding_levers.P_virtual_work", "480", "poles", 16},
      {"fairbairn.P24C", "0.53", "poles", 0.026},
      {"fairbairn.P24A", "0.10", "poles", 0.031},
      {"fairbairn.F_23", "66", polygon, fairbairn,
       Explanation{{"the polygon belongs to another figure than the printed lengths: with CD = 0.714 m, AC = 0.423 m "
                    "and θ = 23.5°, as the other numbers of the polygon want, F23 = F·CD cos θ/CB",
                    "il poligono appartiene a una figura diversa dalle lunghezze stampate: con CD = 0,714 m, AC = "
                    "0,423 m e θ = 23,5°, come vogliono gli altri numeri del poligono, F23 = F·CD cos θ/CB"},
                   F_23_on_a_shorter_lever}},
      {"fairbairn.d", "0,11", polygon, 0.026},
      {"fairbairn.M", "7,3", polygon, 0,
       Explanation{{"follows from the printed F23 = 66 N, itself of another figure: 66·0.11",
                    "segue dalla F23 = 66 N stampata, essa stessa di un'altra figura: 66·0,11"},
                   [] { return 66 * 0.11; }}},
      {"fairbairn.M_virtual_work", "8.3", "poles", 0,
       Explanation{{"with the lengths as printed and cos 23° = 0.921: 50·0.95·0.921/(0.53/0.10)",
                    "con le lunghezze stampate e cos 23° = 0,921: 50·0,95·0,921/(0,53/0,10)"},
                   [] { return 50 * 0.95 * 0.921 / (0.53 / 0.10); }}},
  };
}

}  // namespace epure::ideal_statics
