// Every family of the hard corpora.
#pragma once

#include "bench/families/cancelling.h"
#include "bench/families/coupler_curve.h"
#include "bench/families/four_bar.h"
#include "bench/families/gears.h"
#include "bench/families/meeting.h"
#include "bench/families/plane_motion.h"
#include "bench/families/roulette.h"
#include "bench/families/slider_crank.h"

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
