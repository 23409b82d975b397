// The crane by its routes: funicular polygon, elastic weights, Mohr's circle and the diagrams of strength;
// equilibrium solved and the elastic line integrated; energy.
#pragma once

#include "exercises/boat-crane/quantities.h"
#include "exercises/kit/crane/crane.h"
#include "exercises/kit/proof/ledger.h"
#include "geometry/analytic/stress_formulas.h"
#include "geometry/constructions/proportion.h"
#include "geometry/constructions/vector_polygon.h"
#include "geometry/statics/mohr_circle.h"
#include "geometry/statics/soderberg.h"

namespace epure::boat_crane {

using geometry::root;
using geometry::square;

// What the materials bear, in pascals, and the safety demanded of all checks.
struct Strength {
  Rational sigma_S, Delta_sigma_L, Psi;
  explicit Strength(const Givens& givens)
      : sigma_S(1000000 * givens["sigma_S"]), Delta_sigma_L(1000000 * givens["Delta_sigma_L"]), Psi(givens["Psi"]) {}
};

// What does not depend on the load, as it is constructed.
template <class T>
struct Bodies {
  geometry::DoubleT<T> beam_shape, column_shape;
  geometry::SectionProperties<T> beam, column;
  T J_min, J_max;

  explicit Bodies(const Crane& crane)
      : beam_shape(section<T>(crane.beam)),
        column_shape(section<T>(crane.column)),
        beam(geometry::properties(beam_shape.strips())),
        column(geometry::properties(column_shape.strips())),
        J_min(crane.column_is_weak_about_y() ? column.J_y : column.J_x),
        J_max(crane.column_is_weak_about_y() ? column.J_x : column.J_y) {}

  T half_depth() const { return geometry::quotient(beam_shape.H, T(2)); }
  T W() const { return geometry::quotient(beam.J_x, half_depth()); }
  T radius_of_gyration(const T& J) const {
    return geometry::mean_proportional<T>(geometry::quotient(J, column.area), T(1));
  }
};

class Routes {
 public:
  Routes(const Crane& crane, const Strength& strength) : crane_(crane), strength_(strength) {}

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    constructed(ledger);
    calculated(ledger);
    highest(ledger);
    loaded(ledger, crane_.mass);
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

  // Euler's stress on the hyperbola π² E/λ².
  template <class T>
  T load_on_hyperbola(const Bodies<T>& bodies, const T& J) const {
    const T slenderness = geometry::quotient(number<T>(crane_.H_0), bodies.radius_of_gyration(J));
    return bodies.column.area *
           geometry::quotient(square(geometry::pi<T>()) * number<T>(crane_.E), square(slenderness));
  }

  template <class T>
  void constructed(Ledger<T>& ledger) const {
    const Bodies<T> of(crane_);
    const T safety = number<T>(strength_.Psi);
    put(ledger, "A_1", of.beam.area);
    put(ledger, "J_x1", of.beam.J_x);
    put(ledger, "J_y1", of.beam.J_y);
    put(ledger, "W_x1", of.W());
    put(ledger, "S_x1_max", geometry::static_moment(of.beam_shape.upper_half()));
    put(ledger, "A_2", of.column.area);
    put(ledger, "J_x2", of.column.J_x);
    put(ledger, "J_y2", of.column.J_y);
    put(ledger, "sigma_amm", geometry::fourth_proportional<T>(safety, T(1), number<T>(strength_.sigma_S)));
    put(ledger, "Delta_sigma_Lamm",
        geometry::fourth_proportional<T>(safety, T(1), number<T>(strength_.Delta_sigma_L)));
    put(ledger, "J_min", of.J_min);
    put<T>(ledger, "i_min", [&] { return of.radius_of_gyration(of.J_min); });
    put<T>(ledger, "slenderness", [&] {
      return geometry::fourth_proportional<T>(of.radius_of_gyration(of.J_min), T(1), number<T>(crane_.H_0));
    });
    put<T>(ledger, "slenderness_limit", [&] {
      return root(geometry::quotient(square(geometry::pi<T>()) * number<T>(crane_.E), number<T>(strength_.sigma_S)));
    });
    put<T>(ledger, "P_cr", [&] { return load_on_hyperbola(of, of.J_min); });
    put<T>(ledger, "P_cr_strong_axis", [&] { return load_on_hyperbola(of, of.J_max); });
    put<T>(ledger, "P_cr_over_Psi",
           [&] { return geometry::fourth_proportional<T>(safety, T(1), load_on_hyperbola(of, of.J_min)); });
  }

