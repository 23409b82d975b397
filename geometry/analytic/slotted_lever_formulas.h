// The slotted lever and the rolling disc in complex numbers. The pin is at z = b e^{iα}, with b the length OB, and
// the disc keeps it at Im z = R:
//   z'  = (b' + i b α') e^{iα},                                 Im z'  = 0 gives b',  Re z'  is v_B;
//   z'' = (b'' - b α'² + i (2 b' α' + b α'')) e^{iα},           Im z'' = 0 gives b'', Re z'' is a_B.
// Source: the worked exercise itself up to here. The couple is Lagrange's, with everything reduced to the lever:
//   E = I(α) ω²/2,   I = M1 a² + (M2 + J2/R²) R²/sin⁴α,   C = I dω/dt - (dI/dα) ω²/2 + M1 g a cos α.
//
// Metres, kilograms, seconds, newtons. The lever's ω and dω/dt, and C, are clockwise positive, as the source's; the
// disc's ω and α counter-clockwise. B lies ahead of O (cos α >= 0).
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/decide.h"

namespace epure::geometry::analytic {

// R > 0, OB >= R (the caller's promise), AO > 0; masses in kg, J2 in kg m², g in m/s².
struct SlottedLever {
  Rational R, OB, AO, M1, M2, J2, g;
};

template <class T>
struct SlottedLeverAngle {
  T cosine, sine;  // of α, the lever's angle from the guide
};

template <class T>
SlottedLeverAngle<T> angle(const SlottedLever& of) {
  return {root(from_rational<T>(1 - of.R * of.R / (of.OB * of.OB))), from_rational<T>(of.R / of.OB)};
}

// α itself, from the half angle: tan(α/2) = sin α / (1 + cos α). Of numbers that have an arc_tangent.
template <class T>
T radians(const SlottedLeverAngle<T>& angle) {
  return T(2) * arc_tangent(angle.sine, T(T(1) + angle.cosine));
}

template <class T>
struct SlottedLeverMotion {
  T b_dot, b_ddot;  // outwards positive
  T v_B, a_B;       // along x
  T omega_disc, alpha_disc;
};

template <class T>
SlottedLeverMotion<T> motion(const SlottedLever& of, const SlottedLeverAngle<T>& at, const T& omega,
                             const T& omega_dot) {
  const T b = from_rational<T>(of.OB), R = from_rational<T>(of.R), alpha_1 = -omega, alpha_2 = -omega_dot;
  // Im (p + i q) e^{iα} = 0 gives p = -q cot α, and leaves Re = -q/sin α.
  const T q_1 = b * alpha_1;
  const T b_dot = -quotient(q_1 * at.cosine, at.sine), v_B = -quotient(q_1, at.sine);
  const T q_2 = T(2) * b_dot * alpha_1 + b * alpha_2;
  const T b_ddot = b * square(alpha_1) - quotient(q_2 * at.cosine, at.sine), a_B = -quotient(q_2, at.sine);
  // Rolling: x' = -R ω.
  return {b_dot, b_ddot, v_B, a_B, -quotient(v_B, R), -quotient(a_B, R)};
}

// I(α) and dI/dα.
template <class T>
struct ReducedInertia {
  T I, slope;
};
template <class T>
ReducedInertia<T> reduced_inertia(const SlottedLever& of, const SlottedLeverAngle<T>& at) {
  const T rolling = from_rational<T>(of.M2 * of.R * of.R + of.J2), sine_4 = square(square(at.sine));
  const T of_disc = quotient(rolling, sine_4);
  return {from_rational<T>(of.M1 * of.AO * of.AO) + of_disc, -(T(4) * of_disc * quotient(at.cosine, at.sine))};
}

template <class T>
struct SlottedLeverBalance {
  T kinetic_energy;  // J
  T kinetic_power;   // W, dE/dt
  T gravity_torque;  // N m, resists a clockwise lever when positive
  T couple;          // C
};
template <class T>
SlottedLeverBalance<T> balance(const SlottedLever& of, const SlottedLeverAngle<T>& at, const T& omega,
                               const T& omega_dot) {
  const ReducedInertia<T> reduced = reduced_inertia(of, at);
  const T half = from_rational<T>(Rational(1, 2));
  // α decreases as the lever turns clockwise.
  const T inertia_torque = reduced.I * omega_dot - half * reduced.slope * square(omega);
  const T gravity_torque = from_rational<T>(of.M1 * of.g * of.AO) * at.cosine;
  return {half * reduced.I * square(omega), omega * inertia_torque, gravity_torque, inertia_torque + gravity_torque};
}

// Newton's equations of the disc, solved: along x, upwards, and about B.
template <class T>
struct SlottedLeverReactions {
  T slot;           // on the pin, along the normal of the slot that points clockwise about O: sin α - i cos α
  T normal;         // of the ground, upwards
  T friction;       // of the ground, along x
  Complex<T> at_O;  // of the frame on the lever
};
template <class T>
SlottedLeverReactions<T> reactions(const SlottedLever& of, const SlottedLeverAngle<T>& at,
                                   const SlottedLeverMotion<T>& m, const T& omega, const T& omega_dot) {
  const T friction = quotient(from_rational<T>(of.J2) * m.alpha_disc, from_rational<T>(of.R));
  const T slot = quotient(from_rational<T>(of.M2) * m.a_B - friction, at.sine);
  const T normal = from_rational<T>(of.M2 * of.g) + slot * at.cosine;
  // A = -a e^{iα}: M1 A'' is what the frame, the pin and the weight give the lever together.
  const Complex<T> to_A = -(from_rational<T>(of.AO) * Complex<T>{at.cosine, at.sine});
  const Complex<T> a_A = Complex<T>{-square(omega), -omega_dot} * to_A;
  const Complex<T> weight{T(0), -from_rational<T>(of.M1 * of.g)}, on_pin = slot * Complex<T>{at.sine, -at.cosine};
  return {slot, normal, friction, from_rational<T>(of.M1) * a_A - weight + on_pin};
}

}  // namespace epure::geometry::analytic
