// Each instant twice: by the poles with Euler and Savary, and by closed formulas.
#pragma once

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/rolling/found.h"
#include "geometry/analytic/cycloid.h"

namespace epure::cycloid_involute {

inline constexpr Phrase turns_about{
    "M is at a cusp, where it turns about: a_t has one value before (..._before_cusp) and another after "
    "(..._after_cusp)",
    "M è in una cuspide, dove inverte il moto: a_t ha un valore prima (..._before_cusp) e un altro dopo "
    "(..._after_cusp)"};

// An instant in names of quantities, in the subscripts of their letters, and in words.
struct Instant {
  InstantNames names;
  std::string subscript;
  Words when;

  // "#" in the letters stands for the subscript.
  Quantity operator()(const std::string& name, std::string letters, const std::string& unit,
                      const Words& meaning) const {
    if (const auto at = letters.find('#'); at != letters.npos) letters.replace(at, 1, subscript);
    return {names(name), "$" + letters + "$", unit, meaning + when};
  }
};
inline const Instant instant_phi{at_phi, "φ", {", at φ", ", a φ"}},
    instant_s{at_s, "s", {", when s has been travelled", ", percorso lo spazio s"}},
    instant_t1{at_t1, "1", {", at t₁", ", a t₁"}}, instant_t2{at_t2, "2", {", at t₂", ", a t₂"}};

// Without `before` only the value after a cusp belongs to the motion.
template <class T>
void write_acceleration(Ledger<T>& ledger, const Instant& at, const FoundOnPath<T>& found) {
  ledger.put(at("a_M", "a_{M#}", "m/s^2", {"acceleration of M", "accelerazione di M"}),
             [&] { return size(found.a); });
  ledger.put(at("a_M_x", "a_{M#x}", "m/s^2", {"acceleration of M, along x", "accelerazione di M, lungo x"}),
             found.a.x);
  ledger.put(at("a_M_y", "a_{M#y}", "m/s^2", {"acceleration of M, along y", "accelerazione di M, lungo y"}),
             found.a.y);
  ledger.put(at("a_n", "a^{n}_{M#}", "m/s^2", {"normal part of a_M", "parte normale di a_M"}), found.a_n);
  ledger.put(at("a_t", "a^{t}_{M#}", "m/s^2",
                {"tangential part of a_M, positive along the motion",
                 "parte tangenziale di a_M, positiva nel senso del moto"}),
             [&] {
               if (found.before && found.is_at_cusp) throw geometry::Impossible(turns_about);
               return found.after();
             });
  if (!found.before) return;
  Quantity before =
               at("a_t", "a^{t−}_{M#}", "m/s^2",
                  {"tangential part of a_M just before the instant, which is a cusp if the sides differ",
                   "parte tangenziale di a_M subito prima dell'istante, una cuspide se i due lati differiscono"}),
           after = at(
               "a_t", "a^{t+}_{M#}", "m/s^2",
               {"tangential part of a_M just after the instant", "parte tangenziale di a_M subito dopo l'istante"});
  before.name += "_before_cusp";
  after.name += "_after_cusp";
  ledger.put(before, found.before);
  ledger.put(after, found.after);
}

template <class T>
void write(Ledger<T>& ledger, const Instant& at, const FoundOnPath<T>& found) {
  ledger.put(at("x_M", "x_{M#}", "m", {"abscissa of M", "ascissa di M"}), found.x);
  ledger.put(at("y_M", "y_{M#}", "m", {"ordinate of M", "ordinata di M"}), found.y);
  ledger.put(at("P0M", "P_{0}M_{#}", "m", {"distance of M from the contact P₀", "distanza di M dal contatto P₀"}),
             found.P0M);
  ledger.put(at("v_M", "v_{M#}", "m/s", {"speed of M", "velocità di M"}), [&] { return size(found.v); });
  ledger.put(at("v_M_x", "v_{M#x}", "m/s", {"velocity of M, along x", "velocità di M, lungo x"}), found.v.x);
  ledger.put(at("v_M_y", "v_{M#y}", "m/s", {"velocity of M, along y", "velocità di M, lungo y"}), found.v.y);
  write_acceleration(ledger, at, found);
  ledger.put(at("rho_M", "ρ_{M#}", "m", {"radius of curvature of the path", "raggio di curvatura della traiettoria"}),
             found.rho);
  ledger.put(at("curvature_centre_x", "x_{Ω#}", "m",
                {"abscissa of the centre of curvature", "ascissa del centro di curvatura"}),
             found.centre_x);
  ledger.put(at("curvature_centre_y", "y_{Ω#}", "m",
                {"ordinate of the centre of curvature", "ordinata del centro di curvatura"}),
             found.centre_y);
}

template <class T>
FoundOnPath<T> by_natural_equation(const geometry::analytic::CycloidByArc<T>& path, const T& omega) {
  return {.x = [=] { return path.position().re; },
          .y = [=] { return path.height(); },
          .P0M = [=] { return geometry::quotient(path.speed(), omega); },
          .v = plane(path.velocity()),
          .a = plane(path.acceleration()),
          .a_n = [=] { return path.normal_acceleration(); },
          .before = [=] { return path.tangential_acceleration_before(); },
          .after = [=] { return path.tangential_acceleration(); },
          .rho = [=] { return path.radius_of_curvature(); },
          .centre_x = [=] { return path.position().re + path.to_centre_of_curvature().re; },
          .centre_y = [=] { return path.height() + path.to_centre_of_curvature().im; },
          .is_at_cusp = path.is_at_cusp()};
}

inline Quantity time_at_phi() { return instant_phi("time_at_phi", "t_{#}", "s", {"time", "tempo"}); }
inline Quantity arc_at_phi() {
  return instant_phi("arc_length_at_phi", "s_{#}", "m", {"arc travelled", "arco percorso"});
}
inline Quantity to_inflection_circle() {
  return instant_phi(
      "Mprime_M", "M'M_{#}", "m",
      {"distance of M from M' on the inflection circle", "distanza di M da M' sulla circonferenza dei flessi"});
}
inline Quantity K_x() {
  return instant_phi("K_x", "x_{K#}", "m",
                     {"abscissa of the acceleration pole, and inflection pole",
                      "ascissa del polo delle accelerazioni, e dei flessi"});
}
inline Quantity K_y() { return instant_phi("K_y", "y_{K#}", "m", {"ordinate of K", "ordinata di K"}); }
inline Quantity KM() { return instant_phi("KM", "KM_{#}", "m", {"distance of M from K", "distanza di M da K"}); }
inline Quantity inflection_diameter() {
  return {"cycloid.inflection_diameter",
          "$δ$",
          "m",
          {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}};
}
inline Quantity arch_base() {
  return {"cycloid.arch_base", "$πd$", "m", {"base of an arch", "base di un arco di cicloide"}};
}
inline Quantity arch_length() {
  return {"cycloid.arch_length", "$s_{0}$", "m", {"length of an arch", "lunghezza di un arco di cicloide"}};
}

struct CycloidAtPhi {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    constructed(ledger);
    ledger.route("analytic");
    differentiated(ledger);
    measured_arcs(ledger);
    return ledger;
  }

