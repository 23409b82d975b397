#include "exercises/kit/mechanism_figure.h"

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

void draw_sense_of_crank(Plot& plot, const Place& A0, const Place& A, double sense, const std::string& symbol) {
  constexpr double gap = 0.35, sweep = 1.3;  // radians: the arc arrow stands ahead of the crank, clear of it
  constexpr double radius = 9;               // mm
  const double start = direction(A0, A), way = sense > 0 ? 1 : -1;
  plot.mark(drawings::Rotation{plot.at(A0), radius, start + way * gap, start + way * (gap + sweep)});
  const double middle = start + way * (gap + sweep / 2), out = (radius + 1) / plot.scale().mm_per_unit;
  plot.label(symbol, {A0.x + out * std::cos(middle), A0.y + out * std::sin(middle)}, A0);
}

double direction_of_support(const Place& hinge, const Place& pin) {
  constexpr double too_near = 0.9;  // radians between link and support
  constexpr double down = -std::numbers::pi / 2;
  const double link = direction(hinge, pin);
  return std::abs(std::remainder(link - down, 2 * std::numbers::pi)) < too_near ? -down : down;
}

}  // namespace epure
