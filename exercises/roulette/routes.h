// Every quantity by the poles, with Euler and Savary, and by closed formulas; the arc by its primitive and by
// quadrature.
#pragma once

#include "exercises/kit/rolling/found.h"
#include "exercises/kit/rolling/rolled.h"

namespace epure::roulette {

inline PointQuantity contact() { return {"P0", {" of the contact, the pole", " del contatto, il polo"}}; }
inline PointQuantity inflection_pole() {
  return {"inflection_pole", {" of the inflection pole", " del polo dei flessi"}, "J"};
}
inline PointQuantity centre_of_curvature() {
  return {"curvature_centre_M", {" of the centre of curvature", " del centro di curvatura"}, "Ω"};
}
inline Quantity normal_part() {
  return normal_acceleration("M").length().meaning_that(
      {"normal part of the acceleration", "parte normale dell'accelerazione"});
}
inline Quantity tangential_part_before() {
  return {"a_M_t_before",
          "$a^{t−}_{M}$",
          "m/s^2",
          {"tangential part, just before the instant", "parte tangenziale, subito prima dell'istante"}};
}
inline Quantity tangential_part_after() {
  return {"a_M_t_after",
          "$a^{t+}_{M}$",
          "m/s^2",
          {"tangential part, just after: another at a cusp only",
           "parte tangenziale, subito dopo: altra solo in una cuspide"}};
}
inline Quantity diameter() {
  return {"inflection_diameter",
          "$δ$",
          "m",
          {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}};
}
inline Quantity to_inflection_circle() {
  return {"Mprime_M",
          "$M'M$",
          "m",
          {"from M to the inflection circle, on the ray from the pole",
           "da M alla circonferenza dei flessi, sul raggio dal polo"}};
}
inline Quantity radius_of_curvature() {
  return {"rho_M", "$ρ_{M}$", "m", {"radius of curvature of the path", "raggio di curvatura della traiettoria"}};
}
inline Quantity arc() {
  return {"s", "$s$", "m", {"arc M has travelled since φ = 0", "arco percorso da M da φ = 0"}};
}
inline Quantity from_pole() {
  return distance("P0", "M").meaning_that({"distance of M from the pole", "distanza di M dal polo"});
}

inline const InstantNames names{.normal = "a_M_n"};

struct Routes {
  RollingGivens given;
  bool has_quadrature;  // which takes long, and tells a drawing nothing new

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("poles");
    by_poles(ledger);
    by_analysis(ledger);
    return ledger;
  }

 private:
  template <class T>
  static void write(Ledger<T>& ledger, const FoundOnPath<T>& found) {
    ledger.put(point("M").x(), found.x);
    ledger.put(point("M").y(), found.y);
    ledger.put(from_pole(), found.P0M);
    ledger.put(velocity("M"), found.v);
    ledger.put(acceleration("M"), found.a);
    ledger.put(normal_part(), found.a_n);
    ledger.put(tangential_part_before(), found.before);
    ledger.put(tangential_part_after(), found.after);
    ledger.put(radius_of_curvature(), found.rho);
    ledger.put(centre_of_curvature().x(), found.centre_x);
    ledger.put(centre_of_curvature().y(), found.centre_y);
  }

  template <class T>
  void by_poles(Ledger<T>& ledger) const {
    using geometry::Vector;
    const geometry::Rolling& rolling = given.rolling;
    const auto at = geometry::rolling_instant<T>(rolling, given.phi, geometry::radians<T>(given.omega),
                                                 geometry::radians<T>(given.alpha));
    // From the contact into the fixed plane. On a line the contact has gone r φ, with a π in it that the exact
    // numbers of a tower have no room for: looked for anew by each quantity that needs it.
    const auto contact_point = [&] { return geometry::contact_point<T>(rolling, given.phi); };
    const auto put_point = [&](const PointQuantity& quantity, const std::function<Vector<T>()>& from_contact) {
      ledger.put(quantity.x(), [&] { return contact_point().x + from_contact().x; });
      ledger.put(quantity.y(), [&] { return contact_point().y + from_contact().y; });
    };
    write(ledger, found_by_poles<T>(at, contact_point));
    put_point(contact(), [&] { return Vector<T>{T(0), T(0)}; });
    ledger.put(diameter(), at.diameter);
    put_point(inflection_pole(), [&] { return at.J - at.motion.A; });
    ledger.put(to_inflection_circle(), [&] { return size(at.M_prime() - at.M); });
    draws_rolling(ledger, names, at);
    ledger.route("primitive");
    ledger.put(arc(), [&] { return geometry::arc_length<T>(rolling, given.phi); });
  }

  template <class T>
  void by_analysis(Ledger<T>& ledger) const {
    using geometry::analytic::Complex;
    ledger.route("analytic");
    const T omega = geometry::radians<T>(given.omega), alpha = geometry::radians<T>(given.alpha);
    const auto closed = closed_form();
    const auto path = geometry::analytic::roulette<T>(closed, given.phi);
    const auto motion = path.motion(T(1), T(0));  // poles and circles do not depend on how fast
    write(ledger, found_by_derivatives<T>(path, omega, alpha));
    // Not motion.pole(): on a line that is r - r above it, which an enclosure cannot tell from zero.
    put_point<T>(ledger, contact(), [&] { return geometry::analytic::contact<T>(closed, given.phi); });
    put_length<T>(ledger, diameter(), [&] { return *motion.inflection_pole() - *motion.pole(); });
    put_point<T>(ledger, inflection_pole(), [&] { return *motion.inflection_pole(); });
    put_length<T>(ledger, to_inflection_circle(), [&]() -> Complex<T> {
      if (path.is_at_rest) return {};  // M, M' and the pole are one
      return *motion.on_inflection_circle(path.z) - path.z;
    });
    if (!has_quadrature) return;
    ledger.route("quadrature");
    ledger.put(arc(), [&] { return geometry::analytic::arc_length<T>(closed, given.phi); });
  }

  geometry::analytic::Roulette closed_form() const {
    using geometry::analytic::RouletteKind;
    const auto& [how, r, R, d] = given.rolling;
    switch (how) {
      case geometry::Rolls::circle_on_line:
        return {RouletteKind::cycloid, r, R, d};
      case geometry::Rolls::circle_outside_circle:
        return {RouletteKind::epicycloid, r, R, d};
      case geometry::Rolls::circle_inside_circle:
        return {RouletteKind::hypocycloid, r, R, d};
      default:
        return {RouletteKind::involute, r, R, d};
    }
  }
};

}  // namespace epure::roulette
