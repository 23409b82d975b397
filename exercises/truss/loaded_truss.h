// The truss of the givens with its loads, decided: the regions of Bow's notation and their order.
#pragma once

#include "exercises/truss/shapes.h"

namespace epure::truss {

struct LoadedTruss {
  Shape shape;
  geometry::Truss truss;  // outside: the hinge, the roller, then the loads
  geometry::BowNotation bow;
  Rational P, W;
  Angle beta;                      // of W, from +x
  Angle roller;                    // of the roller's force, from +x
  std::vector<bool> has_P, has_W;  // of each load: by which of them

  // Throws BadGivens, naming value and condition, for panels that this truss cannot have, for one that is not flat,
  // held or loaded.
  explicit LoadedTruss(const Givens& givens);

  std::size_t bars() const { return truss.bars.size(); }
  std::size_t loads() const { return has_P.size(); }
};

std::vector<GivenSpec> given_specs();

}  // namespace epure::truss
