// The slider-crank's accelerations, circles and centres of curvature, found by polar diagram, by poles and by
// analysis.
#pragma once

#include "exercises/kit/slider_crank_routes.h"

namespace epure::slider_crank_acceleration {

inline constexpr const char* no_inflection_circle =
    "the inflection circle is a line: the crank is square to the guide and the pole at infinity";
inline constexpr const char* no_stationarity_circle = "the stationarity circle is a line: ω₃ or α₃ is zero";
inline constexpr const char* no_acceleration_pole = "the acceleration pole K is at infinity: ω₃ and α₃ are zero";
inline constexpr const char* no_point_on_ray = "the ray from the pole meets the inflection circle at infinity";
inline constexpr const char* no_curvature =
    "the path is straight to the second order: the point lies on the inflection circle";

template <class T>
void circle(Ledger<T>& ledger, const std::string& name, const geometry::Cycle<T>& cycle, const char* when_line) {
  ledger.put(name + "_diameter", [&] {
    const T squared = geometry::square(cycle.l) + geometry::square(cycle.m) - T(4) * cycle.k * cycle.n;
    if constexpr (signs_only<T>) {
      return ledger.ratio(squared, geometry::square(cycle.k), when_line);
    } else {
      return ledger.ratio(geometry::root(squared), geometry::absolute(cycle.k), when_line);
    }
  });
  ledger.point(name + "_centre", cycle.centre(), when_line);
}

// X', the centre of curvature and the radius of X's path.
template <class T>
void curvature(Ledger<T>& ledger, const std::string& X, const geometry::PlaneMotion<T>& motion,
               const geometry::Point<T>& at) {
  const geometry::ProjectivePoint<T> on_circle = motion.on_inflection_circle(at);
  const geometry::ProjectivePoint<T> centre = motion.centre_of_curvature(at);
  ledger.distance(X + "prime_" + X, on_circle, at, no_point_on_ray);
  ledger.distance("rho_" + X, centre, at, no_curvature);
  ledger.point("curvature_centre_" + X, centre, no_curvature);
  ledger.point(X + "prime", on_circle, no_point_on_ray);
}

// All that follows from the coupler's motion, whoever found it, and from the inflection pole J.
template <class T>
void second_order(Ledger<T>& ledger, const geometry::PlaneMotion<T>& motion, const geometry::ProjectivePoint<T>& J,
                  const geometry::SliderCrank<T>& at) {
  const auto a = [&](const geometry::Point<T>& X) { return motion.acceleration(X); };
  const geometry::Vector<T> a_A = motion.a_A, a_B = a(at.B), AB = at.B - at.A;
  ledger.put("a_A", [&] { return size(a_A); });
  ledger.put("alpha_3", motion.alpha);
  ledger.put("a_B_x", a_B.x);
  ledger.put("a_B", [&] { return size(a_B); });
  ledger.vector("a_C", a(at.C));
  ledger.vector("a_M", a(at.M));
  ledger.put("a_BA_n", [&] { return size(geometry::square(motion.omega) * AB); });
  ledger.put("a_BA_t", [&] { return size(motion.alpha * AB); });
  ledger.put("a_BA", [&] { return size(a_B - a_A); });
  ledger.put("a_CA", [&] { return size(a(at.C) - a_A); });
  ledger.put("a_MA", [&] { return size(a(at.M) - a_A); });
  ledger.put("gamma", [&] { return slope_angle(geometry::Vector<T>{geometry::square(motion.omega), motion.alpha}); });

  const geometry::ProjectivePoint<T> K = motion.acceleration_pole();
  ledger.point("K", K, no_acceleration_pole);
  ledger.distance("KA", K, at.A, no_acceleration_pole);
  ledger.distance("KB", K, at.B, no_acceleration_pole);
  ledger.distance("KC", K, at.C, no_acceleration_pole);
  ledger.distance("KM", K, at.M, no_acceleration_pole);

  circle(ledger, "inflection", motion.inflection_circle(), no_inflection_circle);
  ledger.point("inflection_pole", J, no_inflection_circle);
  circle(ledger, "stationarity", motion.stationarity_circle(), no_stationarity_circle);
  curvature(ledger, "C", motion, at.C);
  curvature(ledger, "M", motion, at.M);
}

template <class T>
geometry::PlaneMotion<T> motion_by_polar_diagram(const SliderCrankInstant& instant,
                                                 const geometry::SliderCrank<T>& at) {
  const T omega_2 = instant.omega_2<T>();
  const auto velocities = geometry::velocity_diagram(at, omega_2);
  const auto accelerations =
      geometry::acceleration_diagram(at, omega_2, geometry::from_rational<T>(instant.alpha_2), velocities.omega_3);
  return {at.A, velocities.v_A, accelerations.a_A, velocities.omega_3, accelerations.alpha_3};
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant);

struct AccelerationRoutes {
  SliderCrankInstant instant;

