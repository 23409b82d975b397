// The drawn position, and the follower at its highest: velocities, accelerations, forces.
#include <algorithm>
#include <cmath>

#include "exercises/cam-dynamics/figures.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/sum_panel.h"

namespace epure::cam_dynamics {
namespace {

const std::set<std::string> of_forces{"m_2", "m_3", "P", "g"};

// The mechanism with the radius A0B, square to v_B2.
class RadiusPanel : public MechanismPanel {
 public:
  RadiusPanel(const Solution& s, Dimensioned dimensioned)
      : MechanismPanel(whole(s, "", dimensioned)), A0_(s.place("A0")), A_(s.place("A_at")), B_(s.place("B_at")) {}

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    MechanismPanel::draw(plot, room, language);
    plot.segment(A0_, B_, Meaning::construction);
    return {};
  }

 protected:
  Place A0_, A_, B_;
};

// And with the relative pole of cam and follower.
class RelativePolePanel : public RadiusPanel {
 public:
  explicit RelativePolePanel(const Solution& s)
      : RadiusPanel(s, Dimensioned::yes), P23_(s.place("P23")), r_(given(s, "r")), r_r_(given(s, "r_r")) {}

  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override {
    constexpr double letters = 7;  // mm
    const drawings::Box mechanism = MechanismPanel::extent(lengths, vectors);
    Extent all;
    all.include(mechanism.low.x, mechanism.low.y);
    all.include(mechanism.high.x, mechanism.high.y);
    all.include(lengths, P23_, letters);
    return all.box();
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    constexpr double beyond = 4;  // mm
    RadiusPanel::draw(plot, room, language);
    const Arrow2 aside{0.5 * std::sqrt(3), -0.5};
    plot.mark(drawings::Dimension{plot.at(A_), plot.at(A_ + r_ * aside), 0, "$r$"});
    if (r_r_ > 0) plot.mark(drawings::Dimension{plot.at(B_), plot.at(B_ + -r_r_ * aside), 0, "$r_{r}$"});
    plot.long_segment(B_, P23_, beyond, Meaning::construction);
    plot.long_segment(A0_, P23_, beyond, Meaning::construction);
    plot.cross(P23_);
    plot.label("$P_{23}$", P23_, B_, Meaning::locus);
    plot.measures_abscissa("P23_x", P23_, A0_);
    plot.measures("A0B", A0_, B_);
    plot.measures_coordinates("A", A_, A0_);
    return {};
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {{{"The common normal $AB$ meets the level through $A_{0}$ in $P_{23}$, the pole of cam and follower: "
              "both have one velocity there, $v_{B3}$ = $ω_{2}$·$A_{0}P_{23}$.",
              "La normale comune $AB$ incontra l'orizzontale per $A_{0}$ in $P_{23}$, polo del moto relativo di "
              "camma e cedente: lì hanno una sola velocità, $v_{B3}$ = $ω_{2}$·$A_{0}P_{23}$."},
             P23_}};
  }

 private:
  Place P23_;
  double r_, r_r_;
};

// The sought vector is short beside the others: its own letters crowd with those of its ends.
class AccelerationsPanel : public PolygonPanel {
 public:
  AccelerationsPanel(const Solution& s, Language language)
      : PolygonPanel(s, accelerations(s, "", language)), sought_(s.vector("a_B3")) {}

  std::vector<Place> lettered() const override {
    std::vector<Place> all = PolygonPanel::lettered();
    all.push_back(Place{0, 0} + 0.5 * sought_);
    return all;
  }

 private:
  Arrow2 sought_;
};

}  // namespace

PanelSheet velocity_sheet(const Solution& s, Language language) {
  std::set<std::string> without = of_forces;
  without.insert("n_lift");
  const Words relative{
      "Seen from the cam, $B$ goes round $A$ on a circle: disc and roller touch on $AB$, and $A_{0}AB$ is the "
      "equivalent slider-crank.",
      "Visto dalla camma, $B$ percorre un cerchio attorno ad $A$: disco e rullo si toccano su $AB$, e $A_{0}AB$ è il "
      "manovellismo equivalente."};
  return {.panels = panels(RelativePolePanel(s), PolygonPanel(s, velocities(s, "", language))),
          .results = {values({"omega_2", "B_y"}), values({"A0B", "pressure_angle_deg"}), values({"v_B2", "v_B32"}),
                      values({"v_B3", "P23_x"}), values({"v_A", "v_A_y"}), remark(relative.in(language))},
          .seen = {"The cam with its follower and their relative pole, and the polygon of the velocities of B",
                   "La camma con il cedente e il loro polo relativo, e il poligono delle velocità di B"},
          .told = {"omega_2", "v_B2", "v_B32", "v_B3", "P23_x"},
          .without_part = without};
}

