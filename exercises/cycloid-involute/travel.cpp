// The arc travelled against time, and below it the speed, which is its slope.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::cycloid_involute {
namespace {

using drawings::Datum;
using Curve = std::function<double(double)>;

// An instant on the charts; of its quantities those that a ruler reads there.
struct Reached {
  double t, s, v;
  std::string letters;  // the subscript of t
  std::string arc, time, speed;
};

struct Motion {
  double end;       // s: of the charts
  double kink = 0;  // s between two instants at which the speed has a corner; 0: none
  Curve s, v;
  std::vector<Reached> instants;
};

// Evenly, and at every kink.
std::vector<Datum> sampled(const Motion& of, const Curve& f) {
  constexpr int samples = 1200;  // some seven in a millimetre
  std::vector<Datum> points;
  for (int i = 0; i <= samples; ++i) points.push_back({of.end * i / samples, 0});
  if (of.kink > 0 && of.end / of.kink < samples)
    for (double t = of.kink; t < of.end; t += of.kink) points.push_back({t, 0});
  std::sort(points.begin(), points.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  for (Datum& point : points) point.y = f(point.x);
  return points;
}

drawings::Chart chart_of(const Motion& of, const Curve& f, const std::string& letter, const std::string& unit,
                         Meaning meaning, double Reached::*at, Language language) {
  const std::vector<Datum> points = sampled(of, f);
  double high = 0;
  for (const Datum& point : points) high = std::max(high, point.y);
  drawings::Chart chart{.letters_left = 16};
  chart.x = {.quantity = "$t$", .unit = "s", .low = 0, .high = of.end, .to_ticks = false};
  chart.y = {.quantity = letter, .unit = unit, .low = 0, .high = high > 0 ? 1.2 * high : 1};
  chart.curves = {{.runs = {points}, .meaning = meaning}};
  for (const Reached& instant : of.instants) {
    const double value = instant.*at;
    chart.markers.push_back({.at = {instant.t, value},
                             .label = fmt::format("{} {}", value == 0 ? "0" : figures(value, 4, language), unit),
                             .meaning = meaning});
    chart.verticals.push_back({.at = instant.t, .label = "$t_{" + instant.letters + "}$"});
  }
  return chart;
}

Panels charts(const Motion& of, Language language) {
  std::vector<ChartPanel::Read> arcs, speeds;
  for (const Reached& at : of.instants) {
    arcs.push_back({{at.t, at.s}, at.time, at.arc});
    speeds.push_back({{at.t, at.v}, "", at.speed});
  }
  drawings::Chart of_arc = chart_of(of, of.s, "$s$", "m", Meaning::locus, &Reached::s, language);
  of_arc.curves.front().name = "arc";
  constexpr double most_arches = 24;  // of the speed's more would be nothing but ink
  if (of.kink > 0 && of.end > most_arches * of.kink) return panels(ChartPanel(of_arc, arcs));
  drawings::Chart of_speed = chart_of(of, of.v, "$v_{M}$", "m/s", Meaning::velocity, &Reached::v, language);
  constexpr double arches_with_room = 4;  // between more of them a number finds none: the column tells it
  if (of.kink > 0 && of.end > arches_with_room * of.kink)
    for (drawings::Marker& marker : of_speed.markers) marker.label.clear();
  return panels(ChartPanel(of_arc, arcs), ChartPanel(of_speed, speeds));
}

Section curves(const std::vector<Words>& lines, Language language) {
  Section section{{"The curves", "Le curve"}, {}};
  for (const Words& line : lines) section.lines.push_back(remark(line.in(language)));
  return section;
}

}  // namespace

PanelSheet cycloid_travel_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  const double r = CGAL::to_double(of.r), omega = to_double(of.omega_1), turn = 2 * std::numbers::pi / omega;
  const Reached first{s["cycloid.time_at_phi"],    s["cycloid.arc_length_at_phi"], s["cycloid.v_M"], "φ",
                      "cycloid.arc_length_at_phi", "cycloid.time_at_phi",          "cycloid.v_M"},
      second{s["cycloid.t_at_s4"], CGAL::to_double(of.s), s["cycloid.v_M_at_s4"], "s", "",
             "cycloid.t_at_s4",    "cycloid.v_M_at_s4"};
  const Motion motion{.end = std::max(1.25 * std::max(first.t, second.t), turn),
                      .kink = turn,
                      .s =
                          [=](double t) {
                            const double arches = std::floor(t / turn), half = omega * (t - arches * turn) / 2;
                            return 8 * r * arches + 4 * r * (1 - std::cos(half));
                          },
                      .v = [=](double t) { return 2 * r * omega * std::abs(std::sin(omega * t / 2)); },
                      .instants = {first, second}};
  return {
      .panels = charts(motion, language),
      .theory = {curves({{"$s$ = 4$r$ (1 − cos($ω_{1}t$/2)) within the first arch, of length $s_{0}$ = 8$r$, $r$ = "
                          "$d$/2; each arch "
                          "behind adds as much. The source stops at the first.",
                          "$s$ = 4$r$ (1 − cos($ω_{1}t$/2)) nel primo arco, lungo $s_{0}$ = 8$r$, $r$ = $d$/2; ogni "
                          "arco percorso ne "
                          "aggiunge altrettanti. La fonte si ferma al primo."},
                         {"$v_{M}$ = d$s$/d$t$ = 2$rω_{1}$ |sin($ω_{1}t$/2)|. At a cusp the arc has a level tangent "
                          "and the speed a "
                          "corner: $a^{t}_{M}$ jumps from −$ω^{2}_{1}r$ to +$ω^{2}_{1}r$.",
                          "$v_{M}$ = d$s$/d$t$ = 2$rω_{1}$ |sen($ω_{1}t$/2)|. In una cuspide lo spazio ha tangente "
                          "orizzontale e la "
                          "velocità scalare un punto angoloso: $a^{t}_{M}$ salta da −$ω^{2}_{1}r$ a +$ω^{2}_{1}r$."}},
                        language)},
      .results = {table({"", "$t_{φ}$", "$t_{s}$"}, {{"$t$ (s)", {"cycloid.time_at_phi", "cycloid.t_at_s4"}},
                                                     {"$v_{M}$ (m/s)", {"cycloid.v_M", "cycloid.v_M_at_s4"}}}),
                  values({"cycloid.arc_length_at_phi", "cycloid.arch_length"})},
      .seen = {"The arc of the cycloid travelled against time, and the speed",
               "Lo spazio percorso sulla cicloide in funzione del tempo, e la velocità"},
      .told = {"cycloid.time_at_phi", "cycloid.arc_length_at_phi", "cycloid.t_at_s4"},
      .without_part = givens_of_involute};
}

