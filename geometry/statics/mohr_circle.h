// Mohr's circle of a plane state of stress, σ to the right and τ upwards, in any one unit of stress.
#pragma once

#include "geometry/constructions/circle.h"

namespace epure::geometry {

// One normal stress and one shear stress: a beam's. The points of two faces square to each other, (σ, τ) and (0, −τ),
// are the ends of a diameter.
template <class T>
struct MohrCircle {
  Point<T> across, along;  // of the face across the beam, and of the one along it
  Point<T> centre() const { return midpoint(across, along); }
  T radius() const { return distance(centre(), across); }
  // The greater and the lesser principal stress: where it crosses the axis of σ.
  T sigma_I() const { return centre().x + radius(); }
  T sigma_II() const { return centre().x - radius(); }
  // The pole: through it, parallel to a face, runs a line to the point of the circle that is this face's.
  Point<T> pole() const { return {across.x, -across.y}; }
  // Parallel to the face on which σ_I acts.
  Vector<T> principal_face() const { return Point<T>{sigma_I(), T(0)} - pole(); }
  // von Mises: √(σ_I² − σ_I σ_II + σ_II²), which is √(c² + 3 r²).
  T equivalent() const { return root(square(centre().x) + T(3) * length_squared(across - centre())); }
};

template <class T>
MohrCircle<T> mohr_circle(const T& sigma, const T& tau) {
  return {{sigma, tau}, {T(0), -tau}};
}

}  // namespace epure::geometry
