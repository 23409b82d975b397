// Bending and torsion of a chain of bars, each at right angles to the left of the one before, from the clamp
// outwards; displacements by virtual work, whose integrals Simpson's rule gives exactly. The second route to
// statics/frame_across.h, which cuts the chain from its end.
//
// The first bar lies along x, the next along y; z upwards.
#pragma once

#include <vector>

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// In the end of bar `bar`, counted from 0.
struct EndAction {
  std::size_t bar;
  Rational force = 0, couple_x = 0, couple_y = 0;  // upwards; components of a vector
};

struct ClampAction {
  Rational force, couple_x, couple_y;
};

// Bending grows in proportion to the way, torsion stays.
struct BarMoments {
  Rational bending_at_start, bending_at_end, torsion;
  Rational bending_in_middle() const { return (bending_at_start + bending_at_end) / 2; }
};

struct ChainOfBars {
  std::vector<Rational> lengths;

  ClampAction at_clamp(const EndAction& action) const {
    Rational x = 0, y = 0;
    for (std::size_t i = 0; i <= action.bar; ++i) {
      const int sense = i % 4 < 2 ? 1 : -1;
      (i % 2 == 0 ? x : y) += sense * lengths[i];
    }
    return {-action.force, -action.couple_x - y * action.force, -action.couple_y + x * action.force};
  }

  // A corner makes bending of torsion, and torsion of bending. Beyond the action the chain is at rest.
  std::vector<BarMoments> moments(const EndAction& action) const {
    const ClampAction clamp = at_clamp(action);
    std::vector<BarMoments> all;
    Rational bending = clamp.couple_y, torsion = clamp.couple_x;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (i > action.bar) {
        all.push_back({0, 0, 0});
        continue;
      }
      const Rational end = bending + clamp.force * lengths[i];
      all.push_back({bending, end, torsion});
      bending = -torsion;
      torsion = end;
    }
    return all;
  }
};

// ∫ M m over a bar.
struct Work {
  Rational bending, torsion;
};
inline Work work(const BarMoments& M, const BarMoments& m, const Rational& length) {
  return {(M.bending_at_start * m.bending_at_start + 4 * M.bending_in_middle() * m.bending_in_middle() +
           M.bending_at_end * m.bending_at_end) *
              length / 6,
          M.torsion * m.torsion * length};
}

}  // namespace epure::geometry::analytic
