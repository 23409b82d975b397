// Sheet 3: how the flanks slide on each other, along the path of contact: their velocities along the common tangent
// with the sliding velocity between them, and below, the sliding over each flank's own velocity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/charts/chart.h"
#include "exercises/gear-pair/contact_words.h"
#include "exercises/gear-pair/exercise.h"
#include "exercises/gear-pair/fault_marks.h"
#include "exercises/gear-pair/fault_words.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::gear_pair {
namespace {

using drawings::Datum;
using Run = std::vector<Datum>;

constexpr int samples = 600;
constexpr double far_specific = 1e4;  // drawn points stay on this side of infinity
constexpr double most_specific = 6;   // what the axis shows at most: towards T1 and T2 specific sliding has no bound

// Along the common tangent, towards tip 1, at the position ξ in metres. The flanks' points lie P0T1 + ξ and P0T2 - ξ
// from T1 and T2; a rack moves with the pitch point.
struct Velocities {
  double of_1, of_2;
  double sliding() const { return of_1 - of_2; }
};
Velocities velocities(const DrawnPair& pair, double xi) {
  const double of_1 = pair.omega_1 * (xi - pair.T1);
  if (pair.T2) return {of_1, pair.omega_2 * (xi - *pair.T2)};
  return {of_1, -pair.omega_1 * pair.T1};
}

struct SlidingCharts {
  DrawnSheet& onto;
  const DrawnPair& pair;
  Language language;

  bool english() const { return language == Language::english; }
  double mm(double metres) const { return 1000 * metres; }
  std::string num(double x) const { return figures(x, 3, language); }

  Run run(double from, double to, const std::function<double(double)>& of) const {
    Run points;
    for (int i = 0; i <= samples; ++i) {
      const double xi = from + (to - from) * i / samples, y = of(xi);
      if (std::isfinite(y)) points.push_back({mm(xi), std::clamp(y, -far_specific, far_specific)});
    }
    return points;
  }

  double first_contact() const { return pair.path.begins.xi; }
  double last_contact() const { return pair.path.ends.xi; }

  drawings::Axis path_axis() const {
    const double margin = 0.06 * (*pair.E - *pair.A);
    return {.quantity = "$ξ$",
            .unit = "mm",
            .low = mm(std::min(*pair.A, 0.0) - margin),
            .high = mm(std::max(*pair.E, 0.0) + margin)};
  }

  // A, E, P0; the ends of the flanks, T1 and T2 where they come short of A and E; B and D where another pair of teeth
  // comes or goes.
  std::vector<drawings::ReferenceLine> places(bool named) const {
    std::vector<drawings::ReferenceLine> all;
    const auto line = [&](double xi, const std::string& letters, Meaning meaning) {
      all.push_back({.at = mm(xi), .label = named ? "$" + letters + "$" : std::string(), .meaning = meaning});
    };
    line(*pair.A, "A", Meaning::locus);
    line(*pair.E, "E", Meaning::locus);
    line(0, "P_{0}", Meaning::axis);
    if (pair.has(geometry::Fault::Kind::interference_approach)) line(pair.T1, "T_{1}", fault_ink);
    if (pair.has(geometry::Fault::Kind::interference_recess)) line(*pair.T2, "T_{2}", fault_ink);
    for (const DrawnPath::End& end : {pair.path.begins, pair.path.ends})
      if (end.by != DrawnPath::By::tip) line(end.xi, end.name, Meaning::locus);
    if (pair.has_single_contact()) {
      line(pair.B(), "B", Meaning::construction);
      line(pair.D(), "D", Meaning::construction);
    }
    return all;
  }

  // What whole flanks would do between A and E where these do not touch.
  drawings::Curve curve_of_whole_flanks() const {
    drawings::Curve curve{
        .name = "of_whole_flanks", .meaning = Meaning::construction, .line = drawings::LineType::dashed};
    for (const auto& [from, to] : {std::pair{*pair.A, first_contact()}, std::pair{last_contact(), *pair.E}}) {
      if (!(from < to)) continue;
      curve.runs.push_back(run(from, to, [&](double xi) { return velocities(pair, xi).of_1; }));
      curve.runs.push_back(run(from, to, [&](double xi) { return velocities(pair, xi).of_2; }));
      curve.runs.push_back(run(from, to, [&](double xi) { return velocities(pair, xi).sliding(); }));
    }
    return curve;
  }

