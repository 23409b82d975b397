#include "exercises/kit/panels/mechanism_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/senses.h"

namespace epure {

namespace {

constexpr double gap = 0.35, sweep = sweep_of_arrow;  // radians: the arc arrow keeps clear of the link

// `begin`: radians from the direction `link` to the arrow's tail, in the sense of turning.
double middle_of_arrow(double link, double begin, double sense) {
  return link + (sense > 0 ? 1 : -1) * (begin + sweep / 2);
}

// To the nearest of these.
double clearance(double direction, const std::vector<double>& from) {
  double least = std::numbers::pi;
  for (const double each : from)
    least = std::min(least, std::abs(std::remainder(direction - each, 2 * std::numbers::pi)));
  return least;
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

double clearest_direction(const std::vector<double>& between) {
  constexpr int tried = 24;
  constexpr double up = std::numbers::pi / 2, least_gain = 1e-9;
  double best = up;
  for (int i = 1; i < tried; ++i) {
    const int from_up = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
    const double direction = up + from_up * 2 * std::numbers::pi / tried;
    if (clearance(direction, between) > clearance(best, between) + least_gain) best = direction;
  }
  return best;
}

void draw_arc_arrow(Plot& plot, const Place& centre, const ArcArrow& arrow) {
  const double half = (arrow.sense > 0 ? 1 : -1) * sweep / 2;
  plot.mark(
      drawings::Rotation{plot.at(centre), arrow.radius, arrow.middle - half, arrow.middle + half, arrow.meaning});
  const double out = arrow.radius / plot.scale().mm_per_unit;
  plot.label(arrow.symbol, {centre.x + out * std::cos(arrow.middle), centre.y + out * std::sin(arrow.middle)}, centre,
             arrow.meaning == Meaning::link ? Meaning::text : arrow.meaning);
}

void draw_sense_of_crank(Plot& plot, const Place& A0, const Place& A, double sense, const std::string& symbol,
                         std::optional<double> support) {
  draw_arc_arrow(plot, A0, sense_of_crank(A0, A, sense, symbol, support.value_or(direction_of_support(A0, A))));
}

ArcArrow sense_of_crank(const Place& A0, const Place& A, double sense, const std::string& symbol, double support) {
  const double begin = is_ahead(support, A0, A, sense) ? -(gap + sweep) : gap;
  return {middle_of_arrow(direction(A0, A), begin, sense), sense, symbol};
}

ArcArrow sense_of_turning(const Place& centre, const Place& P, double sense, const std::string& symbol) {
  return {middle_of_arrow(direction(centre, P), gap, sense), sense, symbol};
}

void draw_sense_of_turning(Plot& plot, const Place& centre, const Place& P, double sense, const std::string& symbol) {
  draw_arc_arrow(plot, centre, sense_of_turning(centre, P, sense, symbol));
}

double direction_of_support(const Place& hinge, const Place& pin) {
  constexpr double too_near = 0.9;  // radians between link and support
  constexpr double down = -std::numbers::pi / 2;
  const double link = direction(hinge, pin);
  return std::abs(std::remainder(link - down, 2 * std::numbers::pi)) < too_near ? -down : down;
}

}  // namespace epure
