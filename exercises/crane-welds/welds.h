// The welds between web and flanges of the crane's beam: what is given of them, and when that is impossible.
#pragma once

#include "exercises/kit/crane/crane.h"

namespace epure::crane_welds {

struct Welds {
  Crane crane;
  Rational leg;          // of the fillets, metres
  Rational sigma_amm;    // pascals
  Rational f, f_1, f_2;  // efficiencies

  // Throws BadGivens, in one sentence with the values, also for fillets that find no room under the flange.
  explicit Welds(const Givens& givens);

  static std::vector<GivenSpec> givens();
};

}  // namespace epure::crane_welds
