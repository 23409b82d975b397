#include "exercises/gear-pair/sliding_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/gear-pair/faults.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

using drawings::Datum;
using Run = std::vector<Datum>;

constexpr double most_specific = 6;  // what the axis shows at most: towards T1 and T2 specific sliding has no bound

double mm(double metres) { return 1000 * metres; }

void fit_axis(drawings::Chart& chart) {
  double low = 0, high = 0;
  for (const drawings::Curve& curve : chart.curves)
    for (const Run& run : curve.runs)
      for (const Datum& point : run) {
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
  const double air = 0.1 * (high - low);
  chart.y.low = low - air;
  chart.y.high = high + air;
}

// The zones in which two pairs of teeth carry, tinted below all else.
void tint(drawings::Figure& figure, const drawings::ChartMap& map, double from, double to) {
  const drawings::Box& frame = map.frame;
  const double x = map.x.at(mm(from)), until = map.x.at(mm(to));
  const drawings::Path zone =
      drawings::polyline({{x, frame.low.y}, {until, frame.low.y}, {until, frame.high.y}, {x, frame.high.y}}, true);
  figure.marks.insert(figure.marks.begin(), drawings::Area{zone, Meaning::plate, {}});
  figure.window_of.insert(figure.window_of.begin(), -1);
}

// Where there is room for the words.
void name_zone(drawings::Figure& figure, const drawings::ChartMap& map, double from, double to,
               const std::string& words) {
  constexpr double letters = 2.7, room = 18;  // mm
  double x = map.x.at(mm(from)), until = map.x.at(mm(to));
  // Beside the line of P0, where it crosses the zone and leaves room enough.
  if (const double P0 = map.x.at(0); x < P0 && P0 < until && std::max(P0 - x, until - P0) >= room)
    (P0 - x > until - P0 ? until : x) = P0;
  if (until - x >= room)
    figure.labels.push_back({.text = words, .at = {(x + until) / 2, map.frame.low.y + 2}, .size = letters});
}

drawings::Box upper_half(const drawings::Box& room) {
  return {{room.low.x, room.low.y + room.height() / 2 + 1}, room.high};
}
drawings::Box lower_half(const drawings::Box& room) {
  return {room.low, {room.high.x, room.low.y + room.height() / 2 - 1}};
}

}  // namespace

double SlidingPanel::of_flank(int wheel, const std::string& point) const {
  return pair_.s[flank_velocity(wheel, point).name];
}
double SlidingPanel::sliding(const std::string& point) const {
  return std::copysign(pair_.s["v_s_" + point], pair_.s["xi_" + point]);
}

drawings::Axis SlidingPanel::path_axis() const {
  const double margin = 0.06 * (*pair_.E - *pair_.A);
  return {.quantity = "$ξ$",
          .unit = "mm",
          .low = mm(std::min(*pair_.A, 0.0) - margin),
          .high = mm(std::max(*pair_.E, 0.0) + margin)};
}

// A, E, P0; the ends of the flanks, T1 and T2 where they come short of A and E; B and D where another pair of teeth
// comes or goes.
std::vector<drawings::ReferenceLine> SlidingPanel::places(bool named) const {
  std::vector<drawings::ReferenceLine> all;
  const auto line = [&](double xi, const std::string& letters, Meaning meaning) {
    all.push_back({.at = mm(xi), .label = named ? "$" + letters + "$" : std::string(), .meaning = meaning});
  };
  line(*pair_.A, "A", Meaning::locus);
  line(*pair_.E, "E", Meaning::locus);
  line(0, "P_{0}", Meaning::axis);
  if (pair_.has(geometry::Fault::Kind::interference_approach)) line(pair_.T1, "T_{1}", fault_ink);
  if (pair_.has(geometry::Fault::Kind::interference_recess)) line(*pair_.T2, "T_{2}", fault_ink);
  for (const PathEnd& end : {pair_.begins, pair_.ends})
    if (end.is_short()) line(end.xi, end.letters(), Meaning::locus);
  if (pair_.has_single_contact()) {
    line(pair_.B(), "B", Meaning::construction);
    line(pair_.D(), "D", Meaning::construction);
  }
  return all;
}

