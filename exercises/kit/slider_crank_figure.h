// The slider-crank as it is drawn.
#pragma once

#include "exercises/kit/drawn.h"
#include "exercises/kit/plot.h"
#include "exercises/kit/slider_crank.h"

namespace epure {

class Extent;
using DrawnSliderCrank = geometry::SliderCrank<double>;

// The mechanism for drawing: the construction run on Deep, then rounded once.
DrawnSliderCrank drawn_position(const SliderCrankInstant& at);

// Guide and its axis, crank with the circle of A, coupler plate ABC, slider, hinges, and the letters.
void draw_slider_crank(Plot& plot, const DrawnSliderCrank& at, double turns_per_second);

// The mechanism alone, as large as the room allows, beside a diagram that takes its directions from it. Returns its
// scale, for the bars.
Scale draw_small_slider_crank(DrawnSheet& onto, const DrawnSliderCrank& at, const SliderCrankInstant& instant,
                              const drawings::Box& room, const SheetRequest& request);

// Links, plate and points without symbols, for a picture in which the mechanism is small.
void sketch_slider_crank(Plot& plot, const DrawnSliderCrank& at);

// The plate ABC and its sides only.
void draw_plate(Plot& plot, const DrawnSliderCrank& at);

// How far the mechanism reaches from end to end, in metres: what is far or large in its figures is measured by it.
double reach(const DrawnSliderCrank& at);

// What the mechanism covers at a scale: the crank circle, the plate, the guide, and room for symbols and letters.
void include_slider_crank(Extent& extent, const Scale& scale, const DrawnSliderCrank& at);

}  // namespace epure
