#include "exercises/kit/linkages/slider_crank_figure.h"

#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {

using geometry::Deep;

DrawnSliderCrank drawn_position(const SliderCrankInstant& at) {
  return deeply([&]() -> DrawnSliderCrank {
    const auto exact = at.position<Deep>();
    return {to_double(exact.A0), to_double(exact.A),
            to_double(exact.B),  to_double(exact.C),
            to_double(exact.M),  {to_double(exact.guide.a), to_double(exact.guide.b), to_double(exact.guide.c)}};
  });
}

GuideAxes::GuideAxes(const DrawnSliderCrank& at)
    : along{at.guide.b, -at.guide.a},
      left{at.guide.a, at.guide.b},
      foot{-at.guide.c * at.guide.a, -at.guide.c * at.guide.b} {}

std::string swing_in_words(const SliderCrankInstant& at, Language language) {
  std::string text;
  for (const AngleRange& range : crank_swings(at)) {
    const Words sentence = text.empty() ? Words{"The crank cannot turn fully: $φ$ from {}° to {}°",
                                                "La manovella non compie "
                                                "il giro: $φ$ da {}° a {}°"}
                                        : Words{" or from {}° to {}°", " o da {}° a {}°"};
    text += fmt::format(fmt::runtime(sentence.in(language)), figures(range.from, 4, language),
                        figures(range.to, 4, language));
  }
  return text.empty() ? text : text + ".";
}

std::string parallel_to_guide(const SliderCrankInstant& at, Language language) {
  if (!at.is_offset()) return "∥ $A_{0}B$";
  return Words{"∥ guide", "∥ guida"}.in(language);
}

namespace {

constexpr double guide_behind = 14, guide_ahead = 10;  // mm: the hatched line on both sides of the slider

double radius_of_crank(const DrawnSliderCrank& at) { return std::hypot(at.A.x, at.A.y); }

// The guide's axis, from end to end of the mechanism.
void draw_guide_axis(Plot& plot, const DrawnSliderCrank& at, double beyond) {
  const GuideAxes guide(at);
  const double r = radius_of_crank(at), b = guide.abscissa(at.B);
  plot.long_segment(guide.at(std::min(-r, b)), guide.at(std::max(r, b)), beyond, Meaning::axis);
}

// On the paper from P along the guide and to its left, in mm.
drawings::Point beside(drawings::Point p, const GuideAxes& guide, double along, double left) {
  return {p.x + along * guide.along.x + left * guide.left.x, p.y + along * guide.along.y + left * guide.left.y};
}

// Where the offset is dimensioned: outside of the crank circle, on the side away from B.
struct OffsetDimension {
  drawings::Point at_A0, at_guide;
};
std::optional<OffsetDimension> offset_dimension(const DrawnSliderCrank& at, const Scale& scale,
                                                drawings::Point origin) {
  constexpr double shortest = 3;  // mm
  const GuideAxes guide(at);
  const double e = -at.guide.c * scale.mm_per_unit;
  if (std::abs(e) < shortest) return {};
  const double side = guide.abscissa(at.B) > 0 ? -1 : 1;
  const drawings::Point foot_of_A0 = beside(origin, guide, 0, e);
  const double out = side * (radius_of_crank(at) * scale.mm_per_unit + 6);
  return OffsetDimension{beside(origin, guide, out, 0), beside(foot_of_A0, guide, out, 0)};
}

// A₀'s own axis beside the guide's, and the distance between them.
void draw_offset(Plot& plot, const DrawnSliderCrank& at) {
  const auto dimension = offset_dimension(at, plot.scale(), plot.at(at.A0));
  if (!dimension) return;
  const GuideAxes guide(at);
  const Place end = plot.from_paper(dimension->at_A0);
  plot.long_segment(end, at.A0, 2, Meaning::axis);
  plot.long_segment(plot.from_paper(dimension->at_guide), guide.foot, 2, Meaning::axis);
  plot.mark(drawings::Dimension{dimension->at_A0, dimension->at_guide, 0, "$e$"});
}

}  // namespace

void draw_plate(Plot& plot, const DrawnSliderCrank& at) {
  plot.area({at.A, at.B, at.C}, Meaning::plate);
  plot.segment(at.A, at.C, Meaning::link);
  plot.segment(at.B, at.C, Meaning::link);
  plot.segment(at.A, at.B, Meaning::link);
}

void draw_slider_crank(Plot& plot, const DrawnSliderCrank& at, int sense) {
  const GuideAxes guide(at);
  draw_guide_axis(plot, at, 8);
  draw_offset(plot, at);
  plot.circle(at.A0, radius_of_crank(at), Meaning::axis);
  const drawings::Point b = plot.at(at.B);
  plot.mark(drawings::Guide{beside(b, guide, -guide_behind, 0), beside(b, guide, guide_ahead, 0)});
  draw_plate(plot, at);
  plot.segment(at.A0, at.A, Meaning::link);
  plot.mark(drawings::Slider{b, std::atan2(guide.along.y, guide.along.x)});
  plot.mark(drawings::FixedHinge{plot.at(at.A0), direction_of_support(at.A0, at.A)});
  for (const Place& P : {at.A, at.B, at.C}) plot.hinge(P);
  plot.dot(at.M, Meaning::link);

  draw_sense_of_crank(plot, at.A0, at.A, sense);

  const Place inside{(at.A.x + at.B.x + at.C.x) / 3, (at.A.y + at.B.y + at.C.y) / 3};
  plot.label("$A_{0}$", at.A0, Place{at.A.x, at.A.y});
  for (const auto& [name, P] : {std::pair{"$A$", at.A}, std::pair{"$B$", at.B}, std::pair{"$C$", at.C}}) {
    plot.label(name, P, inside);
  }
  plot.label("$M$", at.M, at.C);
}

void sketch_slider_crank(Plot& plot, const DrawnSliderCrank& at) {
  draw_guide_axis(plot, at, 3);
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
  draw_slider_crank(plot, at, sign_of(instant.n));
  return fit.scale;
}

double reach(const DrawnSliderCrank& at) { return std::hypot(at.B.x, at.B.y) + radius_of_crank(at); }

void include_slider_crank(Extent& extent, const Scale& scale, const DrawnSliderCrank& at) {
  const double r = radius_of_crank(at);
  extent.include(scale, {-r, -r}, 2);
  extent.include(scale, {r, r}, 2);
  extent.include(scale, at.C, 8);
  const GuideAxes guide(at);
  const drawings::Point b{scale.mm_per_unit * at.B.x, scale.mm_per_unit * at.B.y};
  for (const double along : {-guide_behind, guide_ahead})
    for (const double across : {-6.0, 6.0}) {
      const drawings::Point corner = beside(b, guide, along, across);
      extent.include(corner.x, corner.y);
    }
  if (const auto dimension = offset_dimension(at, scale, {0, 0})) {
    for (const drawings::Point& end : {dimension->at_A0, dimension->at_guide}) {
      extent.include(end.x - 5, end.y - 5);
      extent.include(end.x + 5, end.y + 5);
    }
  }
}

}  // namespace epure