  Rational J_min() const { return crane_.column_is_weak_about_y() ? crane_.column.J_y() : crane_.column.J_x(); }
  Rational J_max() const { return crane_.column_is_weak_about_y() ? crane_.column.J_x() : crane_.column.J_y(); }
  template <class T>
  T critical_load() const {
    return geometry::analytic::euler_load<T>(crane_.E, J_min(), crane_.H_0);
  }

  template <class T>
  void calculated(Ledger<T>& ledger) const {
    ledger.route("analytic");
    const auto value = [&](const std::string& name, const Rational& q) { put(ledger, name, number<T>(q)); };
    value("A_1", crane_.beam.area());
    value("J_x1", crane_.beam.J_x());
    value("J_y1", crane_.beam.J_y());
    value("W_x1", crane_.beam.W_x());
    value("S_x1_max", crane_.beam.S_half());
    value("A_2", crane_.column.area());
    value("J_x2", crane_.column.J_x());
    value("J_y2", crane_.column.J_y());
    value("sigma_amm", strength_.sigma_S / strength_.Psi);
    value("Delta_sigma_Lamm", strength_.Delta_sigma_L / strength_.Psi);
    value("J_min", J_min());
    put<T>(ledger, "i_min", [&] { return root(number<T>(J_min() / crane_.column.area())); });
    put<T>(ledger, "slenderness",
           [&] { return root(number<T>(crane_.H_0 * crane_.H_0 * crane_.column.area() / J_min())); });
    put<T>(ledger, "slenderness_limit",
           [&] { return geometry::pi<T>() * root(number<T>(crane_.E / strength_.sigma_S)); });
    put<T>(ledger, "P_cr", [&] { return critical_load<T>(); });
    put<T>(ledger, "P_cr_strong_axis",
           [&] { return geometry::analytic::euler_load<T>(crane_.E, J_max(), crane_.H_0); });
    put<T>(ledger, "P_cr_over_Psi",
           [&] { return geometry::analytic::euler_load<T>(crane_.E / strength_.Psi, J_min(), crane_.H_0); });
  }

  template <class T>
  void loaded(Ledger<T>& ledger, const Rational& boat) const {
    const Bodies<T> of(crane_);
    const BeamByFunicular<T> beam = by_funicular<T>(crane_, boat);
    in_equilibrium(ledger, beam);
    displaced(ledger, of, beam, by_elastic_weights(crane_, boat, beam, of.beam.J_x));
    beam_checked(ledger, of, beam);
    column_checked(ledger, of, beam);
    by_analysis(ledger, boat);
    by_energy(ledger, boat);
  }

  template <class T>
  void in_equilibrium(Ledger<T>& ledger, const BeamByFunicular<T>& beam) const {
    const T L = number<T>(crane_.L), half = number<T>(Rational(1, 2)), C = beam.moment_between(L);
    const auto& corners = beam.polygon.corners;
    ledger.route("funicular polygon");
    put<T>(ledger, "P", corners.front() - corners.back());
    put(ledger, "Y_A", beam.Y_A());
    put(ledger, "X_B", geometry::closing_side<T>({T(0), beam.Y_A() + beam.Y_B() - beam.P}, {T(0), T(0)}).x);
    put(ledger, "Y_B", beam.Y_B());
    put<T>(ledger, "R_B", -beam.Y_B());
    // How much the bounding strings fall over a unit of length, times the pole distance.
    const auto shear = [&](const geometry::Line<T>& string) {
      return -(beam.polygon.pole.distance * beam.polygon.slope(string));
    };
    put(ledger, "T_1_BC", shear(beam.supports.closing));
    put(ledger, "T_1_CD", shear(beam.polygon.strings[1]));
    put(ledger, "M_1_mid_BC", beam.moment_between(half * L));
    put(ledger, "M_C", C);
    put<T>(ledger, "M_1_mid_CD", beam.moment_beyond(L + L));
    put<T>(ledger, "N_2", -beam.Y_A());
    put<T>(ledger, "moment_area_BC", half * L * C);
    put<T>(ledger, "moment_area_CD", L * C);
    ledger.tells({"pole_distance", "$h$", "N", {}}, [&] { return beam.polygon.pole.distance; });
    ledger.tells({"moment_ordinate", "$y_{C}$", "m", {}},
                 [&] { return geometry::ordinate(beam.supports.closing, L); });
  }

