// What the exercises on the centred slider-crank share: their givens, when these are impossible, and the instant.
#pragma once

#include "exercises/kit/givens.h"
#include "geometry/mechanisms/slider_crank.h"
#include "geometry/numbers/numbers.h"

namespace epure {

// r, l, AC, BC in metres, n in rpm, t1 in seconds; alpha_2 in rad/s² where the exercise has it.
std::vector<GivenSpec> slider_crank_givens(bool with_alpha_2);

struct SliderCrankInstant {
  geometry::SliderCrankLengths lengths;
  Rational turns_per_second, t1;
  geometry::Turn crank;  // n t1, from the outer dead centre
  Rational alpha_2{0};

  // Special positions, decided exactly.
  bool pole_at_infinity = false;  // the crank is square to the guide
  bool dead_centre = false;       // crank and coupler in line: the pole is B

  // 2 π n. The exact numbers work with unit crank speed where nothing but signs is asked and α₂ = 0, which keeps π
  // out.
  template <class T>
  T omega_2() const {
    constexpr bool exact = std::is_same_v<T, geometry::Exact> || std::is_same_v<T, geometry::Calcium>;
    if (exact && alpha_2 == 0) return T(turns_per_second > 0 ? 1 : -1);
    return geometry::from_rational<T>(2 * turns_per_second) * geometry::pi<T>();
  }
  template <class T>
  geometry::SliderCrank<T> position() const {
    return geometry::slider_crank<T>(lengths, {geometry::cosine<T>(crank), geometry::sine<T>(crank)});
  }
};

// Throws BadGivens, in one sentence with the values, when n = 0, the plate ABC or the linkage does not close, or the
// coupler is square to the guide, where the crank cannot drive the slider; Undecided when no number can tell.
SliderCrankInstant slider_crank_instant(const Givens& givens);

}  // namespace epure
