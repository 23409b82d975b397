// The right flank of a tooth in the frame of its wheel: the centre is the origin, the middle of the tooth lies on +y.
//
// The involute of the base circle r_b whose start lies half_angle to the right of +y. With t, the tangent of the
// pressure angle, r_b t is the length of the tangent to the base circle; it touches the circle in the direction u,
// turned by ±t from the start of the involute:
//   P(t) = r_b (u ± t n),  u = (-sin ψ, cos ψ),  n = (cos ψ, sin ψ),  ψ = -half_angle ± t
// with + on a wheel, whose teeth become thinner outwards, and - on a ring, whose teeth become thicker.
//
// Involutes of one base circle are parallel curves: turned by an angle, the flank moves by r_b times the angle along
// its normals. So r_b (half_angle of the involute through a point - half_angle) is exactly the distance of the point
// from the flank, along the normal and positive outside the tooth.
#pragma once

#include "geometry/constructions/plane.h"

namespace epure::geometry {

template <class T>
struct RightFlank {
  T r_b, half_angle;
  bool ring = false;

  // The curve, for the tracer too; t >= 0.
  template <class X>
  Point<X> operator()(const X& t) const {
    const X turned = ring ? -t : t, psi = turned - X(half_angle);
    const X c = cosine_of_angle(psi), s = sine_of_angle(psi);
    return {X(r_b) * (turned * c - s), X(r_b) * (turned * s + c)};
  }
};

}  // namespace epure::geometry
