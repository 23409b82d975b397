// The mechanisms in equilibrium of Sapienza's N.4 and N.8, as data: what is given of each, where its forces act, and
// which bodies they join. Any model that knows loads, efforts, contacts, hinges, guides and couples takes them:
// geometry::FreeBodies for the construction, geometry::analytic::Equilibrium for the second route.
//
// Metres, newtons; x to the right, y upwards; counter-clockwise positive. Body 1 is the frame; R_ij acts from body i
// on body j.
#pragma once

#include <string>

#include "exercises/kit/statement/givens.h"
#include "geometry/numbers/parallel_angles.h"

namespace epure {

template <class T>
struct XY {
  T x, y;
};
template <class T>
XY<T> unit(const Angle& direction) {
  return {geometry::cosine<T>(direction), geometry::sine<T>(direction)};
}

// A wedge (2) on a floor lifts a rod (3) in a collar: they touch in the origin, where the wedge's face falls by theta
// to the right. P acts on the wedge, Q on the rod along its axis x = 0.
struct Wedge {
  Rational Q, w, y_lower, y_upper;
  Angle theta;
};
inline Rational floor_of_wedge() { return {-60, 1000}; }
inline Rational line_of_P() { return {-45, 1000}; }

// Directions of the forces of the contacts: wedge on rod, floor on wedge, collar on rod (at its upper and lower end,
// where it is two forces).
template <class T>
struct WedgeDirections {
  XY<T> R_23, R_12, R_13_upper, R_13_lower;
};
enum class Collar { one_force, two_forces };
template <class Model, class T>
void describe(Model& model, const Wedge& of, const WedgeDirections<T>& along, Collar collar) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  model.load("Q", 3, T(0), T(0), T(0), -number(of.Q));
  model.contact("R_23", 2, 3, T(0), T(0), along.R_23.x, along.R_23.y);
  if (collar == Collar::one_force) {
    model.guide("R_13", 1, 3, along.R_13_upper.x, along.R_13_upper.y);
  } else {
    const T half = number(of.w / 2);
    model.contact("R_13_upper", 1, 3, -half, number(of.y_upper), along.R_13_upper.x, along.R_13_upper.y);
    model.contact("R_13_lower", 1, 3, half, number(of.y_lower), along.R_13_lower.x, along.R_13_lower.y);
  }
  model.effort("P", 2, T(0), number(line_of_P()), T(1), T(0));
  model.guide("R_12", 1, 2, along.R_12.x, along.R_12.y);
}

// A link AB (3) between a slider 2 on the vertical guide x = 0, loaded by Q, and a slider 4 on the guide y = 0,
// driven by P. theta: of AB with the guide of P.
struct DoubleSlider {
  Rational Q, l;
  Angle theta;
};
template <class T>
struct DoubleSliderAt {
  XY<T> A, B, R_12, R_14;  // hinges; directions of the guides' forces
};
template <class Model, class T>
void describe(Model& model, const DoubleSlider& of, const DoubleSliderAt<T>& at) {
  model.load("Q", 2, at.A.x, at.A.y, T(0), -geometry::from_rational<T>(of.Q));
  model.guide("R_12", 1, 2, at.R_12.x, at.R_12.y);
  model.hinge("R_32", 3, 2, at.A.x, at.A.y);
  model.hinge("R_43", 4, 3, at.B.x, at.B.y);
  model.guide("R_14", 1, 4, at.R_14.x, at.R_14.y);
  model.effort("P", 4, at.B.x, at.B.y, T(1), T(0));
}

// Two levers that touch in C: 2 about A0 = (0, 0), 3 about B0 = (b, 0). Q acts on one of them along a line through
// (x_Q, 0), P on the other with an arm; `nu` is the direction of the contact's force on the lever that Q loads.
struct Levers {
  int loaded;  // by Q: 2 or 3
  Rational Q, x_Q, b, x_C, y_C, arm_P, r_2, r_3;
  Angle nu, direction_Q, direction_P;

