#include "geometry/analytic/oscillation_by_matrix.h"

#include "geometry/analytic/integral.h"
#include "geometry/numbers/ball.h"

namespace epure::geometry::analytic {
namespace {

struct Matrix {
  arb_mat_t value;
  Matrix() { arb_mat_init(value, 2, 2); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { arb_mat_clear(value); }

  void set(int row, int column, const Deep& to) { arb_set(arb_mat_entry(value, row, column), to.ball()); }
  Deep at(int row, int column) const { return Deep::from_ball(arb_mat_entry(value, row, column)); }
};

// The integral of du/(1 + 2 sign ζ u + u²).
Deep along_the_path(const Rational& zeta, int side, const Deep& from, const Deep& to) {
  const Deep twice = from_rational<Deep>(Rational(2 * side) * zeta);
  return integral(
      [&](acb_ptr result, const acb_t u, bool, long bits) {
        ComplexBall sum;
        acb_add_arb(sum.value, u, twice.ball(), bits);
        acb_mul(sum.value, sum.value, u, bits);
        acb_add_si(sum.value, sum.value, 1, bits);
        acb_inv(result, sum.value, bits);
      },
      from, to);
}

}  // namespace

Deep OscillationByMatrix::entry(const Deep& t, int row, int column) const {
  const Deep tau = radians<Deep>(omega_) * t;
  Matrix A;
  A.set(0, 1, tau);
  A.set(1, 0, -tau);
  A.set(1, 1, from_rational<Deep>(Rational(-2) * zeta_) * tau);
  arb_mat_exp(A.value, A.value, Arithmetic<Deep>::bits());
  return A.at(row, column);
}

// From u = 0 to 1, and from p = 1 to 0: the same integral.
Deep OscillationByMatrix::time_of_extreme() const {
  return Deep(2) * along_the_path(zeta_, 1, Deep(0), Deep(1)) / radians<Deep>(omega_);
}
// From p = 0 on to -1/(2ζ); where that is beyond -1, the rest by u.
Deep OscillationByMatrix::time_of_inflection() const {
  const Rational twice = Rational(2) * zeta_;
  const Deep beyond = twice >= 1 ? along_the_path(zeta_, -1, Deep(0), from_rational<Deep>(Rational(1) / twice))
                                 : along_the_path(zeta_, -1, Deep(0), Deep(1)) +
                                       along_the_path(zeta_, -1, from_rational<Deep>(twice), Deep(1));
  return time_of_extreme() + beyond / radians<Deep>(omega_);
}

StepsOfEuler steps_of_euler(const Rational& zeta, const Angle& step, long n) {
  const Deep h = radians<Deep>(step);
  Matrix one;
  one.set(0, 0, Deep(1));
  one.set(0, 1, h);
  one.set(1, 0, -h);
  one.set(1, 1, Deep(1) - from_rational<Deep>(Rational(2) * zeta) * h);
  arb_mat_pow_ui(one.value, one.value, static_cast<ulong>(n), Arithmetic<Deep>::bits());
  return {one.at(0, 1), one.at(1, 1)};
}

}  // namespace epure::geometry::analytic
