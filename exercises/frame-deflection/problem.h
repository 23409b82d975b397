// The givens of the exercise, and when they are impossible.
#pragma once

#include <array>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/statics/frame_across.h"

namespace epure::frame_deflection {

std::vector<GivenSpec> stated_givens();

// In SI units. Bars 1 and 3 are rectangles, bar 2 is round.
struct Problem {
  Rational L_1, L_2, phi, s_r, H_r, P, E, nu;

  // O, B, C, A.
  std::array<geometry::FrameBar, 3> bars() const;
  geometry::Point<Rational> loaded() const { return {0, L_1}; }
  std::vector<Rational> lengths() const { return {L_2, L_1, L_2}; }
};

// Throws BadGivens, in one sentence with the value, where the material or the rectangle is none.
Problem problem(const Givens& givens);

}  // namespace epure::frame_deflection
