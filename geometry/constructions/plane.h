// Points, vectors and lines of the plane, and what ruler and set square do with them.
//
// Lengths in whatever unit the caller uses throughout; x to the right, y upwards, angles counter-clockwise.
// Everything here is rational in its input: no roots, no divisions, except where a function says so.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

template <class T>
struct Vector {
  T x, y;
};

template <class T>
struct Point {
  T x, y;
};

template <class T>
Vector<T> operator+(const Vector<T>& u, const Vector<T>& v) {
  return {u.x + v.x, u.y + v.y};
}
template <class T>
Vector<T> operator-(const Vector<T>& u, const Vector<T>& v) {
  return {u.x - v.x, u.y - v.y};
}
template <class T>
Vector<T> operator-(const Vector<T>& v) {
  return {-v.x, -v.y};
}
template <class T>
Vector<T> operator*(const T& s, const Vector<T>& v) {
  return {s * v.x, s * v.y};
}
template <class T>
Vector<T> operator-(const Point<T>& P, const Point<T>& Q) {
  return {P.x - Q.x, P.y - Q.y};
}
template <class T>
Point<T> operator+(const Point<T>& P, const Vector<T>& v) {
  return {P.x + v.x, P.y + v.y};
}

template <class T>
T dot(const Vector<T>& u, const Vector<T>& v) {
  return u.x * v.x + u.y * v.y;
}

// The z component of u x v: positive when v lies counter-clockwise of u.
template <class T>
T cross(const Vector<T>& u, const Vector<T>& v) {
  return u.x * v.y - u.y * v.x;
}

// `v` turned by 90° counter-clockwise: k x v.
template <class T>
Vector<T> quarter_turn(const Vector<T>& v) {
  return {-v.y, v.x};
}

template <class T>
T length_squared(const Vector<T>& v) {
  return square(v.x) + square(v.y);
}

template <class T>
T length(const Vector<T>& v) {
  return root(length_squared(v));
}

template <class T>
T distance(const Point<T>& P, const Point<T>& Q) {
  return length(Q - P);
}

// The middle of PQ.
template <class T>
Point<T> midpoint(const Point<T>& P, const Point<T>& Q) {
  const T half = from_rational<T>(Rational(1, 2));
  return {half * (P.x + Q.x), half * (P.y + Q.y)};
}

// A point of the projective plane: (x/w, y/w), or the direction (x, y) when w is zero.
template <class T>
struct ProjectivePoint {
  T x, y, w;
};

template <class T>
ProjectivePoint<T> projective(const Point<T>& P) {
  return {P.x, P.y, T(1)};
}

// The finite point. Throws Undecided unless w is proved different from zero.
template <class T>
Point<T> finite(const ProjectivePoint<T>& P) {
  return {quotient(P.x, P.w), quotient(P.y, P.w)};
}

// The line a x + b y + c = 0, directed along (b, -a): the left of the direction is where a x + b y + c > 0.
template <class T>
struct Line {
  T a, b, c;
  Vector<T> direction() const { return {b, -a}; }
};

// Through P in the direction `along`.
template <class T>
Line<T> line(const Point<T>& P, const Vector<T>& along) {
  return {-along.y, along.x, along.y * P.x - along.x * P.y};
}

// Through P towards Q.
template <class T>
Line<T> line(const Point<T>& P, const Point<T>& Q) {
  return line(P, Q - P);
}

// Through P towards Q, either of which may be at infinity. Through two directions runs the line at infinity
// (0, 0, c); points that coincide give (0, 0, 0).
template <class T>
Line<T> line(const ProjectivePoint<T>& P, const ProjectivePoint<T>& Q) {
  return {P.y * Q.w - P.w * Q.y, P.w * Q.x - P.x * Q.w, P.x * Q.y - P.y * Q.x};
}

template <class T>
Line<T> parallel(const Line<T>& l, const Point<T>& P) {
  return line(P, l.direction());
}

// Through P, directed 90° counter-clockwise from l.
template <class T>
Line<T> perpendicular(const Line<T>& l, const Point<T>& P) {
  return line(P, quarter_turn(l.direction()));
}

// Where l and m meet; parallel lines meet in their direction (w = 0); coincident lines give (0, 0, 0).
template <class T>
ProjectivePoint<T> meet(const Line<T>& l, const Line<T>& m) {
  return {l.b * m.c - l.c * m.b, l.c * m.a - l.a * m.c, l.a * m.b - l.b * m.a};
}

// The foot of the perpendicular from P on l. Divides by the squared length of l's direction.
template <class T>
Point<T> foot(const Point<T>& P, const Line<T>& l) {
  return finite(meet(l, perpendicular(l, P)));
}

// Positive when P lies on the left of l (looking along its direction), negative on the right, zero on it.
template <class T>
Sign side(const Point<T>& P, const Line<T>& l) {
  return sign(l.a * P.x + l.b * P.y + l.c);
}

}  // namespace epure::geometry
