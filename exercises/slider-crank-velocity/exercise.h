// N.1 of the Sapienza sheets: velocities of the slider-crank by poles and by the polar diagram, polodes, and
// the path of a coupler point.
#pragma once

#include "exercises/kit/linkages/slider_crank_figure.h"
#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::slider_crank_velocity {

std::vector<Printed> printed_by_the_source();

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  SliderCrankInstant instant;
  DrawnSliderCrank at;
  std::optional<Place> P0 = {};  // none when at infinity
  double omega_3 = 0;
  Arrow2 v_A = {}, v_B = {}, v_C = {}, v_M = {}, v_BA = {}, v_CA = {}, v_MA = {};
};
Drawn drawn(const SliderCrankInstant& instant);

// One sheet each; they add to an empty sheet.
void draw_poles(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_polar_diagram(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_polodes(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_coupler_curve(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::slider_crank_velocity