 private:
  geometry::analytic::Roulette cycloid() const { return {geometry::analytic::RouletteKind::cycloid, of.r, 0, of.r}; }

  template <class T>
  void constructed(Ledger<T>& ledger) const {
    const geometry::Rolling wheel = of.wheel();
    const T omega = geometry::radians<T>(of.omega_1);
    const auto at = geometry::rolling_instant<T>(wheel, of.phi, omega, T(0));
    const auto contact = [&] { return geometry::contact_point<T>(wheel, of.phi); };
    const auto K = [&] { return geometry::finite(at.motion.acceleration_pole()) - at.motion.A; };
    // The contact travels at r ω.
    ledger.put(time_at_phi(),
               [&] { return geometry::quotient(contact().x, geometry::from_rational<T>(of.r) * omega); });
    write(ledger, instant_phi, found_by_poles<T>(at, contact));
    ledger.put(to_inflection_circle(), [&] { return size(at.M_prime() - at.M); });
    ledger.put(K_x(), [&] { return contact().x + K().x; });
    ledger.put(K_y(), [&] { return contact().y + K().y; });
    ledger.put(KM(), [&] { return size(at.M - at.motion.A - K()); });
    ledger.put(inflection_diameter(), [&] { return size(at.J - at.motion.A); });
    ledger.put(arch_base(), [&] { return geometry::contact_point<T>(wheel, Angle{1}).x; });
    draws_rolling(ledger, at_phi, at);
  }

