// The film under a flat slider of infinite width, in closed form (Reynolds, Michell). x runs from the inlet, where
// the film is h1, to the outlet, where it is h2 < h1; the inclined wall, the pad, rests, and the flat one runs
// towards +x at V (if it ran instead, the film would be drawn apart and bear nothing); z is counted from the pad. The
// pressure is zero at both ends; all forces are those of a unit of width. n = h1/h2.
#pragma once

#include "geometry/lubrication/logarithms.h"

namespace epure::geometry {

// What depends on n alone, n > 1:
//   N = load μ V l²/h2²     T = drag μ V l/h2     x_N = centre l     T/N = friction √(μ V/N)
template <class T>
struct FlatSlider {
  T n;

  T load() const {  // A
    return quotient(T(6) * logarithms(Logarithms::load, n), (n + T(1)) * square(n - T(1)));
  }
  T centre() const { return half() + centre_beyond_middle(); }
  // (x_N - l/2)/l
  T centre_beyond_middle() const {
    return quotient(logarithms(Logarithms::couple, n), T(2) * (n - T(1)) * logarithms(Logarithms::load, n));
  }
  T drag() const {  // on the wall that moves
    return quotient(T(2) * logarithms(Logarithms::drag, n), (n + T(1)) * (n - T(1)));
  }
  T drag_on_fixed() const {
    return quotient(T(6), n + T(1)) - quotient(T(2) * logarithms(Logarithms::plain, n), n - T(1));
  }
  T friction() const { return quotient(drag(), root(load())); }  // k

 private:
  static T half() { return from_rational<T>(Rational(1, 2)); }
};

// The film itself.
template <class T>
struct FilmWedge {
  T l, V, mu, h1, h2;

  T h(const T& x) const { return h1 - quotient((h1 - h2) * x, l); }
  T x_of(const T& h) const { return quotient(l * (h1 - h), h1 - h2); }
  T h_bar() const { return quotient(T(2) * h1 * h2, h1 + h2); }  // where the pressure is greatest
  T gradient(const T& x) const {
    const T film = h(x);
    return quotient(T(6) * mu * V * (film - h_bar()), square(film) * film);
  }
  T pressure(const T& x) const {
    return quotient(T(6) * mu * V * (h1 - h2) * x * (l - x), l * (h1 + h2) * square(h(x)));
  }
  T x_bar() const { return quotient(l * h1, h1 + h2); }
  T flow() const { return quotient(V * h1 * h2, h1 + h2); }
  // Couette's and Poiseuille's parts added.
  T velocity(const T& x, const T& z) const {
    const T film = h(x);
    return quotient(V * z, film) - quotient(gradient(x) * (film - z) * z, T(2) * mu);
  }
  // μ du/dz at the walls.
  T shear_on_fixed(const T& x) const { return shear(x, -1); }
  T shear_on_moving(const T& x) const { return shear(x, 1); }

 private:
  T shear(const T& x, int side) const {
    const T film = h(x);
    return quotient(mu * V, film) + T(side) * quotient(film * gradient(x), T(2));
  }
};

// n > 1 with its centre of pressure at `centre` of the length, 1/2 < centre < 1 (the caller's promise). There is one:
// p is x (l - x)/h² times a constant, so of two films the one with the greater n has the share of its pressures
// shifted towards the outlet everywhere (their ratio grows with x), and its centre lies farther.
template <class T>
T ratio_of_films(const Rational&) {
  throw Undecided("the zero of a function of logarithms", "lo zero di una funzione di logaritmi");
}
template <>
Fast ratio_of_films<Fast>(const Rational& centre);
template <>
Bounded ratio_of_films<Bounded>(const Rational& centre);
template <>
Deep ratio_of_films<Deep>(const Rational& centre);

}  // namespace epure::geometry
