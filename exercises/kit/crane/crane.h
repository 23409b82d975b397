// The boat crane of Pisa's exercises 2 and 3: a beam B-C-D, hinged at B, on a column under C, with the boat at D.
// What is given of it, and when that is impossible.
//
// Metres, newtons, pascals, kilograms. ξ runs along the beam from B; C is at ξ = L, D at ξ = 3L.
#pragma once

#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/beam_formulas.h"
#include "geometry/analytic/section_formulas.h"
#include "geometry/constructions/proportion.h"
#include "geometry/statics/funicular.h"
#include "geometry/statics/section.h"

namespace epure {

struct Crane {
  Rational L, H_0;
  geometry::analytic::DoubleT beam, column;
  Rational E, g, mass;  // mass of the boat

  // Throws BadGivens, in one sentence with the values, for flanges that leave no web, or a web wider than its
  // flanges.
  explicit Crane(const Givens& givens);

  static std::vector<GivenSpec> givens();
  // The source computes with twice the mass it states.
  static const Rational& mass_of_the_source();

  // The axis about which the column is less stiff is that of its web.
  bool column_is_weak_about_y() const { return column.J_y() <= column.J_x(); }

  // For drawings: round numbers near the weight of the boat, and such that the deflections n times enlarged are about
  // as long as L.
  Rational pole_distance(const Rational& boat) const;
  Rational enlargement(const Rational& boat) const;
};

// Distances and stiffness as numbers, with a boat.
template <class T>
geometry::analytic::OverhangingBeam<T> beam_of(const Crane& crane, const Rational& boat) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  return {number(crane.L), number(2 * crane.L), number(boat * crane.g), number(crane.E * crane.beam.J_x())};
}
template <class T>
geometry::DoubleT<T> section(const geometry::analytic::DoubleT& of) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  return {number(of.H), number(of.b), number(of.s)};
}

// The beam by its funicular polygon. The strings of P are laid from a horizontal one through the lines of B and D; so
// it is the axis of the diagram of moments, which the closing line and the last string bound on the side of the
// fibres in tension.
template <class T>
struct BeamByFunicular {
  T P;
  geometry::FunicularPolygon<T> polygon;
  geometry::TwoSupports<T> supports;

  T Y_B() const { return supports.first; }
  T Y_A() const { return supports.last; }
  // Pole distance times the ordinate between the axis and the bounding string.
  T moment_between(const T& xi) const { return polygon.pole.distance * -geometry::ordinate(supports.closing, xi); }
  T moment_beyond(const T& xi) const { return polygon.pole.distance * -geometry::ordinate(polygon.strings[1], xi); }
};
template <class T>
BeamByFunicular<T> by_funicular(const Crane& crane, const Rational& boat) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T P = number(boat) * number(crane.g), D = number(3 * crane.L);
  const auto polygon = geometry::funicular<T>({{D, -P}}, {number(crane.pole_distance(boat)), T(0)}, {D, T(0)});
  return {P, polygon, geometry::on_two_supports(polygon, T(0), number(crane.L))};
}

// The elastic line: the areas of the diagram of moments as forces in their centroids, with the pole distance EJ/n.
// The strings are its tangents at B, C and D, n times enlarged; the undeformed beam runs through those of B and C,
// there.
template <class T>
struct ElasticLine {
  T L, area_BC, area_CD, n;
  geometry::FunicularPolygon<T> polygon;
  geometry::Line<T> axis;

  const geometry::Line<T>& tangent_B() const { return polygon.strings[0]; }
  const geometry::Line<T>& tangent_C() const { return polygon.strings[1]; }
  const geometry::Line<T>& tangent_D() const { return polygon.strings[2]; }
  T turn(const geometry::Line<T>& tangent) const {
    return geometry::quotient(polygon.slope(tangent) - polygon.slope(axis), n);
  }
  T rise(const geometry::Line<T>& tangent, const T& xi) const {
    return geometry::quotient(geometry::ordinate(tangent, xi) - geometry::ordinate(axis, xi), n);
  }
  // Where the tangent is parallel to the axis: the area from B to there, which grows as ξ², is what the ray parallel
  // to the axis cuts off the load line. That tangent meets the one of B at two thirds of ξ.
  T highest() const {
    const T cut_off = polygon.pole.distance * polygon.slope(axis);
    return geometry::mean_proportional<T>(L, geometry::fourth_proportional<T>(area_BC, L, cut_off));
  }
  T greatest_rise() const { return rise(tangent_B(), geometry::from_rational<T>(Rational(2, 3)) * highest()); }
};
template <class T>
ElasticLine<T> by_elastic_weights(const Crane& crane, const Rational& boat, const BeamByFunicular<T>& beam,
                                  const T& J_x) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T L = number(crane.L), C = beam.moment_between(L), BC = number(Rational(1, 2)) * L * C, CD = L * C;
  const T n = number(crane.enlargement(boat)), EJ = number(crane.E) * J_x;
  const auto polygon =
      geometry::funicular<T>({{number(Rational(2, 3) * crane.L), BC}, {number(Rational(5, 3) * crane.L), CD}},
                             {geometry::quotient(EJ, n), T(0)}, {T(0), T(0)});
  const geometry::Point<T> B{T(0), T(0)};
  return {L, BC, CD, n, polygon, geometry::line(B, geometry::Point<T>{L, geometry::ordinate(polygon.strings[1], L)})};
}

}  // namespace epure
