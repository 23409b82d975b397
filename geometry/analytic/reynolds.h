// Reynolds' equation for a film between flat walls, integrated by quadrature with proved bounds. No closed form of an
// integral is used; in a steep wedge the quadrature runs over the logarithm of the film.
//
//   x = l (1 + t)/2, t from -1 (inlet) to 1 (outlet)      h = h_m (1 - ε t), h_m = (h1 + h2)/2, ε = (h1 - h2)/(h1 +
//   h2) (h³ p')' = 6 μ V h'   gives   p' = 6 μ V (h - h̄)/h³ with h̄ so that p is zero at both ends:
// with the weights w = (1 - ε t)⁻³ is h̄ the film at their centroid t̄, and
//   p = (3 μ V l ε/h_m²) P(t), P = integral of (t̄ - s) w(s) ds from -1 to t
//   N = (3/2) ε (μ V l²/h_m²) Q, Q the moment of inertia of the weights about t̄     (by parts)
// so nothing cancels where the walls are nearly parallel.
#pragma once

#include <array>
#include <optional>

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// The integral of t^k (1 - ε t)^-b from -1 to `to`, 0 <= ε < 1, -1 <= to <= 1. By Arb's integration: with as many
// bits as are open, less those that are lost.
Deep film_integral(int k, int b, const Deep& epsilon, const Deep& to);
Bounded film_integral(int k, int b, const Bounded& epsilon, const Bounded& to);
Fast film_integral(int k, int b, Fast epsilon, Fast to);
template <class T>
requires(!NumberWithAngles<T>) T film_integral(int, int, const T&, const T&) {
  throw Undecided("an integral of which only bounds are known", "un integrale di cui si conoscono solo dei limiti");
}

template <class T>
class FilmByQuadrature {
 public:
  explicit FilmByQuadrature(T epsilon) : epsilon_(std::move(epsilon)) {}

  const T& epsilon() const { return epsilon_; }
  T ratio() const { return quotient(T(1) + epsilon_, T(1) - epsilon_); }            // n = h1/h2
  T centroid() const { return quotient(moment(1), moment(0)); }                     // t̄
  T inertia() const { return moment(2) - quotient(square(moment(1)), moment(0)); }  // Q
  // Of the pressures, from the middle, in half lengths.
  T centre() const { return quotient(moment(3) - quotient(moment(2) * moment(1), moment(0)), T(2) * inertia()); }
  // P up to t.
  T pressure(const T& t) const {
    return centroid() * film_integral(0, 3, epsilon_, t) - film_integral(1, 3, epsilon_, t);
  }
  // T h_m/(μ V l) on a wall: the mean of  1/(1 - ε t) ± 3 ε (t̄ - t)/(1 - ε t)².
  T drag_on_moving() const { return drag(1); }
  T drag_on_fixed() const { return drag(-1); }
  // What becomes heat, times h_m/(μ V² l): the mean of  1/(1 - ε t) + 3 ε² (t̄ - t)²/(1 - ε t)³.
  T dissipated() const { return half() * (couette() + T(3) * square(epsilon_) * inertia()); }

  // A, k of a load N = A μ V l²/h2² and a friction T/N = k √(μ V/N).
  T load() const { return from_rational<T>(Rational(3, 2)) * epsilon_ * square(T(1) - epsilon_) * inertia(); }

 private:
  static T half() { return from_rational<T>(Rational(1, 2)); }
  T whole(int k, int b) const { return film_integral(k, b, epsilon_, T(1)); }
  T moment(int k) const {
    auto& kept = moments_[static_cast<std::size_t>(k)];
    if (!kept) kept = whole(k, 3);
    return *kept;
  }
  T couette() const {
    if (!couette_) couette_ = whole(0, 1);
    return *couette_;
  }
  T drag(int side) const {
    return half() * (couette() + T(3 * side) * epsilon_ * (centroid() * whole(0, 2) - whole(1, 2)));
  }

  T epsilon_;
  mutable std::array<std::optional<T>, 4> moments_;
  mutable std::optional<T> couette_;
};

// The film itself: length, speed, viscosity, mean film.
template <class T>
struct ReynoldsFilm {
  T l, V, mu, h_m;
  FilmByQuadrature<T> by_t;

  const T& epsilon() const { return by_t.epsilon(); }
  T centroid() const { return by_t.centroid(); }
  T t_of(const T& x) const { return quotient(T(2) * x, l) - T(1); }
  T x_of(const T& t) const { return quotient(l * (T(1) + t), T(2)); }
  T share(const T& t) const { return T(1) - epsilon() * t; }  // h/h_m
  T h(const T& x) const { return h_m * share(t_of(x)); }
  T pressure_unit() const { return quotient(T(3) * mu * V * l * epsilon(), square(h_m)); }
  T gradient(const T& x) const {
    const T t = t_of(x), film = share(t);
    return quotient(T(2) * pressure_unit() * (centroid() - t), l * square(film) * film);
  }
  T pressure(const T& x) const { return pressure_unit() * by_t.pressure(t_of(x)); }
  T greatest_pressure() const { return pressure_unit() * by_t.pressure(centroid()); }
  T velocity(const T& x, const T& z) const {
    const T part = quotient(z, h(x));
    return V * part * (T(1) - bulge(x) * (T(1) - part));
  }
  T shear_on_fixed(const T& x) const { return quotient(mu * V, h(x)) * (T(1) - bulge(x)); }
  T shear_on_moving(const T& x) const { return quotient(mu * V, h(x)) * (T(1) + bulge(x)); }

 private:
  // Poiseuille's share of the slope at the walls: 3 ε (t̄ - t)/(1 - ε t).
  T bulge(const T& x) const {
    const T t = t_of(x);
    return quotient(T(3) * epsilon() * (centroid() - t), share(t));
  }
};

// The mean film under a load N.
template <class T>
T film_of_load(const FilmByQuadrature<T>& by_t, const T& l, const T& V, const T& mu, const T& N) {
  return l * root(quotient(from_rational<T>(Rational(3, 2)) * by_t.epsilon() * by_t.inertia() * mu * V, N));
}

// ε with the centre of pressure at `centre` of the length, 1/2 < centre < 1 (the caller's promise): it grows with ε.
template <class T>
T wedge_of_centre(const Rational&) {
  throw Undecided("the zero of a function of integrals", "lo zero di una funzione di integrali");
}
template <>
Fast wedge_of_centre<Fast>(const Rational& centre);
template <>
Bounded wedge_of_centre<Bounded>(const Rational& centre);
template <>
Deep wedge_of_centre<Deep>(const Rational& centre);

}  // namespace epure::geometry::analytic