PanelSheet acceleration_sheet(const Solution& s, Language language) {
  std::set<std::string> without = of_forces;
  without.insert("n_lift");
  const Words coriolis{"$\\vec{a}_{c}$ is $\\vec{v}_{B32}$ turned by 90° in the sense of $ω_{2}$, times 2$ω_{2}$.",
                       "$\\vec{a}_{c}$ è $\\vec{v}_{B32}$ ruotata di 90° nel verso di $ω_{2}$, per 2$ω_{2}$."};
  return {.panels = panels(RadiusPanel(s, Dimensioned::no), AccelerationsPanel(s, language)),
          .results = {values({"v_B32", "a_B2"}), values({"a_B32_n", "a_coriolis"}), values({"a_B32_t", "a_B3"}),
                      values({"a_G2"}), remark(coriolis.in(language))},
          .seen = {"The polygon of the accelerations of B, with that of Coriolis",
                   "Il poligono delle accelerazioni di B, con quella di Coriolis"},
          .told = {"a_B2", "a_B32_n", "a_coriolis", "a_B32_t", "a_B3"},
          .without_part = without};
}

namespace {

// The forces of the drawn position, as if the cam could pull too.
struct Forces {
  PolygonSide P, P_3, F_3, R_23, R_13, P_2, F_2, R_32, R_12;
};
Forces forces(const Solution& s) {
  const std::string upright = "∥ $y$", level = "∥ $x$";
  const bool is_kept = s.value("R_23").has_value();
  const auto reaction_of = [&](const std::string& name, const std::string& direction, const Arrow2& along) {
    PolygonSide side{.quantity = is_kept ? name : "",
                     .label = force(name).arrow(),
                     .direction = direction,
                     .magnitude = "?",
                     .v = s.vector("held_" + name),
                     .along = along,
                     .length = s.value(name)};
    return side;
  };
  const auto known = [&](const std::string& name, const std::string& direction, const std::string& magnitude,
                         const std::string& tip = {}) {
    PolygonSide side = of_case(s, "", force(name), direction, magnitude, tip);
    if (side.v.x == 0 && side.v.y == 0) side.magnitude = "0";
    return side;
  };
  PolygonSide R_23 = reaction_of("R_23", "∥ $AB$", s.place("B_at") - s.place("A_at"));
  R_23.tip = "$d$";
  return {.P = known("P", upright, "$\\it{P}$", "$a$"),
          .P_3 = known("P_3", upright, "$m_{3}g$", "$b$"),
          .F_3 = known("F_3_in", upright, "$m_{3}a_{B3}$", "$c$"),
          .R_23 = R_23,
          .R_13 = reaction_of("R_13", level, {1, 0}),
          .P_2 = known("P_2", upright, "$m_{2}g$"),
          .F_2 = known("F_2_in", "∥ $A_{0}A$", "$m_{2}a_{G2}$"),
          .R_32 = reaction(R_23, "$\\vec{\\it{R}}_{32}$", "$\\it{R}_{23}$"),
          .R_12 = reaction_of("R_12", "?", {})};
}

FreeBodyPanel follower_cut_free(const Solution& s, const Forces& on) {
  const Place B = s.place("B_at"), C = s.place("contact_at"), G3 = centre_of_follower(s, "");
  FreeBodyPanel body(std::make_shared<const Mechanism>(cam_figure(s, "", Shown::follower)));
  body.force(on.P, G3 + (G3 - B), FreeBodyPanel::Arrow::ends)
      .force(on.P_3, G3)
      .force(on.F_3, G3)
      .force(on.R_23, C, FreeBodyPanel::Arrow::ends)
      .force(on.R_13, B, FreeBodyPanel::Arrow::ends);
  body.step({"The follower cut free: $\\vec{\\it{R}}_{23}$ along $AB$, $\\vec{\\it{R}}_{13}$ square to the guide, "
             "all through $B$.",
             "Il cedente isolato: $\\vec{\\it{R}}_{23}$ lungo $AB$, $\\vec{\\it{R}}_{13}$ normale alla guida, tutte "
             "per $B$."},
            B);
  return body;
}

FreeBodyPanel cam_cut_free(const Solution& s, const Forces& on) {
  const Place A0 = s.place("A0"), A = s.place("A_at"), C = s.place("contact_at");
  FreeBodyPanel body(std::make_shared<const Mechanism>(cam_figure(s, "", Shown::cam)));
  constexpr double one_to_five = 200;  // mm a metre: its polygon is to be seen
  body.at_most(one_to_five)
      .force(on.P_2, A)
      .force(on.F_2, A)
      .force(on.R_32, C, FreeBodyPanel::Arrow::ends)
      .force(on.R_12, A0);
  if (const auto M = s.value("M_m")) body.couple("$\\it{M}_{m}$", A0, *M);
  body.moments({"The cam cut free, with $\\vec{\\it{R}}_{32}$ = −$\\vec{\\it{R}}_{23}$. Moments about $A_{0}$: "
                "$\\it{M}_{m}$ balances those of $\\vec{\\it{P}}_{2}$, arm "
                "$d_{2}$, and $\\vec{\\it{R}}_{32}$, arm $d_{32}$.",
                "La camma isolata, con $\\vec{\\it{R}}_{32}$ = −$\\vec{\\it{R}}_{23}$. Momenti in $A_{0}$: "
                "$\\it{M}_{m}$ equilibra quelli di $\\vec{\\it{P}}_{2}$, "
                "braccio $d_{2}$, e di $\\vec{\\it{R}}_{32}$, braccio $d_{32}$."},
               A0);
  return body;
}

// Enlarged, as the arms are short beside the disc, and nearly of one direction. On its line of action a force may
// stand anywhere: here both stand at A.
FreeBodyPanel arms_enlarged(const Solution& s, const Forces& on) {
  constexpr double beside = 7;  // mm, of the one dimension line
  const Place A0 = s.place("A0"), A = s.place("A_at");
  Mechanism drawn;
  drawn.point("A0", A0, Mechanism::Joint::hinge, "$A_{0}$").point("A", A, Mechanism::Joint::mass, "$A$");
  drawn.body({"A0", "A"});
  FreeBodyPanel detail(std::make_shared<const Mechanism>(std::move(drawn)));
  detail.force(on.P_2, A).force(on.R_32, A, FreeBodyPanel::Arrow::ends);
  const bool is_kept = s.value("R_23").has_value();
  const auto foot = [&](const PolygonSide& force) {
    return A + (dot(A0 - A, force.v) / dot(force.v, force.v)) * force.v - A0;
  };
  const auto add = [&](const PolygonSide& force, const char* letters, const char* quantity, double left) {
    detail.arm(A0, A, force.v, letters, is_kept ? quantity : "", left);
  };
  add(on.P_2, "$d_{2}$", "d_2", 0);
  // On the side away from the other.
  const bool is_left = is_kept && cross(foot(on.P_2), foot(on.R_32)) > 0;
  add(on.R_32, "$d_{32}$", "d_32", is_left ? beside : -beside);
  detail.step(
      {"The arms enlarged: square to both lines of action.", "I bracci ingranditi: normali alle due rette d'azione."},
      A);
  return detail;
}

// Whether the cam would have to pull, and what would keep it from that.
Result contact(const Solution& s, Language language) {
  const Words lost{
      "Contact is lost: to close the polygons the cam would have to pull the follower. It cannot, and the follower "
      "leaves it, unless $\\it{P}$ is at least $\\it{P}_{0}$.",
      "Il contatto si perde: per chiudere i poligoni la camma dovrebbe tirare il cedente. Non può, e il cedente la "
      "lascia, se $\\it{P}$ non è almeno $\\it{P}_{0}$."};
  return remark(s.value("R_23") ? "" : lost.in(language));
}
std::vector<std::string> kept_by(const Solution& s) {
  if (s.value("R_23")) return {};
  return {"P_kept"};
}

}  // namespace