  // C goes down with the column's head; D as many times as far as it is farther from B.
  template <class T>
  void displaced(Ledger<T>& ledger, const Bodies<T>& of, const BeamByFunicular<T>& beam,
                 const ElasticLine<T>& elastic) const {
    const T D = number<T>(3 * crane_.L), bent = elastic.rise(elastic.tangent_D(), D);
    const T shortening = geometry::quotient(beam.Y_A(), of.column.area) *
                         geometry::quotient(number<T>(crane_.H_0), number<T>(crane_.E));
    const T carried = geometry::fourth_proportional<T>(elastic.L, -shortening, D);
    ledger.route("elastic weights");
    put(ledger, "theta_B", elastic.turn(elastic.tangent_B()));
    put(ledger, "theta_C", elastic.turn(elastic.tangent_C()));
    put(ledger, "theta_D", elastic.turn(elastic.tangent_D()));
    put<T>(ledger, "v_max_BC", [&] { return elastic.greatest_rise(); });
    put(ledger, "v_D_bending", bent);
    put(ledger, "column_shortening", shortening);
    put<T>(ledger, "v_D", carried + bent);
    ledger.tells({"enlargement", "$n$", "1", {}}, [&] { return elastic.n; });
    ledger.tells({"elastic_pole_distance", "$\\it{EJ}/n$", "N*m^2", {}},
                 [&] { return elastic.polygon.pole.distance; });
    ledger.tells({"axis_at_C", "", "m", {}}, [&] { return geometry::ordinate(elastic.axis, elastic.L); });
    ledger.tells({"tangent_at_D", "", "m", {}}, [&] { return geometry::ordinate(elastic.tangent_D(), D); });
    ledger.tells({"v_D_carried", "$v_{D,r}$", "m", {}}, [&] { return carried; });
  }

  template <class T>
  void beam_checked(Ledger<T>& ledger, const Bodies<T>& of, const BeamByFunicular<T>& beam) const {
    const T C = beam.moment_between(number<T>(crane_.L)), T_C = beam.Y_B();
    const T sigma = -geometry::quotient(C, of.W()), all = geometry::quotient(T_C, of.beam.area);
    const T web = geometry::quotient(T_C, of.beam_shape.s * of.beam_shape.web_height());
    const T S = geometry::static_moment(of.beam_shape.upper_half());
    const T sigma_S = number<T>(strength_.sigma_S), range = number<T>(strength_.Delta_sigma_L);
    const auto safety = number<T>(strength_.Psi);
    const auto equivalent = [&] { return geometry::mohr_circle(sigma, all).equivalent(); };
    ledger.route("construction");
    put(ledger, "sigma_z_max", sigma);
    put(ledger, "tau_zy", all);
    put(ledger, "tau_web_mean", web);
    put(ledger, "tau_max_Jourawsky", geometry::quotient(T_C * S, of.beam.J_x * of.beam_shape.s));
    ledger.route("Mohr's circle");
    put<T>(ledger, "sigma_eq", equivalent);
    put<T>(ledger, "sigma_eq_web_shear", [&] { return geometry::mohr_circle(sigma, web).equivalent(); });
    ledger.tells({"sigma_I", "$σ_{I}$", "Pa", {}}, [&] { return geometry::mohr_circle(sigma, all).sigma_I(); });
    ledger.tells({"sigma_II", "$σ_{II}$", "Pa", {}}, [&] { return geometry::mohr_circle(sigma, all).sigma_II(); });
    ledger.route("construction");
    utilisation<T>(ledger, "beam_static_utilisation",
                   [&] { return geometry::fourth_proportional<T>(sigma_S, safety, equivalent()); });
    put(ledger, "Delta_sigma", sigma);
    const T mean = number<T>(Rational(1, 2)) * sigma;
    put(ledger, "sigma_m", mean);
    const auto effective = [&] { return geometry::range_without_mean(mean, sigma, sigma_S); };
    put<T>(ledger, "Delta_sigma_eff", effective);
    utilisation<T>(ledger, "beam_fatigue_utilisation",
                   [&] { return geometry::fourth_proportional<T>(range, safety, effective()); });
  }

