// Forces on bodies that move in the plane: moment, power, and the forces of inertia after d'Alembert.
//
// Newtons, metres, kilograms, seconds; moments counter-clockwise positive, about an axis out of the plane.
#pragma once

#include "geometry/motion/plane_motion.h"

namespace epure::geometry {

template <class T>
struct Force {
  Point<T> at;  // a point of its line of action
  Vector<T> f;
};

// About O.
template <class T>
T moment(const Force<T>& force, const Point<T>& O) {
  return cross(force.at - O, force.f);
}

// -m a_G, at the centre of mass G of the body.
template <class T>
Force<T> inertia_force(const T& mass, const Point<T>& G, const PlaneMotion<T>& body) {
  return {G, -(mass * body.acceleration(G))};
}

template <class T>
Force<T> weight(const T& mass, const T& gravity, const Point<T>& G) {
  return {G, {T(0), -(mass * gravity)}};
}

}  // namespace epure::geometry
