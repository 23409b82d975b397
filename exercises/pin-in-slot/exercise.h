// Pin in a slot: a slotted lever hinged at O drives a disc, at whose centre B a pin is fixed, along the guide on
// which it rolls. Velocities and accelerations by construction, forces by Newton and Euler, the couple by the balance
// of powers too.
#pragma once

#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/pin-in-slot/instant.h"

namespace epure::pin_in_slot {

std::vector<Printed> printed_by_the_source();

// The source's balance differentiates E_k after writing v_B = OB ω / sin α with the value of sin α at this instant (2
// OB ω), as if sin α were constant. What its formula gives for the disc's part of (dE_k/dt)/ω, in N m.
double disc_part_with_constant_angle(const Instant& at);

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  Instant instant;
  Place O = {}, A = {}, B = {}, D = {};
  Arrow2 slot = {};                 // unit vector from O to B
  std::optional<Place> P23 = {};    // none when at infinity
  double omega = 0, omega_dot = 0;  // of the lever, clockwise
  double omega_disc = 0, alpha_disc = 0, b_dot = 0, b_ddot = 0;
  Arrow2 v_Bstar = {}, v_rel = {}, v_B = {};
  Arrow2 a_Bstar_n = {}, a_Bstar_t = {}, a_cor = {}, a_rel = {}, a_B = {};
  Arrow2 disc_weight = {}, disc_inertia = {}, friction = {}, slot_force = {}, ground_force = {};
  Arrow2 lever_weight = {}, lever_inertia = {}, pivot_force = {};
  double normal = 0;                                   // of the guide, upwards
  double of_M1 = 0, of_disc = 0, against_gravity = 0;  // the parts of C, N m
  double couple = 0, kinetic_energy = 0;
};
Drawn drawn(const Instant& instant);

// One sheet each; they add to an empty sheet.
void draw_kinematics(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_acceleration(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_forces(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_power_balance(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::pin_in_slot