  template <class T>
  void column_checked(Ledger<T>& ledger, const Bodies<T>& of, const BeamByFunicular<T>& beam) const {
    const T sigma = -geometry::quotient(beam.Y_A(), of.column.area), mean = number<T>(Rational(1, 2)) * sigma;
    const T sigma_S = number<T>(strength_.sigma_S), range = number<T>(strength_.Delta_sigma_L);
    const T safety = number<T>(strength_.Psi);
    ledger.route("construction");
    put(ledger, "sigma_zN", sigma);
    utilisation<T>(ledger, "column_static_utilisation",
                   [&] { return geometry::fourth_proportional<T>(sigma_S, safety, -sigma); });
    put(ledger, "sigma_m2", mean);
    const T effective = geometry::range_without_mean(mean, sigma, sigma_S);
    put(ledger, "Delta_sigma_eff2", effective);
    put<T>(ledger, "Delta_sigma_eff2_conservative",
           [&] { return geometry::range_without_mean<T>(-mean, -sigma, sigma_S); });
    utilisation<T>(ledger, "column_fatigue_utilisation",
                   [&] { return geometry::fourth_proportional<T>(range, safety, -effective); });
    const auto safe = [&] { return geometry::quotient(load_on_hyperbola(of, of.J_min), beam.Y_A()); };
    utilisation<T>(ledger, "buckling_utilisation",
                   [&] { return geometry::fourth_proportional<T>(safe(), T(1), safety); });
    put<T>(ledger, "buckling_safety_factor", safe);
  }

  // Of any load.
  template <class T>
  void highest(Ledger<T>& ledger) const {
    const Bodies<T> of(crane_);
    const auto beam = by_funicular<T>(crane_, crane_.mass);
    ledger.route("elastic weights");
    put<T>(ledger, "xi_v_max_BC",
           [&] { return by_elastic_weights(crane_, crane_.mass, beam, of.beam.J_x).highest(); });
    ledger.route("analytic");
    put<T>(ledger, "xi_v_max_BC", [&] { return beam_of<T>(crane_, crane_.mass).xi_of_greatest_v(); });
  }

  template <class T>
  void by_analysis(Ledger<T>& ledger, const Rational& boat) const {
    const auto beam = beam_of<T>(crane_, boat);
    const T L = number<T>(crane_.L), half = number<T>(Rational(1, 2)), C = beam.moment_between(L);
    ledger.route("analytic");
    put(ledger, "P", number<T>(boat * crane_.g));
    put(ledger, "Y_A", beam.Y_C());
    put(ledger, "X_B", T(0));  // no force is inclined
    put(ledger, "Y_B", beam.Y_B());
    put<T>(ledger, "R_B", beam.Y_C() - beam.P);
    put<T>(ledger, "T_1_BC", beam.P - beam.Y_C());  // of what is on the right
    put(ledger, "T_1_CD", beam.P);
    put(ledger, "M_1_mid_BC", beam.moment_between(half * L));
    put(ledger, "M_C", C);
    put<T>(ledger, "M_1_mid_CD", beam.moment_beyond(L + L));
    put<T>(ledger, "N_2", beam.Y_B() - beam.P);
    put(ledger, "moment_area_BC", beam.area_between());
    put(ledger, "moment_area_CD", beam.area_beyond());
    put(ledger, "theta_B", beam.theta_B());
    put(ledger, "theta_C", beam.theta_C());
    put(ledger, "theta_D", beam.theta_D());
    put<T>(ledger, "v_max_BC", [&] { return beam.v_between(beam.xi_of_greatest_v()); });
    put(ledger, "v_D_bending", beam.v_D());
    const T shortening = beam.Y_C() * number<T>(crane_.H_0 / (crane_.E * crane_.column.area()));
    put(ledger, "column_shortening", shortening);
    put<T>(ledger, "v_D", beam.v_D() - T(3) * shortening);
    strength_of_beam(ledger, C, beam.Y_B());
    strength_of_column(ledger, beam.Y_C());
  }

