// Roulettes in closed form: the path z(φ) as a sum of exponentials, and its derivatives written down.
//
//   cycloid       z = r φ + i r - i d e^{-iφ}              z' = r - d e^{-iφ}
//   epicycloid    z = (R + r) e^{iβ} - d e^{iφ}            z' = i (r e^{iβ} - d e^{iφ}),    β = φ r/(R + r)
//   hypocycloid   z = (R - r) e^{iβ} + d e^{-iφ}           z' = i (r e^{iβ} - d e^{-iφ}),   β = φ r/(R - r)
//   involute      z = R e^{iφ} (1 - iφ) - d e^{iφ}         z' = (R φ - i d) e^{iφ}
//
// φ is the angle the rolling body has turned through (clockwise for cycloid and hypocycloid, else counter-clockwise).
// d is the distance of the tracing point from the centre of the rolling circle, for an involute from the rolling line
// towards the fixed circle. d = r, for an involute d = 0, is the curve with cusps; otherwise it is curtate or
// prolate. Lengths in any unit.
#pragma once

#include "geometry/analytic/plane_motion_formulas.h"
#include "geometry/numbers/angle.h"
#include "geometry/numbers/enclosure.h"

#include <type_traits>

namespace epure::geometry::analytic {

enum class RouletteKind { cycloid, epicycloid, hypocycloid, involute };

// Required of the caller: r > 0, R > 0, for a hypocycloid r < R; each where the kind has it.
struct Roulette {
  RouletteKind kind = RouletteKind::cycloid;
  Rational r = 0, R = 0, d = 0;
};

// e^{i angle}
template <class T>
Complex<T> unit(const Angle& angle) {
  return {cosine<T>(angle), sine<T>(angle)};
}

// z' = 0: for a circle |z'|² = (r - d)² + 2 r d (1 - cos ψ), ψ = φ R/(R ± r) or φ; for an involute d² + R² φ².
// Decided exactly.
bool is_at_rest(const Roulette& g, const Angle& phi);

// R = 2 r, d = r: z = 2 r cos β runs to and fro on a diameter.
bool is_straight(const Roulette& g);

// z and its derivatives by φ, and those of one more point that fixes the motion of the rolling plane.
template <class T>
struct RoulettePath {
  Complex<T> z, z_prime, z_second;
  Complex<T> origin, origin_prime,
      origin_second;  // the circle's centre; the point of the line that was touched first
  T sense;            // dθ/dφ of the rolling plane, ±1
  bool is_at_rest, is_straight;

  Complex<T> velocity(const T& omega) const { return omega * z_prime; }
  Complex<T> acceleration(const T& omega, const T& alpha) const { return square(omega) * z_second + alpha * z_prime; }
  PlaneMotion<T> motion(const T& omega, const T& alpha) const {
    return {origin, omega * origin_prime, square(omega) * origin_second + alpha * origin_prime, sense * omega,
            sense * alpha};
  }

  // |z'|³/|z' x z''|; 0 at a cusp. Throws Impossible where the path is straight to the second order.
  T radius_of_curvature() const {
    if (is_at_rest && !is_straight) return T(0);
    const T bend = is_straight ? T(0) : cross(z_prime, z_second);
    if (is_zero(bend, {"whether the path is straight", "se la traiettoria sia rettilinea"}))
      throw Impossible("the path is straight here: no finite radius",
                       "la traiettoria qui è rettilinea: nessun raggio finito");
    return quotient(squared_modulus(z_prime) * modulus(z_prime), root(square(bend)));
  }
  // z + i z' |z'|²/(z' x z''), as above.
  Complex<T> centre_of_curvature() const {
    if (is_at_rest && !is_straight) return z;
    const T bend = is_straight ? T(0) : cross(z_prime, z_second);
    if (is_zero(bend, {"whether the path is straight", "se la traiettoria sia rettilinea"}))
      throw Impossible("the path is straight here: no finite centre",
                       "la traiettoria qui è rettilinea: nessun centro al finito");
    return z + quotient(squared_modulus(z_prime), bend) * times_i(z_prime);
  }

  // The normal component of the acceleration, which α takes no part in: ω² |z' x z''|/|z'|; 0 at a cusp.
  T normal_component(const T& omega) const {
    if (is_at_rest || is_straight) return T(0);
    return square(omega) * quotient(root(square(cross(z_prime, z_second))), modulus(z_prime));
  }

