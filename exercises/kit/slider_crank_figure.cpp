#include "exercises/kit/slider_crank_figure.h"

#include <cmath>
#include <numbers>

#include "exercises/kit/fit.h"

namespace epure {

using geometry::Deep;

DrawnSliderCrank drawn_position(const SliderCrankInstant& at) {
  return deeply([&]() -> DrawnSliderCrank {
    const auto exact = at.position<Deep>();
    return {to_double(exact.A0), to_double(exact.A), to_double(exact.B),
            to_double(exact.C),  to_double(exact.M), geometry::guide_of_slider_crank<double>()};
  });
}

void draw_plate(Plot& plot, const DrawnSliderCrank& at) {
  plot.area({at.A, at.B, at.C}, Meaning::plate);
  plot.segment(at.A, at.C, Meaning::link);
  plot.segment(at.B, at.C, Meaning::link);
  plot.segment(at.A, at.B, Meaning::link);
}

void draw_slider_crank(Plot& plot, const DrawnSliderCrank& at, double turns_per_second) {
  const double r = std::hypot(at.A.x, at.A.y);
  const Place left{std::min(-r, at.B.x), 0}, right{std::max(r, at.B.x), 0};
  plot.long_segment(left, right, 8, Meaning::axis);
  plot.circle(at.A0, r, Meaning::axis);
  const drawings::Point b = plot.at(at.B);
  plot.mark(drawings::Guide{{b.x - 14, b.y}, {b.x + 10, b.y}});
  draw_plate(plot, at);
  plot.segment(at.A0, at.A, Meaning::link);
  plot.mark(drawings::Slider{b, 0});
  plot.mark(drawings::FixedHinge{plot.at(at.A0)});
  for (const Place& P : {at.A, at.B, at.C}) plot.hinge(P);
  plot.dot(at.M, Meaning::link);

  const double start = std::atan2(at.A.y, at.A.x), sense = turns_per_second > 0 ? 1 : -1;
  constexpr double gap = 0.35, sweep = 1.3;  // radians: the arc arrow stands ahead of the crank, clear of it
  plot.mark(drawings::Rotation{plot.at(at.A0), 9, start + sense * gap, start + sense * (gap + sweep)});
  const double middle = start + sense * (gap + sweep / 2);
  const double out = 10 / plot.scale().mm_per_unit;
  plot.label("$ω_{2}$", {out * std::cos(middle), out * std::sin(middle)}, at.A0);

  const Place inside{(at.A.x + at.B.x + at.C.x) / 3, (at.A.y + at.B.y + at.C.y) / 3};
  plot.label("$A_{0}$", at.A0, Place{at.A.x, at.A.y});
  for (const auto& [name, P] : {std::pair{"$A$", at.A}, std::pair{"$B$", at.B}, std::pair{"$C$", at.C}}) {
    plot.label(name, P, inside);
  }
  plot.label("$M$", at.M, at.C);
}

void sketch_slider_crank(Plot& plot, const DrawnSliderCrank& at) {
  const double r = std::hypot(at.A.x, at.A.y);
  plot.long_segment({std::min(-r, at.B.x), 0}, {std::max(r, at.B.x), 0}, 3, Meaning::axis);
  draw_plate(plot, at);
  plot.segment(at.A0, at.A, Meaning::link);
  const Place inside{(at.A.x + at.B.x + at.C.x) / 3, (at.A.y + at.B.y + at.C.y) / 3};
  for (const auto& [name, P] :
       {std::pair{"$A_{0}$", at.A0}, std::pair{"$A$", at.A}, std::pair{"$B$", at.B}, std::pair{"$C$", at.C}}) {
    plot.dot(P, Meaning::link);
    plot.label(name, P, inside);
  }
}

Scale draw_small_slider_crank(DrawnSheet& onto, const DrawnSliderCrank& at, const SliderCrankInstant& instant,
                              const drawings::Box& room, const SheetRequest& request) {
  const Fit fit = fit_lengths(room, request, 1000 / reach(at), [&](const Scale& scale) {
    Extent extent;
    include_slider_crank(extent, scale, at);
    return extent.box();
  });
  Plot plot(onto, fit.origin, fit.scale);
  draw_slider_crank(plot, at, CGAL::to_double(instant.turns_per_second));
  return fit.scale;
}

double reach(const DrawnSliderCrank& at) { return std::abs(at.B.x) + std::hypot(at.A.x, at.A.y); }

void include_slider_crank(Extent& extent, const Scale& scale, const DrawnSliderCrank& at) {
  const double r = std::hypot(at.A.x, at.A.y);
  extent.include(scale, {-r, -r}, 2);
  extent.include(scale, {r, r}, 2);
  extent.include(scale, at.C, 8);
  const drawings::Point b{scale.mm_per_unit * at.B.x, scale.mm_per_unit * at.B.y};
  extent.include(b.x - 14, b.y - 6);
  extent.include(b.x + 10, b.y + 6);
}

}  // namespace epure