  // P₀ finite and not on the guide: only then does the method of poles fix the inflection circle by P₀, A' and B.
  bool poles_suffice() const { return !instant.pole_at_infinity && !instant.dead_centre; }

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const geometry::SliderCrank<T> at = instant.position<T>();
    const geometry::ProjectivePoint<T> P0 = at.pole();
    ledger.point("P0", P0, pole_at_infinity);
    ledger.distance("P0C", P0, at.C, pole_at_infinity);
    ledger.distance("P0M", P0, at.M, pole_at_infinity);
    ledger.route("polar diagram");
    const geometry::PlaneMotion<T> motion = motion_by_polar_diagram(instant, at);
    second_order(ledger, motion, motion.inflection_pole(), at);
    if (poles_suffice()) {
      ledger.route("poles");
      const T alpha_2 = geometry::from_rational<T>(instant.alpha_2);
      second_order(ledger, geometry::motion_by_poles(at, instant.omega_2<T>(), alpha_2),
                   geometry::inflection_pole_by_poles(at), at);
    }
    by_analysis(ledger, instant);
    return ledger;
  }
};

// The analytic counterpart of what may be at infinity: the value, or the reason why there is none.
template <class V>
const V& present(const std::optional<V>& found, const char* reason) {
  if (!found) throw geometry::Impossible(reason);
  return *found;
}

template <class T>
void by_analysis(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  using Z = geometry::analytic::Complex<T>;
  const AnalyticSliderCrank<T> found = analytic_slider_crank<T>(instant);
  const auto& p = found.position;
  const auto& m = found.motion;
  const auto coupler = geometry::analytic::coupler(p, m);
  // An entry for a complex number that each entry looks for anew, so that an undecided one leaves the others alone.
  const auto point = [&](const std::string& name, const std::function<Z()>& find) {
    ledger.put(name + "_x", [&] { return find().re; });
    ledger.put(name + "_y", [&] { return find().im; });
  };
  const auto length = [&](const std::string& name, const std::function<Z()>& find) {
    ledger.put(name, [&] { return size(plane(find())); });
  };

  ledger.route("analytic");
  const auto P0 = [&] { return present(coupler.pole(), pole_at_infinity); };
  point("P0", P0);
  length("P0C", [&] { return p.C - P0(); });
  length("P0M", [&] { return p.M - P0(); });
  length("a_A", [&] { return m.a_A; });
  ledger.put("alpha_3", m.alpha_3);
  ledger.put("a_B_x", m.a_B.re);
  length("a_B", [&] { return m.a_B; });
  ledger.vector("a_C", plane(m.a_C));
  ledger.vector("a_M", plane(m.a_M));
  const geometry::Vector<T> AB = plane(p.B - p.A);
  ledger.put("a_BA_n", [&] { return size(geometry::square(m.omega_3) * AB); });
  ledger.put("a_BA_t", [&] { return size(m.alpha_3 * AB); });
  length("a_BA", [&] { return m.a_B - m.a_A; });
  length("a_CA", [&] { return m.a_C - m.a_A; });
  length("a_MA", [&] { return m.a_M - m.a_A; });
  ledger.put("gamma", [&] { return slope_angle(geometry::Vector<T>{geometry::square(m.omega_3), m.alpha_3}); });

  const auto K = [&] { return present(coupler.acceleration_pole(), no_acceleration_pole); };
  point("K", K);
  length("KA", [&] { return p.A - K(); });
  length("KB", [&] { return p.B - K(); });
  length("KC", [&] { return p.C - K(); });
  length("KM", [&] { return p.M - K(); });

  // The diameters as vectors from the pole, so that signs need no roots.
  const auto J = [&] { return present(coupler.inflection_pole(), no_inflection_circle); };
  length("inflection_diameter", [&] { return J() - P0(); });
  point("inflection_centre", [&] { return present(coupler.inflection_circle(), no_inflection_circle).centre; });
  point("inflection_pole", J);
  const auto bresse = [&] { return present(coupler.stationarity_circle(), no_stationarity_circle).centre; };
  length("stationarity_diameter", [&] { return T(2) * (bresse() - P0()); });
  point("stationarity_centre", bresse);
  for (const auto& [X, at] : {std::pair{std::string("C"), p.C}, std::pair{std::string("M"), p.M}}) {
    const Z z = at;
    const auto on_circle = [&coupler, z] { return present(coupler.on_inflection_circle(z), no_point_on_ray); };
    const auto centre = [&coupler, z] { return present(coupler.centre_of_curvature(z), no_curvature); };
    length(X + "prime_" + X, [&] { return on_circle() - z; });
    length("rho_" + X, [&] { return centre() - z; });
    point("curvature_centre_" + X, centre);
    point(X + "prime", on_circle);
  }
}

}  // namespace epure::slider_crank_acceleration
