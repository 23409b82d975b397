#include "exercises/oscillator-pendulum/sheets.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/hodograph_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/phase_plane_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/oscillator-pendulum/drawn_curves.h"
#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/oscillator-pendulum/quantities.h"

namespace epure::oscillator_pendulum {
namespace {

using drawings::Datum;
using Line = std::vector<Datum>;

std::string osc(const std::string& name) { return "oscillator." + name; }
std::string pen(const std::string& name) { return "pendulum." + name; }
std::string at(const std::string& of, const std::string& instant) { return of + "_at_" + instant; }

constexpr int smooth = 400;  // points of a curve

// As few of them as look like the curve; all that are shown stay on it.
template <class Points>
Points thinned(const Points& all, std::size_t most) {
  const std::size_t every = all.size() / most + 1;
  Points some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  return some;
}
Line over_time(const std::vector<Moving>& all) {
  Line line;
  for (const Moving& each : all) line.push_back({each.t, each.position});
  return line;
}
Line in_phase_plane(const std::vector<Moving>& all) {
  Line line;
  for (const Moving& each : all) line.push_back({each.position, each.rate});
  return line;
}

// The ends of an axis that shows all these, with air; never a point.
struct Ends {
  double low, high;
};
Ends ends_of(const Line& line, double Datum::*along, double air) {
  double low = 0, high = 0;
  for (const Datum& each : line) low = std::min(low, each.*along), high = std::max(high, each.*along);
  const double more = air * (high - low);
  return {low < 0 ? low - more : low, high > 0 ? high + more : high};
}
drawings::Axis axis(const std::string& quantity, const std::string& unit, const Ends& ends) {
  drawings::Axis axis{.quantity = quantity, .unit = unit, .low = ends.low, .high = ends.high};
  axis.to_ticks = false;
  return axis;
}

// Of both routes of a point of a chart, where it has a value.
void read(std::vector<ChartPanel::Read>& onto, const Solution& s, double x, const std::string& along_x,
          const std::string& along_y) {
  if (const auto y = s.value(along_y)) onto.push_back({{x, *y}, along_x, along_y});
}
double seconds(const std::string& name) { return nearest(instant(name)); }

// Beside points of a chart.
std::string in_seconds(const std::string& name, Language language) {
  std::string number = name;
  std::replace(number.begin(), number.end(), 'p', '.');
  return decimal(number).in(language);
}
// Rows of a table begin with a whole number, of seconds or of milliseconds.
std::vector<Row> rows(const std::vector<std::string>& instants_told, int units_of_a_second,
                      const std::string& case_name, const std::vector<std::string>& columns) {
  std::vector<Row> all;
  for (const std::string& name : instants_told) {
    std::vector<std::string> names;
    for (const std::string& column : columns) names.push_back(case_name + at(column, name));
    all.push_back({geometry::to_text(instant(name) * units_of_a_second), names, "–"});
  }
  return all;
}
std::vector<Row> rows_of_oscillator(const std::vector<std::string>& columns) {
  return rows({"1", "2", "5", "10", "20"}, 1, "oscillator.", columns);
}
std::vector<Row> rows_of_pendulum(const std::vector<std::string>& columns) {
  return rows({"0p1", "0p2", "0p3", "0p4", "0p5", "0p6", "0p7", "0p8", "0p9", "1"}, 1000, "pendulum.", columns);
}

// Points of Euler's polygon are marked one by one where they do not run into each other.
constexpr std::size_t most_marked = 60;

ChartPanel motion_chart(const Solution& s, Language language) {
  const double end = time_shown(s.givens());
  const Line exact = over_time(oscillation(s.givens(), end, smooth)),
             euler = over_time(euler_polygon(s.givens(), end));
  drawings::Chart chart;
  chart.x = axis("$t$", "s", {0, end});
  chart.y = axis("$x$", "m", ends_of(exact, &Datum::y, 0.15));
  chart.horizontals = {{.at = 0}};
  chart.curves = {{.name = "x", .runs = {exact}, .meaning = Meaning::locus, .label = "$x$($t$)"},
                  {.name = "x_euler",
                   .runs = {euler},
                   .meaning = Meaning::velocity,
                   .points = euler.size() <= most_marked ? euler : Line{},
                   .label = Words{"Euler", "Eulero"}.in(language)}};
  std::vector<ChartPanel::Read> all;
  for (const std::string& name : instants("x")) read(all, s, seconds(name), {}, osc(at("x", name)));
  for (const std::string& name : instants("x_euler")) read(all, s, seconds(name), {}, osc(at("x_euler", name)));
  for (const auto& [t, x, letters] :
       {std::tuple("t_x_max", "x_max", "$x_{m}$"), std::tuple("t_inflection", "x_inflection", "$x_{f}$")}) {
    const auto time = s.value(osc(t)), place = s.value(osc(x));
    if (!time || !place || *time > end) continue;
    chart.markers.push_back({.at = {*time, *place}, .label = letters, .meaning = Meaning::locus});
    all.push_back({{*time, *place}, osc(t), osc(x)});
  }
  return ChartPanel(chart, all);
}

Words law_in_words(const Rational& zeta) {
  if (zeta == 1) return decimal("$x$ = $v_{0}t$e$^{−αt}$");
  if (zeta < 1)
    return {"$x$ = ($v_{0}$/$b$)e$^{−αt}$sin $bt$, $b$ = $ω_{n}$√(1 − $ζ^{2}$)",
            "$x$ = ($v_{0}$/$b$)e$^{−αt}$sen $bt$, $b$ = $ω_{n}$√(1 − $ζ^{2}$)"};
  return decimal("$x$ = e$^{−αt}$($\\it{C}_{1}$e$^{βt}$ + $\\it{C}_{2}$e$^{−βt}$)");
}

// Straight lines through the origin, of which all points have one direction of motion.
std::vector<Line> isoclines_through_origin(const Ends& x, const Ends& y) {
  constexpr int how_many = 12;
  const double wide = std::max(-x.low, x.high), high = std::max(-y.low, y.high);
  std::vector<Line> all;
  for (int i = 0; i < how_many; ++i) {
    const double angle = M_PI * (i + 0.5) / how_many, dx = 2 * wide * std::cos(angle),
                 dy = 2 * high * std::sin(angle);
    Line line;
    constexpr int points = 60;
    for (int k = -points; k <= points; ++k) line.push_back({dx * k / points, dy * k / points});
    all.push_back(line);
  }
  return all;
}

PhasePlanePanel oscillator_plane(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double zeta = nearest(givens["zeta"]), omega = geometry::to_double(givens.angle("omega_n")),
               end = 40 / omega * std::max(1.0, std::min(zeta, 10.0));
  const Line exact = in_phase_plane(oscillation(givens, end, 2 * smooth)),
             euler = in_phase_plane(euler_polygon(givens, std::min(end, 20.0)));
  Ends x = ends_of(exact, &Datum::x, 0.12), y = ends_of(exact, &Datum::y, 0.1);
  // Room on the other side of the axes, where the straight trajectories go on.
  const double wide = x.high - x.low, high = y.high - y.low;
  x = {std::min(x.low, -0.25 * wide), std::max(x.high, 0.25 * wide)};
  y = {std::min(y.low, -0.3 * high), std::max(y.high, 0.3 * high)};
  PhasePlane plane{.x = axis("$x$", "m", x), .y = axis("$x'$", "m/s", y), .motion = [=](const Datum& p) {
                     return Arrow2{p.y, -2 * zeta * omega * p.y - omega * omega * p.x};
                   }};
  plane.isoclines = isoclines_through_origin(x, y);
  const auto through_origin = [&](double slope) { return Line{{x.low, slope * x.low}, {x.high, slope * x.high}}; };
  for (const auto& [name, letters] :
       {std::pair("lambda_1", "$x'$ = $λ_{1}x$"), std::pair("lambda_2", "$x'$ = $λ_{2}x$")})
    if (const auto slope = s.value(osc(name)); slope && (givens["zeta"] != 1 || name == std::string("lambda_1")))
      plane.orbits.push_back(
          {.name = name,
           .label = letters,
           .runs = {through_origin(*slope)},
           .meaning = Meaning::second_locus,
           .line = name == std::string("lambda_1") ? drawings::LineType::dash_dotted : drawings::LineType::dashed});
  if (zeta > 0)
    plane.orbits.push_back({.name = "inflections",
                            .label = "$x''$ = 0",
                            .runs = {through_origin(-omega / (2 * zeta))},
                            .meaning = Meaning::acceleration,
                            .line = drawings::LineType::dashed});
  plane.orbits.push_back({.name = "orbit", .label = Words{"exact", "esatta"}.in(language), .runs = {exact}});
  plane.orbits.push_back({.name = "euler",
                          .label = Words{"Euler", "Eulero"}.in(language),
                          .runs = {euler},
                          .meaning = Meaning::velocity,
                          .points = euler.size() <= most_marked ? euler : Line{}});
  for (const char* name : {"1", "2", "5", "10", "20"}) {
    const auto place = s.value(osc(at("x", name))), rate = s.value(osc(at("x_dot", name)));
    if (!place || !rate || seconds(name) > end) continue;
    plane.read.push_back({{*place, *rate}, osc(at("x", name)), osc(at("x_dot", name))});
    plane.markers.push_back({.at = {*place, *rate}, .label = std::string(name) + " s", .meaning = Meaning::locus});
  }
  const auto x_f = s.value(osc("x_inflection")), v_f = s.value(osc("x_dot_min"));
  if (x_f && v_f) plane.read.push_back({{*x_f, *v_f}, osc("x_inflection"), osc("x_dot_min")});
  return PhasePlanePanel(plane);
}

// θ' = a sin θ, of which all points have the direction dθ'/dθ = -Ω²/a.
std::vector<Line> sine_isoclines(double greatest, double wide) {
  std::vector<Line> all;
  for (const double part : {-1.2, -0.8, -0.4, 0.4, 0.8, 1.2}) {
    Line line;
    constexpr int points = 60;
    for (int k = -points; k <= points; ++k) {
      const double theta = wide * k / points;
      line.push_back({theta, part * greatest * std::sin(theta)});
    }
    all.push_back(line);
  }
  return all;
}

// As far as the phase plane shows it.
std::vector<Moving> spiral_of_table(const Solution& s) {
  constexpr double table = 1;
  return swing_of_table(s.givens(), s[pen("Omega")], std::min(2.5 * table, 3 * s[pen("period")]));
}
// As far as the chart of the angle does.
double end_of_angle_chart(const Solution& s) {
  return 1.12 * std::max(s[pen("period")], s.value(pen("period_numeric")).value_or(0));
}
std::vector<Moving> angle_of_table(const Solution& s) {
  return swing_of_table(s.givens(), s[pen("Omega")], std::min(end_of_angle_chart(s), 5.0));
}

// Half again as far as there is need for, or the whole of it where that is less.
double with_room(const Line& line, double Datum::*along, double whole) {
  double most = 0;
  for (const Datum& each : line) most = std::max(most, std::abs(each.*along));
  return std::min(whole, 1.5 * most);
}

PhasePlanePanel pendulum_plane(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double Omega = s[pen("Omega")], period = s[pen("period")];
  const Line exact = in_phase_plane(swing(givens, Omega, period, smooth)),
             spiral = thinned(in_phase_plane(spiral_of_table(s)), 300);
  Line above, below;
  for (int k = -smooth / 4; k <= smooth / 4; ++k) {
    const double theta = 4 * M_PI * k / smooth, rate = 2 * Omega * std::cos(theta / 2);
    above.push_back({theta, rate});
    below.push_back({theta, -rate});
  }
  // Small swings are shown larger, and the separatrix then lies outside.
  Line both = exact;
  both.insert(both.end(), spiral.begin(), spiral.end());
  const double wide = with_room(both, &Datum::x, M_PI), most = with_room(both, &Datum::y, 2.1 * Omega);
  PhasePlane plane{.x = axis("$θ$", "rad", {-wide, wide}),
                   .y = axis("$θ'$", "rad/s", {-most, most}),
                   .motion = [=](const Datum& p) {
                     return Arrow2{p.y, -Omega * Omega * std::sin(p.x)};
                   }};
  plane.isoclines = sine_isoclines(most / 1.05 / std::sin(std::min(wide, M_PI / 2)), wide);
  if (2 * Omega * std::cos(wide / 2) < most)
    plane.orbits.push_back({.name = "separatrix",
                            .label = Words{"separatrix", "separatrice"}.in(language),
                            .runs = {above, below},
                            .meaning = Meaning::second_locus,
                            .line = drawings::LineType::dashed});
  plane.orbits.push_back({.name = "orbit", .label = Words{"exact", "esatta"}.in(language), .runs = {exact}});
  plane.orbits.push_back({.name = "table",
                          .label = Words{"recursion", "ricorsiva"}.in(language),
                          .runs = {spiral},
                          .meaning = Meaning::velocity});
  for (const std::string& name : instants("theta_dot")) {
    const auto theta = s.value(pen(at("theta", name))), rate = s.value(pen(at("theta_dot", name)));
    if (!theta || !rate) continue;
    plane.read.push_back({{*theta, *rate}, pen(at("theta", name)), pen(at("theta_dot", name))});
    plane.markers.push_back({.at = {*theta, *rate}, .label = in_seconds(name, language), .meaning = Meaning::locus});
  }
  for (const char* name : {"0p5", "1"}) {
    const auto theta = s.value(pen(at("theta_numeric", name))), rate = s.value(pen(at("theta_dot_numeric", name)));
    if (!theta || !rate) continue;
    plane.read.push_back({{*theta, *rate}, pen(at("theta_numeric", name)), pen(at("theta_dot_numeric", name))});
    plane.markers.push_back(
        {.at = {*theta, *rate}, .label = {}, .shape = drawings::PointShape::ring, .meaning = Meaning::velocity});
  }
  return PhasePlanePanel(plane);
}

Place place_of(double r, double theta) { return {r * std::sin(theta), -r * std::cos(theta)}; }

std::shared_ptr<const Mechanism> positions_of(const Solution& s, const std::string& now) {
  using Joint = Mechanism::Joint;
  const double r = nearest(s.givens()["r"]);
  Mechanism drawn;
  const double lowest = -0.8 * r;
  drawn.point("A0", {0, 0}, Joint::fixed, "$A_{0}$").point("below", {0, lowest}, Joint::corner, "");
  // Positions whose letters would cover those of another have none.
  constexpr double letters_wide = 0.1;  // of the radius
  std::vector<double> lettered{s[pen(at("theta", now))]};
  for (const char* name : {"0", "0p1", "0p3", "0p4", "0p5"}) {
    const auto theta = s.value(pen(at("theta", name)));
    if (!theta || name == now) continue;
    const std::string point = std::string("G") + name;
    const bool is_clear = std::all_of(lettered.begin(), lettered.end(),
                                      [&](double other) { return std::abs(*theta - other) > letters_wide; });
    if (is_clear) lettered.push_back(*theta);
    drawn.point(point, place_of(r, *theta), Joint::none,
                is_clear ? geometry::to_text(instant(name) * 1000) + " ms" : "");
    drawn.other_position({"A0", point});
  }
  drawn.point("G", place_of(r, s[pen(at("theta", now))]), Joint::mass, "$G$").body({"A0", "G"}, 2);
  drawn.axis({0, 0}, {0, lowest});
  return std::make_shared<const Mechanism>(std::move(drawn));
}

// The forces at some of the positions, moved to G, with what they add up to. Letters stand at the solid one.
class PositionsPanel : public MechanismPanel {
 public:
  PositionsPanel(const Solution& s, const std::string& now)
      : MechanismPanel(positions_of(s, now)), weight_{0, -s[pen("weight")]}, now_(now) {
    const double r = nearest(s.givens()["r"]);
    for (const std::string& name : {std::string("0"), now, std::string("0p4")})
      shown_.push_back(
          {name, place_of(r, s[pen(at("theta", name))]), {s[pen(at("R_12_x", name))], s[pen(at("R_12_y", name))]}});
  }

