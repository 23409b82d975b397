// The slotted lever by all its routes: constructed points, polar diagrams, poles, Newton-Euler, power balance,
// analysis.
#pragma once

#include "exercises/kit/proof/ledger.h"
#include "exercises/pin-in-slot/instant.h"
#include "exercises/pin-in-slot/quantities.h"

namespace epure::pin_in_slot {

inline constexpr Phrase no_relative_pole{"P₂₃ is at infinity: the lever is upright",
                                         "P₂₃ è all'infinito: la leva è verticale"};
inline constexpr Phrase lifts_off{"the guide does not press on the disc (N ≤ 0): it would lift off",
                                  "la guida non preme sul disco (N ≤ 0): si staccherebbe"};

// Throws Impossible when the guide would have to hold the disc down.
template <class T>
void require_pressing(const T& normal) {
  const geometry::Sign sign = geometry::sign(normal);
  if (sign == geometry::Sign::undecided)
    throw geometry::Undecided("whether the guide presses on the disc", "se la guida prema sul disco");
  if (sign != geometry::Sign::positive) throw geometry::Impossible(lifts_off);
}

// A vector that is drawn, with its length where the arrow is too short; one of its components is reported, or none.
template <class T>
void draw(Ledger<T>& ledger, const VectorQuantity& quantity, const geometry::Vector<T>& v) {
  ledger.draws_vector(quantity.name, v);
  ledger.tells(quantity.length(), [&] { return size(v); });
}

template <class T>
void by_polar_diagrams(Ledger<T>& ledger, const geometry::SlottedLever<T>& at,
                       const geometry::SlottedLeverMotion<T>& motion) {
  const auto& v = motion.velocity;
  const auto& a = motion.acceleration;
  const geometry::Vector<T> OB = at.B - at.O;
  ledger.route("polar diagram");
  ledger.put_length(v_Bstar(), v.first.known);
  ledger.put(v_rel().length(), v.first_rate);
  ledger.draws_vector(v_rel().name, v.first.closing);
  ledger.put(v_B().length(), v.second_rate);
  ledger.draws_vector(v_B().name, v.second.closing);
  ledger.put(omega_disc(), motion.disc.omega);
  ledger.put_length(a_Bstar(), a.first.known);
  draw<T>(ledger, a_Bstar_n(), -(geometry::square(motion.lever.omega) * OB));
  draw<T>(ledger, a_Bstar_t(), motion.lever.alpha * geometry::quarter_turn(OB));
  ledger.put_length(a_cor(), a.first.coriolis);
  ledger.put(a_rel().length(), a.first_rate);
  ledger.draws_vector(a_rel().name, a.first.closing);
  ledger.put(a_B().length(), a.second_rate);
  ledger.draws_vector(a_B().name, a.second.closing);
  ledger.put(alpha_disc(), motion.disc.alpha);
  ledger.put(acceleration("A"), motion.lever.acceleration(at.A));
}

template <class T>
void by_poles(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at) {
  const T omega_3 = geometry::disc_speed_by_poles(at, geometry::radians<T>(-instant.omega));
  ledger.route("poles");
  const geometry::ProjectivePoint<T> P23 = at.relative_pole();
  ledger.put(abscissa_of_P23(), [&] { return Ledger<T>::ratio(P23.x, P23.w, no_relative_pole); });
  ledger.put(omega_disc(), omega_3);
  ledger.put(v_B().length(), geometry::turning_about(at.D, omega_3, T(0)).velocity(at.B).x);
}

// The guide's force leans from the upright as far as its line of action is from B on B's level: over R, that is f.
template <class T>
T lean_of(const geometry::Vector<T>& ground, const geometry::SlottedLever<T>& at) {
  require_pressing(ground.y);
  const geometry::Point<T> on_level = geometry::finite(
      geometry::meet(geometry::line(at.D, ground), geometry::line(at.B, geometry::Vector<T>{T(1), T(0)})));
  return geometry::quotient(magnitude_of<T>(on_level.x - at.B.x), at.B.y);
}

template <class T>
void by_newton_euler(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at,
                     const geometry::SlottedLeverMotion<T>& motion) {
  const auto disc = geometry::disc_forces(at, motion.disc, instant.masses);
  const auto lever = geometry::lever_forces(at, motion.lever, disc.slot, instant.masses);
  ledger.route("Newton-Euler");
  ledger.put(gravity_torque(), geometry::moment(lever.weight, at.O));
  ledger.put(driving_couple(), lever.couple);
  ledger.put_length(R_23(), disc.slot.f);
  ledger.put(N_13().length(), disc.normal);
  ledger.draws_vector(N_13().name, disc.ground.f);
  ledger.put_length(T_13(), disc.friction.f);
  ledger.put(required_friction(), [&] { return lean_of<T>(disc.friction.f + disc.ground.f, at); });
  ledger.put(R_12(), lever.pivot.f);
  draw<T>(ledger, weight("A"), lever.weight.f);
  draw<T>(ledger, weight("B"), disc.weight.f);
  draw<T>(ledger, inertia_force("A"), lever.inertia.f);
  draw<T>(ledger, inertia_force("B"), disc.inertia.f);
}

// The source's balance differentiates E_k after writing v_B = k ω OB with k = OB/R, which is 1/sin α at this instant
// only, as if k were constant.
template <class T>
T disc_part_with_constant_k(const Instant& instant, const geometry::SlottedLeverMotion<T>& motion) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const auto& [R, OB, AO] = instant.lengths;
  const T rolling = number(instant.masses.M2 + instant.masses.J2 / (R * R));
  const T growth = geometry::radians<T>(instant.omega_dot) * number(OB) +
                   geometry::radians<T>(instant.omega) * motion.velocity.first_rate;
  return number(OB * OB * OB / (R * R)) * rolling * growth;
}

