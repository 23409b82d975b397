#include "exercises/pump-flywheel/torque.h"

#include <cmath>

#include "geometry/analytic/integral.h"
#include "geometry/numbers/greater.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::pump_flywheel {
namespace {

using geometry::ComplexBall;
using geometry::greater;
using geometry::increasing_root;
using geometry::pi;
using geometry::root;
using geometry::Sign;
using geometry::square;

// Of the place where C sin α + K sin 2α is greatest: 4 K cos² + C cos - 2 K = 0.
Deep cosine_at_greatest(const HalfTurn& of) {
  if (sign(of.K) == Sign::zero) return Deep(0);
  return Deep(4) * of.K / (of.C + root(square(of.C) + Deep(32) * square(of.K)));
}
double log2_of_size(const Deep& x) { return std::log2(geometry::enclosure(x).value); }
constexpr double around = 0.01;

}  // namespace

bool HalfTurn::has_zeros() const {
  const Deep cosine = cosine_at_greatest(*this), sine = root(Deep(1) - square(cosine));
  const Sign above = sign(sine * (C + Deep(2) * K * cosine) - M);
  if (above == Sign::undecided)
    throw geometry::Undecided("whether the torque reaches its mean value", "se il momento arrivi al valore medio");
  return above == Sign::positive;
}

namespace closed {

// Before the greatest value, and not before (C + 2 K) α reaches M.
Deep first_zero(const HalfTurn& of) {
  const Deep cosine = cosine_at_greatest(of), last = geometry::arc_tangent(root(Deep(1) - square(cosine)), cosine);
  const auto above = [&](const Deep& x) {
    const Deep sine = sine_of_angle(x);
    return sine * (of.C + Deep(2) * of.K * cosine_of_angle(x)) - of.M;
  };
  return increasing_root(above, log2_of_size(of.M / (of.C + Deep(2) * of.K)) - around, log2_of_size(last));
}

// π less the first zero of the torque backwards, where K counts the other way.
Deep second_zero(const HalfTurn& of) {
  const Deep cosine = cosine_at_greatest(of), last = geometry::arc_tangent(root(Deep(1) - square(cosine)), -cosine);
  const auto above = [&](const Deep& x) {
    const Deep sine = sine_of_angle(x);
    return sine * (of.C - Deep(2) * of.K * cosine_of_angle(x)) - of.M;
  };
  return pi<Deep>() -
         increasing_root(above, log2_of_size(of.M / (of.C + Deep(2) * of.K)) - around, log2_of_size(last));
}

Deep energy(const HalfTurn& of, const Deep& to) {
  const Deep half_sine = sine_of_angle(to / Deep(2));
  return of.M * to - Deep(2) * of.C * square(half_sine) - of.K * square(sine_of_angle(to));
}

// Over the cosine x the slope is the parabola C x + 2 K (2 x² - 1), steepest at an end of the strip or at its vertex,
// as far as that lies in the strip.
Deep chords_off_at_most(const HalfTurn& of, const std::vector<Deep>& ends) {
  const auto slope = [&](const Deep& x) {
    return absolute(of.C * x + Deep(2) * of.K * (Deep(2) * square(x) - Deep(1)));
  };
  Deep most(0);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Deep first = cosine_of_angle(ends[i - 1]), last = cosine_of_angle(ends[i]);
    Deep steepest = greater(slope(first), slope(last));
    if (sign(of.K) != Sign::zero) steepest = greater(steepest, slope(within(last, -of.C / (Deep(8) * of.K), first)));
    most = greater(most, square(ends[i] - ends[i - 1]) / Deep(8) * steepest);
  }
  return most;
}

}  // namespace closed

