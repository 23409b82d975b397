// What is reported of the lever and its disc, and what only the sheets show. Letters: links 1 (frame), 2 (lever) and
// 3 (disc), masses after their points. Counter-clockwise is positive, but for ω, dω/dt and C, which the source counts
// clockwise.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::pin_in_slot {

inline Quantity lever_angle() {
  return {"lever_angle", "$α$", "rad", {"angle of the lever from the guide", "angolo del glifo dalla guida"}};
}
inline Quantity abscissa_of_B() { return {"B_x", "$x_{B}$", "m", {"abscissa of B", "ascissa di B"}}; }
inline Quantity abscissa_of_P23() {
  return {"P23_x",
          "$x_{P23}$",
          "m",
          {"abscissa of the relative pole of lever and disc", "ascissa del polo relativo di glifo e disco"}};
}

// Vectors of which the size is reported, or under the vector's name the one component that tells it.
inline VectorQuantity of_pin(const std::string& name, const std::string& subscript, const std::string& unit,
                             const Words& meaning) {
  return {name, (unit == "m/s" ? "v" : "a") + std::string("_{{{}}}"), subscript, unit, meaning, meaning};
}
inline VectorQuantity v_Bstar() {
  return of_pin("v_Bstar", "B*", "m/s",
                {"speed of the lever's point under B", "velocità del punto del glifo sotto B"});
}
inline VectorQuantity v_rel() {
  return of_pin("b_dot", "rel", "m/s",
                {"sliding of the pin along the slot, outwards", "scorrimento del piolo, verso fuori"});
}
inline VectorQuantity v_B() { return of_pin("v_B", "B", "m/s", {"velocity of B along x", "velocità di B lungo x"}); }
inline VectorQuantity a_Bstar() {
  return of_pin("a_Bstar", "B*", "m/s^2",
                {"acceleration of the lever's point under B", "accelerazione del punto del glifo sotto B"});
}
inline VectorQuantity a_Bstar_t() { return {"a_Bstar_t", "a^{{t}}_{{{}}}", "B*", "m/s^2", {}, {}}; }
inline VectorQuantity a_Bstar_n() { return {"a_Bstar_n", "a^{{n}}_{{{}}}", "B*", "m/s^2", {}, {}}; }
inline VectorQuantity a_cor() {
  return of_pin("a_cor", "cor", "m/s^2", {"Coriolis acceleration of B", "accelerazione di Coriolis di B"});
}
inline VectorQuantity a_rel() {
  return of_pin("b_ddot", "rel", "m/s^2",
                {"acceleration of the sliding, outwards", "accelerazione dello scorrimento, verso fuori"});
}
inline VectorQuantity a_B() {
  return of_pin("a_B", "B", "m/s^2", {"acceleration of B along x", "accelerazione di B lungo x"});
}

inline Quantity omega_disc() {
  return {"omega_disc",
          "$ω_{3}$",
          "rad/s",
          {"angular velocity of the disc, counter-clockwise", "velocità angolare del disco, antioraria"}};
}
inline Quantity alpha_disc() {
  return {"alpha_disc",
          "$α_{3}$",
          "rad/s^2",
          {"angular acceleration of the disc, counter-clockwise", "accelerazione angolare del disco, antioraria"}};
}

// R_ij acts from body i on body j; W and F are weight and force of inertia of the mass at a point.
inline VectorQuantity force(const std::string& name, const std::string& letter, const std::string& subscript,
                            const Words& meaning, const Words& size) {
  return {name, "\\it{{" + letter + "}}_{{{}}}", subscript, "N", meaning, size};
}
inline VectorQuantity R_23() {
  const Words size{"size of the force of the slot on the pin", "intensità della forza del glifo sul piolo"};
  return force("slot_force_on_pin", "R", "23", {}, size);
}
inline VectorQuantity N_13() {
  const Words upwards{"force of the guide on the disc, upwards", "forza della guida sul disco, verso l'alto"};
  return force("ground_normal_force", "N", "13", {}, upwards);
}
inline VectorQuantity T_13() {
  const Words size{"size of the friction force at the contact D", "intensità della forza d'attrito nel contatto D"};
  return force("ground_friction_force", "T", "13", {}, size);
}
inline VectorQuantity R_12() {
  return force("pivot_force", "R", "12", {"force of the frame on the lever at O", "reazione in O"},
               {"size of the force of the frame at O", "intensità della reazione in O"});
}
inline VectorQuantity weight(const std::string& at) { return force("weight_" + at, "W", at, {}, {}); }
inline VectorQuantity inertia_force(const std::string& at) { return force("inertia_force_" + at, "F", at, {}, {}); }
inline Quantity required_friction() {
  return {"required_friction_coefficient",
          "$f_{min}$",
          "1",
          {"coefficient of friction needed to roll without slipping", "coefficiente d'attrito necessario"}};
}

inline Quantity kinetic_energy() {
  return {"kinetic_energy", "$\\it{E}_{k}$", "J", {"kinetic energy", "energia cinetica"}};
}
inline Quantity kinetic_power() {
  return {"kinetic_power",
          "d$\\it{E}_{k}$/d$t$",
          "W",
          {"growth of the kinetic energy", "derivata dell'energia cinetica"}};
}
inline Quantity gravity_torque() {
  return {"gravity_torque",
          "$\\it{C}_{g}$",
          "N*m",
          {"torque of M1's weight about O, counter-clockwise: it resists",
           "momento del peso di M1, antiorario: resiste"}};
}
inline Quantity driving_couple() {
  return {"C", "$\\it{C}$", "N*m", {"couple that drives the lever, clockwise", "coppia motrice sul glifo, oraria"}};
}

// Parts of C, and the source's: only drawn.
inline Quantity torque(const std::string& name) { return {name, "", "N*m", {}}; }

}  // namespace epure::pin_in_slot
