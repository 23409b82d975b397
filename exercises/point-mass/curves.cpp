// The six diagrams; the tangents to the space through the centroids of the accelerations; the errors of the tables.
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/point-mass/exercise.h"
#include "exercises/point-mass/quantities.h"
#include "exercises/point-mass/routes.h"

namespace epure::point_mass {
namespace {

using drawings::Datum;

constexpr int samples = 160;

std::vector<Datum> sampled(const Powers& of, double end) {
  std::vector<Datum> points;
  for (int i = 0; i <= samples; ++i) points.push_back({end * i / samples, of.at<double>(end * i / samples)});
  return points;
}

// With air above and below; what is zero everywhere lies in the middle.
drawings::Axis axis_around(const std::vector<Datum>& points, const std::string& quantity, const std::string& unit) {
  double low = 0, high = 0;
  for (const Datum& point : points) {
    low = std::min(low, point.y);
    high = std::max(high, point.y);
  }
  if (low == high) return {.quantity = quantity, .unit = unit, .low = -1, .high = 1};
  const double air = 0.12 * (high - low);
  return {.quantity = quantity, .unit = unit, .low = low < 0 ? low - air : 0, .high = high > 0 ? high + air : 0};
}

drawings::Axis time_axis(double end) {
  return {.quantity = "$t$", .unit = "s", .low = 0, .high = end, .to_ticks = false};
}

struct Drawn {
  std::string kind, letters;
  Meaning meaning;
  Powers curve;
};
std::vector<Drawn> drawn(const ByPowers& motion) {
  return {{"F", "$\\it{F}$", Meaning::force, motion.F}, {"a", "$a$", Meaning::acceleration, motion.a},
          {"v", "$v$", Meaning::velocity, motion.v},    {"q", "$q$", Meaning::velocity, motion.q},
          {"E", "$\\it{E}$", Meaning::locus, motion.E}, {"s", "$s$", Meaning::locus, motion.s}};
}

drawings::Chart chart_of(const Solution& s, const Problem& of, const Drawn& what, Language language) {
  const double end = nearest(of.end());
  const std::vector<Datum> points = sampled(what.curve, end);
  const std::string unit = written_unit(s.described(of_motion(what.kind, "", "1").name).unit, language);
  drawings::Chart chart{.x = time_axis(end), .y = axis_around(points, what.letters, unit)};
  chart.curves = {{.name = what.kind, .runs = {points}, .meaning = what.meaning}};
  chart.horizontals = {{.at = 0}};
  return chart;
}

// A point of the diagram, its ordinate a quantity, and its abscissa too where it has a name.
struct Special {
  std::string ordinate, abscissa;
};
const std::map<std::string, std::vector<Special>>& specials() {
  static const std::map<std::string, std::vector<Special>> all{
      {"F", {{"F_max", "t_F_max"}, {"F_min", "t_F_min"}, {"", "t_v_max"}}},
      {"a", {{"", "t_v_max"}}},
      {"v", {{"v_max", "t_v_max"}}},
      {"q", {{"q_max", "t_v_max"}}},
      {"E", {{"E_max", "t_v_max"}}},
      {"s", {{"s_at_v_max", "t_v_max"}}}};
  return all;
}

// Of the velocity where the force changes its sign.
geometry::Sign velocity_at(const Problem& of, const Crossing& zero) {
  const Powers v = ByPowers(of).v;
  return zero.at.sign_of([&](const auto& t) { return v.at(t); });
}
Quadratic zeros_of_force(const Problem& of) { return {of.A, of.B, of.C, of.end()}; }

// A maximum of the velocity is one of the energy if the body goes forwards there.
bool has_greatest_energy(const Problem& of) {
  const auto zero = zeros_of_force(of).falling;
  return zero && velocity_at(of, *zero) == geometry::Sign::positive;
}

SizedChart small_chart(const Solution& s, const Problem& of, const Drawn& what, Language language) {
  drawings::Chart chart = chart_of(s, of, what, language);
  std::vector<ChartPanel::Read> read;
  for (int i = 0; i < 3; ++i) {
    const std::string name = of_motion(what.kind, "", instants[i]).name;
    const Datum at{nearest(of.t[i]), s[name]};
    chart.curves.front().points.push_back(at);
    read.push_back({at, {}, name});
  }
  for (const Special& special : specials().at(what.kind)) {
    if (!s.value(special.abscissa) || (special.ordinate == "E_max" && !has_greatest_energy(of))) continue;
    const double t = s[special.abscissa];
    const Datum at{t, special.ordinate.empty() ? 0 : s[special.ordinate]};
    chart.markers.push_back(
        {.at = at,
         .label = special.ordinate.empty() ? s.described(special.abscissa).symbol : figures(at.y, 4, language),
         .shape = drawings::PointShape::ring,
         .meaning = what.meaning});
    read.push_back({at, special.abscissa, special.ordinate});
  }
  chart.letters_left = 15;
  constexpr ChartSize one_of_six{84, 48};
  return SizedChart(std::move(chart), std::move(read), one_of_six);
}

// What v, q, E and s do where the force passes through zero; where it does not, nothing.
Words where_force_changes_sign(const Problem& of) {
  const Quadratic zeros = zeros_of_force(of);
  const Words inflection{", and $s$ has its inflection.", ", e $s$ ha il flesso."};
  Words told;
  if (zeros.falling)
    told = told +
           Words{" Where $\\it{F}$ passes from positive to negative, $v$ and $q$ have a maximum, ",
                 " Dove $\\it{F}$ passa da positiva a negativa, $v$ e $q$ hanno un massimo, "} +
           (has_greatest_energy(of) ? Words{"$\\it{E}$ too", "così $\\it{E}$"}
                                    : Words{"$\\it{E}$ a minimum", "$\\it{E}$ un minimo"}) +
           inflection;
  if (zeros.rising)
    told = told +
           Words{" Where $\\it{F}$ passes from negative to positive, $v$ and $q$ have a minimum, ",
                 " Dove $\\it{F}$ passa da negativa a positiva, $v$ e $q$ hanno un minimo, "} +
           (velocity_at(of, *zeros.rising) == geometry::Sign::negative
                ? Words{"$\\it{E}$ a maximum", "$\\it{E}$ un massimo"}
                : Words{"$\\it{E}$ too", "così $\\it{E}$"}) +
           inflection;
  return told;
}

}  // namespace

PanelSheet curves_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  Panels all;
  for (const Drawn& what : drawn(ByPowers(of)))
    all.push_back(std::make_unique<SizedChart>(small_chart(s, of, what, language)));
  const std::string formulas =
      "$\\it{F}$ = $\\it{A}t^{3}$ + $\\it{B}t^{2}$ + $\\it{C}t$, $a$ = $\\it{F}$/$m$, $v$ = ∫$a$ d$t$, $q$ = $mv$, "
      "$\\it{E}$ = $mv^{2}$/2, $s$ = ∫$v$ d$t$." +
      where_force_changes_sign(of).in(language);
  std::vector<std::string> at_greatest_velocity{"q_max", "s_at_v_max"};
  if (has_greatest_energy(of)) at_greatest_velocity.insert(at_greatest_velocity.begin() + 1, "E_max");
  return {.panels = std::move(all),
          .theory = {{{"The motion", "Il moto"}, {remark(formulas)}}},
          .results = {table({"", "$t_{1}$", "$t_{2}$", "$t_{3}$"}, {{"$\\it{F}$ (N)", {"F_1", "F_2", "F_3"}},
                                                                    {"$a$ (m/s²)", {"a_1", "a_2", "a_3"}},
                                                                    {"$v$ (m/s)", {"v_1", "v_2", "v_3"}},
                                                                    {"$q$ (kg m/s)", {"q_1", "q_2", "q_3"}},
                                                                    {"$\\it{E}$ (J)", {"E_1", "E_2", "E_3"}},
                                                                    {"$s$ (m)", {"s_1", "s_2", "s_3"}}}),
                      values({"t_F_max", "F_max"}), values({"t_F_min", "F_min"}), values({"t_v_max", "v_max"}),
                      values(at_greatest_velocity), values({"impulse_positive", "impulse_negative"})},
          .seen = {"Force, acceleration, velocity, momentum, kinetic energy and space over time",
                   "Forza, accelerazione, velocità, quantità di moto, energia cinetica e spazio nel tempo"},
          .told = {"F_max", "t_v_max", "v_max", "E_max", "s_3"},
          .without_part = {"dt", "strip", "cm_t", "cm_a", "cm_v", "cm_s"}};
}

