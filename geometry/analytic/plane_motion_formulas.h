// A plane moving with angular velocity ω (rad/s) and angular acceleration α (rad/s²), counter-clockwise positive, in
// complex numbers. With ζ = z - z_A:
//   v(z) = v_A + i ω ζ,   a(z) = a_A + (i α - ω²) ζ.
// What may lie at infinity is an optional, empty when a decided sign says so; an undecided sign throws Undecided.
// Source of the formulas: solving these two lines; Bottema and Roth, Theoretical Kinematics, chapter VIII, has the
// same circles.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/decide.h"

#include <optional>

namespace epure::geometry::analytic {

template <class T>
struct Circle {
  Complex<T> centre;
  T diameter;
};

// The points z with Re(conj(normal) z) + offset = 0; the normal is not zero and has no particular length.
template <class T>
struct Line {
  Complex<T> normal;
  T offset;
};

template <class T>
struct PlaneMotion {
  Complex<T> z_A, v_A, a_A;
  T omega, alpha;

  Complex<T> velocity(const Complex<T>& z) const { return v_A + omega * times_i(z - z_A); }
  Complex<T> acceleration(const Complex<T>& z) const { return a_A + Complex<T>{-square(omega), alpha} * (z - z_A); }

  bool turns() const { return !is_zero(omega, {"whether the plane turns", "se il piano ruoti"}); }

  // The point of velocity zero, z_A + i v_A/ω. Empty when ω = 0.
  std::optional<Complex<T>> pole() const {
    if (!turns()) return {};
    return z_A + divided(times_i(v_A), omega);
  }

  // The point of acceleration zero, z_A - a_A/(i α - ω²). Empty when ω = α = 0.
  std::optional<Complex<T>> acceleration_pole() const {
    const T square_of_factor = square(square(omega)) + square(alpha);
    if (is_zero(square_of_factor,
                {"whether the acceleration pole is at infinity", "se il polo delle accelerazioni sia all'infinito"}))
      return {};
    return z_A + divided(a_A * Complex<T>{square(omega), alpha}, square_of_factor);
  }

  // Acceleration of the point of the moving plane that lies on the pole: a_A - α v_A/ω - i ω v_A. Empty when ω = 0.
  std::optional<Complex<T>> acceleration_at_pole() const {
    if (!turns()) return {};
    return a_A - quotient(alpha, omega) * v_A - omega * times_i(v_A);
  }

  // The point P + a_P/ω²: opposite the pole on the inflection circle. Empty when ω = 0.
  std::optional<Complex<T>> inflection_pole() const {
    if (!turns()) return {};
    return *pole() + divided(*acceleration_at_pole(), square(omega));
  }

  // The points with v x a = 0. For z = P + ρ this is ω² |ρ|² = Re(conj(ρ) a_P): the circle over the diameter from P
  // to P + a_P/ω². Diameter 0 when the pole stands still. Empty when ω = 0: see inflection_line.
  std::optional<Circle<T>> inflection_circle() const {
    if (!turns()) return {};
    const Complex<T> across = divided(*acceleration_at_pole(), square(omega));
    return circle_over(*pole(), across);
  }

  // The points with v . a = 0. For z = P + ρ this is α |ρ|² = Re(conj(ρ) i a_P): the circle over the diameter from P
  // to P + i a_P/α. Empty when ω α = 0: see stationarity_line.
  std::optional<Circle<T>> stationarity_circle() const {
    if (!turns() ||
        is_zero(alpha, {"whether the angular velocity is stationary", "se la velocità angolare sia stazionaria"}))
      return {};
    return circle_over(*pole(), divided(times_i(*acceleration_at_pole()), alpha));
  }

  // What the inflection circle becomes when ω = 0. Empty when ω != 0, and when v x a is constant (no line, or every
  // point: ω = α = 0 or v_A = 0).
  std::optional<Line<T>> inflection_line() const {
    if (turns()) return {};
    return line_through_field(alpha * v_A, cross(v_A, a_A));
  }

