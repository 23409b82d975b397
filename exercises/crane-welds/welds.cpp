#include "exercises/crane-welds/welds.h"

namespace epure::crane_welds {

std::vector<GivenSpec> Welds::givens() {
  std::vector<GivenSpec> all = Crane::givens();
  const std::vector<GivenSpec> of_welds{
      {"b", {"leg of the fillets", "lato dei cordoni"}, "mm", "4", Range::positive, "$b$"},
      {"sigma_amm",
       {"allowable stress of the base material", "tensione ammissibile del materiale base"},
       "MPa",
       "500",
       Range::positive,
       "$σ_{amm}$"},
      {"f", {"efficiency, full penetration", "efficienza, piena penetrazione"}, "1", "0.8", Range::positive, "$f$"},
      {"f_1",
       {"efficiency of fillets, first check", "efficienza dei cordoni, prima verifica"},
       "1",
       "0.8",
       Range::positive,
       "$f_{1}$"},
      {"f_2",
       {"efficiency of fillets, second check", "efficienza dei cordoni, seconda verifica"},
       "1",
       "0.7",
       Range::positive,
       "$f_{2}$"}};
  all.insert(all.end(), of_welds.begin(), of_welds.end());
  return all;
}

Welds::Welds(const Givens& givens)
    : crane(givens),
      leg(givens["b"] / 1000),
      sigma_amm(1000000 * givens["sigma_amm"]),
      f(givens["f"]),
      f_1(givens["f_1"]),
      f_2(givens["f_2"]) {
  const Rational room = (crane.beam.b - crane.beam.s) / 2;
  if (leg > room)
    throw BadGivens(format_words(
        "b = {} mm: the fillets find no room under the flange, which reaches (b_1 - s_1)/2 = {} mm beyond the web",
        "b = {} mm: i cordoni non trovano posto sotto la piattabanda, che sporge dall'anima di (b_1 - s_1)/2 = {} mm",
        decimal(CGAL::to_double(1000 * leg), 6), decimal(CGAL::to_double(1000 * room), 6)));
}

}  // namespace epure::crane_welds
