// The power series. In the disc |τ| <= ρ of complex time about any instant, |v| <= w, w' = A + |B| w² <= |B| (w + a)²
// with a >= √(A/|B|), so |v| <= (v_k + a)/(1 - |B| (v_k + a) ρ): with three quarters for the product, |v| <= L =
// 4 (v_k + a). Then coefficient n of v is at most L/ρ^n (Cauchy), and likewise of what is made of v. A piece of time
// is at most a fourth of ρ long, so n terms leave out less than 4^{1-n}/3 of the bound.
#include <cmath>
#include <vector>

#include "geometry/analytic/spin_up.h"
#include "geometry/numbers/ball.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/greater.h"
#include "geometry/numbers/increasing_root.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {
namespace {

using Coefficients = std::vector<Deep>;
Deep parameter(const Rational& q) { return from_rational<Deep>(q); }

// Coefficient n of the product. (Numbers of a vector lie side by side, as Arb wants them.)
static_assert(sizeof(Deep) == sizeof(arb_struct));
Deep product_at(const Coefficients& a, const Coefficients& b, std::size_t n) {
  Ball sum;
  arb_dot(sum.value, nullptr, 0, a[0].ball(), 1, b[n].ball(), -1, static_cast<slong>(n) + 1,
          Arithmetic<Deep>::bits());
  return Deep::from_ball(sum.value);
}
Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients all;
  for (std::size_t n = 0; n < a.size(); ++n) all.push_back(product_at(a, b, n));
  return all;
}

// A function by its terms, with what may be missing of it anywhere in the piece.
struct Series {
  Coefficients terms;
  Deep left_out;

  Deep at(const Deep& tau) const {
    Deep sum(0);
    for (auto term = terms.rbegin(); term != terms.rend(); ++term) sum = sum * tau + *term;
    return widened(sum, left_out);
  }
  Deep integral(const Deep& tau) const {
    Deep sum(0);
    for (std::size_t n = terms.size(); n-- > 0;) sum = sum * tau + terms[n] / Deep(static_cast<int>(n) + 1);
    return widened(sum * tau, left_out * tau);
  }
};

class Piece {
 public:
  Piece(const SpinUp& of, const SpinState& begin) : of_(of), begin_(begin) {
    const double v = enclosure(begin.v).upper;
    const Deep A = parameter(of.A), B = parameter(CGAL::abs(of.B));
    const Deep beyond = Deep::from_double(of.B == 0 ? v : v + std::sqrt(enclosure(A / B).upper) * (1 + 1e-12));
    const Deep rho = of.B == 0 ? Deep(4) * beyond / A : Deep(3) / (Deep(4) * B * beyond);
    const Deep L = Deep(of.B == 0 ? 5 : 4) * beyond;
    // Not far beyond where the load stands still: it slows down at least as much as now, or as in the end.
    const Deep least = of.B < 0 ? A - B * square(begin.v) : A;
    length_ = midpoint(rho / Deep(4));
    if (const Deep until_rest = midpoint(begin.v / least); sign(length_ - until_rest) == Sign::positive)
      length_ = until_rest;
    expand(L, rho);
  }

  const Deep& length() const { return length_; }

  SpinState at(const Deep& tau) const {
    SpinState now = begin_;
    now.t += tau;
    now.v = v_.at(tau);
    now.omega = omega_.at(tau);
    now.path += v_.integral(tau);
    now.angle += omega_.integral(tau);
    now.cubes += cubes_.integral(tau);
    now.of_wheel += of_wheel_.integral(tau);
    now.of_load += of_load_.integral(tau);
    return now;
  }
  // v - R ω, negated.
  Deep behind(const Deep& tau) const { return parameter(of_.R) * omega_.at(tau) - v_.at(tau); }

 private:
  void expand(const Deep& L, const Deep& rho) {
    const Deep A = parameter(of_.A), B = parameter(of_.B), C = parameter(of_.C), D = parameter(of_.D);
    const auto count = static_cast<std::size_t>(Arithmetic<Deep>::bits() / 2 + 8);
    Coefficients v{begin_.v}, squares, growth, omega{begin_.omega};
    for (std::size_t n = 0; n < count; ++n) {
      squares.push_back(product_at(v, v, n));
      growth.push_back(n == 0 ? C + D * squares[n] : D * squares[n]);
      if (n + 1 == count) break;
      const Deep next(static_cast<int>(n) + 1);
      v.push_back(-(n == 0 ? A + B * squares[n] : B * squares[n]) / next);
      omega.push_back(growth[n] / next);
    }
    Deep share(1);  // of the bound, that the terms leave out
    for (std::size_t n = 1; n < count; ++n) share = share / Deep(4);
    const Deep most_growth = C + absolute(D) * square(L), most_omega = absolute(begin_.omega) + rho * most_growth;
    of_wheel_ = {product(growth, omega), share * most_growth * most_omega};
    of_load_ = {product(growth, v), share * most_growth * L};
    cubes_ = {product(squares, v), share * square(L) * L};
    v_ = {std::move(v), share * L};
    omega_ = {std::move(omega), share * most_omega};
  }

  const SpinUp& of_;
  SpinState begin_;
  Deep length_;
  Series v_, omega_, cubes_, of_wheel_, of_load_;
};

SpinState begin_of(const SpinUp& of) {
  SpinState state;
  state.v = parameter(of.v_0);
  state.omega = parameter(of.omega_0);
  return state;
}

constexpr int most_pieces = 300;
[[noreturn]] void refuse() {
  throw Undecided("a power series in more pieces than are worth it",
                  "una serie di potenze in più tratti di quanti convenga");
}

}  // namespace

SpinState spun_up_by_series(const SpinUp& of, const Deep& t) { return spun_up_by_series(of, begin_of(of), t); }

SpinState spun_up_by_series(const SpinUp& of, const SpinState& from, const Deep& t) {
  SpinState now = from;
  for (int piece = 0; piece < most_pieces; ++piece) {
    const Piece here(of, now);
    const Deep rest = t - now.t;
    if (sign(here.length() - rest) == Sign::positive) return here.at(rest);
    now = here.at(here.length());
  }
  refuse();
}

SpinState end_of_slip_by_series(const SpinUp& of) {
  SpinState now = begin_of(of);
  for (int piece = 0; piece < most_pieces; ++piece) {
    const Piece here(of, now);
    switch (sign(here.behind(here.length()))) {
      case Sign::positive: {
        const auto behind = [&](const Deep& tau) { return here.behind(tau); };
        const double last = std::log2(enclosure(here.length()).value);
        // As soon as the greatest rate at which v - R ω falls in the piece allows.
        const Deep slip = now.v - parameter(of.R) * now.omega,
                   rate =
                       parameter(of.A) + parameter(of.R * of.C) +
                       (parameter(CGAL::abs(of.B)) + parameter(of.R * CGAL::abs(of.D))) * square(parameter(of.v_0));
        if (sign(slip) != Sign::positive)
          throw Undecided("whether slip lasts at all", "se ci sia dello strisciamento");
        const double first = std::log2(enclosure(slip / rate).lower);
        return here.at(increasing_root(behind, first - 1, last));
      }
      case Sign::undecided:
        throw Undecided("whether slip ends where two pieces of a series meet",
                        "se lo strisciamento finisca dove due tratti di una serie si incontrano");
      default:
        now = here.at(here.length());
    }
  }
  refuse();
}

}  // namespace epure::geometry::analytic
