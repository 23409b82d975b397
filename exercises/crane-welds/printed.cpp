// What the source printed. As in the exercise before, it states 300 kg and computed with 600.
#include "exercises/crane-welds/printed.h"

#include <cmath>

namespace epure::crane_welds {
namespace {

// The source's own formulas, with the mass that gives its numbers. Millimetres, newtons, megapascals.
struct Source {
  double T = -2 * 600 * 9.80665, M = T * 3000, J_x1 = (200 * std::pow(300, 3) - 195 * std::pow(290, 3)) / 12;
  double sigma = -M / J_x1 * 145, tau = T / (5 * 290), jourawsky = T * 200 * 5 * 147.5 / (J_x1 * 5);
};

Printed doubled(const std::string& quantity, const std::string& text, const std::string& formula,
                double megapascals) {
  const Words sentence = Words{"The source states 300 kg and computes with 600 kg, which gives the number: ",
                               "La fonte dichiara 300 kg e calcola con 600 kg, che danno il numero: "} +
                         decimal(formula) + Words{".", "."};
  return {quantity, text, "analytic", 0, Explanation{sentence, [=] { return 1e6 * megapascals; }}};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  const Source source;
  const std::vector<Printed> of_load{
      doubled("sigma_par_M", "95.365e6", "2·600·9.80665·3000·145/J_x1", source.sigma),
      doubled("tau_par_T", "-8.116e6", "−2·600·9.80665/1450", source.tau),
      doubled("tau_par_Jour", "-6.467e6", "−2·600·9.80665·147500/(5 J_x1)", source.jourawsky),
      doubled("sigma_eq", "96.395e6", "√(95.365² + 3·8.116²) MPa",
              std::hypot(source.sigma, std::sqrt(3) * source.tau)),
      doubled("fillet_stress_1", "8.116e6", "2·600·9.80665/1450", -source.tau)};
  std::vector<Printed> all{{"A_1", "3.45e-3", "analytic"},
                           {"A_v1", "1.45e-3", "analytic"},
                           {"J_x1", "5.368e-5", "analytic"},
                           {"S_x1", "1.475e-4", "analytic"},
                           {"a", "2.828e-3", "analytic"},
                           {"sigma_amm_W", "400e6", "analytic"},
                           {"fillet_allowable_1", "400e6", "analytic"}};
  for (const Printed& each : of_load) {
    all.push_back(each);
    all.push_back({"mass_600kg." + each.quantity, each.text, each.route});
  }
  return all;
}

}  // namespace epure::crane_welds