// All of them are linear in ξ: a line from end to end. Dashed, what whole flanks would do between A and E where these
// do not touch.
drawings::Chart SlidingPanel::velocities(Language language) const {
  const auto line = [&](const auto& velocity, const std::string& from, const std::string& to) {
    return Run{{mm(pair_.s["xi_" + from]), velocity(from)}, {mm(pair_.s["xi_" + to]), velocity(to)}};
  };
  const auto of_1 = [this](const std::string& at) { return of_flank(1, at); };
  const auto of_2 = [this](const std::string& at) { return of_flank(2, at); };
  const auto between = [this](const std::string& at) { return sliding(at); };
  const std::string &from = pair_.begins.point, &to = pair_.ends.point;
  drawings::Chart chart;
  chart.x = path_axis();
  chart.y = {.quantity = "$v$", .unit = "m/s"};
  chart.curves = {{.name = "v_t1",
                   .runs = {line(of_1, from, to)},
                   .meaning = Meaning::locus,
                   .line = drawings::LineType::dashed,
                   .label = "$v_{t1}$"},
                  {.name = "v_t2",
                   .runs = {line(of_2, from, to)},
                   .meaning = Meaning::second_locus,
                   .line = drawings::LineType::dash_dotted,
                   .label = "$v_{t2}$"},
                  {.name = "v_s",
                   .runs = {line(between, from, to)},
                   .meaning = Meaning::velocity,
                   .line = drawings::LineType::continuous,
                   .label = "$v_{s}$ = $v_{t1}$ − $v_{t2}$"}};
  drawings::Curve beyond{
      .name = "of_whole_flanks", .meaning = Meaning::construction, .line = drawings::LineType::dashed};
  if (*pair_.A < pair_.begins.xi)
    beyond.runs = {line(of_1, "A", from), line(of_2, "A", from), line(between, "A", from)};
  if (pair_.ends.xi < *pair_.E)
    for (const Run& run : {line(of_1, to, "E"), line(of_2, to, "E"), line(between, to, "E")})
      beyond.runs.push_back(run);
  if (!beyond.runs.empty()) chart.curves.push_back(beyond);
  fit_axis(chart);
  for (const PathEnd& end : {pair_.begins, pair_.ends})
    chart.markers.push_back({.at = {mm(end.xi), sliding(end.point)},
                             .label = figures(sliding(end.point), 3, language),
                             .meaning = Meaning::velocity});
  return chart;
}

drawings::Chart SlidingPanel::specific(Language language) const {
  constexpr int samples = 200;
  constexpr double far = 1e4;  // drawn points stay on this side of infinity
  drawings::Chart chart;
  chart.x = path_axis();
  chart.y = {.quantity = "$ζ$", .unit = ""};
  const PathEnd &from = pair_.begins, &to = pair_.ends;
  for (const int wheel : {1, 2}) {
    Run run;
    for (int i = 0; i <= samples; ++i) {
      const auto along = [&](double begin, double end) { return begin + (end - begin) * i / samples; };
      const double own = along(of_flank(wheel, from.point), of_flank(wheel, to.point)),
                   between = along(sliding(from.point), sliding(to.point)),
                   zeta = (wheel == 1 ? 1 : -1) * between / own;
      if (std::isfinite(zeta)) run.push_back({mm(along(from.xi, to.xi)), std::clamp(zeta, -far, far)});
    }
    chart.curves.push_back({.name = on("zeta_", wheel),
                            .runs = {run},
                            .meaning = wheel == 1 ? Meaning::locus : Meaning::second_locus,
                            .label = on("$ζ_{", wheel) + "}$"});
  }
  fit_axis(chart);
  chart.y.low = std::max(chart.y.low, -most_specific);
  chart.y.high = std::min(chart.y.high, most_specific);
  for (const int wheel : {1, 2})
    for (const PathEnd& end : {from, to}) {
      const auto zeta = pair_.s.value(specific_sliding(wheel, end.point).name);
      if (zeta && *zeta > chart.y.low && *zeta < chart.y.high)
        chart.markers.push_back({.at = {mm(end.xi), *zeta},
                                 .label = figures(*zeta, 3, language),
                                 .meaning = wheel == 1 ? Meaning::locus : Meaning::second_locus});
    }
  return chart;
}

// The velocities, and below them the specific sliding.
std::pair<drawings::Chart, drawings::Chart> SlidingPanel::charts(Language language) const {
  constexpr double letters_left = 16;  // mm: both frames begin there
  std::pair<drawings::Chart, drawings::Chart> both{velocities(language), specific(language)};
  for (drawings::Chart* chart : {&both.first, &both.second}) {
    chart->verticals = places(chart == &both.first);
    chart->horizontals = {{.at = 0}};
    chart->letters_left = letters_left;
  }
  return both;
}

void SlidingPanel::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  drawings::Figure& figure = plot.onto().sheet.figure;
  const auto [velocities, specific] = charts(language);
  drawings::draw_axes(velocities, upper_half(room), figure, language);
  drawings::draw_axes(specific, lower_half(room), figure, language);
}

std::vector<drawings::Block> SlidingPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  DrawnSheet& onto = plot.onto();
  drawings::Figure& figure = onto.sheet.figure;
  const auto [velocities, specific] = charts(language);
  const drawings::ChartMap above = drawings::draw(velocities, upper_half(room), figure, language),
                           below = drawings::draw(specific, lower_half(room), figure, language);
  for (const auto& [point, name] : {std::pair{"A", "approach"}, std::pair{"E", "recess"}}) {
    const Datum end{mm(pair_.s[std::string("xi_") + point]), sliding(point)};
    onto.measurements.push_back({std::string("sliding_velocity_") + name, above.at({end.x, 0}), above.at(end),
                                 above.y.per_mm(), Measurement::length});
  }
  if (!pair_.has_single_contact()) return {};
  const double from = pair_.begins.xi, B = pair_.B(), D = pair_.D(), to = pair_.ends.xi;
  const Words two{"two pairs", "due coppie"}, one{"one pair", "una coppia"};
  name_zone(figure, above, from, B, two.in(language));
  name_zone(figure, above, B, D, one.in(language));
  name_zone(figure, above, D, to, two.in(language));
  for (const drawings::ChartMap& map : {above, below}) {
    tint(figure, map, from, B);
    tint(figure, map, D, to);
  }
  return {};
}

}  // namespace epure::gear_pair
