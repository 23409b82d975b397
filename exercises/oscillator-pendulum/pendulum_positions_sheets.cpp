#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/hodograph_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/tracks.h"
#include "exercises/oscillator-pendulum/charts.h"
#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/oscillator-pendulum/quantities.h"
#include "exercises/oscillator-pendulum/sheets.h"

namespace epure::oscillator_pendulum {
namespace {

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
    drawn.point(point, place_of(r, *theta), Joint::none, is_clear ? in_milliseconds(name) + " ms" : "");
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
      plot.vector_on("", beside_the_others(plot, each), weight_ + each.R, Meaning::acceleration,
                     letters("$m_{p}\\vec{a}_{G}$"));
      const drawings::Point from = plot.at(each.G), to = plot.at(plot.tip(each.G, each.R));
      const double per_mm = 1 / plot.vector_scale().mm_per_unit;
      plot.onto().measurements.push_back({pen(at("R_12_x", each.instant)), from, to, per_mm, Measurement::along_x});
      plot.onto().measurements.push_back({pen(at("R_12_y", each.instant)), from, to, per_mm, Measurement::along_y});
    }
    return {};
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {{{"At three positions the weight and the reaction of the frame, which acts in $A_{0}$, moved to $G$: "
              "they add up to $m_{p}\\vec{a}_{G}$.",
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
  // Where the sum of the two begins: at G, or beside it where it would lie on one of them.
  Place beside_the_others(Plot& plot, const Shown& each) const {
    std::vector<VectorOnPaper> vectors;
    for (const Arrow2& v : {weight_, each.R, weight_ + each.R})
      vectors.emplace_back(plot.at(each.G), plot.at(plot.tip(each.G, v)));
    const drawings::Point by = tracks(vectors, vectors[1].second, LyingOver::anything).back().by, G = plot.at(each.G);
    const Place start = plot.from_paper({G.x + by.x, G.y + by.y});
    if (by.x != 0 || by.y != 0) plot.segment(each.G, start, Meaning::dimension);
    return start;
  }

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

HodographPanel hodograph_panel(const Solution& s) {
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
  constexpr double letters_wide = 0.02, one_point = 0.004;  // of the longest
  std::vector<Place> lettered;
  for (const std::string& name : instants("R_12_x")) {
    const auto x = s.value(pen(at("R_12_x", name))), y = s.value(pen(at("R_12_y", name)));
    if (!x || !y) continue;
    const auto is_there = [&](const Hodograph::Instant& other) {
      return std::hypot(other.tip.x - *x, other.tip.y - *y) < one_point * longest;
    };
    const auto same = std::find_if(hodograph.instants.begin(), hodograph.instants.end(), is_there);
    if (same != hodograph.instants.end() && !same->label.empty()) same->label += "; " + in_milliseconds(name);
    const bool is_clear = std::all_of(lettered.begin(), lettered.end(), [&](const Place& other) {
      return std::hypot(other.x - *x, other.y - *y) > letters_wide * longest;
    });
    if (is_clear) lettered.push_back({*x, *y});
    hodograph.instants.push_back({.tip = {*x, *y},
                                  .label = is_clear ? in_milliseconds(name) : "",
                                  .along_x = pen(at("R_12_x", name)),
                                  .along_y = pen(at("R_12_y", name)),
                                  .with_arrow = name == "0" || name == "0p1" || name == "0p2" || name == "0p4",
                                  .letters = name == "0p2" ? "$\\vec{\\it{R}}_{12}$" : ""});
  }
  hodograph.steps = {{{"From the pole $\\it{O}$ the reaction at every instant, to one scale: its tip runs through "
                       "the hodograph to and fro in one period. Numbers: $t$ in ms.",
                       "Dal polo $\\it{O}$ la reazione a ogni istante, in una sola scala: il suo estremo percorre "
                       "l'odografa, avanti e indietro in un periodo. Numeri: $t$ in ms."},
                      Place{0, 0}}};
  return HodographPanel(std::move(hodograph));
}

}  // namespace

PanelSheet positions_sheet(const Solution& s, Language language) {
  const std::string now = "0p2";
  const Words told{
      "Solid: the pendulum at $t$ = 200 ms; dashed: at the start and after 100, 300, 400, 500 ms. With d'Alembert's "
      "force $\\it{F}_{G}$ = −$m_{p}a_{G}$ the weight and the reaction of the frame are in equilibrium.",
      "Continuo: il pendolo per $t$ = 200 ms; tratteggiato: alla partenza e dopo 100, 300, 400, 500 ms. Con la forza "
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
      "Let go level, $θ'^{2}$ = 2$Ω^{2}$cos $θ$, and the hodograph is a circle of the diameter 3$m_{p}rΩ^{2}$.",
      "Lasciato da $A_{0}G$ orizzontale, $θ'^{2}$ = 2$Ω^{2}$cos $θ$ e l'odografa è un cerchio di diametro "
      "3$m_{p}rΩ^{2}$."};
  const Angle theta_0 = s.givens().angle("theta_0");
  const bool is_level = theta_0.radians == 0 && (theta_0.turns == Rational(1, 4) || theta_0.turns == Rational(-1, 4));
  return {.panels = panels(hodograph_panel(s)),
          .theory = {{{"Its shape", "La forma"}, {remark(is_level ? circle.in(language) : "")}}},
          .results = {values(all_pen({"R_12_x_max", "t_R_12_x_max"})), values(all_pen({"R_12_y_max", "R_12_y_min"})),
                      table({"$t$ (ms)", "$\\it{R}_{12x}$ (N)", "$\\it{R}_{12y}$ (N)"},
                            rows_of_pendulum({"R_12_x", "R_12_y"}))},
          .seen = {"The hodograph of the reaction of the frame on the pendulum",
                   "L'odografa della reazione del telaio sul pendolo"},
          .told = all_pen({"R_12_x_max", "R_12_y_max", "R_12_y_min"}),
          .without_part = givens_of_oscillator};
}

}  // namespace epure::oscillator_pendulum
