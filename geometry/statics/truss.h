// A pin-jointed plane truss as plain data, and what of it is decided before any force is known: that it lies flat and
// that its bars are as many as hold it, the regions of the plane between them and the forces round the outline (Bow's
// notation), and in which order Cremona's plan finds these regions as points. All of it exactly.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/constructions/plane.h"

namespace epure::geometry {

struct TrussBar {
  std::size_t from, to;  // joints
};

// Held by a hinge and a roller: three unknown components.
struct Truss {
  std::vector<Point<Rational>> joints;
  std::vector<TrussBar> bars;
  std::vector<std::size_t> outside;     // joints of the forces from outside, loads and reactions, one entry a force
  std::vector<std::string> names = {};  // of the joints, for sentences; none: they are counted from 1
};

inline Vector<Rational> along(const Truss& truss, std::size_t bar) {
  return truss.joints[truss.bars[bar].to] - truss.joints[truss.bars[bar].from];
}

// The regions: first those outside, clockwise, then those between bars, in the order in which they are found.
struct BowNotation {
  // Round the outline, clockwise: the region on its left.
  struct Edge {
    std::size_t bar;
    bool is_forward;  // runs from the bar's first joint to its second
    std::size_t region;
  };
  struct Sides {
    std::size_t left, right;  // of a bar, looking from its first joint to its second
  };
  // A region found: it lies beyond these bars from two regions that are known.
  struct Step {
    std::size_t region;
    std::array<std::size_t, 2> bars;
    std::optional<std::size_t> joint;  // of both bars
  };

  std::vector<std::size_t> forces;  // places in Truss::outside; the k-th stands between the regions k and k + 1,
                                    // the last between the last region outside and region 0
  std::vector<Edge> outline;        // from the joint of Truss::outside[0] on, whose force is the last
  std::vector<Sides> sides;         // of each bar
  std::vector<Step> steps;
  std::vector<std::vector<std::size_t>> corners;  // of each region found, counter-clockwise: joints
  std::size_t closing_bar;                        // which no step has used: that its line fits is the plan's check

  std::size_t regions_outside() const { return forces.size(); }
  std::size_t regions() const { return forces.size() + steps.size(); }
};

// Throws Impossible, with what is wrong, for a truss that
//   is no flat figure: joints that coincide, bars that cross or touch or lie on each other, parts that are apart;
//   has a force at a joint that is not on its outline;
//   has fewer bars than hold it (unstable) or more (statically undetermined): b + 3 = 2j;
//   is not simple: of what is left no region has two known neighbours. So are compound trusses (Fink's), those that
//   are unstable for all the number of their bars, and some with a joint inside at which two bars meet and bear
//   nothing.
// Bars are counted from 1 in these sentences, and joints where they have no names. `outside` must not be empty.
BowNotation bow_notation(const Truss& truss);

}  // namespace epure::geometry
