#include "geometry/numbers/growing.h"

#include "geometry/numbers/ball.h"

namespace epure::geometry {
namespace {

// At one point where the function is not zero: with more bits until as many as asked are left.
void at_point(arb_t result, BallFunction function, const arb_t x, long bits) {
  for (long working = bits + 32; working < 64 * (bits + 4096); working *= 2) {
    function(result, x, working);
    if (arb_rel_accuracy_bits(result) >= bits) return;
  }
  throw Undecided("a difference that cancels beyond all bits", "una differenza che si cancella oltre ogni bit");
}

}  // namespace

Deep growing(BallFunction function, const Deep& x, int at_zero, int there) {
  const long bits = Arithmetic<Deep>::bits();
  Ball end, ends[2], result;
  Float lower_and_upper[2];
  arb_get_interval_arf(lower_and_upper[0].value, lower_and_upper[1].value, x.ball(), arb_bits(x.ball()) + bits + 64);
  for (int i : {0, 1}) {
    arb_set_arf(end.value, lower_and_upper[i].value);
    if (arb_equal_si(end.value, at_zero))
      arb_set_si(ends[i].value, there);
    else
      at_point(ends[i].value, function, end.value, bits);
  }
  arb_union(result.value, ends[0].value, ends[1].value, bits + 16);
  return Deep::from_ball(result.value);
}

}  // namespace epure::geometry
