// Each instant twice: by the poles with Euler and Savary, and by closed formulas.
#pragma once

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "geometry/analytic/cycloid.h"
#include "geometry/analytic/roulette_formulas.h"

namespace epure::cycloid_involute {

inline constexpr Phrase turns_about{
    "M is at a cusp, where it turns about: a_t has one value before (..._before_cusp) and another after "
    "(..._after_cusp)",
    "M è in una cuspide, dove inverte il moto: a_t ha un valore prima (..._before_cusp) e un altro dopo "
    "(..._after_cusp)"};

template <class T>
struct Components {
  T before, after, normal;
};

// The tangential part where it has one value; at a cusp it has two.
template <class T>
T along_the_motion(bool is_at_cusp, const T& after) {
  if (is_at_cusp) throw geometry::Impossible(turns_about);
  return after;
}

template <class T>
void write_vector(Ledger<T>& ledger, const InstantNames& name, const std::string& letter,
                  const geometry::Vector<T>& v) {
  ledger.put(name(letter + "_x"), v.x);
  ledger.put(name(letter + "_y"), v.y);
  ledger.put(name(letter), [&] { return size(v); });
}

template <class T>
void write_sides(Ledger<T>& ledger, const InstantNames& name, const std::function<Components<T>()>& find) {
  ledger.put(name("a_t") + "_before_cusp", [&] { return find().before; });
  ledger.put(name("a_t") + "_after_cusp", [&] { return find().after; });
}

// By the poles: M seen from the contact P₀, which `contact` finds in the fixed plane.
template <class T>
void write_instant(Ledger<T>& ledger, const InstantNames& name, const geometry::RollingInstant<T>& at,
                   const std::function<geometry::Point<T>()>& contact) {
  const geometry::Vector<T> P0M = at.M - at.motion.A;
  ledger.put(name("x_M"), [&] { return contact().x + P0M.x; });
  ledger.put(name("y_M"), [&] { return contact().y + P0M.y; });
  ledger.put(name("P0M"), [&] { return size(P0M); });
  write_vector(ledger, name, "v_M", at.velocity());
  write_vector(ledger, name, "a_M", at.acceleration());
  ledger.put(name("a_n"), [&] { return size(at.normal_acceleration()); });
  ledger.put(name("rho_M"), [&] { return at.radius_of_curvature(); });
  const auto centre = [&] { return geometry::finite(at.centre_of_curvature()) - at.motion.A; };
  ledger.put(name("curvature_centre_x"), [&] { return contact().x + centre().x; });
  ledger.put(name("curvature_centre_y"), [&] { return contact().y + centre().y; });
}

template <class T>
Components<T> components(const geometry::RollingInstant<T>& at) {
  const auto sides = at.tangential_component();
  return {sides.before, sides.after, at.normal_component()};
}

// By the path's derivatives.
template <class T>
void write_instant(Ledger<T>& ledger, const InstantNames& name, const geometry::analytic::RoulettePath<T>& path,
                   const T& omega) {
  ledger.put(name("x_M"), path.z.re);
  ledger.put(name("y_M"), path.z.im);
  ledger.put(name("P0M"), [&] { return size(plane(path.z_prime)); });
  write_vector(ledger, name, "v_M", plane(path.velocity(omega)));
  write_vector(ledger, name, "a_M", plane(path.acceleration(omega, T(0))));
  ledger.put(name("a_n"), [&] { return path.components(omega, T(0)).normal; });
  ledger.put(name("rho_M"), [&] { return path.radius_of_curvature(); });
  ledger.put(name("curvature_centre_x"), [&] { return path.centre_of_curvature().re; });
  ledger.put(name("curvature_centre_y"), [&] { return path.centre_of_curvature().im; });
}

template <class T>
struct CycloidAtPhi {
  const Problem& of;
  Ledger<T>& ledger;

