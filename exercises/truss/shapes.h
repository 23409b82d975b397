// The trusses of this exercise as plain data. A, the hinge, is joint 0 and lies in the origin; B, the roller, is
// joint
// 1. Metres; x to the right, y upwards.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/statics/truss.h"

namespace epure::truss {

enum class Shape { roof, polonceau, warren, pratt, howe, bracket, crane };  // the choices are in its order

struct Built {
  std::vector<geometry::Point<Rational>> joints;
  std::vector<geometry::TrussBar> bars;
  std::vector<std::size_t> loaded;    // by P, from one end to the other
  std::vector<std::size_t> windward;  // by W
};

inline constexpr int least_panels = 2, most_panels = 8, most_bars = 4 * most_panels - 1;

bool has_panels(Shape shape);
// All but Warren's girder and the bracket are the same on both sides of the middle.
bool needs_even_panels(Shape shape);
// The wall bracket hangs on a wall: its roller rolls up and down.
bool stands_on_wall(Shape shape);

// `panels` within the limits above.
Built built(Shape shape, const Rational& span, const Rational& height, int panels);

}  // namespace epure::truss
