#include "bench/families/coupler_curve_family.h"
#include "bench/families/plane_motion_family.h"
#include "tests/bench/family_against_corpus.h"

namespace epure::tests {

TEST_CASE("poles and circles near, far and at infinity, with every number") {
  hold_against_corpus<bench::PoleAndCircles>();
}

TEST_CASE("curvature at and beside cusps and inflections, with every number") {
  hold_against_corpus<bench::Curvature>();
}

TEST_CASE("a coupler curve at and beside cusps and inflections, with every number") {
  hold_against_corpus<bench::CouplerCurvePoint>();
}

}  // namespace epure::tests
