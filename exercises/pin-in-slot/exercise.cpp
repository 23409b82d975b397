#include "exercises/pin-in-slot/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/pin-in-slot/quantities.h"

namespace epure {
namespace pin_in_slot {
namespace {

using geometry::Deep;

std::vector<Quantity> kinematic() {
  return {
      {"lever_angle", "$α$", "rad", {"angle of the lever from the guide", "angolo del glifo dalla guida"}},
      {"B_x", "$x_{B}$", "m", {"abscissa of B", "ascissa di B"}},
      {"P23_x",
       "$x_{P23}$",
       "m",
       {"abscissa of the relative pole of lever and disc", "ascissa del polo relativo di glifo e disco"}},
      {"v_Bstar", "$v_{B*}$", "m/s", {"speed of the lever's point under B", "velocità del punto del glifo sotto B"}},
      {"b_dot",
       "$v_{rel}$",
       "m/s",
       {"sliding of the pin along the slot, outwards", "scorrimento del piolo, verso fuori"}},
      {"v_B", "$v_{B}$", "m/s", {"velocity of B along x", "velocità di B lungo x"}},
      {"omega_disc",
       "$ω_{d}$",
       "rad/s",
       {"angular velocity of the disc, counter-clockwise", "velocità angolare del disco, antioraria"}},
      {"a_Bstar",
       "$a_{B*}$",
       "m/s^2",
       {"acceleration of the lever's point under B", "accelerazione del punto del glifo sotto B"}},
      {"a_cor", "$a_{cor}$", "m/s^2", {"Coriolis acceleration of B", "accelerazione di Coriolis di B"}},
      {"b_ddot",
       "$a_{rel}$",
       "m/s^2",
       {"acceleration of the sliding, outwards", "accelerazione dello scorrimento, verso fuori"}},
      {"a_B", "$a_{B}$", "m/s^2", {"acceleration of B along x", "accelerazione di B lungo x"}},
      {"alpha_disc",
       "$α_{d}$",
       "rad/s^2",
       {"angular acceleration of the disc, counter-clockwise", "accelerazione angolare del disco, antioraria"}},
  };
}

std::vector<Quantity> dynamic() {
  return {
      {"kinetic_energy", "$E_{k}$", "J", {"kinetic energy", "energia cinetica"}},
      {"kinetic_power", "$dE_{k}/dt$", "W", {"growth of the kinetic energy", "derivata dell'energia cinetica"}},
      {"gravity_torque",
       "$C_{g}$",
       "N*m",
       {"torque of M1's weight about O, counter-clockwise: it resists",
        "momento del peso di M1, antiorario: resiste"}},
      {"C", "$C$", "N*m", {"couple that drives the lever, clockwise", "coppia motrice sul glifo, oraria"}},
      {"slot_force_on_pin",
       "$S$",
       "N",
       {"size of the force of the slot on the pin", "intensità della forza del glifo sul piolo"}},
      {"ground_normal_force",
       "$N$",
       "N",
       {"force of the guide on the disc, upwards", "forza della guida sul disco, verso l'alto"}},
      {"ground_friction_force",
       "$T$",
       "N",
       {"size of the friction force at the contact D", "intensità della forza d'attrito nel contatto D"}},
      {"required_friction_coefficient",
       "$f_{min}$",
       "1",
       {"coefficient of friction needed to roll without slipping", "coefficiente d'attrito necessario"}},
      {"pivot_force_x", "$R_{Ox}$", "N", {"force of the frame on the lever at O, along x", "reazione in O, lungo x"}},
      {"pivot_force_y", "$R_{Oy}$", "N", {"force of the frame on the lever at O, along y", "reazione in O, lungo y"}},
      {"pivot_force", "$R_{O}$", "N", {"size of the force of the frame at O", "intensità della reazione in O"}},
  };
}

std::vector<Quantity> quantities() {
  std::vector<Quantity> all = kinematic();
  for (const Quantity& spec : dynamic()) all.push_back(spec);
  return all;
}

Description description() {
  return {.id = "pin-in-slot",
          .title = {"Pin in a slot: lever and rolling disc", "Glifo e disco che rotola"},
          .document = "glifo",
          .item = "1",
          .source = {"Slotted lever (glifo), exercise 1", "Glifo, primo esercizio"},
          .givens = stated_givens(),
          .sheets = {{"kinematics", {"Velocities", "Velocità"}},
                     {"acceleration", {"Accelerations", "Accelerazioni"}},
                     {"forces", {"Forces (Newton-Euler)", "Forze (Newton-Eulero)"}},
                     {"power-balance", {"Balance of powers", "Bilancio delle potenze"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class PinInSlot : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(Routes{instant(givens)}, rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Drawn figure = drawn(instant(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "kinematics") draw_kinematics(onto, figure, request);
    if (sheet == "acceleration") draw_acceleration(onto, figure, request);
    if (sheet == "forces") draw_forces(onto, figure, request);
    if (sheet == "power-balance") draw_power_balance(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

void take_motion(Drawn& figure, const geometry::SlottedLeverMotion<Deep>& motion, const Arrow2& OB) {
  const auto& v = motion.velocity;
  const auto& a = motion.acceleration;
  figure.omega_disc = to_double(motion.disc.omega);
  figure.alpha_disc = to_double(motion.disc.alpha);
  figure.b_dot = to_double(v.first_rate);
  figure.b_ddot = to_double(a.first_rate);
  figure.v_Bstar = to_double(v.first.known);
  figure.v_rel = to_double(v.first.closing);
  figure.v_B = to_double(v.second.closing);
  figure.a_Bstar_n = -(figure.omega * figure.omega * OB);
  figure.a_Bstar_t = -(figure.omega_dot * geometry::quarter_turn(OB));
  figure.a_cor = to_double(a.first.coriolis);
  figure.a_rel = to_double(a.first.closing);
  figure.a_B = to_double(a.second.closing);
}

void take_forces(Drawn& figure, const geometry::SlottedLever<Deep>& at,
                 const geometry::SlottedLeverMotion<Deep>& motion) {
  const auto& masses = figure.instant.masses;
  const auto disc = geometry::disc_forces(at, motion.disc, masses);
  const auto lever = geometry::lever_forces(at, motion.lever, disc.slot, masses);
  const auto balance = geometry::power_balance(at, motion, masses);
  figure.disc_weight = to_double(disc.weight.f);
  figure.disc_inertia = to_double(disc.inertia.f);
  figure.friction = to_double(disc.friction.f);
  figure.slot_force = to_double(disc.slot.f);
  figure.ground_force = to_double(disc.ground.f);
  figure.normal = to_double(disc.normal);
  figure.lever_weight = to_double(lever.weight.f);
  figure.lever_inertia = to_double(lever.inertia.f);
  figure.pivot_force = to_double(lever.pivot.f);
  figure.of_M1 = to_double(balance.of_M1);
  figure.of_disc = to_double(balance.of_disc);
  figure.against_gravity = to_double(balance.against_gravity);
  figure.couple = to_double(balance.couple());
  figure.kinetic_energy = to_double(geometry::kinetic_energy(at, motion, masses));
}

}  // namespace

Drawn drawn(const Instant& instant) {
  return deeply([&] {
    const auto at = instant.position<Deep>();
    const auto motion = instant.motion(at);
    Drawn figure{.instant = instant};
    figure.O = to_double(at.O);
    figure.A = to_double(at.A);
    figure.B = to_double(at.B);
    figure.D = to_double(at.D);
    figure.slot = to_double(at.slot);
    figure.P23 = to_double(at.relative_pole());
    figure.omega = geometry::to_double(instant.omega);
    figure.omega_dot = geometry::to_double(instant.omega_dot);
    take_motion(figure, motion, to_double(at.B - at.O));
    take_forces(figure, at, motion);
    return figure;
  });
}

}  // namespace pin_in_slot

std::unique_ptr<Exercise> make_pin_in_slot() { return std::make_unique<pin_in_slot::PinInSlot>(); }

}  // namespace epure
