// The welds by their routes: forces by the funicular polygon, stresses by similar triangles and Mohr's circle, the
// throat with the set square; and by equilibrium solved, eigenvalues and closed form.
#pragma once

#include "exercises/crane-welds/quantities.h"
#include "exercises/crane-welds/welds.h"
#include "exercises/kit/proof/ledger.h"
#include "geometry/analytic/stress_formulas.h"
#include "geometry/statics/mohr_circle.h"

namespace epure::crane_welds {

using geometry::fourth_proportional;
using geometry::quotient;
using geometry::root;
using geometry::square;

class Routes {
 public:
  explicit Routes(const Welds& welds) : welds_(welds) {}

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    constructed(ledger);
    calculated(ledger);
    loaded(ledger, welds_.crane.mass);
    ledger.begin_case("mass_600kg.", {", with 600 kg", ", con 600 kg"});
    loaded(ledger, Crane::mass_of_the_source());
    return ledger;
  }

 private:
  template <class T>
  static void put(Ledger<T>& ledger, const std::string& name, const std::function<T()>& find) {
    ledger.put(quantity(name), find);
  }
  template <class T>
  static void put(Ledger<T>& ledger, const std::string& name, const T& value) {
    ledger.put(quantity(name), value);
  }

  // And whether it is above 1, which a sheet tells.
  template <class T>
  static void utilisation(Ledger<T>& ledger, const std::string& name, const std::function<T()>& find) {
    ledger.put(quantity(name), find);
    ledger.tells({name + "_excess", "", "1", {}}, [&] { return find() - T(1); });
  }

  // The height of the right angle of two legs over the face of the fillet.
  template <class T>
  T throat() const {
    const T leg = number<T>(welds_.leg);
    const geometry::Point<T> corner{T(0), T(0)};
    const auto face = geometry::line(geometry::Point<T>{leg, T(0)}, geometry::Point<T>{T(0), leg});
    return geometry::distance(corner, geometry::foot(corner, face));
  }

  template <class T>
  T half_web() const {
    return number<T>(welds_.crane.beam.h() / 2);
  }

  template <class T>
  void constructed(Ledger<T>& ledger) const {
    const auto shape = section<T>(welds_.crane.beam);
    const auto beam = geometry::properties(shape.strips());
    const T base = number<T>(welds_.sigma_amm);
    put(ledger, "A_1", beam.area);
    put(ledger, "A_v1", geometry::rectangle<T>(shape.s, shape.web_height()).area);
    put(ledger, "J_x1", beam.J_x);
    put(ledger, "S_x1", geometry::static_moment<T>({shape.flange()}));
    put<T>(ledger, "a", [&] { return throat<T>(); });
    put(ledger, "sigma_amm_W", fourth_proportional<T>(T(1), base, number<T>(welds_.f)));
    put(ledger, "fillet_allowable_1", fourth_proportional<T>(T(1), base, number<T>(welds_.f_1)));
    put(ledger, "fillet_allowable_2", fourth_proportional<T>(T(1), base, number<T>(welds_.f_2)));
    put(ledger, "fillet_stress_2", T(0));  // neither across the joint nor across the throat does anything act
  }

  template <class T>
  void calculated(Ledger<T>& ledger) const {
    const auto& beam = welds_.crane.beam;
    ledger.route("analytic");
    const auto value = [&](const std::string& name, const Rational& q) { put(ledger, name, number<T>(q)); };
    value("A_1", beam.area());
    value("A_v1", beam.area() - 2 * beam.b * beam.s);
    value("J_x1", beam.J_x());
    value("S_x1", beam.S_flange());
    put<T>(ledger, "a", [&] { return root(number<T>(welds_.leg * welds_.leg / 2)); });
    value("sigma_amm_W", welds_.f * welds_.sigma_amm);
    value("fillet_allowable_1", welds_.f_1 * welds_.sigma_amm);
    value("fillet_allowable_2", welds_.f_2 * welds_.sigma_amm);
    value("fillet_stress_2", 0);
  }

  template <class T>
  void loaded(Ledger<T>& ledger, const Rational& boat) const {
    by_construction(ledger, by_funicular<T>(welds_.crane, boat));
    by_analysis(ledger, beam_of<T>(welds_.crane, boat));
  }

