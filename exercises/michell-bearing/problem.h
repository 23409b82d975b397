// What is given of the Michell bearing: a film whose walls are known (inverse problem), and a pad whose load and
// pivot are (direct problem). Metres, seconds, newtons; forces of the film are those of a unit of width.
#pragma once

#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/reynolds.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure::michell_bearing {

std::vector<GivenSpec> given_specs();

struct Film {
  Rational l, V, h_1, h_2, mu;
  Rational dx, x_1, x_3;
  long strips;  // of dx, in l

  template <class T>
  geometry::FilmWedge<T> wedge() const {
    const auto number = geometry::from_rational<T>;
    return {number(l), number(V), number(mu), number(h_1), number(h_2)};
  }
  template <class T>
  geometry::analytic::ReynoldsFilm<T> reynolds() const {
    const auto number = geometry::from_rational<T>;
    return {number(l), number(V), number(mu), number((h_1 + h_2) / 2),
            geometry::analytic::FilmByQuadrature<T>(number((h_1 - h_2) / (h_1 + h_2)))};
  }
  Rational n() const { return h_1 / h_2; }
  Rational h(const Rational& x) const { return h_1 - (h_1 - h_2) * x / l; }
  // Then the shear is zero somewhere on each wall, and beyond it the film runs back at the inlet.
  bool has_zero_shear() const { return h_1 >= Rational(2) * h_2; }
};

struct Pad {
  Rational P, pads, r_m, l, b, x_N, mu, h_ref;
  Angle speed;

  Rational centre() const { return x_N / l; }
};

struct Problem {
  Film film;
  Pad pad;
  // Throws BadGivens: a film that does not narrow, a grid that does not fit, sections off the pad, a pivot where no
  // flat pad can have it, pads that overlap.
  explicit Problem(const Givens& givens);
};

}  // namespace epure::michell_bearing
