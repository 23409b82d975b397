// Both dead centres of the rocker in one picture: the ends of its swing.
#include <cmath>
#include <numbers>

#include "exercises/four-bar/linkage.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::four_bar {
namespace {

// The short way from one direction to the other.
double turn(double from, double to) { return std::remainder(to - from, 2 * std::numbers::pi); }

// The linkage extended, A₁ B₁ C₁, and folded.
Mechanism both(const Solution& s, const std::string& extended, const std::string& folded) {
  using Joint = Mechanism::Joint;
  Mechanism mechanism;
  mechanism.point("A0", s.place(extended + "A0"), Joint::fixed, "$A_{0}$")
      .point("B0", s.place(extended + "B0"), Joint::fixed, "$B_{0}$");
  for (const auto& [number, prefix] : {std::pair{"1", extended}, {"2", folded}})
    for (const auto& [letter, joint] : {std::pair{"A", Joint::hinge}, {"B", Joint::hinge}, {"C", Joint::none}})
      mechanism.point(std::string(letter) + number, s.place(prefix + letter), joint,
                      std::string("$") + letter + "_{" + number + "}$");
  const double to_1 = direction(mechanism.at("B0"), mechanism.at("B1")),
               swing = turn(to_1, direction(mechanism.at("B0"), mechanism.at("B2")));
  constexpr double beyond = 0.16;  // radians of the rocker's way
  mechanism.body({"A0", "A1"}, 2)
      .body({"A1", "B1", "C1"}, 3)
      .body({"B0", "B1"}, 4)
      .other_position({"A0", "A2"})
      .other_position({"A2", "B2", "C2"})
      .other_position({"B0", "B2"})
      .axis(mechanism.at("A0"), mechanism.at("B0"))
      .path("A0", "A1")
      .swing("B0", "B1", std::min(0.0, swing) - beyond, std::max(0.0, swing) + beyond)
      .turning("A0", "A1", sign_of(problem(s.givens()).instant.n), "$ω_{2}$")
      .found_in(1, {"B1"})
      .found_in(2, {"B2"})
      .found_in(3, {"A1", "A2", "C1", "C2"});
  for (const auto& [number, prefix] : {std::pair{"1", extended}, {"2", folded}})
    if (const auto phi = s.value(prefix + "crank_angle"))
      mechanism.angle("A0", 0, *phi, std::string("$φ_{") + number + "}$");
  if (s.value("rocker_swing")) mechanism.angle("B0", to_1, to_1 + swing, "$Δθ_{4}$");
  return mechanism;
}

class DeadCentresPanel : public MechanismPanel {
 public:
  DeadCentresPanel(std::shared_ptr<const Mechanism> mechanism, const std::string& extended, const std::string& folded)
      : MechanismPanel(mechanism, {{extended + "A", mechanism->at("A1")},
                                   {extended + "B", mechanism->at("B1")},
                                   {extended + "C", mechanism->at("C1")},
                                   {folded + "A", mechanism->at("A2")},
                                   {folded + "B", mechanism->at("B2")},
                                   {folded + "C", mechanism->at("C2")}}),
        mechanism_(std::move(mechanism)) {}

  std::vector<Place> lettered() const override { return mechanism_->corners(); }

  // The compasses' arcs that find B₁ and B₂, a little to both sides.
  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    for (const auto& [name, letters] : {std::pair{"A0", "$A_{0}$"}, std::pair{"B0", "$B_{0}$"}}) {
      plot.cross(mechanism_->at(name), Meaning::construction);
      plot.label(letters, mechanism_->at(name));
    }
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    for (const char* B : {"B1", "B2"}) compass_arc(plot, mechanism_->at("A0"), mechanism_->at(B), 16);
    return MechanismPanel::draw(plot, room, language);
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {{{"The arc about $A_{0}$ with radius $AB$ + $A_{0}A$ cuts the arc of the rocker at $B_{1}$: crank and "
              "coupler extended.",
              "L'arco di centro $A_{0}$ e raggio $AB$ + $A_{0}A$ taglia l'arco del bilanciere in $B_{1}$: manovella "
              "e biella distese."},
             mechanism_->at("B1")},
            {{"The arc with radius |$AB$ − $A_{0}A$| cuts it at $B_{2}$: crank and coupler folded (dashed).",
              "L'arco di raggio |$AB$ − $A_{0}A$| lo taglia in $B_{2}$: manovella e biella sovrapposte (a tratti)."},
             mechanism_->at("B2")},
            {{"$A_{1}$ on $A_{0}B_{1}$, $A_{2}$ on the line $A_{0}B_{2}$. The pole $P_{31}$ is $B$: $v_{B}$ = 0, "
              "$ω_{4}$ = 0, and $\\vec{a}_{B}$ is all tangential.",
              "$A_{1}$ su $A_{0}B_{1}$, $A_{2}$ sulla retta $A_{0}B_{2}$. Il polo $P_{31}$ è $B$: $v_{B}$ = 0, "
              "$ω_{4}$ = 0, e la $\\vec{a}_{B}$ è tutta tangenziale."},
             mechanism_->at("A2")}};
  }

