// N.2 of the Sapienza sheets: accelerations of the slider-crank by the polar diagram and by poles, the
// inflection and stationarity circles, and centres of curvature by Euler-Savary.
#pragma once

#include "exercises/kit/linkages/slider_crank_figure.h"
#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::slider_crank_acceleration {

std::vector<Printed> printed_by_the_source();

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  SliderCrankInstant instant;
  DrawnSliderCrank at;
  double omega_2 = 0;
  SliderCrankFigure mechanism;
  CouplerFigure coupler;  // its points: A, B, C, M; refers to `mechanism`
  Arrow2 a_A_n = {}, a_A_t = {}, a_A = {}, a_B = {}, a_C = {}, a_M = {}, a_BA_n = {}, a_BA_t = {}, a_CA = {},
         a_MA = {};
};
// Kept where it is made: the coupler refers to the mechanism.
std::unique_ptr<Drawn> drawn(const SliderCrankInstant& instant);

// One sheet each; they add to an empty sheet.
void draw_polar_diagram(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_circles(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_poles(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_curvature(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::slider_crank_acceleration
