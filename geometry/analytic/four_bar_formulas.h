// The four-bar linkage by its closure equation, in complex numbers:
//   A0A u + AB v = z_B0 + B0B w,   u, v, w unit directions of the crank A0 -> A, the coupler A -> B, the rocker
//                                  B0 -> B,
// and its first and second derivatives with respect to time. With d = z_B0 - A0A u, the way from A to B0, the coupler
// is eliminated by |d + B0B w| = AB: Freudenstein's equation, linear in the cosine and sine of the rocker's angle,
//   2 B0B Re(conj(d) w) = AB² - B0B² - |d|².
// Source: Esercitazioni di Meccanica Applicata, N.10. There the equation is solved for tan(θ₄/2), which does not
// exist at θ₄ = π; here for w itself, which has no such place.
//
// A0 is the origin, B0 anywhere else. Angles are counter-clockwise from the real axis.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/crank_state.h"
#include "geometry/analytic/decide.h"
#include "geometry/analytic/digits.h"
#include "geometry/analytic/plane_motion_formulas.h"

#include <string>

namespace epure::geometry::analytic {

// Lengths in metres: crank A0A > 0, coupler AB > 0, rocker B0B > 0; B0 = (x_B0, y_B0).
struct FourBar {
  Rational A0A, AB, B0B, x_B0, y_B0;

