// A dyad: two links that meet in a joint X and hang on bodies whose motion is known. Whatever the joints are, the
// velocity of X, and then its acceleration, is told twice, once from each side:
//
//   known vectors + (unknown rate) direction  =  known vectors + (unknown rate) direction
//
// One vector equation with two unknown magnitudes: a polygon, closed by two lines (close_polygon).
//
//   a side            its rate          velocity of X                 acceleration of X
//   Bar about P       ω, α              v_P + ω k x PX                a_P - ω² PX + α k x PX
//   Slide on a body   u, du/dt          v_X* + u s                    a_X* + 2 ω* u k x s + du/dt s
//   Pin in a slot     u, du/dt          v_P - u s                     a_P - 2 ω u k x s - du/dt s
//
// X* is the point of the guiding body under X, ω* that body's angular velocity, s the direction of sliding. The third
// side is the second one seen from the pin: it pairs with a Bar whose slot the pin runs in, so that ω is unknown too.
//
// RRR: Bar and Bar.  RRP: Bar and Slide.  PRP: Slide and Slide.  RPR: Bar and Pin in its slot.
//
// Metres, radians, seconds; counter-clockwise positive. Rates of sliding are per length of s (m/s when s is a unit
// vector).
#pragma once

#include "geometry/constructions/circle.h"
#include "geometry/constructions/vector_polygon.h"
#include "geometry/motion/plane_motion.h"

namespace epure::geometry {

// A point of a body whose motion is known.
template <class T>
struct Pin {
  Point<T> at;
  Vector<T> v, a;
};

template <class T>
Pin<T> fixed_pin(const Point<T>& P) {
  return {P, {T(0), T(0)}, {T(0), T(0)}};
}
template <class T>
Pin<T> pin_on(const PlaneMotion<T>& body, const Point<T>& X) {
  return {X, body.velocity(X), body.acceleration(X)};
}

// A body that turns about a fixed point O.
template <class T>
PlaneMotion<T> turning_about(const Point<T>& O, const T& omega, const T& alpha) {
  const Vector<T> none{T(0), T(0)};
  return {O, none, none, omega, alpha};
}

// What one side of the dyad says of X: the terms in the order in which the polygon is drawn.
template <class T>
struct VelocityTerms {
  Vector<T> known;    // v_P, v_X*
  Vector<T> closing;  // v_XP, u s
};
template <class T>
struct AccelerationTerms {
  Vector<T> known;     // a_P, a_X*
  Vector<T> normal;    // of a Bar, -ω² PX; else zero
  Vector<T> coriolis;  // of sliding, 2 ω u k x s; of a Bar zero
  Vector<T> closing;   // α k x PX, du/dt s
};

template <class T>
struct Bar {
  Pin<T> P;

  Vector<T> direction(const Point<T>& X) const { return quarter_turn(X - P.at); }
  Vector<T> known_velocity(const Point<T>&) const { return P.v; }
  AccelerationTerms<T> known_acceleration(const Point<T>& X, const T& omega, const T&) const {
    const Vector<T> none{T(0), T(0)};
    return {P.a, -(square(omega) * (X - P.at)), none, none};
  }
  // The bar's own motion, once its rates are known.
  PlaneMotion<T> motion(const T& omega, const T& alpha) const { return {P.at, P.v, P.a, omega, alpha}; }
};

template <class T>
struct Slide {
  PlaneMotion<T> body;  // that the guide is cut in
  Vector<T> along;      // the guide's direction s

  Vector<T> direction(const Point<T>&) const { return along; }
  Vector<T> known_velocity(const Point<T>& X) const { return body.velocity(X); }
  AccelerationTerms<T> known_acceleration(const Point<T>& X, const T& u, const T&) const {
    const Vector<T> none{T(0), T(0)};
    return {body.acceleration(X), none, (T(2) * body.omega * u) * quarter_turn(along), none};
  }
};

template <class T>
struct PinInSlot {
  Pin<T> P;         // of the driving body
  Vector<T> along;  // the slot's direction s, of the body that is the other side

