// A circle that rolls without slipping on a line or a circle, a line that rolls on a circle, and a point M carried
// along: cycloids, epicycloids, hypocycloids, involutes, curtate and prolate ones.
//
// φ is everywhere the angle the rolling body has turned through, counted positive in the sense named here:
//   circle_on_line         the line is the x axis, the circle above it rolls towards +x, turning clockwise; at φ = 0
//                          M is straight below the centre, at (0, r - d)
//   circle_outside_circle  fixed circle about the origin, first contact (R, 0), contact and body go
//   counter-clockwise; circle_inside_circle   so does the contact here, while the body turns clockwise;
//                          at φ = 0 M is on the radius through the contact, d from the centre
//   line_on_circle         fixed circle about the origin, first contact (R, 0), the line unwinds counter-clockwise;
//                          at φ = 0 M is at (R - d, 0)
//
// The vector from the contact to M is drawn as such, not as the difference of two positions: so it is exactly zero at
// a cusp in every number, and beside a cusp it keeps its digits. What depends on it (velocity, acceleration,
// curvature) is therefore read from RollingInstant, about the contact, and not from rolling_motion in the fixed
// plane.
#pragma once

#include <vector>

#include "geometry/motion/euler_savary.h"
#include "geometry/numbers/angle.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {

enum class Rolls { circle_on_line, circle_outside_circle, circle_inside_circle, line_on_circle };

// Lengths in any unit. Required (else a caller's mistake): r > 0 and d >= 0 for a rolling circle, R > 0 for a fixed
// one, r < R inside it.
struct Rolling {
  Rolls how = Rolls::circle_on_line;
  Rational r = 0;  // radius of the rolling circle
  Rational R = 0;  // radius of the fixed circle
  // Distance of M from the centre of the rolling circle (r: on its rim); of a line: from that line, positive towards
  // the fixed circle's centre (0: on the line).
  Rational d = 0;
};

// +1 when the body turns counter-clockwise for growing φ, else -1.
int sense(const Rolling& rolling);

// dβ/dφ, where β is how far the contact has gone around the fixed circle, counter-clockwise. Around a line: 0.
Rational gone_around_per_turned(const Rolling& rolling);

// dψ/dφ, where ψ is the arc rolled off, as an angle of the rolling circle, in the sense of φ: how far the body has
// turned against the common normal. For a line, which has none, ψ is φ.
Rational rolled_per_turned(const Rolling& rolling);

// β and ψ themselves. An angle A is an Angle, or Radians<T> where a curve is traced; so below.
template <class A>
A contact_angle(const Rolling& rolling, const A& phi) {
  return gone_around_per_turned(rolling) * phi;
}
template <class A>
A rolled_angle(const Rolling& rolling, const A& phi) {
  return rolled_per_turned(rolling) * phi;
}

// Whether M is a point of the rolling circle or line itself, so that it comes to rest: at every contact of its own.
bool has_cusps(const Rolling& rolling);

// Whether M is on the contact: decided exactly.
bool is_at_cusp(const Rolling& rolling, const Angle& phi);

// The φ of every cusp from one angle to the other, both included, in increasing order; none when from > to.
// At a cusp v = 0, ρ = 0, and a runs along the tangent: its tangential component is -|a| just before, +|a| just
// after. (Where the path is a straight line, see runs_straight, M turns back instead, and no ρ exists.)
std::vector<Angle> cusps(const Rolling& rolling, const Angle& from, const Angle& to);

// Whether M goes to and fro on a diameter: a rim point of a circle that rolls inside one twice as large (La Hire,
// Cardan). Every point of the rim is then on the inflection circle.
bool runs_straight(const Rolling& rolling);

// Unit vector along the common normal, from the contact to the centre of the rolling circle; of a line away from the
// fixed circle.
template <class T, class A>
Vector<T> common_normal(const Rolling& rolling, const A& phi) {
  if (rolling.how == Rolls::circle_on_line) return {T(0), T(1)};
  const A beta = contact_angle(rolling, phi);
  const Vector<T> outwards{cosine<T>(beta), sine<T>(beta)};
  return rolling.how == Rolls::circle_inside_circle ? -outwards : outwards;
}

