#include "exercises/kit/slider_crank.h"

#include <fmt/format.h>

#include "geometry/numbers/climb.h"
#include "geometry/numbers/turn.h"

namespace epure {
namespace {

using geometry::Sign;

double number(const Rational& q) { return CGAL::to_double(q); }

void require_plate(const geometry::SliderCrankLengths& of) {
  const auto longer = [](const char* long_name, const Rational& longest, const char* sum, const Rational& others) {
    if (longest > others) {
      throw BadGivens(
          fmt::format("the plate ABC does not close: {} = {:.6g} m is longer than {} = {:.6g} m by {:.3g} m",
                      long_name, number(longest), sum, number(others), number(longest - others)));
    }
  };
  longer("AB", of.l, "AC + BC", of.AC + of.BC);
  longer("AC", of.AC, "AB + BC", of.l + of.BC);
  longer("BC", of.BC, "AB + AC", of.l + of.AC);
}

void require_closure(const SliderCrankInstant& at) {
  const Sign reach = geometry::decide([&]<class T>() {
                       const T A_y = geometry::from_rational<T>(at.lengths.r) * geometry::sine<T>(at.crank);
                       return geometry::square(geometry::from_rational<T>(at.lengths.l)) - geometry::square(A_y);
                     }).sign;
  if (reach == Sign::positive) return;
  if (reach == Sign::undecided) throw geometry::Undecided("whether the coupler reaches the guide");
  const double phi = 360 * number(at.crank.fraction);
  const double A_y = std::abs(number(at.lengths.r) * geometry::sine<geometry::Fast>(at.crank));
  const double l = number(at.lengths.l);
  if (reach == Sign::negative) {
    throw BadGivens(
        fmt::format("the linkage does not close: at crank angle {:.6g}° the pin A is {:.6g} m from the "
                    "guide, and the coupler AB = {:.6g} m is too short by {:.3g} m",
                    phi, A_y, l, A_y - l));
  }
  throw BadGivens(
      fmt::format("at crank angle {:.6g}° the coupler AB = {:.6g} m stands square to the guide, where the "
                  "crank cannot drive the slider: its velocity does not exist",
                  phi, l));
}

}  // namespace

std::vector<GivenSpec> slider_crank_givens(bool with_alpha_2) {
  std::vector<GivenSpec> givens{
      {"r", {"crank A₀A", "manovella A₀A"}, "m", "0.20", Range::positive, "$r$"},
      {"l", {"coupler AB", "biella AB"}, "m", "0.50", Range::positive, "$l$"},
      {"BC", {"side BC of the coupler plate", "lato BC della biella"}, "m", "0.40", Range::positive, "$BC$"},
      {"AC", {"side AC of the coupler plate", "lato AC della biella"}, "m", "0.30", Range::positive, "$AC$"},
      {"n",
       {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
       "rpm",
       "360",
       Range::any,
       "$n$"},
      {"t1",
       {"instant, counted from the outer dead centre", "istante, dal punto morto esterno"},
       "s",
       "1/72",
       Range::not_negative,
       "$t_{1}$"},
  };
  if (with_alpha_2) {
    givens.push_back({"alpha_2",
                      {"angular acceleration of the crank at t1", "accelerazione angolare della manovella a t1"},
                      "rad/s^2",
                      "0",
                      Range::any,
                      "$α_{2}$"});
  }
  return givens;
}

SliderCrankInstant slider_crank_instant(const Givens& givens) {
  SliderCrankInstant at{.lengths = {givens["r"], givens["l"], givens["AC"], givens["BC"]},
                        .turns_per_second = givens["n"] / 60,
                        .t1 = givens["t1"],
                        .crank = {givens["n"] / 60 * givens["t1"]}};
  for (const GivenSpec& spec : givens.specs()) {
    if (spec.symbol == "alpha_2") at.alpha_2 = givens["alpha_2"];
  }
  if (at.turns_per_second == 0) throw BadGivens("n = 0 rpm: the crank must turn, n must differ from 0");
  require_plate(at.lengths);
  require_closure(at);
  // A quarter turn has one of the coordinates exactly zero: a decision on the rational number of quarter turns.
  const Rational quarters = 4 * at.crank.fraction;
  if (quarters.denominator() == 1) {
    const bool even = mpz_even_p(quarters.numerator().mpz()) != 0;
    at.dead_centre = even;
    at.pole_at_infinity = !even;
  }
  // Beyond the square position links of equal length stay folded onto each other, B on A₀.
  const Rational turn = geometry::within_one_turn(at.crank).fraction;
  if (at.lengths.r == at.lengths.l && turn > Rational(1, 4) && turn < Rational(3, 4)) at.dead_centre = true;
  return at;
}

}  // namespace epure
