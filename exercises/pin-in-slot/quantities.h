// The slotted lever by all its routes: constructed points, polar diagrams, poles, Newton-Euler, power balance,
// analysis.
#pragma once

#include "exercises/kit/proof/ledger.h"
#include "exercises/pin-in-slot/instant.h"

namespace epure::pin_in_slot {

inline constexpr Phrase no_relative_pole{"P₂₃ is at infinity: the lever is upright",
                                         "P₂₃ è all'infinito: la leva è verticale"};
inline constexpr Phrase lifts_off{"the guide does not press on the disc (N ≤ 0): it would lift off",
                                  "la guida non preme sul disco (N ≤ 0): si staccherebbe"};

// |x| without deciding its sign, which an enclosure of zero does not tell; for signs, x².
template <class T>
T magnitude_of(const T& x) {
  return size(geometry::Vector<T>{x, T(0)});
}

// How rough disc and guide must be: |T| / N. Absent when the guide would have to hold the disc down.
template <class T>
T required_friction(const T& friction, const T& normal) {
  switch (geometry::sign(normal)) {
    case geometry::Sign::positive:
      return geometry::quotient(magnitude_of(friction), normal);
    case geometry::Sign::undecided:
      throw geometry::Undecided("whether the guide presses on the disc", "se la guida prema sul disco");
    default:
      throw geometry::Impossible(lifts_off);
  }
}

template <class T>
void by_polar_diagrams(Ledger<T>& ledger, const geometry::SlottedLeverMotion<T>& motion) {
  const auto& v = motion.velocity;
  const auto& a = motion.acceleration;
  ledger.route("polar diagram");
  ledger.put("v_Bstar", [&] { return size(v.first.known); });
  ledger.put("b_dot", v.first_rate);
  ledger.put("v_B", v.second_rate);
  ledger.put("omega_disc", motion.disc.omega);
  ledger.put("a_Bstar", [&] { return size(a.first.known); });
  ledger.put("a_cor", [&] { return size(a.first.coriolis); });
  ledger.put("b_ddot", a.first_rate);
  ledger.put("a_B", a.second_rate);
  ledger.put("alpha_disc", motion.disc.alpha);
}

template <class T>
void by_poles(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at) {
  const T omega_disc = geometry::disc_speed_by_poles(at, geometry::radians<T>(-instant.omega));
  ledger.route("poles");
  const geometry::ProjectivePoint<T> P23 = at.relative_pole();
  ledger.put("P23_x", [&] { return Ledger<T>::ratio(P23.x, P23.w, no_relative_pole); });
  ledger.put("omega_disc", omega_disc);
  ledger.put("v_B", geometry::turning_about(at.D, omega_disc, T(0)).velocity(at.B).x);
}

template <class T>
void by_newton_euler(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at,
                     const geometry::SlottedLeverMotion<T>& motion) {
  const auto disc = geometry::disc_forces(at, motion.disc, instant.masses);
  const auto lever = geometry::lever_forces(at, motion.lever, disc.slot, instant.masses);
  ledger.route("Newton-Euler");
  ledger.put("gravity_torque", geometry::moment(lever.weight, at.O));
  ledger.put("C", lever.couple);
  ledger.put("slot_force_on_pin", [&] { return size(disc.slot.f); });
  ledger.put("ground_normal_force", disc.normal);
  ledger.put("ground_friction_force", [&] { return size(disc.friction.f); });
  ledger.put("required_friction_coefficient", [&] { return required_friction(disc.friction.f.x, disc.normal); });
  ledger.vector("pivot_force", lever.pivot.f);
}

template <class T>
void by_power_balance(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at,
                      const geometry::SlottedLeverMotion<T>& motion) {
  const auto balance = geometry::power_balance(at, motion, instant.masses);
  ledger.route("power balance");
  ledger.put("kinetic_energy", geometry::kinetic_energy(at, motion, instant.masses));
  ledger.put("kinetic_power", geometry::radians<T>(instant.omega) * balance.kinetic());
  ledger.put("gravity_torque", balance.against_gravity);
  ledger.put("C", balance.couple());
}

template <class T>
void by_analysis(Ledger<T>& ledger, const Instant& instant) {
  namespace analytic = geometry::analytic;
  const analytic::SlottedLever of = instant.analytic();
  const T omega = geometry::radians<T>(instant.omega), omega_dot = geometry::radians<T>(instant.omega_dot);
  const T OB = geometry::from_rational<T>(of.OB);
  const auto angle = analytic::angle<T>(of);
  const auto m = analytic::motion(of, angle, omega, omega_dot);
  const auto balance = analytic::balance(of, angle, omega, omega_dot);
  const auto force = analytic::reactions(of, angle, m, omega, omega_dot);
  ledger.route("analytic");
  if constexpr (signs_only<T>) {
    ledger.put("lever_angle", angle.sine);
  } else {
    ledger.put("lever_angle", [&] { return analytic::radians(angle); });
  }
  ledger.put("B_x", OB * angle.cosine);
  ledger.put("P23_x", [&] { return Ledger<T>::ratio(OB, angle.cosine, no_relative_pole); });
  ledger.put("v_Bstar", magnitude_of<T>(OB * omega));
  ledger.put("b_dot", m.b_dot);
  ledger.put("v_B", m.v_B);
  ledger.put("omega_disc", m.omega_disc);
  ledger.put("a_Bstar", [&] { return size(geometry::Vector<T>{OB * geometry::square(omega), OB * omega_dot}); });
  ledger.put("a_cor", magnitude_of<T>(T(2) * omega * m.b_dot));
  ledger.put("b_ddot", m.b_ddot);
  ledger.put("a_B", m.a_B);
  ledger.put("alpha_disc", m.alpha_disc);
  ledger.put("kinetic_energy", balance.kinetic_energy);
  ledger.put("kinetic_power", balance.kinetic_power);
  ledger.put("gravity_torque", balance.gravity_torque);
  ledger.put("C", balance.couple);
  ledger.put("slot_force_on_pin", magnitude_of<T>(force.slot));
  ledger.put("ground_normal_force", force.normal);
  ledger.put("ground_friction_force", magnitude_of<T>(force.friction));
  ledger.put("required_friction_coefficient", [&] { return required_friction(force.friction, force.normal); });
  ledger.vector("pivot_force", {force.at_O.re, force.at_O.im});
}

struct Routes {
  Instant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const geometry::SlottedLever<T> at = instant.position<T>();
    const geometry::SlottedLeverMotion<T> motion = instant.motion(at);
    ledger.put("lever_angle", [&] { return slope_angle(at.slot); });
    ledger.put("B_x", at.B.x);
    by_polar_diagrams(ledger, motion);
    by_poles(ledger, instant, at);
    by_newton_euler(ledger, instant, at, motion);
    by_power_balance(ledger, instant, at, motion);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::pin_in_slot