  template <class T>
  void differentiated(Ledger<T>& ledger) const {
    const T omega = geometry::radians<T>(of.omega_1);
    const auto path = geometry::analytic::roulette<T>(cycloid(), of.phi);
    const auto motion = path.motion(omega, T(0));
    const auto K = [&] { return present(motion.acceleration_pole(), no_acceleration_pole); };
    ledger.put(time_at_phi(), [&] { return geometry::quotient(geometry::radians<T>(of.phi), omega); });
    write(ledger, instant_phi, found_by_derivatives<T>(path, omega, T(0)));
    // a_n = ω² M'M
    ledger.put(to_inflection_circle(),
               [&] { return geometry::quotient(path.components(omega, T(0)).normal, geometry::square(omega)); });
    ledger.put(K_x(), [&] { return K().re; });
    ledger.put(K_y(), [&] { return K().im; });
    ledger.put(KM(), [&] { return size(plane(path.z - K())); });
    ledger.put(inflection_diameter(),
               [&] { return present(motion.inflection_circle(), no_inflection_circle).diameter; });
    ledger.put(arch_base(), [&] { return geometry::analytic::roulette<T>(cycloid(), Angle{1}).z.re; });
  }

  // By 4 r (1 - cos φ/2), arch by arch, and as an integral.
  template <class T>
  void measured_arcs(Ledger<T>& ledger) const {
    ledger.put(arc_at_phi(), [&] { return geometry::arc_length<T>(of.wheel(), of.phi); });
    ledger.put(arch_length(), [&] { return geometry::arc_length<T>(of.wheel(), Angle{1}); });
    ledger.route("quadrature");
    ledger.put(arc_at_phi(), [&] { return geometry::analytic::arc_length<T>(cycloid(), of.phi); });
    ledger.put(arch_length(), [&] { return geometry::analytic::arc_length<T>(cycloid(), Angle{1}); });
  }
};

struct CycloidAtArc {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    const Quantity angle = instant_s("phi", "φ_{#}", "rad", {"angle of the wheel", "angolo della ruota"})
                               .turned_through(),
                   time = instant_s("t", "t_{#}", "s", {"time", "tempo"});
    const geometry::CycloidArc arc = of.travelled();
    const T omega = geometry::radians<T>(of.omega_1), r = geometry::from_rational<T>(of.r);
    const auto at = geometry::rolling_instant<T>(arc, omega);
    const auto phi = [&] { return geometry::turned_angle<T>(arc); };
    ledger.put(angle, phi);
    ledger.put(time, [&] { return geometry::quotient(phi(), omega); });
    write(ledger, instant_s, found_by_poles<T>(at, [&] { return geometry::Point<T>{r * phi(), T(0)}; }));
    draws_rolling(ledger, at_s, at);

    const geometry::analytic::CycloidByArc<T> path(of.r, of.s, omega);
    ledger.route("natural equation");
    ledger.put(angle, [&] { return path.angle(); });
    ledger.put(time, [&] { return geometry::quotient(path.angle(), omega); });
    write(ledger, instant_s, by_natural_equation<T>(path, omega));
    return ledger;
  }
};

// The motion begins with φ = 0, so that at the cusp there the tangential part is the one after it.
struct OnInvolute {
  const Problem& of;
  const Angle& phi;
  const Instant& instant;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    const Quantity angle =
                       instant("phi", "φ_{#}", "rad", {"angle of the line", "angolo della retta"}).turned_through(),
                   travelled = instant("arc_length", "s_{#}", "m", {"arc travelled", "arco percorso"});
    const auto written = [&](FoundOnPath<T> found) {
      found.before = nullptr;
      write(ledger, instant, found);
    };
    const geometry::Rolling line = of.line();
    const T omega = geometry::radians<T>(of.omega_2);
    const auto at = geometry::rolling_instant<T>(line, phi, omega, T(0));
    ledger.put(angle, [&] {
      return geometry::quotient(geometry::distance(at.motion.A, at.M), geometry::from_rational<T>(of.r_0));
    });
    written(found_by_poles<T>(at, [&] { return geometry::contact_point<T>(line, phi); }));
    ledger.put(travelled, [&] { return geometry::arc_length<T>(line, phi); });
    draws_rolling(ledger, instant.names, at);

    const geometry::analytic::Roulette involute{geometry::analytic::RouletteKind::involute, 0, of.r_0, 0};
    ledger.route("analytic");
    ledger.put(angle, [&] { return geometry::radians<T>(phi); });
    written(found_by_derivatives<T>(geometry::analytic::roulette<T>(involute, phi), omega, T(0)));
    ledger.put(travelled, [&] { return geometry::analytic::arc_length<T>(involute, phi); });
    return ledger;
  }
};

// Instant by instant, so that one that needs many bits or a proof does not hold up the others.
inline std::vector<RouteValue> solved(const Problem& of, Rung rung) {
  std::vector<RouteValue> all = settle(CycloidAtPhi{of}, rung);
  for (const auto& more : {settle(CycloidAtArc{of}, rung), settle(OnInvolute{of, of.phi_1, instant_t1}, rung),
                           settle(OnInvolute{of, of.phi_2, instant_t2}, rung)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace epure::cycloid_involute
