#include "geometry/analytic/roulette_formulas.h"

#include "geometry/numbers/ball_integral.h"

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

// What is integrated, as Arb asks for it.
//   circle  |z'| = √(least² + between sin²(ψ/2)), because |r - d e^{iψ}|² = (r - d)² + 4 r d sin²(ψ/2)
//   line    |z'| = √(least² + between φ²)
// With least = 0 the root is taken: between two cusps it is analytic.
struct Speed {
  Deep least2, between;
  bool on_line, has_cusps;
};

int speed_at(acb_ptr result, const acb_t angle, void* parameters, slong order, slong bits) {
  const auto* g = static_cast<const Speed*>(parameters);
  acb_set(result, angle);
  if (!g->on_line) {
    acb_mul_2exp_si(result, result, -1);
    acb_sin(result, result, bits);
  }
  if (g->has_cusps) {
    const Deep factor = root(g->between);
    acb_mul_arb(result, result, factor.ball(), bits);
    return 0;
  }
  acb_mul(result, result, result, bits);
  acb_mul_arb(result, result, g->between.ball(), bits);
  acb_add_arb(result, result, g->least2.ball(), bits);
  // order > 0: Arb asks to be told where the root is not analytic.
  acb_sqrt_analytic(result, result, order != 0, bits);
  return 0;
}

Deep integral(Speed speed, const Deep& from, const Deep& to) { return ball_integral(speed_at, &speed, from, to); }

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
    return integral({deep(g.d * g.d), deep(g.R * g.R), true, g.d == 0}, Deep(0), radians<Deep>(phi));
  const Speed speed{deep((g.r - g.d) * (g.r - g.d)), deep(Rational(4) * g.r * g.d), false, g.d == g.r};
  const Rational k = rolled_per_turned(g);
  // From one least speed to the next the arches are all alike.
  const Angle psi = k * phi;
  const Rational arches = whole_turns(psi);
  Deep sum = integral(speed, Deep(0), radians<Deep>(psi - Angle{arches}));
  if (arches != 0) sum = sum + deep(arches) * integral(speed, Deep(0), radians<Deep>(Angle{1}));
  return sum / deep(k);
}

}  // namespace epure::geometry::analytic