  std::string scale_group() const override { return "positions"; }
  Vectors vectors() const override {
    constexpr double longest_on_paper = 45;  // mm
    double longest = 0;
    for (const Shown& each : shown_)
      for (const Arrow2& v : {weight_, each.R, weight_ + each.R}) longest = std::max(longest, std::hypot(v.x, v.y));
    return {"N", longest, longest_on_paper};
  }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override {
    constexpr double letters = 6;  // mm
    const drawings::Box mechanism = MechanismPanel::extent(lengths, vectors);
    Extent all;
    all.include(mechanism.low.x, mechanism.low.y);
    all.include(mechanism.high.x, mechanism.high.y);
    for (const Shown& each : shown_)
      for (const Arrow2& v : {weight_, each.R, weight_ + each.R})
        for (const double beyond : {-letters, letters})
          all.include(lengths.mm_per_unit * each.G.x + vectors.mm_per_unit * v.x + beyond,
                      lengths.mm_per_unit * each.G.y + vectors.mm_per_unit * v.y + beyond);
    return all.box();
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    MechanismPanel::draw(plot, room, language);
    for (const Shown& each : shown_) {
      const auto letters = [&](const char* of) { return each.instant == now_ ? std::string(of) : std::string(); };
      plot.vector_on(pen("weight"), each.G, weight_, Meaning::force, letters("$m_{p}\\vec{g}$"));
      plot.vector_on("", each.G, each.R, Meaning::force, letters("$\\vec{\\it{R}}_{12}$"));
      plot.vector_on("", each.G, weight_ + each.R, Meaning::acceleration, letters("$m_{p}\\vec{a}_{G}$"));
      const drawings::Point from = plot.at(each.G), to = plot.at(plot.tip(each.G, each.R));
      const double per_mm = 1 / plot.vector_scale().mm_per_unit;
      plot.onto().measurements.push_back({pen(at("R_12_x", each.instant)), from, to, per_mm, Measurement::along_x});
      plot.onto().measurements.push_back({pen(at("R_12_y", each.instant)), from, to, per_mm, Measurement::along_y});
    }
    return {};
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {
        {{"At three positions the weight and the reaction of the frame, which acts in $A_{0}$, moved to $G$: they "
          "add up to $m_{p}\\vec{a}_{G}$.",
          "In tre posizioni il peso e la reazione del telaio, che agisce in $A_{0}$, trasportata in $G$: la loro "
          "somma è $m_{p}\\vec{a}_{G}$."},
         shown_.back().G}};
  }