// In the fixed plane. On a line it has gone r φ.
template <class T, class A>
Point<T> contact_point(const Rolling& rolling, const A& phi) {
  if (rolling.how == Rolls::circle_on_line) return {from_rational<T>(rolling.r) * radians<T>(phi), T(0)};
  const A beta = contact_angle(rolling, phi);
  const T R = from_rational<T>(rolling.R);
  return {R * cosine<T>(beta), R * sine<T>(beta)};
}

// Centre of the rolling circle in the fixed plane. Throws Impossible for a line, which has none.
template <class T, class A>
Point<T> rolling_centre(const Rolling& rolling, const A& phi) {
  if (rolling.how == Rolls::line_on_circle) throw Impossible("a line has no centre", "una retta non ha centro");
  return contact_point<T>(rolling, phi) + from_rational<T>(rolling.r) * common_normal<T>(rolling, phi);
}

// From the contact to M, in the axes of the contact: y along the common normal n, x along the common tangent, a
// quarter turn clockwise of n.
//   line    R φ along the tangent, as far as it has been unwound, and d off it
//   circle  (r - d) along the normal, to the circle of radius d about the same centre, and the chord of that circle
//           which belongs to the rolled angle ψ: 2 d sin(ψ/2) long, at ψ/2 to the tangent
template <class T>
Vector<T> line_contact_to_point(const Rolling& rolling, const T& phi) {
  return {from_rational<T>(rolling.R) * phi, -from_rational<T>(rolling.d)};
}
// `half`: the direction of ψ/2, in the sense of the body.
template <class T>
Vector<T> circle_contact_to_point(const Rolling& rolling, const Vector<T>& half) {
  const T chord = T(2) * from_rational<T>(rolling.d) * half.y;
  return {chord * half.x, from_rational<T>(rolling.r - rolling.d) + chord * half.y};
}
template <class A>
A half_rolled_angle(const Rolling& rolling, const A& phi) {
  return Rational(sense(rolling), 2) * rolled_angle(rolling, phi);
}
template <class T, class A>
Vector<T> contact_to_point_by_normal(const Rolling& rolling, const A& phi) {
  if (rolling.how == Rolls::line_on_circle) return line_contact_to_point<T>(rolling, radians<T>(phi));
  const A half = half_rolled_angle(rolling, phi);
  return circle_contact_to_point<T>(rolling, {cosine<T>(half), sine<T>(half)});
}

// A vector from the axes of the contact to the fixed ones.
template <class T>
Vector<T> from_contact_axes(const Vector<T>& n, const Vector<T>& by_normal) {
  return by_normal.y * n - by_normal.x * quarter_turn(n);
}

// M in the fixed plane.
template <class T, class A>
Point<T> tracing_point(const Rolling& rolling, const A& phi) {
  const Vector<T> n = common_normal<T>(rolling, phi);
  return contact_point<T>(rolling, phi) + from_contact_axes(n, contact_to_point_by_normal<T>(rolling, phi));
}

// The diameter of the inflection circle: how far the inflection pole J is from the contact, the instant centre P0,
// along the common normal n.
//   circle on line    the centre's path is straight: J is the centre
//   line on circle    seen from the line, the circle's centre runs straight; J lies opposite it
//   circle on circle  the centre's path is a circle about the fixed centre: Euler and Savary
template <class T>
T inflection_diameter(const Rolling& rolling) {
  const T r = from_rational<T>(rolling.r), R = from_rational<T>(rolling.R);
  if (rolling.how == Rolls::circle_on_line) return r;
  if (rolling.how == Rolls::line_on_circle) return R;
  const Point<T> P0{T(0), T(0)}, centre{T(0), r},
      fixed_centre{T(0), rolling.how == Rolls::circle_inside_circle ? R : -R};
  return euler_savary_point(P0, centre, fixed_centre).y;
}

