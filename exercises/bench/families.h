// Every family of the hard corpora.
#pragma once

#include "exercises/bench/families/cancelling.h"
#include "exercises/bench/families/coupler_curve.h"
#include "exercises/bench/families/four_bar.h"
#include "exercises/bench/families/gears.h"
#include "exercises/bench/families/meeting.h"
#include "exercises/bench/families/plane_motion.h"
#include "exercises/bench/families/roulette.h"
#include "exercises/bench/families/slider_crank.h"

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