template <class T>
void by_power_balance(Ledger<T>& ledger, const Instant& instant, const geometry::SlottedLever<T>& at,
                      const geometry::SlottedLeverMotion<T>& motion) {
  const auto balance = geometry::power_balance(at, motion, instant.masses);
  ledger.route("power balance");
  ledger.put(kinetic_energy(), geometry::kinetic_energy(at, motion, instant.masses));
  ledger.put(kinetic_power(), geometry::radians<T>(instant.omega) * balance.kinetic());
  ledger.put(gravity_torque(), balance.against_gravity);
  ledger.put(driving_couple(), balance.couple());
  const auto mistaken = [&] { return disc_part_with_constant_k(instant, motion); };
  ledger.tells(torque("of_M1"), [&] { return balance.of_M1; });
  ledger.tells(torque("of_disc"), [&] { return balance.of_disc; });
  ledger.tells(torque("of_disc_k"), mistaken);
  ledger.tells(torque("C_k"), [&] { return balance.of_M1 + mistaken() + balance.against_gravity; });
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
    ledger.put(lever_angle(), angle.sine);
  } else {
    ledger.put(lever_angle(), [&] { return analytic::radians(angle); });
  }
  ledger.put(abscissa_of_B(), OB * angle.cosine);
  ledger.put(abscissa_of_P23(), [&] { return Ledger<T>::ratio(OB, angle.cosine, no_relative_pole); });
  ledger.put(v_Bstar().length(), magnitude_of<T>(OB * omega));
  ledger.put(v_rel().length(), m.b_dot);
  ledger.put(v_B().length(), m.v_B);
  ledger.put(omega_disc(), m.omega_disc);
  ledger.put(a_Bstar().length(), [&] {
    return size(geometry::Vector<T>{OB * geometry::square(omega), OB * omega_dot});
  });
  ledger.put(a_cor().length(), magnitude_of<T>(T(2) * omega * m.b_dot));
  ledger.put(a_rel().length(), m.b_ddot);
  ledger.put(a_B().length(), m.a_B);
  ledger.put(alpha_disc(), m.alpha_disc);
  const T AO = geometry::from_rational<T>(of.AO), towards_O = AO * geometry::square(omega), along = AO * omega_dot;
  ledger.put(acceleration("A"), geometry::Vector<T>{towards_O * angle.cosine - along * angle.sine,
                                                    towards_O * angle.sine + along * angle.cosine});
  ledger.put(kinetic_energy(), balance.kinetic_energy);
  ledger.put(kinetic_power(), balance.kinetic_power);
  ledger.put(gravity_torque(), balance.gravity_torque);
  ledger.put(driving_couple(), balance.couple);
  ledger.put(R_23().length(), magnitude_of<T>(force.slot));
  ledger.put(N_13().length(), force.normal);
  ledger.put(T_13().length(), magnitude_of<T>(force.friction));
  ledger.put(required_friction(), [&] {
    require_pressing(force.normal);
    return geometry::quotient(magnitude_of(force.friction), force.normal);
  });
  ledger.put(R_12(), geometry::Vector<T>{force.at_O.re, force.at_O.im});
}

struct Routes {
  Instant instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const geometry::SlottedLever<T> at = instant.position<T>();
    const geometry::SlottedLeverMotion<T> motion = instant.motion(at);
    ledger.put(lever_angle(), [&] { return slope_angle(at.slot); });
    ledger.put(abscissa_of_B(), at.B.x);
    ledger.draws_point("O", at.O);
    ledger.draws_point("A", at.A);
    ledger.draws_point("B", at.B);
    ledger.draws_point("D", at.D);
    ledger.draws_vector("slot", at.slot);
    by_poles(ledger, instant, at);
    by_polar_diagrams(ledger, at, motion);
    by_newton_euler(ledger, instant, at, motion);
    by_power_balance(ledger, instant, at, motion);
    by_analysis(ledger, instant);
    return ledger;
  }
};

}  // namespace epure::pin_in_slot
