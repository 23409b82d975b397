#include "geometry/motion/rolling.h"

#include "geometry/numbers/ball.h"

#include <cassert>

namespace epure::geometry {

namespace {

bool is_line(const Rolling& rolling) { return rolling.how == Rolls::line_on_circle; }

bool is_possible(const Rolling& g) {
  const bool has_circle = is_line(g) || (g.r > 0 && g.d >= 0);
  const bool has_ground = g.how == Rolls::circle_on_line || g.R > 0;
  return has_circle && has_ground && (g.how != Rolls::circle_inside_circle || g.r < g.R);
}

// ∫ √(1 - m sin² u) du from 0 to `to`, in [0, π/2], for m <= 0.
Deep second_kind(const Deep& to, const Deep& m) {
  const ComplexBall angle(to), parameter(m);
  ComplexBall integral;
  acb_elliptic_e_inc(integral.value, angle.value, parameter.value, 0, Arithmetic<Deep>::bits());
  return integral.real();
}
Deep complete_second_kind(const Deep& m) {
  const ComplexBall parameter(m);
  ComplexBall integral;
  acb_elliptic_e(integral.value, parameter.value, Arithmetic<Deep>::bits());
  return integral.real();
}

// ∫ √((r - d)² + 4 r d sin² u) du from 0 to ψ/2, for d other than r. The integrand repeats after every half turn of
// u, and backwards from its middle.
Deep by_circle(const Rational& r, const Rational& d, const Angle& psi) {
  const Rational off_rim = abs(r - d);
  const Deep m = from_rational<Deep>(Rational(-4) * r * d / (off_rim * off_rim));
  const Rational periods = whole_turns(psi);
  const Angle rest = psi - Angle{periods};
  const bool is_beyond_middle = sign_of(rest - Angle{Rational(1, 2)}) > 0;
  const Angle folded = Rational(1, 2) * (is_beyond_middle ? Angle{1} - rest : rest);
  const Deep part = second_kind(radians<Deep>(folded), m);
  const Rational quarters = Rational(2) * (is_beyond_middle ? periods + 1 : periods);
  const Deep whole = quarters == 0 ? Deep(0) : from_rational<Deep>(quarters) * complete_second_kind(m);
  return from_rational<Deep>(off_rim) * (is_beyond_middle ? whole - part : whole + part);
}

// ∫ √(d² + R² φ²) dφ = (φ √(d² + R² φ²) + d²/R arsinh(R φ/|d|))/2, for d other than 0.
Deep by_line(const Rational& R, const Rational& d, const Angle& phi) {
  const Deep angle = radians<Deep>(phi), d2 = from_rational<Deep>(d * d);
  const Deep ratio = from_rational<Deep>(R / abs(d)) * angle;
  ComplexBall area(ratio);
  arb_asinh(acb_realref(area.value), ratio.ball(), Arithmetic<Deep>::bits());
  const Deep slant = root(d2 + square(from_rational<Deep>(R) * angle));
  return (angle * slant + quotient(d2, from_rational<Deep>(R)) * area.real()) / Deep(2);
}

}  // namespace

Deep transcendental_arc_length(const Rolling& rolling, const Angle& phi) {
  if (is_line(rolling)) return by_line(rolling.R, rolling.d, phi);
  const Deep doubled = from_rational<Deep>(Rational(2) / rolled_per_turned(rolling));
  return doubled * by_circle(rolling.r, rolling.d, rolled_angle(rolling, phi));
}

int sense(const Rolling& rolling) { return rolling.how == Rolls::circle_outside_circle || is_line(rolling) ? 1 : -1; }

Rational gone_around_per_turned(const Rolling& rolling) {
  assert(is_possible(rolling) && "a circle that cannot roll so");
  switch (rolling.how) {
    case Rolls::circle_outside_circle:
      return rolling.r / (rolling.R + rolling.r);
    case Rolls::circle_inside_circle:
      return rolling.r / (rolling.R - rolling.r);
    case Rolls::line_on_circle:
      return 1;
    default:
      return 0;
  }
}

Rational rolled_per_turned(const Rolling& rolling) {
  const Rational around = gone_around_per_turned(rolling);
  return is_line(rolling) ? Rational(1) : Rational(1) - sense(rolling) * around;
}

bool has_cusps(const Rolling& rolling) { return rolling.d == (is_line(rolling) ? Rational(0) : rolling.r); }

bool is_at_cusp(const Rolling& rolling, const Angle& phi) {
  if (!has_cusps(rolling)) return false;
  return is_line(rolling) ? sign_of(phi) == 0 : is_whole_turns(rolled_angle(rolling, phi));
}

std::vector<Angle> cusps(const Rolling& rolling, const Angle& from, const Angle& to) {
  if (!has_cusps(rolling)) return {};
  if (is_line(rolling)) {
    if (sign_of(from) > 0 || sign_of(to) < 0) return {};
    return {Angle{}};
  }
  std::vector<Angle> found;
  const Rational last = whole_turns(rolled_angle(rolling, to));
  for (Rational n = -whole_turns(-rolled_angle(rolling, from)); n <= last; n += 1)
    found.push_back({n / rolled_per_turned(rolling)});
  return found;
}

bool runs_straight(const Rolling& rolling) {
  return rolling.how == Rolls::circle_inside_circle && has_cusps(rolling) && rolling.R == Rational(2) * rolling.r;
}

}  // namespace epure::geometry