  void by_poles() const {
    const geometry::Rolling wheel = of.wheel();
    const T omega = geometry::radians<T>(of.omega_1);
    const auto at = geometry::rolling_instant<T>(wheel, of.phi, omega, T(0));
    const auto contact = [&] { return geometry::contact_point<T>(wheel, of.phi); };
    const auto K = [&] { return geometry::finite(at.motion.acceleration_pole()) - at.motion.A; };
    ledger.route("poles");
    // The contact travels at r ω.
    ledger.put(at_phi("time_at_phi"), [&] {
      return geometry::quotient(contact().x, geometry::from_rational<T>(of.r) * geometry::radians<T>(of.omega_1));
    });
    write_instant<T>(ledger, at_phi, at, contact);
    ledger.put(at_phi("a_t"), [&] { return along_the_motion(at.is_at_cusp, components(at).after); });
    write_sides<T>(ledger, at_phi, [&] { return components(at); });
    ledger.put(at_phi("Mprime_M"), [&] { return size(at.M_prime() - at.M); });
    ledger.put(at_phi("K_x"), [&] { return contact().x + K().x; });
    ledger.put(at_phi("K_y"), [&] { return contact().y + K().y; });
    ledger.put(at_phi("KM"), [&] { return size(at.M - at.motion.A - K()); });
    ledger.put("cycloid.inflection_diameter", [&] { return size(at.J - at.motion.A); });
    ledger.put("cycloid.arch_base", [&] { return geometry::contact_point<T>(wheel, Angle{1}).x; });
  }

  void by_derivatives() const {
    const T omega = geometry::radians<T>(of.omega_1);
    const auto path = geometry::analytic::roulette<T>(cycloid(), of.phi);
    const auto motion = path.motion(omega, T(0));
    const auto parts = [&]() -> Components<T> {
      const auto found = path.components(omega, T(0));
      return {found.before, found.after, found.normal};
    };
    const auto K = [&] { return present(motion.acceleration_pole(), no_acceleration_pole); };
    ledger.route("analytic");
    ledger.put(at_phi("time_at_phi"), [&] { return geometry::quotient(geometry::radians<T>(of.phi), omega); });
    write_instant<T>(ledger, at_phi, path, omega);
    ledger.put(at_phi("a_t"), [&] { return along_the_motion(path.is_at_rest, parts().after); });
    write_sides<T>(ledger, at_phi, parts);
    // a_n = ω² M'M
    ledger.put(at_phi("Mprime_M"), [&] { return geometry::quotient(parts().normal, geometry::square(omega)); });
    ledger.put(at_phi("K_x"), [&] { return K().re; });
    ledger.put(at_phi("K_y"), [&] { return K().im; });
    ledger.put(at_phi("KM"), [&] { return size(plane(path.z - K())); });
    ledger.put("cycloid.inflection_diameter",
               [&] { return present(motion.inflection_circle(), no_inflection_circle).diameter; });
    ledger.put("cycloid.arch_base", [&] { return geometry::analytic::roulette<T>(cycloid(), Angle{1}).z.re; });
  }

  // By 4 r (1 - cos φ/2), arch by arch, and as an integral.
  void arcs() const {
    ledger.route("analytic");
    ledger.put(at_phi("arc_length_at_phi"), [&] { return geometry::arc_length<T>(of.wheel(), of.phi); });
    ledger.put(at_phi("arch_length"), [&] { return geometry::arc_length<T>(of.wheel(), Angle{1}); });
    ledger.route("quadrature");
    ledger.put(at_phi("arc_length_at_phi"), [&] { return geometry::analytic::arc_length<T>(cycloid(), of.phi); });
    ledger.put(at_phi("arch_length"), [&] { return geometry::analytic::arc_length<T>(cycloid(), Angle{1}); });
  }

 private:
  geometry::analytic::Roulette cycloid() const { return {geometry::analytic::RouletteKind::cycloid, of.r, 0, of.r}; }
};

template <class T>
struct CycloidAtArc {
  const Problem& of;
  Ledger<T>& ledger;