PanelSheet tangents_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  const std::vector<Drawn> all = drawn(ByPowers(of));
  drawings::Chart accelerations = chart_of(s, of, all[1], language), spaces = chart_of(s, of, all[5], language);
  const double end = nearest(of.end());
  std::vector<ChartPanel::Read> read;
  for (int i = 0; i < 3; ++i) {
    const std::string space = "s_" + instants[i], centroid = centroid_at(instants[i]).name;
    const Datum touches{nearest(of.t[i]), s[space]};
    const double v = s["v_" + instants[i]];
    const auto at = [&](double t) { return Datum{t, touches.y + v * (t - touches.x)}; };
    spaces.curves.push_back({.name = "tangent_" + instants[i],
                             .runs = {{at(0), at(end)}},
                             .meaning = Meaning::construction,
                             .line = drawings::LineType::continuous,
                             .label = "$v_{" + instants[i] + "}$"});
    spaces.curves.front().points.push_back(touches);
    read.push_back({touches, {}, space});
    const std::string& letters = s.described(centroid).symbol;
    accelerations.verticals.push_back(
        {.at = touches.x, .label = "$t_{" + instants[i] + "}$", .meaning = Meaning::axis});
    spaces.verticals.push_back({.at = touches.x, .label = "$t_{" + instants[i] + "}$", .meaning = Meaning::axis});
    if (!s.value(centroid) || s[centroid] < 0 || s[centroid] > end) continue;
    accelerations.verticals.push_back({.at = s[centroid], .label = letters, .meaning = Meaning::construction});
    spaces.verticals.push_back({.at = s[centroid], .label = letters, .meaning = Meaning::construction});
    spaces.markers.push_back({.at = {s[centroid], 0}, .shape = drawings::PointShape::ring});
    read.push_back({{s[centroid], 0}, centroid, {}});
  }
  for (drawings::Chart* chart : {&accelerations, &spaces}) chart->letters_left = 15;
  const Words tangent{
      "$s$($t_{k}$) = ∫($t_{k}$ − $τ$) $a$ d$τ$ = $v_{k}$ ($t_{k}$ − $t_{Gk}$): the tangent at $t_{k}$, of slope "
      "$v_{k}$, meets the axis under the centroid of the accelerations from 0 to $t_{k}$, areas below the axis taken "
      "as negative.",
      "$s$($t_{k}$) = ∫($t_{k}$ − $τ$) $a$ d$τ$ = $v_{k}$ ($t_{k}$ − $t_{Gk}$): la tangente in $t_{k}$, di pendenza "
      "$v_{k}$, incontra l'asse sotto il baricentro delle accelerazioni da 0 a $t_{k}$, con le aree sotto l'asse "
      "negative."};
  return {.panels = panels(SizedChart(std::move(accelerations), {}, {110, 70}),
                           SizedChart(std::move(spaces), std::move(read), {110, 80})),
          .theory = {{{"The tangents", "Le tangenti"}, {remark(tangent.in(language))}}},
          .results = {table({"", "$t_{1}$", "$t_{2}$", "$t_{3}$"},
                            {{"$v$ (m/s)", {"v_1", "v_2", "v_3"}},
                             {"$s$ (m)", {"s_1", "s_2", "s_3"}},
                             {"$t_{G}$ (s)", {"t_centroid_1", "t_centroid_2", "t_centroid_3"}}})},
          .seen = {"Acceleration and space over time, with the tangents to the space at three instants",
                   "Accelerazione e spazio nel tempo, con le tangenti allo spazio in tre istanti"},
          .told = {"t_centroid_1", "t_centroid_2", "t_centroid_3"},
          .without_part = {"dt", "strip", "cm_t", "cm_a", "cm_v", "cm_s"}};
}

}  // namespace epure::point_mass