// The rolling plane and its point M at one instant, in axes through the contact P0, parallel to the fixed ones.
template <class T>
struct RollingInstant {
  PlaneMotion<T> motion;  // A = P0, the origin; counter-clockwise
  Point<T> M, J;
  Vector<T> n;          // common_normal
  Vector<T> by_normal;  // P0 to M in the axes of the contact
  T diameter;           // P0J
  bool is_at_cusp, runs_straight;

  Vector<T> velocity() const { return motion.velocity(M); }
  Vector<T> acceleration() const { return motion.acceleration(M); }
  // |ω| P0M
  T speed() const { return absolute(motion.omega) * length(by_normal); }

  // M', where the ray from P0 through M meets the inflection circle again: the foot of the perpendicular from J.
  // At a cusp the ray is tangent to the circle in P0, and M' = M = P0.
  Point<T> M_prime() const { return M + times_beyond() * (M - motion.A); }

  // Towards the centre of curvature: ω² MM', zero at a cusp.
  Vector<T> normal_acceleration() const { return (square(motion.omega) * times_beyond()) * (M - motion.A); }
  // What remains of the acceleration, along the path.
  Vector<T> tangential_acceleration() const { return acceleration() - normal_acceleration(); }

  // The components along the direction of travel. They differ only at a cusp, where that direction turns about.
  // Throws Impossible when the plane does not turn, and M has no direction of travel.
  struct BothSides {
    T before, after;
  };
  BothSides tangential_component() const {
    const Sign turning = sign(motion.omega);
    if (turning == Sign::undecided) throw Undecided("whether the rolling body turns", "se il corpo che rotola ruoti");
    if (turning == Sign::zero)
      throw Impossible("the rolling body does not turn: its points have no direction of travel",
                       "il corpo che rotola non ruota: i suoi punti non hanno direzione di moto");
    if (is_at_cusp) {
      const T size = length(acceleration());
      return {-size, size};
    }
    // Along ω k x P0M: (-y, x) in the axes of the contact, where P0J is (0, diameter).
    const T P0M = length(by_normal);
    const T component = square(motion.omega) * quotient(diameter * by_normal.x, P0M) + motion.alpha * P0M;
    return turning == Sign::positive ? BothSides{component, component} : BothSides{-component, -component};
  }
  // Not negative.
  T normal_component() const { return length(normal_acceleration()); }

  // The centre of curvature of M's path, by Euler and Savary; at infinity (w = 0), in the direction of the ray, where
  // M is on the inflection circle. At a cusp M itself; where the path is a straight line always at infinity.
  ProjectivePoint<T> centre_of_curvature() const {
    if (runs_straight) return at_infinity();
    if (is_at_cusp) return projective(M);
    const T w = times_beyond();
    const Vector<T> P0M = M - motion.A;
    return {w * M.x + P0M.x, w * M.y + P0M.y, w};
  }

  // Never negative. Throws Impossible where the centre is at infinity, Undecided where that cannot be told.
  T radius_of_curvature() const {
    if (is_at_cusp && !runs_straight) return T(0);
    const T w = runs_straight ? T(0) : times_beyond();
    if (sign(w) == Sign::zero)
      throw Impossible("the path is straight here: the centre of curvature lies at infinity",
                       "la traiettoria qui è rettilinea: il centro di curvatura è all'infinito");
    return quotient(length(by_normal), absolute(w));
  }

 private:
  // MM' as a multiple of P0M.
  T times_beyond() const {
    if (is_at_cusp || runs_straight) return T(0);
    const T P0M2 = length_squared(by_normal);
    return quotient(diameter * by_normal.y - P0M2, P0M2);
  }
  // M runs on a diameter through the fixed centre: the ray is square to it, unless M is at its end and on P0.
  ProjectivePoint<T> at_infinity() const {
    const Vector<T> across = is_at_cusp ? quarter_turn(n) : M - motion.A;
    return {across.x, across.y, T(0)};
  }
};

