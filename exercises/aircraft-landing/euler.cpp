#include "exercises/aircraft-landing/euler.h"

#include <algorithm>
#include <string>

#include "geometry/numbers/numbers.h"

namespace epure::aircraft_landing {
namespace {

using geometry::Sign;

constexpr int most_steps = 20000;

template <class T>
T scalar(const Rational& q) {
  return geometry::from_rational<T>(q);
}
template <>
Rational scalar<Rational>(const Rational& q) {
  return q;
}

template <class T>
struct Stepwise {
  T h, A, B, C, D, v, omega;
  Stepwise(const SpinUp& of, const Rational& step)
      : h(scalar<T>(step)),
        A(scalar<T>(of.A)),
        B(scalar<T>(of.B)),
        C(scalar<T>(of.C)),
        D(scalar<T>(of.D)),
        v(scalar<T>(of.v_0)),
        omega(scalar<T>(of.omega_0)) {}
  void advance() {
    const T square = v * v;
    v = v - h * (A + B * square);
    omega = omega + h * (C + D * square);
  }
};

// With y = 1/2 - h B v the scheme is y ← y² + c, c = 1/4 + h² A B. And v falls by h (k A + B Σv²), from which the sum
// follows, and with it ω. Where B = 0, v falls evenly and Σv² is that of an arithmetic progression.
struct AsMap {
  SpinUp of;
  Rational step;
  int k = 0;
  Deep y, c, v, omega;

  AsMap(const SpinUp& law, const Rational& h)
      : of(law),
        step(h),
        y(scalar<Deep>(Rational(1, 2) - h * law.B * law.v_0)),
        c(scalar<Deep>(Rational(1, 4) + h * h * law.A * law.B)),
        v(scalar<Deep>(law.v_0)),
        omega(scalar<Deep>(law.omega_0)) {}
  void advance() {
    ++k;
    Deep squares;
    if (of.B == 0) {
      const Rational n(k), down = step * of.A;
      v = scalar<Deep>(of.v_0 - n * down);
      squares = scalar<Deep>(n * of.v_0 * of.v_0 - of.v_0 * down * n * (n - 1) +
                             down * down * (n - 1) * n * (Rational(2) * n - 1) / 6);
    } else {
      y = y * y + c;
      v = (scalar<Deep>(Rational(1, 2)) - y) / scalar<Deep>(step * of.B);
      squares = ((scalar<Deep>(of.v_0) - v) / scalar<Deep>(step) - scalar<Deep>(of.A * k)) / scalar<Deep>(of.B);
    }
    const Deep gained = scalar<Deep>(step) * (scalar<Deep>(of.C * k) + scalar<Deep>(of.D) * squares);
    omega = scalar<Deep>(of.omega_0) + gained;
  }
};

// By fractions, whose digits double with each step unless B = 0.
Sign exactly(const SpinUp& of, const Rational& step, int k) {
  constexpr int few = 8;
  if (of.B != 0 && k > few) return Sign::undecided;
  Stepwise<Rational> run(of, step);
  for (int i = 0; i < k; ++i) run.advance();
  return static_cast<Sign>(static_cast<int>(CGAL::sign(run.v - of.R * run.omega)));
}

// v - R ω > 0 after step k?
template <class Run>
bool slips(const SpinUp& of, const Rational& step, int k, const Run& run) {
  Sign found = geometry::sign(run.v - scalar<Deep>(of.R) * run.omega);
  if (found == Sign::undecided) found = exactly(of, step, k);
  if (found == Sign::undecided)
    throw geometry::Undecided("whether slip ends with a step of Euler's",
                              "se lo strisciamento finisca con un passo di Eulero");
  return found == Sign::positive;
}

[[noreturn]] void refuse_so_many() {
  throw geometry::Impossible("the scheme takes more than 20000 steps, and is not carried out",
                             "lo schema richiede più di 20000 passi e non viene svolto");
}

template <class Run>
EulerState run_to(Run run, const SpinUp& of, const Rational& step, int k) {
  for (int i = 1; i <= k; ++i) {
    run.advance();
    if (i < k && !slips(of, step, i, run)) {
      const std::string n = std::to_string(i);
      throw geometry::Impossible("slip has ended before, with step " + n,
                                 "lo strisciamento è finito prima, con il passo " + n);
    }
  }
  return {run.v, run.omega};
}

template <class Run>
EulerEnd run_to_end(Run run, const SpinUp& of, const Rational& step) {
  // No step takes more off the slip than at the faster of its two ends.
  const Rational at_rest = of.A + of.R * of.C, at_first = at_rest + (of.B + of.R * of.D) * of.v_0 * of.v_0,
                 at_most = step * std::max(at_rest, at_first);
  if (of.v_0 - of.R * of.omega_0 > at_most * most_steps) refuse_so_many();
  const Deep R = scalar<Deep>(of.R), h = scalar<Deep>(step);
  Deep before = run.v - R * run.omega;
  for (int k = 1; k <= most_steps; ++k) {
    run.advance();
    const Deep now = run.v - R * run.omega;
    if (!slips(of, step, k, run)) return {k, h * (Deep(k - 1) + before / (before - now))};
    before = now;
  }
  refuse_so_many();
}

}  // namespace

EulerState after_steps(const SpinUp& of, const Rational& step, int k, Arrangement how) {
  return how == Arrangement::stepwise ? run_to(Stepwise<Deep>(of, step), of, step, k)
                                      : run_to(AsMap(of, step), of, step, k);
}

EulerEnd end_of_slip(const SpinUp& of, const Rational& step, Arrangement how) {
  return how == Arrangement::stepwise ? run_to_end(Stepwise<Deep>(of, step), of, step)
                                      : run_to_end(AsMap(of, step), of, step);
}

bool stops_at_once(const SpinUp& of, const Rational& step) {
  Stepwise<Rational> run(of, step);
  run.advance();
  return run.v == 0;
}

}  // namespace epure::aircraft_landing
