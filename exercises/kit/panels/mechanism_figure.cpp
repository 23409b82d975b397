#include "exercises/kit/panels/mechanism_figure.h"

#include <cmath>
#include <numbers>

namespace epure {

Fit fit_mechanism(const MechanismFigure& mechanism, const drawings::Box& room, const SheetRequest& request) {
  return fit_lengths(room, request, 1000 / mechanism.reach(), [&](const Scale& scale) {
    Extent extent;
    mechanism.include(extent, scale);
    return extent.box();
  });
}

Scale draw_small(DrawnSheet& onto, const MechanismFigure& mechanism, const drawings::Box& room,
                 const SheetRequest& request) {
  const Fit fit = fit_mechanism(mechanism, room, request);
  Plot plot(onto, fit.origin, fit.scale);
  mechanism.draw(plot);
  return fit.scale;
}

namespace {

constexpr double gap = 0.35, sweep = 1.3;  // radians: the arc arrow keeps clear of the link
constexpr double radius_of_arc = 9;        // mm

// `begin`: radians from the direction `link` to the arrow's tail, in the sense of turning.
void draw_arc_arrow(Plot& plot, const Place& centre, double link, double begin, double sense,
                    const std::string& symbol) {
  const double way = sense > 0 ? 1 : -1, tail = link + way * begin;
  plot.mark(drawings::Rotation{plot.at(centre), radius_of_arc, tail, tail + way * sweep});
  const double middle = tail + way * sweep / 2, out = (radius_of_arc + 1) / plot.scale().mm_per_unit;
  plot.label(symbol, {centre.x + out * std::cos(middle), centre.y + out * std::sin(middle)}, centre);
}

// Whether the arrow ahead of the crank would run into the support. There the support, as wide as its hatching, takes
// 0.7 rad to either side. An arrow behind is then free: link and support are never within 0.4 rad of each other.
bool is_ahead(double direction_of_support, const Place& A0, const Place& A, double sense) {
  constexpr double half_support = 0.75;  // radians
  const double way = sense > 0 ? 1 : -1;
  const double support = way * std::remainder(direction_of_support - direction(A0, A), 2 * std::numbers::pi);
  return support > gap - half_support && support < gap + sweep + half_support;
}

}  // namespace

void draw_sense_of_crank(Plot& plot, const Place& A0, const Place& A, double sense, const std::string& symbol,
                         std::optional<double> support) {
  const double begin = is_ahead(support.value_or(direction_of_support(A0, A)), A0, A, sense) ? -(gap + sweep) : gap;
  draw_arc_arrow(plot, A0, direction(A0, A), begin, sense, symbol);
}

void draw_sense_of_turning(Plot& plot, const Place& centre, const Place& P, double sense, const std::string& symbol) {
  draw_arc_arrow(plot, centre, direction(centre, P), gap, sense, symbol);
}

double direction_of_support(const Place& hinge, const Place& pin) {
  constexpr double too_near = 0.9;  // radians between link and support
  constexpr double down = -std::numbers::pi / 2;
  const double link = direction(hinge, pin);
  return std::abs(std::remainder(link - down, 2 * std::numbers::pi)) < too_near ? -down : down;
}

}  // namespace epure