PanelSheet forces_sheet(const Solution& s, Language language) {
  const Forces on = forces(s);
  return {.panels = panels(follower_cut_free(s, on),
                           PolygonPanel(s, force_polygon("3", {on.R_13}, {on.P, on.P_3, on.F_3, on.R_23}))),
          .results = {contact(s, language), values(kept_by(s)), values({"P_3", "F_3_in"}), values({"R_13", "R_23"})},
          .seen = {"The follower cut free, and the polygon of its forces",
                   "Il cedente isolato, e il poligono delle sue forze"},
          .told = {"R_13", "R_23"},
          .without_part = {"n_lift", "m_2"}};
}

PanelSheet torque_sheet(const Solution& s, Language language) {
  const Forces on = forces(s);
  const Words work{
      "Virtual work: $\\it{M}_{m}ω_{2}$ = $\\it{P}_{2}v_{Ay}$ + ($\\it{P}$ + $\\it{P}_{3}$ − "
      "$\\it{F}^{in}_{3}$)$v_{B3}$, upward velocities positive. $\\vec{\\it{F}}^{in}_{2}$ does none.",
      "Lavori virtuali: $\\it{M}_{m}ω_{2}$ = $\\it{P}_{2}v_{Ay}$ + ($\\it{P}$ + $\\it{P}_{3}$ − "
      "$\\it{F}^{in}_{3}$)$v_{B3}$, velocità positive in su. $\\vec{\\it{F}}^{in}_{2}$ non lavora."};
  return {.panels = panels(cam_cut_free(s, on), arms_enlarged(s, on),
                           PolygonPanel(s, force_polygon("2", {on.R_12}, {on.R_32, on.P_2, on.F_2}))),
          .results = {contact(s, language), values(kept_by(s)), values({"P_2", "F_2_in"}), values({"R_23", "R_12"}),
                      values({"d_2", "d_32", "M_m"}), remark(work.in(language)), values({"M_m_virtual_work"})},
          .seen = {"The cam cut free with the arms of its forces, and their polygon",
                   "La camma isolata con i bracci delle sue forze, e il loro poligono"},
          .told = {"R_12", "M_m"},
          .without_part = {"n_lift"}};
}

