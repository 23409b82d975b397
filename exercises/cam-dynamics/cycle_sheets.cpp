// The whole turn: the lift by inversion, pressure angle, acceleration and closing force.
#include <algorithm>
#include <cmath>

#include "exercises/cam-dynamics/figures.h"
#include "exercises/kit/panels/cam_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/sized_chart.h"

namespace epure::cam_dynamics {
namespace {

using drawings::Datum;

constexpr ChartSize beside_another{72, 52};

std::string name(const std::string& quantity) { return "cycle." + quantity; }

// The lift's closed form on doubles, by the angle in radians: curves between the points that are quantities.
struct Curves {
  double r, l, e;
  explicit Curves(const Solution& s) : r(given(s, "A0A")), l(given(s, "r") + given(s, "r_r")), e(given(s, "e")) {}
  double across(double t) const { return e - r * std::cos(t); }
  double along(double t) const { return std::sqrt((l - across(t)) * (l + across(t))); }
  double y(double t) const { return r * std::sin(t) + along(t); }
  double pressure(double t) const { return std::atan2(across(t), along(t)); }
  double y2(double t) const {
    const double c = std::cos(t), s = std::sin(t), d = across(t), u = along(t);
    return -r * s - (r * s * r * s + d * r * c) / u - d * d * r * s * r * s / (u * u * u);
  }
};

// Where the follower stands across its axis but for less than doubles tell, the curve has a gap.
template <class Function>
std::vector<std::vector<Datum>> over_the_turn(const Function& of) {
  constexpr int pieces = 360;
  std::vector<std::vector<Datum>> runs{{}};
  for (int i = 0; i <= pieces; ++i) {
    const double y = of(i * M_PI / 180);
    if (std::isfinite(y))
      runs.back().push_back({static_cast<double>(i), y});
    else
      runs.emplace_back();
  }
  return runs;
}

drawings::Chart over_angle(const std::string& quantity, const std::string& unit,
                           const std::vector<std::vector<Datum>>& runs, Meaning meaning) {
  double low = 0, high = 0;
  for (const auto& run : runs)
    for (const Datum& each : run) low = std::min(low, each.y), high = std::max(high, each.y);
  if (high == low) high = low + 1;
  const double air = 0.12 * (high - low);
  drawings::Chart chart;
  chart.x = {.quantity = "$φ$", .unit = "°", .low = 0, .high = 360, .steps = drawings::degree_steps};
  chart.y = {
      .quantity = quantity, .unit = unit, .low = low < 0 ? low - air : low, .high = high > 0 ? high + air : high};
  chart.letters_left = 16;
  chart.horizontals = {{.at = 0}};
  chart.curves = {{.name = "curve", .runs = runs, .meaning = meaning}};
  return chart;
}

void mark(drawings::Chart& chart, const Datum& at, const std::string& letters, Meaning meaning) {
  chart.markers.push_back({.at = at, .label = letters, .meaning = meaning});
}

SizedChart lift_chart(const Solution& s, const Curves& of) {
  const double low = s[name("y_B_min")];
  drawings::Chart chart =
      over_angle("$h$", "m", over_the_turn([&](double t) { return of.y(t) - low; }), Meaning::velocity);
  std::vector<ChartPanel::Read> read;
  for (int n = 0; n < 360; n += 30) {
    const std::string lift = name("lift_at_" + std::to_string(n));
    read.push_back({{static_cast<double>(n), s[lift]}, {}, lift});
    chart.curves.front().points.push_back(read.back().at);
  }
  const Datum highest{s[name("angle_at_max_lift_deg")], s[name("lift")]}, lowest{s[name("angle_at_min_lift_deg")], 0};
  mark(chart, highest, "$φ_{max}$", Meaning::velocity);
  mark(chart, lowest, "$φ_{min}$", Meaning::velocity);
  read.push_back({highest, name("angle_at_max_lift_deg"), name("lift")});
  read.push_back({lowest, name("angle_at_min_lift_deg"), {}});
  return SizedChart(chart, read, beside_another);
}

SizedChart pressure_chart(const Solution& s, const Curves& of) {
  drawings::Chart chart =
      over_angle("$δ$", "°", over_the_turn([&](double t) { return of.pressure(t) * 180 / M_PI; }), Meaning::locus);
  const Datum greatest{180, s[name("pressure_angle_max_deg")]}, least{0, s[name("pressure_angle_min_deg")]};
  mark(chart, greatest, "$δ_{max}$", Meaning::locus);
  mark(chart, least, "$δ_{min}$", Meaning::locus);
  return SizedChart(chart,
                    {{greatest, {}, name("pressure_angle_max_deg")}, {least, {}, name("pressure_angle_min_deg")}},
                    beside_another);
}

CamPanel inversion(const Solution& s) {
  CamFigure cam{.A0 = {0, 0},
                .A = s.place(name("A")),
                .disc = given(s, "r"),
                .roller = given(s, "r_r"),
                .positions = {},
                .steps = {}};
  for (int n = 0; n < 360; n += 30) {
    const std::string at = std::to_string(n);
    cam.positions.push_back({at, name("lift_at_" + at), s.place(name("foot_" + at)), s.place(name("lowest_" + at)),
                             s.place(name("roller_" + at))});
  }
  cam.steps = {
      {{"The cam is held with $A_{0}A$ at 0°, and the frame turned back: the follower's axis touches the circle of "
        "radius |$e$| about $A_{0}$.",
        "La camma si ferma con $A_{0}A$ a 0° e si fa ruotare all'indietro il telaio: l'asse del cedente tocca il "
        "cerchio di raggio |$e$| di centro $A_{0}$."},
       cam.positions[2].foot},
      {{"The circle of radius $AB$ about $A$ cuts it in the roller's centre.",
        "Il cerchio di raggio $AB$ e centro $A$ lo taglia nel centro del rullo."},
       cam.positions[3].roller},
      {{"The circle about $A_{0}$ through the lowest roller's centre: beyond it the axis shows the lift $h$.",
        "Il cerchio di centro $A_{0}$ per il centro del rullo più basso: oltre di esso l'asse mostra l'alzata $h$."},
       cam.positions[4].lowest}};
  return CamPanel(cam);
}

Result lifts() {
  std::vector<Row> both;
  for (int n = 0; n < 180; n += 30)
    both.push_back({std::to_string(n) + "°",
                    {name("lift_at_" + std::to_string(n)), name("lift_at_" + std::to_string(n + 180))}});
  return table({"$φ$", "$h$($φ$) (m)", "$h$($φ$ + 180°) (m)"}, both);
}

}  // namespace

PanelSheet lift_sheet(const Solution& s, Language language) {
  const Curves of(s);
  const Words letters{
      "$δ$: the pressure angle, of $AB$ with the guide. $φ_{r}$: the turn of the cam while it lifts.",
      "$δ$: l'angolo di pressione, di $AB$ con la guida. $φ_{r}$: la rotazione di salita della camma."};
  return {.panels = panels(inversion(s), lift_chart(s, of), pressure_chart(s, of)),
          .results = {values({name("y_B_max"), name("y_B_min")}), values({name("lift"), name("rise_angle_deg")}),
                      values({name("angle_at_max_lift_deg"), name("angle_at_min_lift_deg")}),
                      values({name("pressure_angle_max_deg"), name("pressure_angle_min_deg")}),
                      remark(letters.in(language)), lifts()},
          .seen = {"The follower round the cam by inversion, its lift and its pressure angle over the turn",
                   "Il cedente attorno alla camma per inversione, la sua alzata e l'angolo di pressione nel giro"},
          .told = {name("lift"), name("y_B_max"), name("y_B_min"), name("pressure_angle_max_deg")},
          .without_part = {"phi", "m_2", "m_3", "P", "g", "n", "n_lift"}};
}

PanelSheet closing_force_sheet(const Solution& s, Language language) {
  const Curves of(s);
  const double w = geometry::to_double(s.givens().angle("n_lift")), m_3 = given(s, "m_3"), g = given(s, "g");
  const auto a = [&](double t) { return w * w * of.y2(t); };
  const auto needed = [&](double t) { return -m_3 * (a(t) + g); };
  drawings::Chart accelerations = over_angle("$a_{B3}$", "m/s²", over_the_turn(a), Meaning::acceleration),
                  forces = over_angle("$\\it{P}$", "N", over_the_turn(needed), Meaning::force);
  std::vector<ChartPanel::Read> of_a, of_P;
  if (const auto at = s.value(name("angle_at_P_min_deg"))) {
    const Datum least{*at, s[name("a_B3_y_min")]}, most{*at, s[name("P_min")]};
    mark(accelerations, least, "$a_{min}$", Meaning::acceleration);
    mark(forces, most, "$\\it{P}_{min}$", Meaning::force);
    of_a = {{least, name("angle_at_P_min_deg"), name("a_B3_y_min")}};
    of_P = {{most, name("angle_at_P_min_deg"), name("P_min")}};
    const Datum lifted{s["maximum_lift.angle_of_A0A_deg"], s["maximum_lift.P_min"]};
    mark(forces, lifted, Words{"maximum lift", "alzata massima"}.in(language), Meaning::force);
    of_P.push_back({lifted, "maximum_lift.angle_of_A0A_deg", "maximum_lift.P_min"});
  }
  forces.horizontals.push_back({.at = given(s, "P"), .label = "$\\it{P}$"});
  constexpr ChartSize across{110, 52};
  const Words keeps{
      "Contact is kept where $\\it{P}$ + $\\it{P}_{3}$ + $m_{3}a_{B3}$ ≥ 0: over the whole turn it takes the "
      "$\\it{P}$ of the least acceleration, which is that of maximum lift for $e$ = 0 only.",
      "Il contatto resta dove $\\it{P}$ + $\\it{P}_{3}$ + $m_{3}a_{B3}$ ≥ 0: per l'intero giro occorre la $\\it{P}$ "
      "dell'accelerazione minima, che è quella della massima alzata solo per $e$ = 0."};
  const Words first{
      "With the given $\\it{P}$ contact is first lost beyond $ω_{2,P}$, where the acceleration is least",
      "Con la $\\it{P}$ data il contatto si perde dapprima oltre $ω_{2,P}$, dove l'accelerazione è minima"};
  const Words speed = first + (s.givens()["e"] == 0 ? Words{": at maximum lift.", ": alla massima alzata."}
                                                    : Words{"; at maximum lift only beyond $ω_{2,l}$.",
                                                            "; alla massima alzata solo oltre $ω_{2,l}$."});
  const Words enough{"$\\it{P}_{min}$ is negative: the weight alone keeps contact.",
                     "$\\it{P}_{min}$ è negativa: basta il peso a mantenere il contatto."};
  return {.panels = panels(SizedChart(accelerations, of_a, across), SizedChart(forces, of_P, across)),
          .theory = {{{"Contact", "Contatto"},
                      {remark(keeps.in(language)), remark(s[name("P_min")] < 0 ? enough.in(language) : ""),
                       remark(s.value(name("omega_2_first_loss")) ? speed.in(language) : "")}}},
          .results = {values({"maximum_lift.omega_2"}), values({name("a_B3_y_min"), name("P_min")}),
                      values({name("angle_at_P_min_deg")}), values({name("omega_2_first_loss")}),
                      values({"maximum_lift.omega_2_contact_loss"})},
          .seen = {"The follower's acceleration and the closing force that keeps contact, over the turn",
                   "L'accelerazione del cedente e la forza di chiusura che mantiene il contatto, nel giro"},
          .told = {name("a_B3_y_min"), name("P_min"), name("angle_at_P_min_deg"), name("omega_2_first_loss"),
                   "maximum_lift.omega_2_contact_loss"},
          .without_part = {"phi", "m_2", "n"}};
}

}  // namespace epure::cam_dynamics
