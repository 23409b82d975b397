#include "geometry/analytic/roulette_formulas.h"

#include "geometry/analytic/integral.h"

namespace epure::geometry::analytic {

namespace {

// dψ/dφ, where ψ is the angle between the two exponentials of z'.
Rational rolled_per_turned(const Roulette& g) {
  switch (g.kind) {
    case RouletteKind::epicycloid:
      return g.R / (g.R + g.r);
    case RouletteKind::hypocycloid:
      return g.R / (g.R - g.r);
    default:
      return 1;
  }
}

// What is integrated.
//   circle  |z'| = √(least² + between sin²(ψ/2)), because |r - d e^{iψ}|² = (r - d)² + 4 r d sin²(ψ/2)
//   line    |z'| = √(least² + between φ²)
// With least = 0 the root is taken: between two cusps it is analytic.
struct Speed {
  Deep least2, between;
  bool on_line, has_cusps;
};

Deep length_travelled(const Speed& g, const Deep& from, const Deep& to) {
  return integral(
      [&g](acb_ptr result, const acb_t angle, bool must_be_analytic, long bits) {
        acb_set(result, angle);
        if (!g.on_line) {
          acb_mul_2exp_si(result, result, -1);
          acb_sin(result, result, bits);
        }
        if (g.has_cusps) {
          const Deep factor = root(g.between);
          acb_mul_arb(result, result, factor.ball(), bits);
          return;
        }
        acb_mul(result, result, result, bits);
        acb_mul_arb(result, result, g.between.ball(), bits);
        acb_add_arb(result, result, g.least2.ball(), bits);
        acb_sqrt_analytic(result, result, must_be_analytic ? 1 : 0, bits);
      },
      from, to);
}

}  // namespace

bool is_at_rest(const Roulette& g, const Angle& phi) {
  if (g.kind == RouletteKind::involute) return g.d == 0 && sign_of(phi) == 0;
  return g.d == g.r && is_whole_turns(rolled_per_turned(g) * phi);
}

bool is_straight(const Roulette& g) {
  return g.kind == RouletteKind::hypocycloid && g.d == g.r && g.R == Rational(2) * g.r;
}

Deep arc_length_by_quadrature(const Roulette& g, const Angle& phi) {
  if (sign_of(phi) < 0) return -arc_length_by_quadrature(g, -phi);
  const auto deep = [](const Rational& x) { return from_rational<Deep>(x); };
  if (g.kind == RouletteKind::involute)
    return length_travelled({deep(g.d * g.d), deep(g.R * g.R), true, g.d == 0}, Deep(0), radians<Deep>(phi));
  const Speed speed{deep((g.r - g.d) * (g.r - g.d)), deep(Rational(4) * g.r * g.d), false, g.d == g.r};
  const Rational k = rolled_per_turned(g);
  // From one least speed to the next the arches are all alike.
  const Angle psi = k * phi;
  const Rational arches = whole_turns(psi);
  Deep sum = length_travelled(speed, Deep(0), radians<Deep>(psi - Angle{arches}));
  if (arches != 0) sum = sum + deep(arches) * length_travelled(speed, Deep(0), radians<Deep>(Angle{1}));
  return sum / deep(k);
}

}  // namespace epure::geometry::analytic