PanelSheet maximum_lift_sheet(const Solution& s, Language language) {
  const std::string at = "maximum_lift.";
  const Words inertia{"inertia of the follower", "inerzia del cedente"}, weight{"its weight", "il suo peso"};
  const Words in_line{
      "$A_{0}$, $A$ and $B$ are in line: $\\vec{v}_{B32}$ = −$\\vec{v}_{B2}$, the follower rests, and its "
      "acceleration is $a_{B3}$ = $ω^{2}_{2}$·$A_{0}A$(1 + $A_{0}A$/$AB$)/cos $δ$.",
      "$A_{0}$, $A$ e $B$ sono allineati: $\\vec{v}_{B32}$ = −$\\vec{v}_{B2}$, il cedente è fermo, e la sua "
      "accelerazione è $a_{B3}$ = $ω^{2}_{2}$·$A_{0}A$(1 + $A_{0}A$/$AB$)/cos $δ$."};
  const Words least{
      "Contact is just kept where the cam no longer presses: $\\it{P}_{min}$ = $\\it{F}^{in}_{3}$ − $\\it{P}_{3}$.",
      "Il contatto è appena mantenuto dove la camma non preme più: $\\it{P}_{min}$ = $\\it{F}^{in}_{3}$ − "
      "$\\it{P}_{3}$."};
  const Words source{", as the source has it within its reading", ", come la fonte a meno della lettura"};
  const Words mistake = Words{"With the acceleration at the given $φ$ instead, at the higher speed",
                              "Con l'accelerazione al $φ$ dato, alla velocità maggiore"} +
                        (s.givens().as_stated() ? source : Words{}) + Words{".", "."};
  const double P_3 = s[at + "P_3"];
  return {
      .panels = panels(
          MechanismPanel(whole(s, at)), PolygonPanel(s, accelerations(s, at, language)),
          SumPanel({{.name = {"Least closing force at maximum lift", "Forza di chiusura minima alla massima alzata"},
                     .parts = {{inertia, s[at + "F_3_in"], at + "F_3_in"}, {weight, -P_3, {}}},
                     .whole = {decimal("$\\it{P}_{min}$"), s[at + "P_min"], at + "P_min"},
                     .steps = {least}},
                    {.name = {"With the acceleration at the given $φ$", "Con l'accelerazione al $φ$ dato"},
                     .parts = {{inertia, s[at + "F_3_drawn"], {}}, {weight, -P_3, {}}},
                     .whole = {decimal("$\\it{P}$"), s[at + "P_drawn"], {}},
                     .steps = {mistake}}},
                   "N")),
      .results = {values({at + "angle_of_A0A_deg", at + "pressure_angle_deg"}), values({at + "omega_2", at + "v_B2"}),
                  values({at + "a_B2", at + "a_B32_n"}), values({at + "a_coriolis", at + "a_B32_t"}),
                  values({at + "a_B3", at + "F_3_in"}), values({at + "P_min", at + "omega_2_contact_loss"}),
                  remark(in_line.in(language))},
      .seen = {"The cam at maximum lift, the polygon of the accelerations and the least closing force",
               "La camma alla massima alzata, il poligono delle accelerazioni e la forza di chiusura minima"},
      .told = {at + "a_B3", at + "F_3_in", at + "P_min", at + "omega_2_contact_loss"},
      .without_part = {"n", "m_2"}};
}

}  // namespace epure::cam_dynamics
