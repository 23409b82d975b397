// A truss with its supports and loads, decided: the regions of Bow's notation and their order.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/statics/truss.h"

namespace epure::trusses {

// A force of these components, and beside it one of this size along an angle from +x.
struct Load {
  std::size_t joint;
  geometry::Vector<Rational> components;
  Rational size;
  Angle along;
  std::string label;     // "$\\it{P}$"
  bool is_told = false;  // by its components, as no given is its size
};

struct LoadedTruss {
  geometry::Truss truss;  // with its joints' names, "A", "C3"; outside: the hinge, the roller, then the loads
  Angle roller;           // of its force, from +x
  std::vector<Load> loads;
  geometry::BowNotation bow;

  // `held`: as above, but for its loads, which are added. Throws Impossible, with what is wrong, for a truss that is
  // not flat, not held or not simple.
  LoadedTruss(geometry::Truss held, const Angle& roller, std::vector<Load> loads);

  std::size_t bars() const { return truss.bars.size(); }
  std::size_t hinge() const { return truss.outside[0]; }
  std::size_t roller_at() const { return truss.outside[1]; }
};

}  // namespace epure::trusses