  // Each check from the forces again, not from the stress before.
  template <class T>
  void strength_of_beam(Ledger<T>& ledger, const T& C, const T& shear) const {
    using namespace geometry::analytic;
    const DoubleT& beam = crane_.beam;
    const T sigma = -(C * number<T>(beam.H / (2 * beam.J_x()))), all = shear * number<T>(1 / beam.area());
    const T web = shear * number<T>(1 / (beam.s * beam.h()));
    const auto of_principal = [](const T& normal, const T& tangential) {
      const auto [greater, lesser] = principal_stresses(normal, tangential);
      return root(square(greater) - greater * lesser + square(lesser));
    };
    put(ledger, "sigma_z_max", sigma);
    put(ledger, "tau_zy", all);
    put<T>(ledger, "sigma_eq", [&] { return of_principal(sigma, all); });
    put(ledger, "tau_web_mean", web);
    put(ledger, "tau_max_Jourawsky", greatest_web_shear(beam, shear));
    put<T>(ledger, "sigma_eq_web_shear", [&] { return of_principal(sigma, web); });
    put<T>(ledger, "beam_static_utilisation",
           [&] { return equivalent_stress(sigma, all) * number<T>(strength_.Psi / strength_.sigma_S); });
    put(ledger, "Delta_sigma", sigma);
    put<T>(ledger, "sigma_m", -(C * number<T>(beam.H / (4 * beam.J_x()))));
    const auto effective = [&] { return without_mean(sigma); };
    put<T>(ledger, "Delta_sigma_eff", effective);
    put<T>(ledger, "beam_fatigue_utilisation",
           [&] { return effective() * number<T>(strength_.Psi / strength_.Delta_sigma_L); });
  }

  // Of a stress from nought to this.
  template <class T>
  T without_mean(const T& sigma) const {
    return geometry::analytic::soderberg<T>(sigma, sigma * number<T>(Rational(1, 2)), number<T>(strength_.sigma_S),
                                            geometry::mean_stress_yields);
  }

  template <class T>
  void strength_of_column(Ledger<T>& ledger, const T& load) const {
    const T sigma = -(load * number<T>(1 / crane_.column.area()));
    put(ledger, "sigma_zN", sigma);
    put<T>(ledger, "column_static_utilisation",
           load * number<T>(strength_.Psi / (crane_.column.area() * strength_.sigma_S)));
    put<T>(ledger, "sigma_m2", -(load * number<T>(1 / (2 * crane_.column.area()))));
    put(ledger, "Delta_sigma_eff2", without_mean(sigma));
    put<T>(ledger, "Delta_sigma_eff2_conservative", [&] { return without_mean<T>(-sigma); });
    put<T>(ledger, "column_fatigue_utilisation",
           -(without_mean(sigma) * number<T>(strength_.Psi / strength_.Delta_sigma_L)));
    put<T>(ledger, "buckling_utilisation",
           [&] { return geometry::quotient(number<T>(strength_.Psi) * load, critical_load<T>()); });
    put<T>(ledger, "buckling_safety_factor", [&] { return geometry::quotient(critical_load<T>(), load); });
  }

  // Clapeyron: the work of P on its way is twice the energy of the beam, or of beam and column.
  template <class T>
  void by_energy(Ledger<T>& ledger, const Rational& boat) const {
    const auto beam = beam_of<T>(crane_, boat);
    const T column = geometry::quotient(square(beam.Y_C()) * number<T>(crane_.H_0),
                                        T(2) * number<T>(crane_.E * crane_.column.area()));
    ledger.route("energy");
    put<T>(ledger, "v_D_bending", -geometry::quotient(T(2) * beam.energy(), beam.P));
    put<T>(ledger, "v_D", -geometry::quotient(T(2) * (beam.energy() + column), beam.P));
  }

  Crane crane_;
  Strength strength_;
};

}  // namespace epure::boat_crane