  Vector<T> direction(const Point<T>&) const { return -along; }
  Vector<T> known_velocity(const Point<T>&) const { return P.v; }
  AccelerationTerms<T> known_acceleration(const Point<T>&, const T& u, const T& omega) const {
    const Vector<T> none{T(0), T(0)};
    return {P.a, none, -((T(2) * omega * u) * quarter_turn(along)), none};
  }
};

// The two polygons of a dyad.
template <class T>
struct DyadVelocity {
  T first_rate, second_rate;
  VelocityTerms<T> first, second;
  Vector<T> v_X;
};
template <class T>
struct DyadAcceleration {
  T first_rate, second_rate;
  AccelerationTerms<T> first, second;
  Vector<T> a_X;
};

// Throws Impossible when the two unknown directions are parallel (the dyad is at a limit position: it then fixes
// nothing), Undecided when that cannot be told.
template <class T, class First, class Second>
DyadVelocity<T> dyad_velocity(const First& first, const Second& second, const Point<T>& X) {
  const Vector<T> u = first.direction(X), w = second.direction(X);
  const VelocityTerms<T> of_first{first.known_velocity(X), {}}, of_second{second.known_velocity(X), {}};
  const auto [x, y] = close_polygon(of_first.known - of_second.known, u, w);
  const Vector<T> closing = x * u;
  return {x, y, {of_first.known, closing}, {of_second.known, y * w}, of_first.known + closing};
}

template <class T, class First, class Second>
DyadAcceleration<T> dyad_acceleration(const First& first, const Second& second, const Point<T>& X,
                                      const DyadVelocity<T>& rates) {
  const Vector<T> u = first.direction(X), w = second.direction(X);
  AccelerationTerms<T> one = first.known_acceleration(X, rates.first_rate, rates.second_rate);
  AccelerationTerms<T> other = second.known_acceleration(X, rates.second_rate, rates.first_rate);
  const Vector<T> up_to_one = one.known + one.normal + one.coriolis;
  const Vector<T> up_to_other = other.known + other.normal + other.coriolis;
  const auto [x, y] = close_polygon(up_to_one - up_to_other, u, w);
  one.closing = x * u;
  other.closing = y * w;
  return {x, y, one, other, up_to_one + one.closing};
}

// Where the joint is. Each throws Impossible when the dyad does not close, Undecided when that cannot be told.

// RRR: bars of the lengths given about P and Q; X on the named side of P -> Q.
template <class T>
Point<T> joint_of_bars(const Point<T>& P, const T& PX, const Point<T>& Q, const T& QX, Side side) {
  return meet(Circle<T>{P, PX}, Circle<T>{Q, QX}, side);
}

// RRP: a bar about P, and a guide; X ahead of or behind the foot of P on the guide.
template <class T>
Point<T> joint_on_guide(const Point<T>& P, const T& PX, const Line<T>& guide, Along which) {
  return meet(Circle<T>{P, PX}, guide, which);
}

// PRP: where two guides cross. Impossible when they are parallel.
template <class T>
Point<T> joint_of_guides(const Line<T>& first, const Line<T>& second) {
  const ProjectivePoint<T> X = meet(first, second);
  const Sign apart = sign(X.w);
  if (apart == Sign::zero) throw Impossible("the two guides are parallel", "le due guide sono parallele");
  if (apart == Sign::undecided) throw Undecided("whether two guides are parallel", "se due guide siano parallele");
  return finite(X);
}

// RPR: the direction, from Q towards P, of the slot of a body that turns about Q, when the pin P runs in it. The slot
// passes Q at the signed distance `offset`, positive when Q lies on its right. A unit vector.
template <class T>
Vector<T> slot_direction(const Point<T>& Q, const Point<T>& P, const T& offset) {
  const Vector<T> QP = P - Q;
  const T d2 = length_squared(QP), along2 = d2 - square(offset);
  const Sign reaches = sign(along2);
  if (reaches == Sign::negative)
    throw Impossible("the pin is nearer to the pivot than its slot passes",
                     "il perno è più vicino alla cerniera di quanto vi passi la sua scanalatura");
  if (reaches == Sign::undecided || sign(d2) == Sign::undecided)
    throw Undecided("whether a slot reaches its pin", "se una scanalatura raggiunga il suo perno");
  if (sign(d2) == Sign::zero)
    throw Impossible("the pin lies on the pivot of its slot: the slot has no direction",
                     "il perno sta sulla cerniera della sua scanalatura: questa non ha direzione");
  return quotient(root(along2), d2) * QP + quotient(-offset, d2) * quarter_turn(QP);
}

}  // namespace epure::geometry
