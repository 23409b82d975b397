// The arc travelled against time, and below it the speed, which is its slope.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "drawings/charts/chart.h"
#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

using drawings::Datum;

struct Motion {
  std::string name;
  double end;       // s: of the charts
  double kink = 0;  // s between two instants at which the speed turns from falling to rising; 0: none
  std::function<double(double)> s, v;
  std::vector<const DrawnInstant*> instants;
  std::vector<std::string> letters;      // "φ", "s": the subscripts of t
  std::vector<std::string> arcs, times;  // the quantities that are no givens; empty: given
};

// Of more arches than these nothing but ink would be seen.
bool shows_speed(const Motion& of) {
  constexpr double most_arches = 24;
  return of.kink == 0 || of.end <= most_arches * of.kink;
}

// Evenly, and at every kink.
std::vector<Datum> sampled(const Motion& of, const std::function<double(double)>& f) {
  constexpr int samples = 1200;  // some seven in a millimetre
  std::vector<Datum> points;
  for (int i = 0; i <= samples; ++i) points.push_back({of.end * i / samples, 0});
  if (of.kink > 0 && of.end / of.kink < samples)
    for (double t = of.kink; t < of.end; t += of.kink) points.push_back({t, 0});
  std::sort(points.begin(), points.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  for (Datum& point : points) point.y = f(point.x);
  return points;
}

drawings::Chart chart_of(const Motion& of, const std::function<double(double)>& f, const std::string& letter,
                         const std::string& unit, Meaning meaning,
                         const std::function<double(const DrawnInstant&)>& at, Language language) {
  const std::vector<Datum> points = sampled(of, f);
  double high = 0;
  for (const Datum& point : points) high = std::max(high, point.y);
  drawings::Chart chart;
  chart.x = {.quantity = "$t$", .unit = "s", .low = 0, .high = of.end, .to_ticks = false};
  chart.y = {.quantity = letter, .unit = unit, .low = 0, .high = high > 0 ? 1.12 * high : 1};
  chart.curves = {{.name = of.name, .runs = {points}, .meaning = meaning}};
  for (std::size_t i = 0; i < of.instants.size(); ++i) {
    const DrawnInstant& instant = *of.instants[i];
    chart.markers.push_back(
        {.at = {instant.t, at(instant)},
         .label = fmt::format("{} {}", at(instant) == 0 ? "0" : figures(at(instant), 4, language), unit),
         .meaning = meaning});
    chart.verticals.push_back({.at = instant.t, .label = "$t_{" + of.letters[i] + "}$"});
  }
  return chart;
}

drawings::Chart arc_chart(const Motion& of, Language language) {
  return chart_of(
      of, of.s, "$s$", "m", Meaning::locus, [](const DrawnInstant& at) { return at.s; }, language);
}
drawings::Chart speed_chart(const Motion& of, Language language) {
  return chart_of(
      of, of.v, "$v_{M}$", "m/s", Meaning::velocity, [](const DrawnInstant& at) { return magnitude(at.v); },
      language);
}

void draw_charts(DrawnSheet& onto, const Motion& of, const SheetRequest& request) {
  const Language language = request.language;
  drawings::Box room = drawings::drawing_area(request.paper);
  constexpr double air = 4, between = 3, arc_share = 0.6, letters_left = 16;  // mm; of the height; mm
  room = {{room.low.x + air, room.low.y + air}, {room.high.x - air, room.high.y - air}};
  const auto up = [&](const drawings::ChartMap& map, const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({to.x, 0}), map.at(to), map.y.per_mm(), Measurement::along_y});
  };
  const auto across = [&](const drawings::ChartMap& map, const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({0, to.y}), map.at(to), map.x.per_mm(), Measurement::along_x});
  };

  drawings::Box upper = room;
  if (shows_speed(of)) {
    const double divide = room.high.y - arc_share * room.height();
    upper.low.y = divide + between;
    drawings::Chart speeds = speed_chart(of, language);
    speeds.letters_left = letters_left;
    const drawings::ChartMap map = draw(speeds, {room.low, {room.high.x, divide}}, onto.sheet.figure, language);
    for (const DrawnInstant* at : of.instants) up(map, at->names("v_M"), {at->t, magnitude(at->v)});
  }
  drawings::Chart arcs = arc_chart(of, language);
  arcs.letters_left = letters_left;
  const drawings::ChartMap map = draw(arcs, upper, onto.sheet.figure, language);
  for (std::size_t i = 0; i < of.instants.size(); ++i) {
    const Datum at{of.instants[i]->t, of.instants[i]->s};
    if (!of.arcs[i].empty()) up(map, of.arcs[i], at);
    if (!of.times[i].empty()) across(map, of.times[i], at);
  }
}

