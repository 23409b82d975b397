// The motion of a four-bar's coupler and rocker as its two graphical routes find it.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/linkages/four_bar_instant.h"

namespace epure {

// What one route found: the coupler's motion, the rates of the rocker, and the inflection pole.
template <class T>
struct CouplerAndRocker {
  geometry::PlaneMotion<T> coupler;
  T omega_4, alpha_4;
  geometry::ProjectivePoint<T> J;
};

template <class T>
CouplerAndRocker<T> motion_by_polar_diagram(const geometry::FourBar<T>& at, const T& omega_2, const T& alpha_2) {
  const auto found = geometry::four_bar_motion(at, omega_2, alpha_2);
  return {found.coupler, found.rocker.omega, found.rocker.alpha, found.coupler.inflection_pole()};
}

// From the velocity of B, or its acceleration, to the rate of the rocker.
template <class T>
T rate_of_rocker(const geometry::FourBar<T>& at, const geometry::Vector<T>& of_B) {
  const geometry::Vector<T> B0B = at.B - at.B0;
  return geometry::quotient(cross(B0B, of_B), length_squared(B0B));
}

// For a finite pole.
template <class T>
CouplerAndRocker<T> motion_by_poles(const geometry::FourBar<T>& at, const T& omega_2, const T& alpha_2) {
  const geometry::Point<T> P0 = finite(at.pole());
  const geometry::Vector<T> crank = at.A - at.A0, v_A = omega_2 * quarter_turn(crank);
  const geometry::Vector<T> a_A = alpha_2 * quarter_turn(crank) - geometry::square(omega_2) * crank;
  const auto J = inflection_pole_by_poles(at, P0);
  const auto coupler = geometry::motion_by_poles(P0, finite(J), at.A, v_A, a_A);
  return {coupler, rate_of_rocker(at, coupler.velocity(at.B)), rate_of_rocker(at, coupler.acceleration(at.B)), J};
}

inline constexpr Phrase no_path{"the point is at rest: its path has no direction there",
                                "il punto è fermo: lì la sua traiettoria non ha direzione"};

// |part| / |along|, for a part of a vector given as a product with a vector along the path.
template <class T>
T part_along(const T& product, const geometry::Vector<T>& along) {
  if constexpr (signs_only<T>) {
    return Ledger<T>::ratio(product, geometry::length_squared(along), no_path);
  } else {
    return Ledger<T>::ratio(geometry::root(geometry::square(product)), geometry::length(along), no_path);
  }
}

}  // namespace epure
