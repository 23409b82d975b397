// The slider-crank as it is drawn.
#pragma once

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/plot.h"
#include "exercises/kit/panels/rounded.h"

namespace epure {

class Extent;
using DrawnSliderCrank = geometry::SliderCrank<double>;

// The mechanism for drawing: the construction run on Deep, then rounded once.
DrawnSliderCrank drawn_position(const SliderCrankInstant& at);

// The guide as axes for drawing: unit vectors along it and to its left, and the foot of A₀ on it.
struct GuideAxes {
  Arrow2 along, left;
  Place foot;

  explicit GuideAxes(const DrawnSliderCrank& at);
  Place at(double abscissa, double ordinate = 0) const {
    return {foot.x + abscissa * along.x + ordinate * left.x, foot.y + abscissa * along.y + ordinate * left.y};
  }
  double abscissa(const Place& P) const { return (P.x - foot.x) * along.x + (P.y - foot.y) * along.y; }
  double ordinate(const Place& P) const { return (P.x - foot.x) * left.x + (P.y - foot.y) * left.y; }
};

// Between which crank angles the linkage closes; empty when the crank turns fully.
std::string swing_in_words(const SliderCrankInstant& at, Language language);

// How a direction is named in a polygon: "∥ A₀B", or by the guide when it does not pass A₀.
std::string parallel_to_guide(const SliderCrankInstant& at, Language language);

// Guide and its axis, crank with the circle of A, coupler plate ABC, slider, hinges, and the letters.
void draw_slider_crank(Plot& plot, const DrawnSliderCrank& at, int sense);

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

// For the sheets that serve every mechanism.
class SliderCrankFigure : public MechanismFigure {
 public:
  SliderCrankFigure(const DrawnSliderCrank& at, int sense) : at_(at), sense_(sense) {}

  void draw(Plot& plot) const override { draw_slider_crank(plot, at_, sense_); }
  void sketch(Plot& plot) const override { sketch_slider_crank(plot, at_); }
  void include(Extent& extent, const Scale& scale) const override { include_slider_crank(extent, scale, at_); }
  std::vector<Place> corners() const override { return {at_.A0, at_.A, at_.B, at_.C}; }
  double reach() const override { return epure::reach(at_); }

 private:
  DrawnSliderCrank at_;
  int sense_;
};

}  // namespace epure