  // What the stationarity circle becomes when ω α = 0. Empty otherwise, and when v . a is constant: ω = α = 0, or a
  // pole that stands still and α = 0 (every point's speed is constant).
  std::optional<Line<T>> stationarity_line() const {
    const bool still = !turns(), steady = is_zero(alpha, {"whether the angular velocity is stationary",
                                                          "se la velocità angolare sia stazionaria"});
    if (still) return line_through_field(-(alpha * times_i(v_A)), dot(v_A, a_A));
    if (!steady) return {};
    return line_through_field(-(omega * (omega * v_A + times_i(a_A))), dot(v_A, a_A));
  }

  // Where the ray from the pole through z meets the inflection circle again: P + ρ Re(conj(ρ) a_P)/(ω² |ρ|²).
  // The pole itself when that circle is a point or tangent to the ray. Empty when ω = 0. Throws Impossible when z is
  // the pole.
  std::optional<Complex<T>> on_inflection_circle(const Complex<T>& z) const {
    if (!turns()) return {};
    const Complex<T> rho = z - *pole();
    const T length2 = squared_modulus(rho);
    if (is_zero(length2, {"whether the point is the pole", "se il punto sia il centro d'istantanea rotazione"}))
      throw Impossible("the point is the pole: no ray leads from one to the other",
                       "il punto è il centro d'istantanea rotazione: nessun raggio va dall'uno all'altro");
    return *pole() + quotient(dot(rho, *acceleration_at_pole()), square(omega) * length2) * rho;
  }

  // Signed curvature (1/m) of the path of z at z: (v x a)/|v|³, positive when the path bends to its left.
  // Throws Impossible when z is at rest.
  T curvature(const Complex<T>& z) const {
    const Complex<T> v = velocity(z);
    const T speed2 = moving(squared_modulus(v));
    return quotient(cross(v, acceleration(z)), speed2 * root(speed2));
  }

  // Radius of curvature (m, never negative). Empty when the path is straight to the second order.
  // Throws Impossible when z is at rest.
  std::optional<T> radius_of_curvature(const Complex<T>& z) const {
    const Complex<T> v = velocity(z);
    const T speed2 = moving(squared_modulus(v)), bend = cross(v, acceleration(z));
    if (is_zero(bend, {"whether the path is straight", "se la traiettoria sia rettilinea"})) return {};
    return quotient(speed2 * root(speed2), root(square(bend)));
  }

  // Centre of curvature z + i v |v|²/(v x a). Empty when the path is straight to the second order.
  // Throws Impossible when z is at rest.
  std::optional<Complex<T>> centre_of_curvature(const Complex<T>& z) const {
    const Complex<T> v = velocity(z);
    const T speed2 = moving(squared_modulus(v)), bend = cross(v, acceleration(z));
    if (is_zero(bend, {"whether the path is straight", "se la traiettoria sia rettilinea"})) return {};
    return z + quotient(speed2, bend) * times_i(v);
  }

 private:
  static Circle<T> circle_over(const Complex<T>& from, const Complex<T>& across) {
    return {from + divided(across, T(2)), modulus(across)};
  }

  static const T& moving(const T& speed2) {
    if (is_zero(speed2, {"whether the point is at rest", "se il punto sia fermo"}))
      throw Impossible("the point is at rest: its path has no curvature there",
                       "il punto è fermo: lì la sua traiettoria non ha curvatura");
    return speed2;
  }

  // The line Re(conj(normal) (z - z_A)) + at_A = 0.
  std::optional<Line<T>> line_through_field(const Complex<T>& normal, const T& at_A) const {
    if (is_zero(squared_modulus(normal),
                {"whether the circle has become a line", "se la circonferenza sia diventata una retta"}))
      return {};
    return Line<T>{normal, at_A - dot(normal, z_A)};
  }
};

}  // namespace epure::geometry::analytic