  template <class T>
  void by_construction(Ledger<T>& ledger, const BeamByFunicular<T>& beam) const {
    const auto shape = section<T>(welds_.crane.beam);
    const auto properties = geometry::properties(shape.strips());
    const T C = beam.moment_between(number<T>(welds_.crane.L)), half_depth = quotient(shape.H, T(2));
    ledger.route("funicular polygon");
    put(ledger, "T_1", beam.Y_B());
    put(ledger, "M_C", C);
    ledger.route("construction");
    // From the outer fibre to the joint by similar triangles.
    const T outer = -quotient(C * half_depth, properties.J_x),
            sigma = fourth_proportional<T>(half_depth, outer, half_web<T>());
    const T mean = quotient(beam.Y_B(), shape.s * shape.web_height());
    const T flow = quotient(-beam.Y_B() * geometry::static_moment<T>({shape.flange()}), properties.J_x);
    const T jourawsky = -quotient(flow, shape.s);
    put(ledger, "sigma_par_M", sigma);
    put(ledger, "tau_par_T", mean);
    put(ledger, "tau_par_Jour", jourawsky);
    ledger.tells({"sigma_outer", "$σ_{z}$", "Pa", {}}, [&] { return outer; });
    ledger.route("Mohr's circle");
    const auto circle = geometry::mohr_circle(sigma, mean);
    const T allowed = number<T>(welds_.f * welds_.sigma_amm);
    put<T>(ledger, "sigma_eq", [&] { return circle.equivalent(); });
    put<T>(ledger, "sigma_eq_Jour", [&] { return geometry::mohr_circle(sigma, jourawsky).equivalent(); });
    utilisation<T>(ledger, "full_penetration_utilisation",
                   [&] { return fourth_proportional<T>(allowed, T(1), circle.equivalent()); });
    put(ledger, "Mohr_centre", circle.centre().x);
    put<T>(ledger, "Mohr_radius", [&] { return circle.radius(); });
    put<T>(ledger, "sigma_I", [&] { return circle.sigma_I(); });
    put<T>(ledger, "sigma_II", [&] { return circle.sigma_II(); });
    // From the pole to σ_II: the face along σ_I. (T_1 < 0.)
    put<T>(ledger, "principal_direction", [&] {
      const geometry::Vector<T> along = circle.pole() - geometry::Point<T>{circle.sigma_II(), T(0)};
      return slope_angle(along);
    });
    ledger.route("construction");
    const T first = number<T>(welds_.f_1 * welds_.sigma_amm);
    const auto on_throats = [&] { return quotient(flow, T(2) * throat<T>()); };
    put(ledger, "q", flow);
    ledger.tells({"flange_pull", "$\\it{F}_{C}$", "N", {}}, [&] { return flow * number<T>(welds_.crane.L); });
    put<T>(ledger, "tau_fillet", on_throats);
    put<T>(ledger, "fillet_stress_1", [&] { return geometry::length(geometry::Vector<T>{T(0), mean}); });
    utilisation<T>(ledger, "fillet_utilisation", [&] { return fourth_proportional<T>(first, T(1), -mean); });
    utilisation<T>(ledger, "fillet_throat_utilisation",
                   [&] { return fourth_proportional<T>(first, T(1), on_throats()); });
  }

  // The shear flow from the forces of the flange: what it is pulled with at C and in the middle of BC, over the
  // length between.
  template <class T>
  T flow_between_sections(const geometry::analytic::OverhangingBeam<T>& beam) const {
    const T per_moment = number<T>(welds_.crane.beam.S_flange() / welds_.crane.beam.J_x());
    const T half = quotient(beam.L, T(2));
    return quotient(per_moment * (beam.moment_between(half) - beam.moment_between(beam.L)), half);
  }

  template <class T>
  void by_analysis(Ledger<T>& ledger, const geometry::analytic::OverhangingBeam<T>& beam) const {
    using namespace geometry::analytic;
    const geometry::analytic::DoubleT& of = welds_.crane.beam;
    const T C = beam.moment_between(beam.L), T_C = beam.P - beam.Y_C(), half = number<T>(Rational(1, 2));
    const T sigma = -(C * number<T>(of.h() / (2 * of.J_x()))),
            mean = T_C * number<T>(1 / (of.area() - 2 * of.b * of.s));
    const T flow = flow_between_sections(beam), jourawsky = -(flow * number<T>(1 / of.s));
    const T allowed = number<T>(welds_.f * welds_.sigma_amm), first = number<T>(welds_.f_1 * welds_.sigma_amm);
    const auto magnitude = [&] { return beam.Y_C() - beam.P; };  // of the shear
    ledger.route("analytic");
    put(ledger, "T_1", T_C);
    put(ledger, "M_C", C);
    put(ledger, "sigma_par_M", sigma);
    put(ledger, "tau_par_T", mean);
    put(ledger, "tau_par_Jour", jourawsky);
    put<T>(ledger, "sigma_eq", [&] { return equivalent_stress(sigma, mean); });
    put<T>(ledger, "sigma_eq_Jour", [&] { return equivalent_stress(sigma, jourawsky); });
    put<T>(ledger, "full_penetration_utilisation", [&] { return quotient(equivalent_stress(sigma, mean), allowed); });
    put<T>(ledger, "Mohr_centre", half * sigma);
    put<T>(ledger, "Mohr_radius", [&] {
      const auto [greater, lesser] = principal_stresses(sigma, mean);
      return half * (greater - lesser);
    });
    put<T>(ledger, "sigma_I", [&] { return principal_stresses(sigma, mean).greater; });
    put<T>(ledger, "sigma_II", [&] { return principal_stresses(sigma, mean).lesser; });
    put<T>(ledger, "principal_direction", [&] { return half_the_double_angle<T>(sigma, T(2) * mean); });
    put(ledger, "q", flow);
    put<T>(ledger, "tau_fillet", [&] { return flow * root(number<T>(1 / (2 * welds_.leg * welds_.leg))); });
    put<T>(ledger, "fillet_stress_1", [&] { return magnitude() * number<T>(1 / (of.s * of.h())); });
    put<T>(ledger, "fillet_utilisation", [&] { return quotient(magnitude(), first * number<T>(of.s * of.h())); });
    put<T>(ledger, "fillet_throat_utilisation",
           [&] { return quotient(flow, first * root(number<T>(2 * welds_.leg * welds_.leg))); });
  }

  // ½ arctan(2 |τ|/σ); for signs, its sine's.
  template <class T>
  static T half_the_double_angle(const T& sigma, const T& twice_tau) {
    if constexpr (signs_only<T>) {
      return -twice_tau;
    } else {
      return quotient(geometry::arc_tangent(T(-twice_tau), sigma), T(2));
    }
  }

  Welds welds_;
};

}  // namespace epure::crane_welds
