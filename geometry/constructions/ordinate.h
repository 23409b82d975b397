// Where a line stands above a place on the x axis.
#pragma once

#include "geometry/constructions/plane.h"

namespace epure::geometry {

// Throws Undecided unless the line is proved not to be upright.
template <class T>
T ordinate(const Line<T>& l, const T& x) {
  return finite(meet(l, line(Point<T>{x, T(0)}, Vector<T>{T(0), T(1)}))).y;
}

}  // namespace epure::geometry