  int driven() const { return 5 - loaded; }
  std::string contact() const { return loaded == 3 ? "R_23" : "R_32"; }
  Rational hinge(int lever) const { return lever == 2 ? Rational(0) : b; }
};
// Which way a force in C at this angle turns a lever about its hinge: positive counter-clockwise; zero through the
// hinge.
geometry::Sign turned_from_C(const Levers& of, int lever, const Angle& direction);
template <class T>
struct LeversAt {
  XY<T> C, along;   // contact, and direction of its force on the loaded lever
  Angle direction;  // the same, as the sum of given angles that it is
};
template <class T>
XY<T> foot_of_P(const Levers& of) {
  const XY<T> P = unit<T>(of.direction_P);
  const T arm = geometry::from_rational<T>(of.arm_P);
  return {geometry::from_rational<T>(of.hinge(of.driven())) + arm * P.y, -(arm * P.x)};
}
template <class Model, class T>
void describe(Model& model, const Levers& of, const LeversAt<T>& at) {
  const T Q = geometry::from_rational<T>(of.Q);
  const XY<T> q = unit<T>(of.direction_Q), p = unit<T>(of.direction_P), foot = foot_of_P<T>(of);
  model.load("Q", of.loaded, geometry::from_rational<T>(of.x_Q), T(0), Q * q.x, Q * q.y);
  model.contact(of.contact(), of.driven(), of.loaded, at.C.x, at.C.y, at.along.x, at.along.y);
  model.effort("P", of.driven(), foot.x, foot.y, p.x, p.y);
  model.directed("Q", of.direction_Q);
  model.directed(of.contact(), at.direction);
  model.directed("P", of.direction_P);
  model.hinge("R_12", 1, 2, T(0), T(0));
  model.hinge("R_13", 1, 3, geometry::from_rational<T>(of.b), T(0));
}

// Fairbairn's mechanism: crank 2 about A = (0, AC), block 3 pinned to it in B and sliding on the lever 4 about
// C = (0, 0), block 5 pinned to the lever in D and sliding in an upright slot of the ram 6, which moves along x.
// theta: of the lever, to the right of CA; B is the farther point of the lever at AB from A.
struct Fairbairn {
  Rational F, AB, AC, CD;
  Angle theta;
  bool touches = false;  // the crank's circle the lever: decided with the givens
};
template <class T>
struct FairbairnAt {
  XY<T> A, B, D;
  XY<T> R_34, R_56, R_16;  // directions of the sliding pairs' forces
};
template <class Model, class T>
void describe(Model& model, const Fairbairn& of, const FairbairnAt<T>& at) {
  model.load("F", 6, at.D.x, at.D.y, geometry::from_rational<T>(of.F), T(0));
  model.guide("R_16", 1, 6, at.R_16.x, at.R_16.y);
  model.guide("R_56", 5, 6, at.R_56.x, at.R_56.y);
  model.hinge("R_45", 4, 5, at.D.x, at.D.y);
  model.guide("R_34", 3, 4, at.R_34.x, at.R_34.y);
  model.hinge("R_14", 1, 4, T(0), T(0));
  model.hinge("R_23", 2, 3, at.B.x, at.B.y);
  model.hinge("R_12", 1, 2, at.A.x, at.A.y);
  model.couple("M", 2);
}

// All of them, as one exercise gives them: the symbol of a given is its name after that of its mechanism. Throws
// BadGivens, naming value and condition, when a mechanism does not close or cannot be in equilibrium.
struct LoadedMechanisms {
  Wedge wedge;
  DoubleSlider double_slider;
  Levers levers, levers_Q_on_2;
  Fairbairn fairbairn, fairbairn_short_lever;

  explicit LoadedMechanisms(const Givens& givens);
};
std::vector<GivenSpec> givens_of_loaded_mechanisms();

}  // namespace epure
