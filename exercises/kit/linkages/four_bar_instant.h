// What the exercises on the four-bar linkage share: when their givens are impossible, and the instant.
#pragma once

#include "exercises/kit/linkages/driving_crank.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/four_bar_formulas.h"
#include "geometry/mechanisms/four_bar.h"

namespace epure {

inline constexpr Phrase crank_parallel_to_rocker{
    "the pole of the coupler is at infinity: crank and rocker are parallel",
    "il polo della biella è all'infinito: manovella e bilanciere sono paralleli"};

// The side of a directed line on which a point lies, as a given: of A -> B₀ for B, of A -> B for a plate's corner.
// `point` and `line` are rich text.
GivenSpec side_given(const std::string& symbol, const Words& meaning, const std::string& stated,
                     const std::string& point, const std::string& line);
geometry::Side side_chosen(const Givens& givens, const std::string& symbol);

struct FourBarInstant {
  geometry::FourBarLengths lengths;
  geometry::Side side = geometry::Side::left;  // B's, of A -> B₀
  Angle n;                                     // of a second
  Angle crank;                                 // from +x
  Angle alpha_2 = {};

  // Special positions, decided exactly.
  bool pole_at_infinity = false;  // crank and rocker are parallel, and not in one line
  bool dead_centre = false;       // crank and coupler are in line: the rocker rests, and the pole is B
  bool one_line = false;          // all four hinges are in line: crank, coupler and rocker too

  template <class T>
  T omega_2() const {
    return crank_speed<T>(n, alpha_2);
  }
  template <class T>
  geometry::FourBar<T> position() const {
    return geometry::four_bar<T>(lengths, {geometry::cosine<T>(crank), geometry::sine<T>(crank)}, side);
  }

  geometry::analytic::FourBar analytic_lengths() const {
    return {lengths.A0A, lengths.AB, lengths.B0B, lengths.x_B0, lengths.y_B0};
  }
  geometry::analytic::Branch analytic_branch() const {
    return side == geometry::Side::left ? geometry::analytic::Branch::left : geometry::analytic::Branch::right;
  }
};

// Decides the special positions. Throws BadGivens, in one sentence with the values, when the crank does not turn, B₀
// lies on A₀, the linkage does not close, or the crank is at a limit position, where it cannot drive the rocker;
// Undecided when no number can tell.
void require_drivable(FourBarInstant& at);

}  // namespace epure