 private:
  std::shared_ptr<const Mechanism> mechanism_;
};

}  // namespace

namespace {

PanelSheet linkage_alone(const Solution& s, Language language, const Words& why) {
  const Words drawn{" Drawn: the linkage at its instant.", " È disegnato il meccanismo all'istante dato."};
  return {.panels = panels(MechanismPanel(linkage(s))),
          .results = {remark((why + drawn).in(language))},
          .seen = {"No dead centre", "Nessun punto morto"},
          .without_part = without()};
}

Words without_both(bool has_extended, bool has_folded) {
  if (has_extended)
    return {
        "This rocker has one dead centre only, with crank and coupler extended: folded they cannot come in line, or "
        "do so at a change point.",
        "Questo bilanciere ha un solo punto morto, con manovella e biella distese: sovrapposte non possono "
        "allinearsi, o lo fanno in una configurazione di incertezza."};
  if (has_folded)
    return {
        "This rocker has one dead centre only, with crank and coupler folded: extended they cannot come in line, or "
        "do so at a change point.",
        "Questo bilanciere ha un solo punto morto, con manovella e biella sovrapposte: distese non possono "
        "allinearsi, o lo fanno in una configurazione di incertezza."};
  return {"This rocker has no dead centre: crank and coupler cannot come in line, or do so at a change point.",
          "Questo bilanciere non ha punti morti: manovella e biella non possono allinearsi, o lo fanno in una "
          "configurazione di incertezza."};
}

}  // namespace

PanelSheet no_dead_centre(const Solution& s, Language language) {
  return linkage_alone(
      s, language,
      {"This rocker has not this dead centre: crank and coupler cannot come in line so, or do so at a change point.",
       "Questo bilanciere non ha questo punto morto: manovella e biella non possono allinearsi così, o lo fanno in "
       "una configurazione di incertezza."});
}

PanelSheet dead_centres_sheet(const Solution& s, Language language) {
  const std::string extended = dead_centre(geometry::Reach::extended).prefix,
                    folded = dead_centre(geometry::Reach::folded).prefix;
  const bool has_extended = s.value(extended + "A_x").has_value(), has_folded = s.value(folded + "A_x").has_value();
  if (!has_extended || !has_folded) return linkage_alone(s, language, without_both(has_extended, has_folded));
  const auto row = [&](const char* number, const std::string& prefix, std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, prefix);
    return Row{number, names};
  };
  const std::vector<std::string> angles{"crank_angle_deg", "rocker_angle_deg", "omega_3"},
      rates{"alpha_3", "alpha_4"};
  return {.panels = panels(
              DeadCentresPanel(std::make_shared<const Mechanism>(both(s, extended, folded)), extended, folded)),
          .results = {table({"", "$φ$ (°)", "$θ_{4}$ (°)", "$ω_{3}$ (rad/s)"},
                            {row("1", extended, angles), row("2", folded, angles)}),
                      table({"", "$α_{3}$ (rad/s²)", "$α_{4}$ (rad/s²)"},
                            {row("1", extended, rates), row("2", folded, rates)}),
                      values({"rocker_swing_deg", "crank_rotation_extended_to_folded_deg"}), values({"time_ratio"}),
                      remark(s.value("time_ratio") ? Words{"$τ$: time of the slower stroke over that of the quicker, "
                                                           "at constant $ω_{2}$, from $Δφ$ and 360° − $Δφ$.",
                                                           "$τ$: tempo della corsa lenta su quello della rapida, a "
                                                           "$ω_{2}$ costante, da $Δφ$ e 360° − $Δφ$."}
                                                         .in(language)
                                                   : "")},
          .seen = {"The four-bar linkage in both dead centres of its rocker",
                   "Il quadrilatero articolato nei due punti morti del bilanciere"},
          .told = {extended + "alpha_4", folded + "alpha_4", "rocker_swing", "time_ratio"},
          .without_part = without({"t", "phi"})};
}

}  // namespace epure::four_bar