void fill(DrawnSheet& onto, const Motion& of, const std::vector<Words>& lines, const Words& description,
          Language language) {
  const bool english = language == Language::english;
  const auto num = [&](double x) { return x == 0 ? "0" : figures(x, 4, language); };
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "The curves" : "Le curve"});
  for (const Words& line : lines) column.push_back(drawings::Paragraph{line.in(language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  drawings::Table table{{"", "$t$ (s)", "$s$ (m)", "$v_{M}$ (m/s)"}, {}};
  std::vector<Value> values;
  for (std::size_t i = 0; i < of.instants.size(); ++i) {
    const DrawnInstant& at = *of.instants[i];
    table.rows.push_back({"$t_{" + of.letters[i] + "}$", num(at.t), num(at.s), num(magnitude(at.v))});
    values.insert(values.end(), {{"t_" + of.letters[i], at.t, "s"}, {"s", at.s, "m"}});
  }
  column.push_back(table);
  onto.sheet.description = in_words(description, values, language);
}

}  // namespace

void draw_cycloid_travel(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const DrawnInstant first = drawn_at_phi(of), second = drawn_at_s(of);
  const double r = CGAL::to_double(of.r), omega = geometry::to_double(of.omega_1);
  const double turn = 2 * std::numbers::pi / omega;
  const Motion motion{.name = "arc",
                      .end = std::max(1.25 * std::max(first.t, second.t), turn),
                      .kink = turn,
                      .s =
                          [=](double t) {
                            const double arches = std::floor(t / turn), half = omega * (t - arches * turn) / 2;
                            return 8 * r * arches + 4 * r * (1 - std::cos(half));
                          },
                      .v = [=](double t) { return 2 * r * omega * std::abs(std::sin(omega * t / 2)); },
                      .instants = {&first, &second},
                      .letters = {"φ", "s"},
                      .arcs = {at_phi("arc_length_at_phi"), ""},
                      .times = {at_phi("time_at_phi"), at_s("t")}};
  draw_charts(onto, motion, request);
  fill(
      onto, motion,
      {{"$s$ = 4$r$ (1 − cos $ωt$/2) within the first arch, which is 8$r$ long; each arch behind adds as much. The "
        "source stops at the first.",
        "$s$ = 4$r$ (1 − cos $ωt$/2) nel primo arco, lungo 8$r$; ogni arco percorso ne aggiunge altrettanti. La "
        "fonte "
        "si ferma al primo."},
       {"$v_{M}$ = d$s$/d$t$ = 2$rω$ |sin $ωt$/2|. At a cusp the arc has a level tangent, and the speed turns about: "
        "its slope $a^{t}_{M}$ goes from −$ω^{2}r$ to +$ω^{2}r$.",
        "$v_{M}$ = d$s$/d$t$ = 2$rω$ |sen $ωt$/2|. In una cuspide lo spazio ha tangente orizzontale e la velocità "
        "s'inverte: la sua pendenza $a^{t}_{M}$ passa da −$ω^{2}r$ a +$ω^{2}r$."}},
      {"The arc of the cycloid travelled against time, and the speed",
       "Lo spazio percorso sulla cicloide in funzione del tempo, e la velocità"},
      request.language);
}

void draw_involute_travel(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const DrawnInstant first = drawn_on_involute(of, of.phi_1, at_t1), second = drawn_on_involute(of, of.phi_2, at_t2);
  const double r = CGAL::to_double(of.r_0), omega = geometry::to_double(of.omega_2);
  const double latest = std::max(first.t, second.t);
  const Motion motion{.name = "arc",
                      .end = latest > 0 ? 1.1 * latest : 1 / omega,
                      .s = [=](double t) { return r * omega * t * omega * t / 2; },
                      .v = [=](double t) { return r * omega * omega * t; },
                      .instants = {&first, &second},
                      .letters = {"1", "2"},
                      .arcs = {at_t1("arc_length"), at_t2("arc_length")},
                      .times = {"", ""}};
  draw_charts(onto, motion, request);
  fill(
      onto, motion,
      {{"$s$ = $rφ^{2}$/2 = $r$ ($ωt$)$^{2}$/2: a parabola.", "$s$ = $rφ^{2}$/2 = $r$ ($ωt$)$^{2}$/2: una parabola."},
       {"$v_{M}$ = d$s$/d$t$ = $ω^{2}rt$, a straight line: its slope $a^{t}_{M}$ = $ω^{2}r$ is constant.",
        "$v_{M}$ = d$s$/d$t$ = $ω^{2}rt$, una retta: la sua pendenza $a^{t}_{M}$ = $ω^{2}r$ è costante."}},
      {"The arc of the involute travelled against time, and the speed",
       "Lo spazio percorso sull'evolvente in funzione del tempo, e la velocità"},
      request.language);
}

}  // namespace epure::cycloid_involute
