// What a route finds of M at an instant of a rolling motion: by the poles, seen from the contact P₀, or by the
// derivatives of the path. Its exercise writes it down under names of its own. Each number is looked for anew, so
// that an undecided one leaves the others alone.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "geometry/analytic/roulette_formulas.h"
#include "geometry/motion/rolling.h"

namespace epure {

template <class T>
using Find = std::function<T()>;

// The tangential part has two values at a cusp.
template <class T>
struct FoundOnPath {
  Find<T> x, y, P0M;
  geometry::Vector<T> v, a;
  Find<T> a_n, before, after, rho, centre_x, centre_y;
  bool is_at_cusp;
};

// `contact` finds P₀ in the fixed plane.
template <class T>
FoundOnPath<T> found_by_poles(const geometry::RollingInstant<T>& at, const Find<geometry::Point<T>>& contact) {
  const geometry::Vector<T> P0M = at.M - at.motion.A;
  const auto centre = [at] {
    const geometry::ProjectivePoint<T> found = at.centre_of_curvature();
    if (geometry::sign(found.w) == geometry::Sign::zero) throw geometry::Impossible(no_curvature);
    return geometry::finite(found) - at.motion.A;
  };
  return {.x = [=] { return contact().x + P0M.x; },
          .y = [=] { return contact().y + P0M.y; },
          .P0M = [at] { return size(at.by_normal); },
          .v = at.velocity(),
          .a = at.acceleration(),
          .a_n = [at] { return size(at.normal_acceleration()); },
          .before = [at] { return at.tangential_component().before; },
          .after = [at] { return at.tangential_component().after; },
          .rho = [at] { return at.radius_of_curvature(); },
          .centre_x = [=] { return contact().x + centre().x; },
          .centre_y = [=] { return contact().y + centre().y; },
          .is_at_cusp = at.is_at_cusp};
}

template <class T>
FoundOnPath<T> found_by_derivatives(const geometry::analytic::RoulettePath<T>& path, const T& omega, const T& alpha) {
  return {.x = [=] { return path.z.re; },
          .y = [=] { return path.z.im; },
          .P0M = [=] { return size(plane(path.z_prime)); },
          .v = plane(path.velocity(omega)),
          .a = plane(path.acceleration(omega, alpha)),
          .a_n = [=] { return path.normal_component(omega); },
          .before = [=] { return path.components(omega, alpha).before; },
          .after = [=] { return path.components(omega, alpha).after; },
          .rho = [=] { return path.radius_of_curvature(); },
          .centre_x = [=] { return path.centre_of_curvature().re; },
          .centre_y = [=] { return path.centre_of_curvature().im; },
          .is_at_cusp = path.is_at_rest};
}

}  // namespace epure
