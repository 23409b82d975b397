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

// A dead centre that the rocker has: extended, A₁ B₁ C₁, or folded.
struct Numbered {
  std::string number, prefix;
};
std::vector<Numbered> dead_centres_of(const Solution& s) {
  std::vector<Numbered> found;
  for (const auto& [number, reach] : {std::pair{"1", geometry::Reach::extended}, {"2", geometry::Reach::folded}})
    if (const std::string prefix = dead_centre(reach).prefix; s.value(prefix + "A_x"))
      found.push_back({number, prefix});
  return found;
}

// The linkage in the first of them, and in the other.
Mechanism drawn(const Solution& s, const std::vector<Numbered>& centres) {
  using Joint = Mechanism::Joint;
  Mechanism mechanism;
  mechanism.point("A0", s.place(centres.front().prefix + "A0"), Joint::fixed, "$A_{0}$")
      .point("B0", s.place(centres.front().prefix + "B0"), Joint::fixed, "$B_{0}$");
  for (const auto& [number, prefix] : centres)
    for (const auto& [letter, joint] : {std::pair{"A", Joint::hinge}, {"B", Joint::hinge}, {"C", Joint::none}})
      mechanism.point(letter + number, s.place(prefix + letter), joint,
                      std::string("$") + letter + "_{" + number + "}$");
  const std::string &first = centres.front().number, &last = centres.back().number;
  const double to_first = direction(mechanism.at("B0"), mechanism.at("B" + first)),
               swing = turn(to_first, direction(mechanism.at("B0"), mechanism.at("B" + last)));
  constexpr double beyond = 0.16;  // radians of the rocker's way
  mechanism.body({"A0", "A" + first}, 2)
      .body({"A" + first, "B" + first, "C" + first}, 3)
      .body({"B0", "B" + first}, 4)
      .axis(mechanism.at("A0"), mechanism.at("B0"))
      .path("A0", "A" + first)
      .swing("B0", "B" + first, std::min(0.0, swing) - beyond, std::max(0.0, swing) + beyond)
      .turning("A0", "A" + first, sign_of(problem(s.givens()).instant.n), "$ω_{2}$");
  const int then = static_cast<int>(centres.size()) + 1;
  for (int step = 1; const auto& [number, prefix] : centres) {
    mechanism.found_in(step++, {"B" + number}).found_in(then, {"A" + number, "C" + number});
    if (const auto phi = s.value(prefix + "crank_angle")) mechanism.angle("A0", 0, *phi, "$φ_{" + number + "}$");
    if (number == first) continue;
    mechanism.other_position({"A0", "A" + number})
        .other_position({"A" + number, "B" + number, "C" + number})
        .other_position({"B0", "B" + number});
  }
  if (s.value("rocker_swing")) mechanism.angle("B0", to_first, to_first + swing, "$Δθ_{4}$");
  return mechanism;
}

std::vector<std::pair<std::string, Place>> points_of(const Mechanism& mechanism,
                                                     const std::vector<Numbered>& centres) {
  std::vector<std::pair<std::string, Place>> all;
  for (const auto& [number, prefix] : centres)
    for (const char* letter : {"A", "B", "C"}) all.emplace_back(prefix + letter, mechanism.at(letter + number));
  return all;
}

class DeadCentresPanel : public MechanismPanel {
 public:
  DeadCentresPanel(std::shared_ptr<const Mechanism> mechanism, std::vector<Numbered> centres)
      : MechanismPanel(mechanism, points_of(*mechanism, centres)),
        mechanism_(std::move(mechanism)),
        centres_(std::move(centres)) {}

  std::vector<Place> lettered() const override { return mechanism_->corners(); }

