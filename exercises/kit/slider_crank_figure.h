// The slider-crank as it is drawn.
#pragma once

#include "exercises/kit/plot.h"
#include "exercises/kit/slider_crank.h"

namespace epure {

using DrawnSliderCrank = geometry::SliderCrank<double>;

// The mechanism for drawing: the exact text run with 128 bits, then rounded once.
DrawnSliderCrank drawn_position(const SliderCrankInstant& at);

double to_double(const geometry::Deep& x);
Place to_double(const geometry::Point<geometry::Deep>& P);
Arrow2 to_double(const geometry::Vector<geometry::Deep>& v);

// Runs `find`, a callable of the number Deep, at the precision drawings are made with.
template <class Find>
auto deeply(const Find& find) {
  const geometry::Arithmetic<geometry::Deep> bits(256);
  return find();
}

// Guide and its axis, crank with the circle of A, coupler plate ABC, slider, hinges, and the letters.
void draw_slider_crank(Plot& plot, const DrawnSliderCrank& at, double turns_per_second);

// The triangle ABC and its letters only.
void draw_plate(Plot& plot, const DrawnSliderCrank& at);

// What the mechanism covers at a scale: the crank circle, the plate, the guide, and room for symbols and letters.
void include_slider_crank(class Extent& extent, const Scale& scale, const DrawnSliderCrank& at);

}  // namespace epure