  drawings::ChartMap draw_velocities(const drawings::Box& box) const {
    const auto of = [&](auto member) {
      return run(first_contact(), last_contact(), [&, member](double xi) { return member(velocities(pair, xi)); });
    };
    drawings::Chart chart;
    chart.x = path_axis();
    chart.y = {.quantity = "$v$", .unit = "m/s"};
    chart.curves = {{.name = "v_t1",
                     .runs = {of([](const Velocities& v) { return v.of_1; })},
                     .meaning = Meaning::locus,
                     .line = drawings::LineType::dashed,
                     .label = "$v_{t1}$"},
                    {.name = "v_t2",
                     .runs = {of([](const Velocities& v) { return v.of_2; })},
                     .meaning = Meaning::second_locus,
                     .line = drawings::LineType::dash_dotted,
                     .label = "$v_{t2}$"},
                    {.name = "v_s",
                     .runs = {of([](const Velocities& v) { return v.sliding(); })},
                     .meaning = Meaning::velocity,
                     .line = drawings::LineType::continuous,
                     .label = "$v_{s}$ = $v_{t1}$ − $v_{t2}$"}};
    if (drawings::Curve curve = curve_of_whole_flanks(); !curve.runs.empty()) chart.curves.push_back(curve);
    fit_axis(chart);
    for (const double xi : {first_contact(), last_contact()}) {
      const double v = velocities(pair, xi).sliding();
      chart.markers.push_back({.at = {mm(xi), v}, .label = num(v), .meaning = Meaning::velocity});
    }
    chart.verticals = places(true);
    chart.horizontals = {{.at = 0}};
    chart.letters_left = 16;
    const drawings::ChartMap map = draw(chart, box, onto.sheet.figure, language);
    measure(map);
    return map;
  }

  drawings::ChartMap draw_specific(const drawings::Box& box) const {
    drawings::Chart chart;
    chart.x = path_axis();
    chart.y = {.quantity = "$ζ$", .unit = ""};
    const auto specific = [&](bool first) {
      return [this, first](double xi) {
        const Velocities v = velocities(pair, xi);
        return first ? v.sliding() / v.of_1 : -v.sliding() / v.of_2;
      };
    };
    chart.curves = {{.name = "zeta_1",
                     .runs = {run(first_contact(), last_contact(), specific(true))},
                     .meaning = Meaning::locus,
                     .label = "$ζ_{1}$"},
                    {.name = "zeta_2",
                     .runs = {run(first_contact(), last_contact(), specific(false))},
                     .meaning = Meaning::second_locus,
                     .label = "$ζ_{2}$"}};
    fit_axis(chart);
    chart.y.low = std::max(chart.y.low, -most_specific);
    chart.y.high = std::min(chart.y.high, most_specific);
    for (const bool first : {true, false})
      for (const double xi : {first_contact(), last_contact()}) {
        const double zeta = specific(first)(xi);
        if (!(zeta > chart.y.low && zeta < chart.y.high)) continue;
        chart.markers.push_back(
            {.at = {mm(xi), zeta}, .label = num(zeta), .meaning = first ? Meaning::locus : Meaning::second_locus});
      }
    chart.verticals = places(false);
    chart.horizontals = {{.at = 0}};
    chart.letters_left = 16;
    return draw(chart, box, onto.sheet.figure, language);
  }

  static void fit_axis(drawings::Chart& chart) {
    double low = 0, high = 0;
    for (const drawings::Curve& curve : chart.curves)
      for (const Run& points : curve.runs)
        for (const Datum& point : points) {
          low = std::min(low, point.y);
          high = std::max(high, point.y);
        }
    const double air = 0.1 * (high - low);
    chart.y.low = low - air;
    chart.y.high = high + air;
  }

  void measure(const drawings::ChartMap& map) const {
    for (const auto& [xi, name] : {std::pair{*pair.A, "approach"}, std::pair{*pair.E, "recess"}}) {
      const Datum end{mm(xi), velocities(pair, xi).sliding()};
      onto.measurements.push_back({std::string("sliding_velocity_") + name, map.at({end.x, 0}), map.at(end),
                                   map.y.per_mm(), Measurement::length});
    }
  }

  static drawings::Path corners(double from, double to, const drawings::Box& frame) {
    return drawings::polyline({{from, frame.low.y}, {to, frame.low.y}, {to, frame.high.y}, {from, frame.high.y}},
                              true);
  }