PanelSheet involute_travel_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  const double r = CGAL::to_double(of.r_0), omega = to_double(of.omega_2);
  const auto reached = [&](const Angle& phi, const InstantNames& at, const std::string& letters) -> Reached {
    return {geometry::quotient_of<double>(phi, of.omega_2),
            s[at("arc_length")],
            s[at("v_M")],
            letters,
            at("arc_length"),
            "",
            at("v_M")};
  };
  const Reached first = reached(of.phi_1, at_t1, "1"), second = reached(of.phi_2, at_t2, "2");
  const double latest = std::max(first.t, second.t);
  const Motion motion{.end = latest > 0 ? 1.1 * latest : 1 / omega,
                      .s = [=](double t) { return r * omega * t * omega * t / 2; },
                      .v = [=](double t) { return r * omega * omega * t; },
                      .instants = {first, second}};
  return {
      .panels = charts(motion, language),
      .theory = {curves(
          {{"$s$ = $rφ^{2}$/2 = $r$ ($ω_{2}t$)$^{2}$/2, $r$ = $d_{0}$/2: a parabola.",
            "$s$ = $rφ^{2}$/2 = $r$ ($ω_{2}t$)$^{2}$/2, $r$ = $d_{0}$/2: una parabola."},
           {"$v_{M}$ = d$s$/d$t$ = $ω^{2}_{2}rt$, a straight line: its slope $a^{t}_{M}$ = $ω^{2}_{2}r$ is constant.",
            "$v_{M}$ = d$s$/d$t$ = $ω^{2}_{2}rt$, una retta: la sua pendenza $a^{t}_{M}$ = $ω^{2}_{2}r$ è "
            "costante."}},
          language)},
      .results = {table({"", "$t_{1}$", "$t_{2}$"}, {{"$φ$ (rad)", {at_t1("phi"), at_t2("phi")}},
                                                     {"$s$ (m)", {at_t1("arc_length"), at_t2("arc_length")}},
                                                     {"$v_{M}$ (m/s)", {at_t1("v_M"), at_t2("v_M")}},
                                                     {"$a^{t}_{M}$ (m/s²)", {at_t1("a_t"), at_t2("a_t")}}})},
      .seen = {"The arc of the involute travelled against time, and the speed",
               "Lo spazio percorso sull'evolvente in funzione del tempo, e la velocità"},
      .told = {at_t1("arc_length"), at_t2("arc_length")},
      .without_part = givens_of_cycloid};
}

}  // namespace epure::cycloid_involute