 private:
  struct Shown {
    std::string instant;
    Place G;
    Arrow2 R;
  };
  Arrow2 weight_;
  std::string now_;
  std::vector<Shown> shown_;
};

PolygonPanel forces_panel(const Solution& s, const std::string& now, Language language) {
  const Arrow2 R{s[pen(at("R_12_x", now))], s[pen(at("R_12_y", now))]}, W{0, -s[pen("weight")]};
  const Arrow2 F{-(R.x + W.x), -(R.y + W.y)};
  const Words upright{"vertical", "verticale"};
  return PolygonPanel(
      s, force_polygon("G", {{.label = "$\\vec{\\it{R}}_{12}$", .direction = "?", .magnitude = "?", .v = R}},
                       {{.quantity = pen("weight"),
                         .label = "$m_{p}\\vec{g}$",
                         .direction = upright.in(language),
                         .magnitude = "$m_{p}g$",
                         .v = W,
                         .tip = "$a$"},
                        {.label = "$\\vec{\\it{F}}_{G}$",
                         .direction = "∥ $\\vec{a}_{G}$",
                         .magnitude = "$m_{p}a_{G}$",
                         .v = F,
                         .tip = "$b$"}}));
}

HodographPanel hodograph_panel(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double Omega = s[pen("Omega")], period = s[pen("period")], weight = s[pen("weight")],
               m_r = nearest(givens["m_p"]) * nearest(givens["r"]);
  Hodograph hodograph{
      .pole = "$\\it{O}$", .unit = "N", .x_letters = "$\\it{R}_{12x}$", .y_letters = "$\\it{R}_{12y}$"};
  Hodograph::Curve curve{.name = "R_12", .points = {}};
  for (const Moving& each : swing(givens, Omega, period / 2, smooth)) {
    const double a = -Omega * Omega * std::sin(each.position), sine = std::sin(each.position),
                 cosine = std::cos(each.position), square = each.rate * each.rate;
    curve.points.push_back({m_r * (a * cosine - square * sine), weight + m_r * (a * sine + square * cosine)});
  }
  hodograph.curves = {curve};
  double longest = 0;
  for (const Place& tip : curve.points) longest = std::max(longest, std::hypot(tip.x, tip.y));
  constexpr double letters_wide = 0.04;  // of the longest
  std::vector<Place> lettered;
  for (const std::string& name : instants("R_12_x")) {
    const auto x = s.value(pen(at("R_12_x", name))), y = s.value(pen(at("R_12_y", name)));
    if (!x || !y) continue;
    const bool is_clear = std::all_of(lettered.begin(), lettered.end(), [&](const Place& other) {
      return std::hypot(other.x - *x, other.y - *y) > letters_wide * longest;
    });
    if (is_clear) lettered.push_back({*x, *y});
    hodograph.instants.push_back({.tip = {*x, *y},
                                  .label = is_clear ? in_seconds(name, language) : "",
                                  .along_x = pen(at("R_12_x", name)),
                                  .along_y = pen(at("R_12_y", name)),
                                  .with_arrow = name == "0" || name == "0p1" || name == "0p2" || name == "0p3"});
  }
  hodograph.steps = {
      {{"From the pole $\\it{O}$ the reaction at every instant, to one scale: its tip runs through the hodograph to "
        "and fro in one period. Numbers: $t$ in s.",
        "Dal polo $\\it{O}$ la reazione a ogni istante, in una sola scala: il suo estremo percorre l'odografa, "
        "avanti e "
        "indietro in un periodo. Numeri: $t$ in s."},
       Place{0, 0}}};
  return HodographPanel(std::move(hodograph));
}

ChartPanel angle_chart(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double Omega = s[pen("Omega")], period = s[pen("period")], small = s[pen("period_small")],
               theta_0 = geometry::to_double(givens.angle("theta_0")), end = end_of_angle_chart(s);
  const std::vector<Moving> table = angle_of_table(s);
  Line cosine;
  for (int i = 0; i <= smooth; ++i)
    cosine.push_back({end * i / smooth, theta_0 * std::cos(Omega * end * i / smooth)});
  drawings::Chart chart;
  const double most = 1.35 * std::abs(theta_0);
  chart.x = axis("$t$", "s", {0, end});
  chart.y = axis("$θ$", "rad", {-most, most});
  chart.horizontals = {{.at = 0}};
  chart.verticals = {{.at = period, .label = "$\\it{T}$", .meaning = Meaning::locus},
                     {.at = small, .label = "$\\it{T}_{0}$"}};
  const auto of_table = s.value(pen("period_numeric"));
  if (of_table) chart.verticals.push_back({.at = *of_table, .label = "$\\it{T}_{n}$", .meaning = Meaning::velocity});
  chart.curves = {
      {.name = "theta",
       .runs = {over_time(swing(givens, Omega, end, smooth))},
       .meaning = Meaning::locus,
       .label = Words{"exact", "esatta"}.in(language)},
      {.name = "theta_small", .runs = {cosine}, .meaning = Meaning::construction, .label = "$θ_{0}$cos $Ωt$"},
      {.name = "theta_numeric",
       .runs = {thinned(over_time(table), 400)},
       .meaning = Meaning::velocity,
       .label = Words{"recursion", "ricorsiva"}.in(language)}};
  std::vector<ChartPanel::Read> all;
  for (const char* of : {"theta", "theta_numeric", "theta_small"})
    for (const std::string& name : instants(of)) read(all, s, seconds(name), {}, pen(at(of, name)));
  all.push_back({{s[pen("t_first_bottom")], 0}, pen("t_first_bottom"), {}});
  all.push_back({{period, 0}, pen("period"), {}});
  all.push_back({{small, 0}, pen("period_small"), {}});
  if (of_table) all.push_back({{*of_table, 0}, pen("period_numeric"), {}});
  return ChartPanel(chart, all);
}

std::vector<std::string> all_pen(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(pen(name));
  return all;
}

}  // namespace

PanelSheet motion_sheet(const Solution& s, Language language) {
  const Words euler{
      "Euler's polygon goes on from each point along its own tangent for Δ$t$: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, "
      "$x'_{i+1}$ = $x'_{i}$ + $x''_{i}$Δ$t$. $e$ = ($x_{E}$ − $x$)/$x$ at one instant.",
      "Il poligono di Eulero prosegue da ogni punto per Δ$t$ lungo la tangente: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, "
      "$x'_{i+1}$ = $x'_{i}$ + $x''_{i}$Δ$t$. $e$ = ($x_{E}$ − $x$)/$x$ allo stesso istante."};
  return {
      .panels = panels(motion_chart(s, language)),
      .theory = {{{"Law of motion", "Legge del moto"},
                  {remark("$x''$ + 2$ζω_{n}x'$ + $ω_{n}^{2}x$ = 0; " + law_in_words(s.givens()["zeta"]).in(language)),
                   remark(euler.in(language))}}},
      .results = {values({osc("alpha"), osc("beta")}), values({osc("C_1"), osc("C_2")}),
                  values({osc("t_x_max"), osc("x_max")}), values({osc("t_inflection"), osc("x_inflection")}),
                  table({"$t$ (s)", "$x$ (m)", "$x_{E}$ (m)", "$e$"},
                        rows_of_oscillator({"x", "x_euler", "err_euler"}))},
      .seen = {"The position of the oscillator over time, exact and by Euler's method",
               "La posizione dell'oscillatore nel tempo, esatta e con il metodo di Eulero"},
      .told = {osc("x_max"), osc("t_x_max"), osc("x_at_5"), osc("x_euler_at_5")},
      .without_part = givens_of_pendulum};
}

PanelSheet phase_plane_sheet(const Solution& s, Language language) {
  const Words isoclines{
      "On a straight line through the origin all trajectories have one direction (strokes): d$x'$/d$x$ = −2$ζω_{n}$ "
      "− "
      "$ω_{n}^{2}x$/$x'$.",
      "Su una retta per l'origine tutte le traiettorie hanno una direzione (trattini): d$x'$/d$x$ = −2$ζω_{n}$ − "
      "$ω_{n}^{2}x$/$x'$."};
  const Words straight =
      s.givens()["zeta"] < 1
          ? Words{"$ζ$ < 1: no line is its own direction, so no trajectory is straight, and all wind round the origin.",
                  "$ζ$ < 1: nessuna retta coincide con la propria direzione, nessuna traiettoria è rettilinea, e tutte si "
                  "avvolgono sull'origine."}
          : Words{"Where the line has its own direction it is a trajectory: its slope is a root of the characteristic "
                  "equation. All others end in the origin along $x'$ = $λ_{1}x$.",
                  "Dove la retta coincide con la propria direzione è essa stessa una traiettoria: la pendenza è radice "
                  "dell'equazione caratteristica. Tutte le altre finiscono nell'origine lungo $x'$ = $λ_{1}x$."};
  return {
      .panels = panels(oscillator_plane(s, language)),
      .theory = {{{"The plane", "Il piano"}, {remark(isoclines.in(language)), remark(straight.in(language))}}},
      .results = {values({osc("lambda_1"), osc("lambda_2")}), values({osc("c"), osc("k"), osc("c_critical")}),
                  values({osc("x_max"), osc("x_inflection"), osc("x_dot_min")}),
                  values({osc("E_0"), osc("E_at_x_max")}),
                  table({"$t$ (s)", "$x'$ (m/s)", "$x'_{E}$ (m/s)"}, rows_of_oscillator({"x_dot", "x_dot_euler"}))},
      .seen = {"The phase plane of the oscillator with isoclines, straight trajectories and Euler's polygon",
               "Il piano delle fasi dell'oscillatore con isocline, traiettorie rettilinee e poligono di Eulero"},
      .told = {osc("x_max"), osc("x_dot_min"), osc("E_0"), osc("E_at_x_max")},
      .without_part = givens_of_pendulum};
}

PanelSheet pendulum_plane_sheet(const Solution& s, Language language) {
  const RunOfTable run = run_of_table(spiral_of_table(s), s[pen("Omega")]);
  const Words closed{"The exact orbit is closed: $θ'^{2}$ = 2$Ω^{2}$(cos $θ$ − cos $θ_{0}$). ",
                     "L'orbita esatta è chiusa: $θ'^{2}$ = 2$Ω^{2}$(cos $θ$ − cos $θ_{0}$). "},
      winds{"The recursion adds energy at every step and winds outwards",
            "La formula ricorsiva aggiunge energia a ogni passo e si apre in spirale"},
      wavers{"The recursion does not keep the energy: some steps add to it, others take from it",
             "La formula ricorsiva non conserva l'energia: alcuni passi ne aggiungono, altri ne tolgono"},
      over{"; it goes over the top", "; passa per il punto più alto"}, stop{". ", ". "};
  std::string rings;
  for (const char* name : {"0p5", "1"})
    if (s.value(pen(at("theta_numeric", name))))
      rings += (rings.empty() ? "" : ", ") + geometry::to_text(instant(name) * 1000) + " ms";
  const Words told_rings =
      rings.empty() ? Words{}
                    : format_words("Rings: its values after {}. ", "Anelli: i suoi valori dopo {}. ", rings);
  const Words orbit = closed + (run.gains_always ? winds : wavers) + (run.goes_over ? over + stop : stop) +
                      told_rings + Words{"Numbers: $t$ in s.", "Numeri: $t$ in s."};
  return {.panels = panels(pendulum_plane(s, language)),
          .theory = {{{"The plane", "Il piano"}, {remark(orbit.in(language))}}},
          .results = {values(all_pen({"I_A0", "equivalent_length"})), values(all_pen({"Omega", "theta_dot_max"})),
                      values(all_pen({"energy_ratio_numeric_at_1"})),
                      table({"$t$ (ms)", "$θ$ (rad)", "$θ'$ (rad/s)"}, rows_of_pendulum({"theta", "theta_dot"}))},
          .seen = {"The phase plane of the pendulum: the exact orbit, the spiral of the recursion, the separatrix",
                   "Il piano delle fasi del pendolo: orbita esatta, spirale della formula ricorsiva, separatrice"},
          .told = {pen("theta_dot_max"), pen("energy_ratio_numeric_at_1")},
          .without_part = givens_of_oscillator};
}

PanelSheet positions_sheet(const Solution& s, Language language) {
  const std::string now = "0p2";
  const Words told{
      "Solid: the pendulum at $t$ = 200 ms; dashed: at the start and after 100, 300, 400, 500 ms. With d'Alembert's "
      "force $\\it{F}_{G}$ = −$m_{p}a_{G}$ the weight and the reaction of the frame are in equilibrium.",
      "Continuo: il pendolo per $t$ = 200 ms; a tratti: alla partenza e dopo 100, 300, 400, 500 ms. Con la forza "
      "d'inerzia $\\it{F}_{G}$ = −$m_{p}a_{G}$ il peso e la reazione del telaio sono in equilibrio."};
  return {
      .panels = panels(PositionsPanel(s, now), forces_panel(s, now, language)),
      .theory = {{{"Free body", "Corpo libero"}, {remark(told.in(language))}}},
      .results = {values(all_pen({"weight"})), values(all_pen({at("theta", now), at("theta_dot", now)})),
                  values(all_pen({at("theta_ddot", now)})), values(all_pen({at("R_12_x", now), at("R_12_y", now)}))},
      .seen = {"Positions of the pendulum, and the force polygon of one of them",
               "Posizioni del pendolo, e il poligono delle forze di una di esse"},
      .told = all_pen({at("R_12_x", now), at("R_12_y", now)}),
      .without_part = givens_of_oscillator};
}

PanelSheet hodograph_sheet(const Solution& s, Language language) {
  const Words circle{
      "Let go level, $θ'^{2}$ = 2$Ω^{2}$cos $θ$, and the hodograph is a circle of the diameter "
      "3$m_{p}rΩ^{2}$.",
      "Lasciato da $A_{0}G$ orizzontale, $θ'^{2}$ = 2$Ω^{2}$cos $θ$ e l'odografa è un cerchio di diametro "
      "3$m_{p}rΩ^{2}$."};
  const Angle theta_0 = s.givens().angle("theta_0");
  const bool is_level = theta_0.radians == 0 && (theta_0.turns == Rational(1, 4) || theta_0.turns == Rational(-1, 4));
  return {.panels = panels(hodograph_panel(s, language)),
          .theory = {{{"Its shape", "La forma"}, {remark(is_level ? circle.in(language) : "")}}},
          .results = {values(all_pen({"R_12_x_max", "t_R_12_x_max"})), values(all_pen({"R_12_y_max", "R_12_y_min"})),
                      table({"$t$ (ms)", "$\\it{R}_{12x}$ (N)", "$\\it{R}_{12y}$ (N)"},
                            rows_of_pendulum({"R_12_x", "R_12_y"}))},
          .seen = {"The hodograph of the reaction of the frame on the pendulum",
                   "L'odografa della reazione del telaio sul pendolo"},
          .told = all_pen({"R_12_x_max", "R_12_y_max", "R_12_y_min"}),
          .without_part = givens_of_oscillator};
}

PanelSheet angle_sheet(const Solution& s, Language language) {
  const RunOfTable run = run_of_table(angle_of_table(s), s[pen("Omega")]);
  const Words exact{
      "$\\it{T}$ = 4$\\it{K}$/$Ω$ of the exact motion, $\\it{T}_{0}$ = 2$π$/$Ω$ of small swings",
      "$\\it{T}$ = 4$\\it{K}$/$Ω$ del moto esatto, $\\it{T}_{0}$ = 2$π$/$Ω$ delle piccole oscillazioni"},
      over{". The recursion goes over the top, and has no period.",
           ". La formula ricorsiva passa per il punto più alto e non ha periodo."},
      not_yet{". The recursion has not swung to and fro by then.",
              ". La formula ricorsiva non ha ancora compiuto un'oscillazione."};
  const Words of_row{
      ", $\\it{T}_{n}$ of the recursion: the step at which it rests again on the side where it began.",
      ", $\\it{T}_{n}$ della formula ricorsiva: il passo in cui si ferma di nuovo dalla parte da cui è partita."};
  const Words recursion = s.value(pen("period_numeric")) ? of_row : run.goes_over ? over : not_yet;
  const Words periods = exact + recursion;
  return {
      .panels = panels(angle_chart(s, language)),
      .theory = {{{"Periods", "Periodi"}, {remark(periods.in(language))}}},
      .results = {values(all_pen({"k", "K"})), values(all_pen({"period", "period_small", "period_numeric"})),
                  values(all_pen({"period_ratio"})), values(all_pen({"t_first_bottom"})),
                  table({"$t$ (ms)", "$θ$ (rad)", "$θ_{n}$ (rad)"}, rows_of_pendulum({"theta", "theta_numeric"}))},
      .seen = {"The angle of the pendulum over time: exact, for small swings, and by the recursion",
               "L'angolo del pendolo nel tempo: esatto, per piccole oscillazioni e con la formula ricorsiva"},
      .told = all_pen({"period", "period_small", "theta_at_1", "theta_numeric_at_1"}),
      .without_part = givens_of_oscillator};
}

}  // namespace epure::oscillator_pendulum
