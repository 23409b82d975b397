#include "geometry/analytic/reynolds.h"

#include <algorithm>
#include <cmath>

#include "geometry/analytic/integral.h"
#include "geometry/numbers/ball.h"
#include "geometry/numbers/growing.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::geometry::analytic {
namespace {

// t_N by doubles, with Gauss' five points on panels that halve towards the outlet: 1 - ε t = (2 + d (1 - t))/(2 + d).
double centre_in_doubles(double d) {
  constexpr std::array<double, 5> node{-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                       0.90617984593866399},
      weight{0.23692688505618909, 0.47862867049936647, 0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
  std::array<double, 4> moments{};
  constexpr int panels_to_half = 4;  // of them in every halving
  const double innermost = 0.1 / (1 + d);
  for (double right = 2; right > innermost; right /= 2) {
    const double left = right / 2 > innermost ? right / 2 : 0, half = (right - left) / (2 * panels_to_half);
    for (int panel = 0; panel < panels_to_half; ++panel)
      for (std::size_t i = 0; i < node.size(); ++i) {
        const double to_outlet = left + half * (2 * panel + 1 + node[i]), t = 1 - to_outlet;
        double term = weight[i] * half * std::pow(2 + d * to_outlet, -3);
        for (double& moment : moments) moment += term, term *= t;
      }
  }
  const double centroid = moments[1] / moments[0];
  return (moments[3] - moments[2] * centroid) / (2 * (moments[2] - moments[1] * centroid));
}

// The d of which t_N is as sought lies between these powers of two, or beside them by a little. t_N ≈ d/5 where it is
// small, too small for doubles; where it is large, 1 - t_N ≈ 1/ln d.
struct SearchedIn {
  double low, high;
};
SearchedIn searched_in(double sought) {
  SearchedIn within{std::log2(sought) - 2, 8 + 3 / (1 - sought)};
  if (sought < 1e-4) return {within.low, within.low + 8};
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (within.low + within.high) / 2;
    (centre_in_doubles(std::exp2(middle)) < sought ? within.low : within.high) = middle;
  }
  constexpr double as_near_as_doubles_tell = 1e-11;
  return {within.low - as_near_as_doubles_tell, within.high + as_near_as_doubles_tell};
}

Deep logarithm(const Deep& x) {
  Ball result;
  arb_log(result.value, x.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}

// With s = ln(1 - ε t): t = (1 - e^s)/ε, dt = -e^s ds/ε. The integrand has no pole any more, so a steep wedge costs a
// few panels and not some for each halving of the film.
Deep by_logarithm_of_film(int k, int b, const Deep& epsilon, const Deep& to) {
  return integral(
             [&](acb_ptr result, const acb_t s, bool, long bits) {
               ComplexBall film, t;
               acb_exp(film.value, s, bits);
               acb_sub_si(t.value, film.value, 1, bits);
               acb_neg(t.value, t.value);
               acb_div_arb(t.value, t.value, epsilon.ball(), bits);
               acb_pow_ui(t.value, t.value, static_cast<ulong>(k), bits);
               acb_pow_si(film.value, film.value, 1 - b, bits);
               acb_mul(result, t.value, film.value, bits);
             },
             logarithm(Deep(1) - epsilon * to), logarithm(Deep(1) + epsilon)) /
         epsilon;
}

// The integrand is infinite around the pole at 1/ε, from where the quadrature then stays away.
Deep by_place(int k, int b, const Deep& epsilon, const Deep& to) {
  return integral(
      [&](acb_ptr result, const acb_t t, bool, long bits) {
        ComplexBall film;
        acb_mul_arb(film.value, t, epsilon.ball(), bits);
        acb_sub_si(film.value, film.value, 1, bits);
        acb_neg(film.value, film.value);
        acb_pow_ui(film.value, film.value, static_cast<ulong>(b), bits);
        acb_pow_ui(result, t, static_cast<ulong>(k), bits);
        acb_div(result, result, film.value, bits);
      },
      Deep(-1), to);
}

}  // namespace

// Of both forms the one that costs less: where ε is small the first one would cancel, where it is nearly 1 the other
// one is slow. Either holds for every ε, so that an undecided sign decides nothing wrong.
Deep film_integral(int k, int b, const Deep& epsilon, const Deep& to) {
  const bool is_steep = sign(Deep(2) * epsilon - Deep(1)) == Sign::positive;
  return is_steep ? by_logarithm_of_film(k, b, epsilon, to) : by_place(k, b, epsilon, to);
}

Bounded film_integral(int k, int b, const Bounded& epsilon, const Bounded& to) {
  return in_doubles([&] { return film_integral(k, b, ball(epsilon), ball(to)); });
}

Fast film_integral(int k, int b, Fast epsilon, Fast to) {
  const Arithmetic<Deep> scope(64);
  return enclosure(film_integral(k, b, Deep::from_double(epsilon), Deep::from_double(to))).value;
}

// ε = d/(2 + d) is sought by d, which may be as small or as large as it likes.
template <>
Deep wedge_of_centre<Deep>(const Rational& centre) {
  const Rational sought_rational = Rational(2) * centre - Rational(1);
  const SearchedIn within = searched_in(CGAL::to_double(sought_rational));
  const long bits = Arithmetic<Deep>::bits(), lost = static_cast<long>(std::abs(within.low) + std::abs(within.high));
  const Arithmetic<Deep> more(bits + 32 + lost);
  const Deep sought = from_rational<Deep>(sought_rational);
  const auto wedge = [](const Deep& d) { return quotient(d, Deep(2) + d); };
  return wedge(increasing_root([&](const Deep& d) { return FilmByQuadrature<Deep>(wedge(d)).centre() - sought; },
                               within.low, within.high));
}

template <>
Bounded wedge_of_centre<Bounded>(const Rational& centre) {
  return in_doubles([&] { return wedge_of_centre<Deep>(centre); });
}

template <>
Fast wedge_of_centre<Fast>(const Rational& centre) {
  const Arithmetic<Deep> scope(64);
  return enclosure(wedge_of_centre<Deep>(centre)).value;
}

}  // namespace epure::geometry::analytic
