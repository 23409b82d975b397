// N.2 of the Sapienza sheets: accelerations of the centred slider-crank by the polar diagram and by poles, the
// inflection and stationarity circles, and centres of curvature by Euler-Savary.
#pragma once

#include "exercises/kit/exercise.h"
#include "exercises/kit/slider_crank.h"
#include "exercises/kit/slider_crank_figure.h"

namespace epure::slider_crank_acceleration {

std::vector<Printed> printed_by_the_source();

// The path of a point of the coupler to the second order.
struct Curvature {
  std::optional<Place> on_circle;  // X', none when at infinity
  std::optional<Place> centre;     // Ω_X, none when the path is straight there
};

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  SliderCrankInstant instant;
  DrawnSliderCrank at;
  double omega_2 = 0, omega_3 = 0, alpha_3 = 0;
  std::optional<Place> P0 = {}, J = {}, K = {};  // none when at infinity
  DrawnCycle inflection = {}, stationarity = {};
  Arrow2 a_A_n = {}, a_A_t = {}, a_A = {}, a_B = {}, a_C = {}, a_M = {}, a_BA_n = {}, a_BA_t = {}, a_CA = {},
         a_MA = {};
  Curvature C = {}, M = {};
};
Drawn drawn(const SliderCrankInstant& instant);

// One sheet each; they add to an empty sheet.
void draw_polar_diagram(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_circles(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_poles(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_curvature(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

// The four points the exercise follows.
struct Followed {
  std::string symbol, distance_from_K, acceleration;
  Place at;
  Arrow2 a;
};
std::vector<Followed> followed(const Drawn& figure);
double greatest_acceleration(const Drawn& figure);

}  // namespace epure::slider_crank_acceleration
