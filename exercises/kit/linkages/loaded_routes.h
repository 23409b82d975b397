// What the exercises on mechanisms in equilibrium share of their routes: a description solved by either model when it
// is first asked, and the points of the mechanisms by construction and by analysis.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exercises/kit/linkages/loaded_mechanisms.h"
#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "geometry/analytic/equilibrium.h"
#include "geometry/constructions/circle.h"
#include "geometry/statics/free_bodies.h"

namespace epure::loaded {

namespace analytic = geometry::analytic;
using analytic::Complex;
using geometry::Point;
using geometry::ProjectivePoint;
using geometry::Vector;

inline constexpr Phrase parallel_forces{"it is at infinity: the forces on the body are parallel",
                                        "è all'infinito: le forze sul corpo sono parallele"};

template <class T>
XY<T> xy(const Vector<T>& v) {
  return {v.x, v.y};
}
template <class T>
XY<T> xy(const Point<T>& P) {
  return {P.x, P.y};
}
template <class T>
Complex<T> complex(const XY<T>& v) {
  return {v.x, v.y};
}
template <class T>
Point<T> origin() {
  return {T(0), T(0)};
}

// A vector, or a point, that is looked for when it is wanted.
template <class T, class Find>
void put_vector(Ledger<T>& ledger, const VectorQuantity& quantity, const Find& find) {
  ledger.put_x(quantity, [&] { return Vector<T>(find()).x; });
  ledger.put_y(quantity, [&] { return Vector<T>(find()).y; });
  ledger.put_size(quantity, [&] { return size(Vector<T>(find())); });
}
template <class T, class Find>
void put_point(Ledger<T>& ledger, const PointQuantity& quantity, const Find& find, const Phrase& at_infinity) {
  ledger.put_x(quantity, [&] {
    const ProjectivePoint<T> P = find();
    return Ledger<T>::ratio(P.x, P.w, at_infinity);
  });
  ledger.put_y(quantity, [&] {
    const ProjectivePoint<T> P = find();
    return Ledger<T>::ratio(P.y, P.w, at_infinity);
  });
}
template <class T, class Find>
void draw_vector(Ledger<T>& ledger, const std::string& name, const Find& find) {
  ledger.draws_point(name, [&]() -> Point<T> { return origin<T>() + Vector<T>(find()); });
}

// One model of a mechanism, solved when it is first asked.
template <class T, class Describe>
auto solved_bodies(int bodies, const Describe& describe) {
  return once([=] {
    geometry::FreeBodies<T> model(bodies);
    describe(model);
    model.solve();
    return model;
  });
}
template <class T>
struct Equations {
  analytic::Equilibrium<T> model;
  std::map<std::string, typename analytic::Equilibrium<T>::Wrench> forces;
  std::map<int, typename analytic::Equilibrium<T>::Wrench> velocities;

  Vector<T> force(const std::string& name) const { return {forces.at(name).x, forces.at(name).y}; }
  const T& omega(int body) const { return velocities.at(body).m; }
};
template <class T, class Describe>
auto solved_equations(int bodies, const std::string& driven, const Describe& describe) {
  return once([=] {
    Equations<T> equations{analytic::Equilibrium<T>(bodies), {}, {}};
    describe(equations.model);
    equations.forces = equations.model.forces();
    equations.velocities = equations.model.velocities(driven);
    return equations;
  });
}

// By both routes the forces of these names.
template <class T, class Bodies, class Equal>
void put_forces(Ledger<T>& ledger, const Bodies& bodies, const Equal& equations,
                const std::vector<VectorQuantity>& forces) {
  for (const VectorQuantity& R : forces) {
    ledger.route("force polygon");
    put_vector(ledger, R, [&] { return bodies().force(R.name); });
    ledger.route("equilibrium equations");
    put_vector(ledger, R, [&] { return equations().force(R.name); });
  }
}
// The profiles' centres on the contact's normal n: the loaded lever's ahead of C, the other's behind it.
inline Rational offset_of_centre(const Levers& of, int lever) {
  return lever == of.loaded ? (lever == 2 ? of.r_2 : of.r_3) : -(lever == 2 ? of.r_2 : of.r_3);
}

template <class T>
struct LeverPoints {
  Point<T> A0, B0, C, A, B;
  Vector<T> n;
};
template <class T>
LeverPoints<T> points_of(const Levers& of) {
  const XY<T> n = unit<T>(of.nu);
  const Point<T> C{number<T>(of.x_C), number<T>(of.y_C)};
  const Vector<T> along{n.x, n.y};
  return {origin<T>(),
          {number<T>(of.b), T(0)},
          C,
          C + number<T>(offset_of_centre(of, 2)) * along,
          C + number<T>(offset_of_centre(of, 3)) * along,
          along};
}

// Where the reaction through a hinge meets the line of Q or P.
template <class T>
ProjectivePoint<T> on_reaction(const Complex<T>& hinge, const Vector<T>& R, const Complex<T>& X,
                               const Complex<T>& along) {
  const Complex<T> r{R.x, R.y};
  const T w = analytic::cross(r, along), s = analytic::cross(X - hinge, along);
  return {w * hinge.re + s * r.re, w * hinge.im + s * r.im, w};
}

template <class T>
struct FairbairnPoints {
  Point<T> A, B, C, D;
  Vector<T> lever;  // unit vector from C
};
template <class T>
FairbairnPoints<T> points_of(const Fairbairn& of) {
  const Point<T> C = origin<T>(), A{T(0), number<T>(of.AC)};
  const Vector<T> lever{geometry::sine<T>(of.theta), geometry::cosine<T>(of.theta)};
  const geometry::Line<T> along = line(C, lever);
  const Point<T> B = of.touches ? geometry::foot(A, along)
                                : meet(geometry::Circle<T>{A, number<T>(of.AB)}, along, geometry::Along::ahead);
  return {A, B, C, C + number<T>(of.CD) * lever, lever};
}

// B from the triangle ABC by the law of sines: sin β = AC sin θ/AB at B, and the crank turned from CA by θ + β.
template <class T>
Complex<T> crank_by_sines(const Fairbairn& of) {
  const T s = geometry::sine<T>(of.theta), c = geometry::cosine<T>(of.theta), AB = number<T>(of.AB);
  const T sine = geometry::quotient(number<T>(of.AC) * s, AB),
          cosine = of.touches ? T(0) : geometry::root(T(1) - geometry::square(sine));
  return AB * Complex<T>{s * cosine + c * sine, c * cosine - s * sine};
}

}  // namespace epure::loaded