  template <class T>
  Complex<T> B0() const {
    return {from_rational<T>(x_B0), from_rational<T>(y_B0)};
  }
  // |A0B0|², in m²: rational even where the length is not.
  Rational squared_frame() const { return x_B0 * x_B0 + y_B0 * y_B0; }
};

// The side of a directed line.
enum class Side { left, right };

// The assembly branch: the side of the directed line A -> B0 on which B lies. Where A, B, B0 are in line both
// coincide.
enum class Branch { left, right };

// Points in metres; unit directions of the three moving links.
template <class T>
struct FourBarPosition {
  Complex<T> A, B;
  Complex<T> crank, coupler, rocker;
  T coupler_cross_rocker;  // AB B0B sin of the angle from coupler to rocker (m²): zero in line, negative on the right
};

// Angular in rad/s and rad/s², counter-clockwise positive; velocities in m/s, accelerations in m/s².
template <class T>
struct FourBarMotion {
  T omega_3, omega_4, alpha_3, alpha_4;
  Complex<T> v_A, v_B, a_A, a_B;
};

// Throws Impossible when A0 and B0 coincide.
inline void require_frame(const FourBar& g) {
  if (g.squared_frame() == 0)
    throw Impossible("the hinges A0 and B0 coincide: there is no frame",
                     "le cerniere A0 e B0 coincidono: non c'è telaio");
}

// Throws Impossible for a linkage that closes too far or too near by `short_by`; |d| is the distance from A to B0.
template <class T>
[[noreturn]] void refuse_closure(const T& d, const Words& reach, const T& short_by) {
  throw Impossible(Words{"the four-bar does not close: A is ", "il quadrilatero non si chiude: A dista "} +
                   digits(d) + Words{" m from B0, and AB and B0B ", " m da B0, e AB e B0B "} + reach +
                   Words{" m: short by ", " m: mancano "} + digits(short_by) + " m");
}

// Four times the area of the triangle A B B0, by Heron's formula
//   √((AB + B0B)² - |d|²) √(|d|² - (AB - B0B)²).
// When its sides AB and B0B are A0A and A0B0, in either order, the triangle A0 A B0 is as large, which takes no root:
// one of a square of sines would hide its zeros from every exact number. Throws Undecided as position.
template <class T>
T four_areas(const FourBar& g, const CrankState<T>& crank, const T& to_spare, const T& beyond) {
  const bool is_kite = g.AB == g.A0A && g.B0B * g.B0B == g.squared_frame();
  const bool is_parallelogram = g.B0B == g.A0A && g.AB * g.AB == g.squared_frame();
  if (!is_kite && !is_parallelogram) return root(to_spare * beyond);
  const T twice = from_rational<T>(2 * g.A0A) * cross(g.B0<T>(), Complex<T>{crank.cosine, crank.sine});
  return decided_sign(twice, {"on which side of the frame the crank points",
                              "da quale parte del telaio sia rivolta la manovella"}) == Sign::negative
             ? -twice
             : twice;
}

// The whole position. Throws Impossible when the linkage does not close, saying by how much, when A0 and B0 coincide,
// and when A lies on B0 with AB = B0B (then B may be anywhere on a circle). Undecided when T cannot tell.
// Where coupler and rocker are in line the position exists.
template <class T>
FourBarPosition<T> position(const FourBar& g, const CrankState<T>& crank, Branch branch) {
  require_frame(g);
  const Complex<T> B0 = g.B0<T>(), u{crank.cosine, crank.sine};
  const T a = from_rational<T>(g.A0A), b = from_rational<T>(g.AB), c = from_rational<T>(g.B0B);
  const Complex<T> d = B0 - a * u;
  // |d|² = f² + a² - 2 a Re(conj(z_B0) u). Everything but the last term is rational and stays together, so that no
  // digits are lost where terms cancel.
  const T varying = T(2) * a * dot(B0, u);
  const auto squared_d_and = [&](const Rational& constant) {
    return from_rational<T>(g.squared_frame() + g.A0A * g.A0A + constant) - varying;
  };
  const Rational longest = g.AB + g.B0B, shortest = abs(g.AB - g.B0B);
  const T to_spare = -squared_d_and(-longest * longest), beyond = squared_d_and(-shortest * shortest);
  if (decided_sign(to_spare, {"whether coupler and rocker reach from A to B0",
                              "se biella e bilanciere arrivino da A a B0"}) == Sign::negative) {
    const T distance = modulus(d), reach = from_rational<T>(longest);
    refuse_closure(distance, Words{"together reach ", "insieme arrivano a "} + digits(reach), distance - reach);
  }
  if (decided_sign(beyond, {"whether coupler and rocker fold up as near as A is to B0",
                            "se biella e bilanciere ripiegati si avvicinino quanto A a B0"}) == Sign::negative) {
    const T distance = modulus(d), reach = from_rational<T>(shortest);
    refuse_closure(distance, Words{"come no nearer than ", "non si avvicinano a meno di "} + digits(reach),
                   reach - distance);
  }
  const T d2 = squared_d_and(0);
  if (is_zero(d2, {"whether A lies on B0", "se A stia su B0"}))
    throw Impossible("A lies on B0: coupler and rocker may then point anywhere",
                     "A sta su B0: biella e bilanciere possono allora avere qualsiasi direzione");
  // Both solutions of Freudenstein's equation, and likewise of the one for v.
  const T areas = four_areas(g, crank, to_spare, beyond), h = branch == Branch::left ? areas : -areas;
  const T cosine_part_of_v = squared_d_and(g.AB * g.AB - g.B0B * g.B0B);
  const T cosine_part_of_w = -squared_d_and(g.B0B * g.B0B - g.AB * g.AB);
  const Complex<T> v = divided(Complex<T>{cosine_part_of_v, h} * d, T(2) * b * d2);
  const Complex<T> w = divided(Complex<T>{cosine_part_of_w, h} * d, T(2) * c * d2);
  return {a * u, B0 + c * w, u, v, w, quotient(h, T(2))};
}

// Velocities and accelerations at a position of `position`. Throws Impossible when coupler and rocker are in line
// (the crank is at a limit of its way: the closure then fixes neither ω₃ nor ω₄). Undecided when T cannot tell.
template <class T>
FourBarMotion<T> motion(const FourBar& g, const CrankState<T>& crank, const FourBarPosition<T>& p) {
  if (is_zero(p.coupler_cross_rocker,
              {"whether coupler and rocker are in line", "se biella e bilanciere siano allineati"}))
    throw Impossible("coupler and rocker are in line: their angular velocities are not defined",
                     "biella e bilanciere sono allineati: le loro velocità angolari non sono definite");
  const T a = from_rational<T>(g.A0A), b = from_rational<T>(g.AB), c = from_rational<T>(g.B0B);
  const Complex<T>&u = p.crank, &v = p.coupler, &w = p.rocker;
  const T omega_2 = crank.omega, alpha_2 = crank.alpha;
  FourBarMotion<T> m;
  // First derivative, i a ω₂ u + i b ω₃ v = i c ω₄ w: the part across w is free of ω₄, the part across v free of ω₃.
  m.omega_3 = -quotient(a * c * omega_2 * cross(u, w), p.coupler_cross_rocker);
  m.omega_4 = quotient(a * b * omega_2 * cross(v, u), p.coupler_cross_rocker);
  // Second derivative, a (i α₂ - ω₂²) u + b (i α₃ - ω₃²) v = c (i α₄ - ω₄²) w: along w, and along v.
  const T along_w = a * (square(omega_2) * dot(u, w) - alpha_2 * cross(u, w)) + b * square(m.omega_3) * dot(v, w) -
                    c * square(m.omega_4);
  const T along_v = a * (square(omega_2) * dot(u, v) - alpha_2 * cross(u, v)) + b * square(m.omega_3) -
                    c * square(m.omega_4) * dot(v, w);
  m.alpha_3 = quotient(c * along_w, p.coupler_cross_rocker);
  m.alpha_4 = quotient(b * along_v, p.coupler_cross_rocker);
  // (i ω) and (i α - ω²) are what d/dt and d²/dt² make of a unit direction.
  m.v_A = omega_2 * times_i(p.A);
  m.a_A = Complex<T>{-square(omega_2), alpha_2} * p.A;
  m.v_B = c * m.omega_4 * times_i(w);
  m.a_B = c * (Complex<T>{-square(m.omega_4), m.alpha_4} * w);
  return m;
}

// The three moving links as planes: pole, acceleration pole, circles, curvature, velocity and acceleration of any
// point.
template <class T>
PlaneMotion<T> crank(const CrankState<T>& state) {
  return {{}, {}, {}, state.omega, state.alpha};
}
template <class T>
PlaneMotion<T> coupler(const FourBarPosition<T>& p, const FourBarMotion<T>& m) {
  return {p.A, m.v_A, m.a_A, m.omega_3, m.alpha_3};
}
template <class T>
PlaneMotion<T> rocker(const FourBar& g, const FourBarMotion<T>& m) {
  return {g.B0<T>(), {}, {}, m.omega_4, m.alpha_4};
}

// The point of a link given in its own frame: real part along the link's direction, imaginary part across, 90°
// counter-clockwise from it, in metres. Origins: A0, A and B0.
template <class T>
Complex<T> crank_point(const FourBarPosition<T>& p, const Complex<T>& in_link) {
  return in_link * p.crank;
}
template <class T>
Complex<T> coupler_point(const FourBarPosition<T>& p, const Complex<T>& in_link) {
  return p.A + in_link * p.coupler;
}
template <class T>
Complex<T> rocker_point(const FourBar& g, const FourBarPosition<T>& p, const Complex<T>& in_link) {
  return g.B0<T>() + in_link * p.rocker;
}

// C of a plate with its right angle at C, in the coupler's frame, on the given side of A -> B: the foot of C divides
// AB at AC²/AB (Euclid), the height follows from Pythagoras. The decision is on rationals. Throws Impossible when the
// leg AC is longer than AB.
template <class T>
Complex<T> right_angled_plate_point(const FourBar& g, const Rational& AC, Side side) {
  const Rational squared_BC = (g.AB - AC) * (g.AB + AC);
  if (squared_BC < 0)
    throw Impossible(
        Words{"the plate has no right angle at C: AC is ", "la piastra non ha angolo retto in C: AC è "} +
        digits(from_rational<T>(AC)) + Words{" m and the hypotenuse AB only ", " m e l'ipotenusa AB soltanto "} +
        digits(from_rational<T>(g.AB)) + " m");
  const T height = from_rational<T>(AC / g.AB) * root(from_rational<T>(squared_BC));
  return {from_rational<T>(AC * AC / g.AB), side == Side::left ? height : -height};
}

}  // namespace epure::geometry::analytic
