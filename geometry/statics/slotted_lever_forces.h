// The forces of the slotted lever and the rolling disc, and the couple C that drives the lever, found twice: body by
// body with the force polygons of Newton and Euler, and with the balance of powers, in which no reaction appears.
//
// The lever has no mass; a point mass M1 sits at A; the disc has mass M2 and moment of inertia J2 about B. The pin
// runs in the slot without friction. Newtons, metres, kilograms, seconds; C is positive clockwise, as the source's.
#pragma once

#include "geometry/constructions/vector_polygon.h"
#include "geometry/mechanisms/slotted_lever.h"
#include "geometry/statics/force.h"

namespace epure::geometry {

struct SlottedLeverMasses {
  Rational M1, M2, J2, g;
};

// Each group is in equilibrium with the forces of inertia (d'Alembert).
template <class T>
struct DiscForces {
  Force<T> weight, inertia;
  Force<T> friction;  // of the guide, along it
  Force<T> slot;      // of the slot on the pin, square to the slot
  Force<T> ground;    // of the guide, square to it
  T on_slot_normal;   // the slot's force along the normal that points clockwise about O
  T normal;           // the guide's force upwards; negative: the guide would have to hold the disc down
};
template <class T>
struct LeverForces {
  Force<T> pin;  // of the pin on the slot
  Force<T> weight, inertia;
  Force<T> pivot;  // of the frame, at O
  T couple;        // C
};

// The friction follows from the moments about B, the other two forces close the polygon.
template <class T>
DiscForces<T> disc_forces(const SlottedLever<T>& at, const PlaneMotion<T>& disc, const SlottedLeverMasses& of) {
  const T M2 = from_rational<T>(of.M2), J2 = from_rational<T>(of.J2);
  const Vector<T> along{T(1), T(0)}, up{T(0), T(1)}, clockwise = -quarter_turn(at.slot);
  const Force<T> W = weight(M2, from_rational<T>(of.g), at.B), inertia = inertia_force(M2, at.B, disc);
  const T lever_arm = moment(Force<T>{at.D, along}, at.B);
  const Force<T> friction{at.D, quotient(J2 * disc.alpha, lever_arm) * along};
  const auto [on_pin, minus_normal] = close_polygon(W.f + inertia.f + friction.f, clockwise, up);
  const T normal = -minus_normal;
  return {W, inertia, friction, {at.B, on_pin * clockwise}, {at.D, normal * up}, on_pin, normal};
}

// The couple follows from the moments about O, the pivot's force closes the polygon.
template <class T>
LeverForces<T> lever_forces(const SlottedLever<T>& at, const PlaneMotion<T>& lever, const Force<T>& on_pin,
                            const SlottedLeverMasses& of) {
  const T M1 = from_rational<T>(of.M1);
  const Force<T> pin{at.B, -on_pin.f}, W = weight(M1, from_rational<T>(of.g), at.A),
                                       inertia = inertia_force(M1, at.A, lever);
  const Vector<T> none{T(0), T(0)};
  return {pin,
          W,
          inertia,
          {at.O, closing_side(pin.f + W.f + inertia.f, none)},
          moment(pin, at.O) + moment(W, at.O) + moment(inertia, at.O)};
}

// The balance  C ω = dE_k/dt + (power spent against the weight of M1), each part divided by ω: the powers of the
// actual forces in a motion with unit lever speed, clockwise. So it holds for a lever that is just starting, too.
template <class T>
struct PowerBalance {
  T of_M1, of_disc;  // parts of (dE_k/dt)/ω: M1 at A; the disc's translation and rotation
  T against_gravity;

  T kinetic() const { return of_M1 + of_disc; }
  T couple() const { return kinetic() + against_gravity; }
};

template <class T>
PowerBalance<T> power_balance(const SlottedLever<T>& at, const SlottedLeverMotion<T>& motion,
                              const SlottedLeverMasses& of) {
  const T M1 = from_rational<T>(of.M1), M2 = from_rational<T>(of.M2), J2 = from_rational<T>(of.J2);
  const SlottedLeverMotion<T> unit = slotted_lever_motion(at, T(-1), T(0));
  const Vector<T> v_A = unit.lever.velocity(at.A), v_B = unit.disc.v_A;
  return {M1 * dot(motion.lever.acceleration(at.A), v_A),
          M2 * dot(motion.disc.a_A, v_B) + J2 * (motion.disc.alpha * unit.disc.omega),
          -dot(weight(M1, from_rational<T>(of.g), at.A).f, v_A)};
}

// ½ Σ (m v² + J ω²).
template <class T>
T kinetic_energy(const SlottedLever<T>& at, const SlottedLeverMotion<T>& motion, const SlottedLeverMasses& of) {
  const T twice = from_rational<T>(of.M1) * length_squared(motion.lever.velocity(at.A)) +
                  from_rational<T>(of.M2) * length_squared(motion.disc.v_A) +
                  from_rational<T>(of.J2) * square(motion.disc.omega);
  return from_rational<T>(Rational(1, 2)) * twice;
}

}  // namespace epure::geometry