  // Says how many pairs of teeth carry in each zone that has room for the words.
  void name_zones(const drawings::ChartMap& map) const {
    if (!pair.has_single_contact()) return;
    const auto name_zone = [&](double from, double to, const Words& words) {
      const double x = map.x.at(mm(from)), until = map.x.at(mm(to));
      constexpr double letters = 2.7, room = 18;  // mm
      if (until - x < room) return;
      onto.sheet.figure.labels.push_back(
          {.text = words.in(language), .at = {(x + until) / 2, map.frame.low.y + 2}, .size = letters});
    };
    name_zone(first_contact(), pair.B(), {"two pairs", "due coppie"});
    name_zone(pair.B(), pair.D(), {"one pair", "una coppia"});
    name_zone(pair.D(), last_contact(), {"two pairs", "due coppie"});
  }

  // A tint where two pairs of teeth carry, below all else.
  void tint_zones(const drawings::ChartMap& map) const {
    if (!pair.has_single_contact()) return;
    for (const auto& [from, to] : {std::pair{first_contact(), pair.B()}, std::pair{pair.D(), last_contact()}}) {
      const double x = map.x.at(mm(from)), until = map.x.at(mm(to));
      drawings::Figure& figure = onto.sheet.figure;
      figure.marks.insert(figure.marks.begin(), drawings::Area{corners(x, until, map.frame), Meaning::plate, {}});
      figure.window_of.insert(figure.window_of.begin(), -1);
    }
  }
};

Words along_the_tangent(const DrawnPair& pair) {
  if (pair.is_rack())
    return {
        "Along the common tangent flank 1 moves with $v_{t1}$ = $ω_{1}$·$T_{1}P$, the rack's with the constant "
        "$v_{t2}$ = $ω_{1}$·$T_{1}P_{0}$; $v_{s}$ = $ω_{1}$·$P_{0}P$, zero in $P_{0}$.",
        "Lungo la tangente comune il fianco 1 si muove con $v_{t1}$ = $ω_{1}$·$T_{1}P$, quello della dentiera con "
        "$v_{t2}$ = $ω_{1}$·$T_{1}P_{0}$ costante; $v_{s}$ = $ω_{1}$·$P_{0}P$, nulla in $P_{0}$."};
  return {
      "Along the common tangent the flanks move with $v_{t1}$ = $ω_{1}$·$T_{1}P$ and $v_{t2}$ = $ω_{2}$·$T_{2}P$; "
      "$v_{s}$ = $ω_{r}$·$P_{0}P$, zero in $P_{0}$.",
      "Lungo la tangente comune i fianchi si muovono con $v_{t1}$ = $ω_{1}$·$T_{1}P$ e $v_{t2}$ = "
      "$ω_{2}$·$T_{2}P$; $v_{s}$ = $ω_{r}$·$P_{0}P$, nulla in $P_{0}$."};
}

std::vector<std::string> explained(const DrawnPair& pair, Language language) {
  const bool english = language == Language::english;
  const std::string begin = "$" + pair.path.begins.name + "$", end = "$" + pair.path.ends.name + "$";
  std::vector<std::string> lines{
      english ? "$ξ$ is the position of the contact on the line of action, from $P_{0}$; contact travels from " +
                    begin + " to " + end + "."
              : "$ξ$ è la posizione del contatto sulla retta d'azione, da $P_{0}$; il contatto va da " + begin +
                    " a " + end + ".",
      along_the_tangent(pair).in(language),
      english
          ? "Specific sliding: $ζ_{1}$ = $v_{s}$/$v_{t1}$, $ζ_{2}$ = −$v_{s}$/$v_{t2}$; without bound towards "
            "$T_{1}$ and $T_{2}$."
          : "Strisciamento specifico: $ζ_{1}$ = $v_{s}$/$v_{t1}$, $ζ_{2}$ = −$v_{s}$/$v_{t2}$; senza limite verso "
            "$T_{1}$ e $T_{2}$."};
  const Words whole = pair.path.known ? Words{"Dashed grey: what whole flanks would do",
                                              "In grigio, a tratti: quel che farebbero fianchi interi"}
                                      : Words{"The curves are of whole flanks", "Le curve sono di fianchi interi"};
  if (!pair.path.is_whole()) lines.push_back(about_path(pair, whole, language));
  if (pair.has_single_contact())
    lines.push_back(english ? "Grey: two pairs of teeth carry; between $B$ and $D$ one alone."
                            : "In grigio: due coppie di denti in presa; fra $B$ e $D$ una sola.");
  return lines;
}

drawings::Table velocities_at_ends(const DrawnPair& pair, Language language) {
  const auto num = [&](double x) { return std::isfinite(x) ? figures(x, 4, language) : "–"; };
  const DrawnPath::End &begin = pair.path.begins, &end = pair.path.ends;
  drawings::Table table{{"", "$" + begin.name + "$", "$" + end.name + "$"}, {}};
  const auto row = [&](const std::string& name, const std::function<double(double)>& of) {
    table.rows.push_back({name, num(of(begin.xi)), num(of(end.xi))});
  };
  row("$ξ$ (mm)", [&](double xi) { return 1000 * xi; });
  row("$v_{t1}$ (m/s)", [&](double xi) { return velocities(pair, xi).of_1; });
  row("$v_{t2}$ (m/s)", [&](double xi) { return velocities(pair, xi).of_2; });
  row("$v_{s}$ (m/s)", [&](double xi) { return velocities(pair, xi).sliding(); });
  row("$ζ_{1}$", [&](double xi) { return velocities(pair, xi).sliding() / velocities(pair, xi).of_1; });
  row("$ζ_{2}$", [&](double xi) { return -velocities(pair, xi).sliding() / velocities(pair, xi).of_2; });
  return table;
}

std::string speeds(const DrawnPair& pair, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  std::string text = fmt::format("$ω_{{1}}$ = {}\u00a0rad/s", num(pair.omega_1));
  if (pair.T2)
    text += fmt::format(", $ω_{{2}}$ = {}\u00a0rad/s, $ω_{{r}}$ = |$ω_{{1}}$ − $ω_{{2}}$| = {}\u00a0rad/s",
                        num(pair.omega_2), num(std::abs(pair.omega_1 - pair.omega_2)));
  else
    text += fmt::format(", $v$ = $ω_{{1}}$·$r_{{1}}$ = {}\u00a0m/s", num(pair.omega_1 * pair.wheel1.circles.r_w));
  return text + ".";
}

}  // namespace

