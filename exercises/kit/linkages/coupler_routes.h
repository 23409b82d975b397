// What follows from the motion of a plane up to the second order, as every route writes it down: pole, acceleration
// pole, inflection and stationarity circles, centres of curvature. The motion itself is found by whoever calls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/linkages/second_order_quantities.h"
#include "exercises/kit/proof/ledger.h"
#include "geometry/analytic/plane_motion_formulas.h"
#include "geometry/motion/euler_savary.h"
#include "geometry/motion/plane_motion.h"

namespace epure {

inline constexpr Phrase no_inflection_circle{
    "there is no inflection circle: ω₃ is zero, so the points with an inflection lie on a line, and nowhere when α₃ "
    "is zero too",
    "non c'è circonferenza dei flessi: ω₃ è zero, e i punti di flesso stanno su una retta, e in nessun luogo quando "
    "anche α₃ è zero"};
inline constexpr Phrase no_stationarity_circle{
    "there is no stationarity circle: where ω₃ or α₃ is zero it is a line, and where both are, all points or none",
    "non c'è circonferenza di stazionarietà: con ω₃ o α₃ zero è una retta, con entrambe zero tutti i punti o "
    "nessuno"};
inline constexpr Phrase no_acceleration_pole{"the acceleration pole K is at infinity: ω₃ and α₃ are zero",
                                             "il polo delle accelerazioni K è all'infinito: ω₃ e α₃ sono zero"};
inline constexpr Phrase no_point_on_ray{"the ray from the pole meets the inflection circle at infinity",
                                        "il raggio dal polo incontra la circonferenza dei flessi all'infinito"};
inline constexpr Phrase no_curvature{
    "the path is straight to the second order: the point lies on the inflection circle",
    "la traiettoria è rettilinea al secondo ordine: il punto sta sulla circonferenza dei flessi"};
inline constexpr Phrase no_ray{
    "the point is the pole: it rests, its path has a cusp there or goes back on itself, and no ray leads to it",
    "il punto è il polo: è fermo, la sua traiettoria ha lì una cuspide o torna su sé stessa, e nessun raggio vi "
    "porta"};

// A point of the plane, under the letter it has in the names of quantities.
template <class P>
struct Lettered {
  std::string letter;
  P at;
};

// From complex numbers to what a ledger takes.
template <class T>
geometry::Vector<T> plane(const geometry::analytic::Complex<T>& z) {
  return {z.re, z.im};
}

// The analytic counterpart of what may be at infinity: the value, or the reason why there is none.
template <class V>
const V& present(const std::optional<V>& found, const Phrase& reason) {
  if (!found) throw geometry::Impossible(reason);
  return *found;
}

// Entries for complex numbers. Each looks for its number anew, so that an undecided one leaves the others alone.
template <class T>
using FindComplex = std::function<geometry::analytic::Complex<T>()>;
template <class T>
void put_point(Ledger<T>& ledger, const std::string& name, const FindComplex<T>& find) {
  ledger.put(name + "_x", [&] { return find().re; });
  ledger.put(name + "_y", [&] { return find().im; });
}
template <class T>
void put_point(Ledger<T>& ledger, const PointQuantity& quantity, const FindComplex<T>& find) {
  ledger.put(quantity.x(), [&] { return find().re; });
  ledger.put(quantity.y(), [&] { return find().im; });
}
template <class T, class Name>
void put_length(Ledger<T>& ledger, const Name& name, const FindComplex<T>& find) {
  ledger.put(name, [&] { return size(plane(find())); });
}

// The pole, called `pole` (P0, P31), and its distances from the points.
template <class T>
void write_pole(Ledger<T>& ledger, const std::string& pole, const geometry::ProjectivePoint<T>& P0,
                const std::vector<Lettered<geometry::Point<T>>>& points, const Phrase& at_infinity) {
  ledger.put(epure::pole(pole), P0, at_infinity);
  for (const auto& X : points) ledger.distance(distance(pole, X.letter), P0, X.at, at_infinity);
}
template <class T>
void write_pole(Ledger<T>& ledger, const std::string& pole, const geometry::analytic::PlaneMotion<T>& motion,
                const std::vector<Lettered<geometry::analytic::Complex<T>>>& points, const Phrase& at_infinity) {
  const auto P0 = [&] { return present(motion.pole(), at_infinity); };
  put_point<T>(ledger, epure::pole(pole), P0);
  for (const auto& X : points) put_length<T>(ledger, distance(pole, X.letter), [&] { return X.at - P0(); });
}

// K, and its distances from the points.
template <class T>
void write_acceleration_pole(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion,
                             const std::vector<Lettered<geometry::Point<T>>>& points,
                             const Phrase& at_infinity = no_acceleration_pole) {
  const geometry::ProjectivePoint<T> K = motion.acceleration_pole();
  ledger.put(acceleration_pole(), K, at_infinity);
  for (const auto& X : points) ledger.distance(distance("K", X.letter), K, X.at, at_infinity);
}
template <class T>
void write_acceleration_pole(Ledger<T>& ledger, const geometry::analytic::PlaneMotion<T>& motion,
                             const std::vector<Lettered<geometry::analytic::Complex<T>>>& points,
                             const Phrase& at_infinity = no_acceleration_pole) {
  const auto K = [&] { return present(motion.acceleration_pole(), at_infinity); };
  put_point<T>(ledger, acceleration_pole(), K);
  for (const auto& X : points) put_length<T>(ledger, distance("K", X.letter), [&] { return X.at - K(); });
}

// Diameter and centre of a circle that may have become a line. For drawings the point of either that is nearest to
// the origin, and the direction there: of k t² + √(l² + m²) t + n = 0 the root that stays finite when k vanishes.
template <class T>
void write_circle(Ledger<T>& ledger, const Quantity& diameter, const PointQuantity& centre,
                  const geometry::Cycle<T>& cycle, const Phrase& when_line) {
  ledger.put(diameter, [&] {
    const T squared = geometry::square(cycle.l) + geometry::square(cycle.m) - T(4) * cycle.k * cycle.n;
    if constexpr (signs_only<T>) {
      return ledger.ratio(squared, geometry::square(cycle.k), when_line);
    } else {
      return ledger.ratio(geometry::root(squared), geometry::absolute(cycle.k), when_line);
    }
  });
  ledger.put(centre, cycle.centre(), when_line);
  if constexpr (std::is_same_v<T, geometry::Deep>) {
    const geometry::Vector<T> steepest{cycle.l, cycle.m};
    ledger.draws_point(centre.name + "_nearest", [&]() -> geometry::Point<T> {
      const T steep = geometry::length(steepest);
      const T reach = steep + geometry::root(geometry::square(steep) - T(4) * cycle.k * cycle.n);
      return geometry::Point<T>{T(0), T(0)} + geometry::quotient(T(-2) * cycle.n, steep * reach) * steepest;
    });
    ledger.draws_point(centre.name + "_along", [&]() -> geometry::Point<T> {
      const geometry::Vector<T> along = geometry::quarter_turn(steepest);
      return {geometry::quotient(along.x, geometry::length(along)),
              geometry::quotient(along.y, geometry::length(along))};
    });
  }
}

// Both circles and the inflection pole J, which a route may know better than by cancellation.
template <class T>
void write_circles(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion, const geometry::ProjectivePoint<T>& J) {
  write_circle(ledger, inflection_diameter(), inflection_centre(), motion.inflection_circle(), no_inflection_circle);
  ledger.put(inflection_pole(), J, no_inflection_circle);
  write_circle(ledger, stationarity_diameter(), stationarity_centre(), motion.stationarity_circle(),
               no_stationarity_circle);
}

// What builds the inflection circle: X' on the ray of a point X whose path has this centre of curvature.
template <class T>
void draws_builder(Ledger<T>& ledger, const geometry::ProjectivePoint<T>& P0, const Lettered<geometry::Point<T>>& X,
                   const geometry::Point<T>& centre) {
  ledger.draws_point(X.letter + "prime", [&] { return euler_savary_point(geometry::finite(P0), X.at, centre); });
}
// ... and the stationarity circle: A" on the ray of the driven point A, where the acceleration along the path is
// zero. It grows along the ray at the rate α: A"A = a_A^t / α.
template <class T>
void draws_builder(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion) {
  ledger.draws_point("Adoubleprime", [&]() -> geometry::Point<T> {
    const geometry::Vector<T> ray = motion.A - geometry::finite(motion.pole());
    const T along_path = geometry::dot(motion.a_A, geometry::quarter_turn(ray));
    return motion.A + geometry::quotient(-along_path, motion.alpha * geometry::length_squared(ray)) * ray;
  });
}

// The diameters as vectors from the pole, so that signs need no roots.
template <class T>
void write_circles(Ledger<T>& ledger, const geometry::analytic::PlaneMotion<T>& motion) {
  const auto P0 = [&] { return present(motion.pole(), no_inflection_circle); };
  const auto J = [&] { return present(motion.inflection_pole(), no_inflection_circle); };
  const auto bresse = [&] { return present(motion.stationarity_circle(), no_stationarity_circle).centre; };
  put_length<T>(ledger, inflection_diameter(), [&] { return J() - P0(); });
  put_point<T>(ledger, inflection_centre(),
               [&] { return present(motion.inflection_circle(), no_inflection_circle).centre; });
  put_point<T>(ledger, inflection_pole(), J);
  put_length<T>(ledger, stationarity_diameter(), [&] { return T(2) * (bresse() - P0()); });
  put_point<T>(ledger, stationarity_centre(), bresse);
}

// Why there is no point on the ray to X, or no centre of curvature, where there is none: X may be the pole.
template <class T>
const Phrase& unless_pole(const geometry::PlaneMotion<T>& motion, const geometry::Point<T>& X, const Phrase& reason) {
  return geometry::sign(geometry::length_squared(motion.velocity(X))) == geometry::Sign::zero ? no_ray : reason;
}

// X', the centre of curvature of the path of X, and its radius.
template <class T>
void write_curvature(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion,
                     const Lettered<geometry::Point<T>>& X) {
  const geometry::ProjectivePoint<T> on_circle = motion.on_inflection_circle(X.at);
  const geometry::ProjectivePoint<T> centre = motion.centre_of_curvature(X.at);
  const Phrase &none_on_ray = unless_pole(motion, X.at, no_point_on_ray),
               &no_centre = unless_pole(motion, X.at, no_curvature);
  ledger.distance(distance_on_ray(X.letter), on_circle, X.at, none_on_ray);
  ledger.distance(radius_of_curvature(X.letter), centre, X.at, no_centre);
  ledger.put(centre_of_curvature(X.letter), centre, no_centre);
  ledger.put(point_on_ray(X.letter), on_circle, none_on_ray);
}
template <class T>
void write_curvature(Ledger<T>& ledger, const geometry::analytic::PlaneMotion<T>& motion,
                     const Lettered<geometry::analytic::Complex<T>>& X) {
  const auto on_circle = [&] { return present(motion.on_inflection_circle(X.at), no_point_on_ray); };
  const auto centre = [&] { return present(motion.centre_of_curvature(X.at), no_curvature); };
  put_length<T>(ledger, distance_on_ray(X.letter), [&] { return on_circle() - X.at; });
  put_length<T>(ledger, radius_of_curvature(X.letter), [&] { return centre() - X.at; });
  put_point<T>(ledger, centre_of_curvature(X.letter), centre);
  put_point<T>(ledger, point_on_ray(X.letter), on_circle);
}

}  // namespace epure