namespace summed {
namespace {

// 2 C t (1 + t²) + 4 K t (1 - t²) - M (1 + t²)², t = tan(α/2): grows from below zero to above it.
Deep zero_by_half_angle(const HalfTurn& of, const Deep& K, const Deep& cosine) {
  const Deep last = root((Deep(1) - cosine) / (Deep(1) + cosine));
  const auto above = [&](const Deep& t) {
    const Deep t2 = t * t, both = Deep(1) + t2;
    return Deep(2) * t * (of.C * both + Deep(2) * K * (Deep(1) - t2)) - of.M * square(both);
  };
  const double first = log2_of_size(of.M / (of.C + Deep(2) * of.K)) - 1;
  return Deep(2) * geometry::arc_tangent(increasing_root(above, first - around, log2_of_size(last)), Deep(1));
}

}  // namespace

Deep first_zero(const HalfTurn& of) { return zero_by_half_angle(of, of.K, cosine_at_greatest(of)); }
Deep second_zero(const HalfTurn& of) { return pi<Deep>() - zero_by_half_angle(of, -of.K, -cosine_at_greatest(of)); }

Deep energy(const HalfTurn& of, const Deep& from, const Deep& to) {
  return geometry::analytic::integral(
      [&](acb_ptr result, acb_srcptr x, bool, long bits) {
        ComplexBall sine, cosine;
        acb_sin_cos(sine.value, cosine.value, x, bits);
        acb_mul_arb(cosine.value, cosine.value, of.K.ball(), bits);
        acb_mul_2exp_si(cosine.value, cosine.value, 1);
        acb_add_arb(cosine.value, cosine.value, of.C.ball(), bits);
        acb_mul(result, sine.value, cosine.value, bits);
        acb_neg(result, result);
        acb_add_arb(result, result, of.M.ball(), bits);
      },
      from, to);
}

// C cos α is C less what C sin α has taken, by the energy; 2 K cos 2α is 2 K - 4 K sin² α.
Deep slope_by_energy(const HalfTurn& of, const Deep& angle) {
  return of.C + energy(of, Deep(0), angle) - of.M * angle + of.K * (Deep(2) - Deep(3) * square(sine_of_angle(angle)));
}

// As much at most as the chord of a parabola is off that bends by the steepest slope throughout: in the strip's
// middle. Where the slope turns, 4 K (x - x_0)² of the cosine x vanishes, and of 4 K ((x - x_0)² - x_0²) - 2 K the
// rest is left.
Deep chords_off_at_most(const HalfTurn& of, const std::vector<Deep>& ends) {
  Deep most(0);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Deep &begin = ends[i - 1], &end = ends[i];
    Deep bend = greater(absolute(slope_by_energy(of, begin)), absolute(slope_by_energy(of, end)));
    if (sign(of.K) != Sign::zero) {
      const Deep x_0 = -of.C / (Deep(8) * of.K);
      const Deep x = within(cosine_of_angle(end), x_0, cosine_of_angle(begin));
      bend = greater(bend, absolute(Deep(4) * of.K * (square(x - x_0) - square(x_0)) - Deep(2) * of.K));
    }
    const auto parabola = [&](const Deep& angle) { return bend * square(angle) / Deep(2); };
    const Deep off = (parabola(begin) + parabola(end)) / Deep(2) - parabola((begin + end) / Deep(2));
    most = greater(most, off);
  }
  return most;
}

Deep sine_times_cosine(int k) {
  return geometry::analytic::integral(
      [k](acb_ptr result, acb_srcptr x, bool, long bits) {
        ComplexBall multiple;
        acb_mul_si(multiple.value, x, k, bits);
        acb_cos(multiple.value, multiple.value, bits);
        acb_sin(result, x, bits);
        acb_mul(result, result, multiple.value, bits);
      },
      Deep(0), pi<Deep>());
}

Deep sine_squared() {
  return geometry::analytic::integral(
      [](acb_ptr result, acb_srcptr x, bool, long bits) {
        acb_sin(result, x, bits);
        acb_sqr(result, result, bits);
      },
      Deep(0), pi<Deep>());
}

}  // namespace summed
}  // namespace epure::pump_flywheel