void draw_sliding(DrawnSheet& onto, const DrawnPair& pair, const Differences& differences,
                  const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  add_faults(onto, pair, language);
  if (!pair.has_contact() || !pair.path.touches) {
    column.push_back(drawings::Paragraph{english ? "There is no contact, and no sliding to be drawn."
                                                 : "Non c'è contatto, né strisciamento da disegnare."});
    if (pair.has_contact())
      column.push_back(drawings::Paragraph{
          about_path(pair, {"Whole flanks would touch", "Fianchi interi si toccherebbero"}, language)});
    return;
  }
  drawings::Box room = drawings::drawing_area(request.paper);
  constexpr double air = 4;  // mm
  room = {{room.low.x + air, room.low.y + air}, {room.high.x - air, room.high.y - air}};
  const double middle = room.low.y + 0.5 * room.height();
  const SlidingCharts charts{onto, pair, language};
  const drawings::ChartMap above = charts.draw_velocities({{room.low.x, middle + 1}, room.high});
  const drawings::ChartMap below = charts.draw_specific({room.low, {room.high.x, middle - 1}});
  charts.name_zones(above);
  charts.tint_zones(above);
  charts.tint_zones(below);
  column.push_back(drawings::Heading{english ? "The curves" : "Le curve"});
  for (const std::string& line : explained(pair, language)) column.push_back(drawings::Paragraph{line});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(drawings::Paragraph{speeds(pair, language)});
  column.push_back(velocities_at_ends(pair, language));
  add_differences(onto, differences, {"omega_relative", "sliding_velocity_approach", "sliding_velocity_recess"},
                  language);
  onto.sheet.description =
      in_words({"Sliding velocity and specific sliding of both flanks along the path of contact",
                "Velocità di strisciamento e strisciamento specifico dei due fianchi lungo la linea di ingranamento"},
               {{"v_s(" + plain_name(pair.path.begins) + ")", velocities(pair, pair.path.begins.xi).sliding(), "m/s"},
                {"v_s(" + plain_name(pair.path.ends) + ")", velocities(pair, pair.path.ends.xi).sliding(), "m/s"}},
               language);
}

}  // namespace epure::gear_pair