  // Components of the acceleration along and square to the direction of travel, the second never negative. At a cusp
  // z' = z'' dφ: the direction of travel is against z'' before and along it after, and α takes no part.
  // Throws Impossible when ω = 0.
  struct Components {
    T before, after, normal;
  };
  Components components(const T& omega, const T& alpha) const {
    const Sign turning = decided_sign(omega, {"whether the body turns", "se il corpo ruoti"});
    if (turning == Sign::zero)
      throw Impossible("the body does not turn: its points have no direction of travel",
                       "il corpo non ruota: i suoi punti non hanno direzione di moto");
    if (is_at_rest) {
      const T size = square(omega) * modulus(z_second);
      return {-size, size, T(0)};
    }
    const Complex<T> v = velocity(omega), a = acceleration(omega, alpha);
    const T speed = modulus(v), along = quotient(dot(v, a), speed);
    return {along, along, is_straight ? T(0) : quotient(root(square(cross(v, a))), speed)};
  }
};

template <class T>
RoulettePath<T> roulette(const Roulette& g, const Angle& phi) {
  const T r = from_rational<T>(g.r), R = from_rational<T>(g.R), d = from_rational<T>(g.d);
  const auto i = [](const Complex<T>& z) { return times_i(z); };
  const bool at_rest = is_at_rest(g, phi), straight = is_straight(g);
  switch (g.kind) {
    case RouletteKind::cycloid: {
      const Complex<T> arm = -(d * i(unit<T>(-phi))), c{r * radians<T>(phi), r};
      const Complex<T> one{r, T(0)}, none{};
      return {c + arm, one - i(arm), -arm, c, one, none, T(-1), at_rest, straight};
    }
    case RouletteKind::involute: {
      const Complex<T> outwards = unit<T>(phi), d_out = d * outwards;
      const T length = R * radians<T>(phi);
      const Complex<T> on_line = R * outwards - length * i(outwards), unwound = length * outwards;
      const Complex<T> second = R * outwards + i(unwound);
      return {on_line - d_out, unwound - i(d_out), second + d_out, on_line, unwound, second, T(1), at_rest, straight};
    }
    default: {
      const bool outside = g.kind == RouletteKind::epicycloid;
      const Rational between = outside ? g.R + g.r : g.R - g.r;
      const Complex<T> to_centre = unit<T>((g.r / between) * phi);
      const Complex<T> arm = outside ? -(d * unit<T>(phi)) : d * unit<T>(-phi);
      const Complex<T> c = from_rational<T>(between) * to_centre, c_prime = r * i(to_centre);
      const Complex<T> c_second = -(from_rational<T>(g.r * g.r / between) * to_centre);
      return {c + arm,
              outside ? c_prime + i(arm) : c_prime - i(arm),
              c_second - arm,
              c,
              c_prime,
              c_second,
              T(outside ? 1 : -1),
              at_rest,
              straight};
    }
  }
}

// Where the two bodies touch: (r φ, 0) on a line, R e^{iβ} on a circle.
template <class T>
Complex<T> contact(const Roulette& g, const Angle& phi) {
  if (g.kind == RouletteKind::cycloid) return {from_rational<T>(g.r) * radians<T>(phi), T(0)};
  const Rational beta_per_phi = g.kind == RouletteKind::involute     ? Rational(1)
                                : g.kind == RouletteKind::epicycloid ? g.r / (g.R + g.r)
                                                                     : g.r / (g.R - g.r);
  return from_rational<T>(g.R) * unit<T>(beta_per_phi * phi);
}

// The arc length from 0 to φ, negative for φ < 0, by quadrature of |z'| with a proved bound (Arb). At the bits of the
// Deep scope, less what cusps and near misses cost.
Deep arc_length_by_quadrature(const Roulette& g, const Angle& phi);

// The same for every number that can: Exact throws LeavesTheTower, Calcium Undecided.
template <class T>
T arc_length(const Roulette& g, const Angle& phi) {
  if constexpr (std::is_same_v<T, Deep>) return arc_length_by_quadrature(g, phi);
  if constexpr (std::is_same_v<T, Exact>)
    throw LeavesTheTower("the length of an arc, as an integral", "la lunghezza di un arco, come integrale");
  if constexpr (std::is_same_v<T, Bounded> || std::is_same_v<T, Fast>) {
    constexpr long bits = 80;  // a double's 53 and what the quadrature loses
    const Arithmetic<Deep> scope(bits);
    const Deep length = arc_length_by_quadrature(g, phi);
    if constexpr (std::is_same_v<T, Bounded>) return to_bounded(length);
    if constexpr (std::is_same_v<T, Fast>) return enclosure(length).value;
  }
  throw Undecided("the length of an arc, as an integral, is an enclosure only",
                  "la lunghezza di un arco, come integrale, è solo un intervallo");
}

}  // namespace epure::geometry::analytic
