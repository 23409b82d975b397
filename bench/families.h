// Every family of the hard corpora.
#pragma once

#include "bench/families/cancelling_family.h"
#include "bench/families/coupler_curve_family.h"
#include "bench/families/four_bar_family.h"
#include "bench/families/gears_family.h"
#include "bench/families/meeting_family.h"
#include "bench/families/plane_motion_family.h"
#include "bench/families/roulette_family.h"
#include "bench/families/slider_crank_family.h"

namespace epure::bench {

// visit(Family{}) for each.
template <class Visit>
void for_each_family(const Visit& visit) {
  visit(FourBarPosition{});
  visit(FourBarSecondOrder{});
  visit(SliderCrankSecondOrder{});
  visit(PoleAndCircles{});
  visit(Curvature{});
  visit(PolodePoint{});
  visit(CouplerCurvePoint{});
  visit(RoulettePoint{});
  visit(GearFlankPoint{});
  visit(VectorPolygon{});
  visit(Circles{});
  visit(Cancelling{});
}

}  // namespace epure::bench
