// A figure carried by a rigid motion, as with tracing paper: the segment AB is laid on A'B', all else goes along.
#pragma once

#include "geometry/constructions/plane.h"

namespace epure::geometry {

template <class T>
class Transport {
 public:
  // From the directed segment AB to the equally long A'B' (the caller's promise), without turning the paper over.
  Transport(const Point<T>& A, const Point<T>& B, const Point<T>& A_new, const Point<T>& B_new)
      : from_(A), to_(A_new) {
    const Vector<T> was = B - A, is = B_new - A_new;
    const T l2 = length_squared(was);
    cosine_ = quotient(dot(was, is), l2);
    sine_ = quotient(cross(was, is), l2);
  }

  Vector<T> operator()(const Vector<T>& v) const { return cosine_ * v + sine_ * quarter_turn(v); }
  Point<T> operator()(const Point<T>& P) const { return to_ + (*this)(P - from_); }
  // A direction stays a direction.
  ProjectivePoint<T> operator()(const ProjectivePoint<T>& P) const {
    const Vector<T> moved = (*this)(Vector<T>{P.x - P.w * from_.x, P.y - P.w * from_.y});
    return {moved.x + P.w * to_.x, moved.y + P.w * to_.y, P.w};
  }

 private:
  Point<T> from_, to_;
  T cosine_{0}, sine_{0};
};

}  // namespace epure::geometry