  // The compasses' arcs that find B₁ and B₂, a little to both sides.
  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    for (const auto& [name, letters] : {std::pair{"A0", "$A_{0}$"}, std::pair{"B0", "$B_{0}$"}}) {
      plot.cross(mechanism_->at(name), Meaning::construction);
      plot.label(letters, mechanism_->at(name));
    }
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    for (const Numbered& centre : centres_)
      compass_arc(plot, mechanism_->at("A0"), mechanism_->at("B" + centre.number), 16);
    return MechanismPanel::draw(plot, room, language);
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    std::vector<PanelStep> all;
    Words points;
    for (const auto& [number, prefix] : centres_) {
      const bool is_extended = number == "1", is_second = &number != &centres_.front().number;
      all.push_back(
          {(is_extended ? to_B1() : to_B2()) + (is_second ? dashed() : Words{}) + ".", mechanism_->at("B" + number)});
      points = points + (is_second ? ", " : "") +
               (is_extended ? Words{"$A_{1}$ on $A_{0}B_{1}$", "$A_{1}$ su $A_{0}B_{1}$"}
                            : Words{"$A_{2}$ on the line $A_{0}B_{2}$", "$A_{2}$ sulla retta $A_{0}B_{2}$"});
    }
    all.push_back({points + Words{". The pole $P_{31}$ is $B$: $v_{B}$ = 0, $ω_{4}$ = 0, and $\\vec{a}_{B}$ is all "
                                  "tangential.",
                                  ". Il polo $P_{31}$ è $B$: $v_{B}$ = 0, $ω_{4}$ = 0, e la $\\vec{a}_{B}$ è tutta "
                                  "tangenziale."},
                   mechanism_->at("A" + centres_.back().number)});
    return all;
  }

 private:
  static Words to_B1() {
    return {
        "The arc about $A_{0}$ with radius $AB$ + $A_{0}A$ cuts the arc of the rocker at $B_{1}$: crank and "
        "coupler extended",
        "L'arco di centro $A_{0}$ e raggio $AB$ + $A_{0}A$ taglia l'arco del bilanciere in $B_{1}$: manovella e "
        "biella distese"};
  }
  static Words to_B2() {
    return {
        "The arc about $A_{0}$ with radius |$AB$ − $A_{0}A$| cuts the arc of the rocker at $B_{2}$: crank and "
        "coupler folded",
        "L'arco di centro $A_{0}$ e raggio |$AB$ − $A_{0}A$| taglia l'arco del bilanciere in $B_{2}$: manovella "
        "e biella sovrapposte"};
  }
  static Words dashed() { return {" (dashed)", " (a tratti)"}; }

  std::shared_ptr<const Mechanism> mechanism_;
  std::vector<Numbered> centres_;
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

// Where there is one, why there is no other.
Words without_other(const std::string& number) {
  if (number == "1")
    return {
        "This rocker has one dead centre only, with crank and coupler extended: folded they cannot come in line, or "
        "do so at a change point.",
        "Questo bilanciere ha un solo punto morto, con manovella e biella distese: sovrapposte non possono "
        "allinearsi, o lo fanno in una configurazione di incertezza."};
  return {
      "This rocker has one dead centre only, with crank and coupler folded: extended they cannot come in line, or do "
      "so at a change point.",
      "Questo bilanciere ha un solo punto morto, con manovella e biella sovrapposte: distese non possono allinearsi, "
      "o lo fanno in una configurazione di incertezza."};
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
  const std::vector<Numbered> centres = dead_centres_of(s);
  if (centres.empty())
    return linkage_alone(
        s, language,
        {"This rocker has no dead centre: crank and coupler cannot come in line, or do so at a change point.",
         "Questo bilanciere non ha punti morti: manovella e biella non possono allinearsi, o lo fanno in una "
         "configurazione di incertezza."});
  std::vector<Row> angles, rates;
  std::vector<std::string> told{"rocker_swing", "time_ratio"};
  for (const auto& [number, prefix] : centres) {
    angles.push_back({number, {prefix + "crank_angle_deg", prefix + "rocker_angle_deg", prefix + "omega_3"}});
    rates.push_back({number, {prefix + "alpha_3", prefix + "alpha_4"}});
    told.push_back(prefix + "alpha_4");
  }
  const Words of_ratio{
      "$τ$: time of the slower stroke over that of the quicker, at constant $ω_{2}$, from $Δφ$ and 360° − $Δφ$.",
      "$τ$: tempo della corsa lenta su quello della rapida, a $ω_{2}$ costante, da $Δφ$ e 360° − $Δφ$."};
  const Words note = centres.size() == 1     ? without_other(centres.front().number)
                     : s.value("time_ratio") ? of_ratio
                                             : Words{};
  return {.panels = panels(DeadCentresPanel(std::make_shared<const Mechanism>(drawn(s, centres)), centres)),
          .results = {table({"", "$φ$ (°)", "$θ_{4}$ (°)", "$ω_{3}$ (rad/s)"}, angles),
                      table({"", "$α_{3}$ (rad/s²)", "$α_{4}$ (rad/s²)"}, rates),
                      values({"rocker_swing_deg", "crank_rotation_extended_to_folded_deg"}), values({"time_ratio"}),
                      remark(note.in(language))},
          .seen = {"The four-bar linkage in the dead centres of its rocker",
                   "Il quadrilatero articolato nei punti morti del bilanciere"},
          .told = std::move(told),
          .without_part = without({"t", "phi"})};
}

}  // namespace epure::four_bar