  void by_poles() const {
    const geometry::CycloidArc arc = of.travelled();
    const T omega = geometry::radians<T>(of.omega_1), r = geometry::from_rational<T>(of.r);
    const auto at = geometry::rolling_instant<T>(arc, omega);
    const auto phi = [&] { return geometry::turned_angle<T>(arc); };
    ledger.route("poles");
    ledger.put(at_s("phi"), phi);
    ledger.put(at_s("t"), [&] { return geometry::quotient(phi(), omega); });
    write_instant<T>(ledger, at_s, at, [&] { return geometry::Point<T>{r * phi(), T(0)}; });
    ledger.put(at_s("a_t"), [&] { return along_the_motion(at.is_at_cusp, components(at).after); });
    write_sides<T>(ledger, at_s, [&] { return components(at); });
  }

  void by_natural_equation() const {
    const T omega = geometry::radians<T>(of.omega_1);
    const geometry::analytic::CycloidByArc<T> path(of.r, of.s, omega);
    ledger.route("natural equation");
    ledger.put(at_s("phi"), [&] { return path.angle(); });
    ledger.put(at_s("t"), [&] { return geometry::quotient(path.angle(), omega); });
    ledger.put(at_s("x_M"), [&] { return path.position().re; });
    ledger.put(at_s("y_M"), path.height());
    ledger.put(at_s("P0M"), [&] { return geometry::quotient(path.speed(), omega); });
    write_vector(ledger, at_s, "v_M", plane(path.velocity()));
    write_vector(ledger, at_s, "a_M", plane(path.acceleration()));
    ledger.put(at_s("a_n"), path.normal_acceleration());
    ledger.put(at_s("rho_M"), path.radius_of_curvature());
    ledger.put(at_s("curvature_centre_x"), [&] { return path.position().re + path.to_centre_of_curvature().re; });
    ledger.put(at_s("curvature_centre_y"), [&] { return path.height() + path.to_centre_of_curvature().im; });
    ledger.put(at_s("a_t"), [&] { return along_the_motion(path.is_at_cusp(), path.tangential_acceleration()); });
    write_sides<T>(ledger, at_s, [&]() -> Components<T> {
      return {path.tangential_acceleration_before(), path.tangential_acceleration(), path.normal_acceleration()};
    });
  }
};

// The motion begins with φ = 0, so that at the cusp there the tangential part is the one after it.
template <class T>
struct OnInvolute {
  const Problem& of;
  const Angle& phi;
  const InstantNames& name;
  Ledger<T>& ledger;

  void by_poles() const {
    const geometry::Rolling line = of.line();
    const auto at = geometry::rolling_instant<T>(line, phi, geometry::radians<T>(of.omega_2), T(0));
    ledger.route("poles");
    ledger.put(name("phi"), [&] {
      return geometry::quotient(geometry::distance(at.motion.A, at.M), geometry::from_rational<T>(of.r_0));
    });
    write_instant<T>(ledger, name, at, [&] { return geometry::contact_point<T>(line, phi); });
    ledger.put(name("a_t"), [&] { return components(at).after; });
    ledger.put(name("arc_length"), [&] { return geometry::arc_length<T>(line, phi); });
  }

  void by_derivatives() const {
    const geometry::analytic::Roulette involute{geometry::analytic::RouletteKind::involute, 0, of.r_0, 0};
    const T omega = geometry::radians<T>(of.omega_2);
    const auto path = geometry::analytic::roulette<T>(involute, phi);
    ledger.route("analytic");
    ledger.put(name("phi"), [&] { return geometry::radians<T>(phi); });
    write_instant<T>(ledger, name, path, omega);
    ledger.put(name("a_t"), [&] { return path.components(omega, T(0)).after; });
    ledger.put(name("arc_length"), [&] { return geometry::analytic::arc_length<T>(involute, phi); });
  }
};

}  // namespace epure::cycloid_involute
