// While in scope, doubles are rounded to nearest, whatever scope of intervals is open around it; afterwards as
// before.
//
// For what is not ours: sines of the standard library are meant for this mode. Arb's + - * / are integer arithmetic,
// but functions below its others and below Calcium use doubles in places, and their authors tested them rounding to
// nearest. (No test of ours has seen a difference there: caution.)
#pragma once

#include <CGAL/FPU.h>

namespace epure::geometry {

struct RoundToNearest : CGAL::Protect_FPU_rounding<true> {
  RoundToNearest() : CGAL::Protect_FPU_rounding<true>(CGAL_FE_TONEAREST) {}
};

}  // namespace epure::geometry