// omega = dφ/dt, alpha its derivative.
template <class T>
RollingInstant<T> rolling_instant(const Rolling& rolling, const Angle& phi, const T& omega, const T& alpha) {
  const Point<T> P0{T(0), T(0)};
  const T ccw(sense(rolling));
  const Vector<T> n = common_normal<T>(rolling, phi), by_normal = contact_to_point_by_normal<T>(rolling, phi);
  const T diameter = inflection_diameter<T>(rolling);
  const Vector<T> P0J = diameter * n;
  // The plane's point at the contact is accelerated towards J.
  const PlaneMotion<T> motion{P0, {T(0), T(0)}, square(omega) * P0J, ccw * omega, ccw * alpha};
  return {motion,
          P0 + from_contact_axes(n, by_normal),
          P0 + P0J,
          n,
          by_normal,
          diameter,
          is_at_cusp(rolling, phi),
          runs_straight(rolling)};
}

// The motion of the rolling plane in the fixed one.
template <class T>
PlaneMotion<T> rolling_motion(const Rolling& rolling, const Angle& phi, const T& omega, const T& alpha) {
  PlaneMotion<T> motion = rolling_instant<T>(rolling, phi, omega, alpha).motion;
  motion.A = contact_point<T>(rolling, phi);
  return motion;
}

// The way M has gone since φ = 0, negative for φ < 0.
//   on the rim     each arch is 8 r (R ± r)/R, on a line 8 r; of the last one (1 - cos ψ/2)/2 of it
//   involute       R φ²/2
//   other circles  an elliptic integral of the second kind:  ∫ √((r - d)² + 4 r d sin²(ψ/2)) dφ
//   other lines    ∫ √(d² + R² φ²) dφ
// The last two by Arb, for every enclosing number and Fast; Exact throws LeavesTheTower, Calcium Undecided.
template <class T>
T arc_length(const Rolling& rolling, const Angle& phi);

// ---------------------------------------------------------------------------------------------------------------------

// To as many bits as the Deep scope has, roughly.
Deep transcendental_arc_length(const Rolling& rolling, const Angle& phi);

namespace rolling_arcs {

inline constexpr long bits_for_doubles = 80;

template <class T>
T transcendental(const Rolling& rolling, const Angle& phi) {
  if constexpr (std::is_same_v<T, Exact>) throw LeavesTheTower("the length of an arc", "la lunghezza di un arco");
  if constexpr (std::is_same_v<T, Deep>) return transcendental_arc_length(rolling, phi);
  if constexpr (std::is_same_v<T, Bounded> || std::is_same_v<T, Fast>) {
    const Arithmetic<Deep> scope(bits_for_doubles);
    const Deep length = transcendental_arc_length(rolling, phi);
    if constexpr (std::is_same_v<T, Bounded>) return to_bounded(length);
    if constexpr (std::is_same_v<T, Fast>) return enclosure(length).value;
  }
  throw Undecided("the length of an arc is a transcendental number",
                  "la lunghezza di un arco è un numero trascendente");
}

}  // namespace rolling_arcs

template <class T>
T arc_length(const Rolling& rolling, const Angle& phi) {
  if (!has_cusps(rolling)) return rolling_arcs::transcendental<T>(rolling, phi);
  if (rolling.how == Rolls::line_on_circle) {
    const T half_square = from_rational<T>(rolling.R / 2) * square(radians<T>(phi));
    return sign_of(phi) < 0 ? -half_square : half_square;
  }
  const Angle psi = rolled_angle(rolling, phi);
  const Rational arches = whole_turns(psi), arch = Rational(8) * rolling.r / rolled_per_turned(rolling);
  // (1 - cos x/2)/2 = sin² x/4, without the cancelling beside a cusp.
  const T part = square(sine<T>(Rational(1, 4) * (psi - Angle{arches})));
  return from_rational<T>(arch) * (from_rational<T>(arches) + part);
}

}  // namespace epure::geometry
