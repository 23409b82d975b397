// The four-bar's angles and rates by constraint equations, by closed analysis and by the polar diagram.
#pragma once

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/linkages/four_bar_routes.h"

namespace epure::four_bar_constraints {

// What each route finds.
template <class T>
struct Found {
  LinkRates<T> rates;
  MidpointMotion<T> midpoints;
};

template <class T>
geometry::analytic::CrankState<T> crank_of(const FourBarInstant& at) {
  return geometry::analytic::crank_at<T>(at.crank, at.omega_2<T>(), geometry::radians<T>(at.alpha_2));
}

// The middle of a link in its own frame.
template <class T>
geometry::analytic::Complex<T> middle_of(const Rational& length) {
  return {geometry::from_rational<T>(length / 2), T(0)};
}

template <class T>
Found<T> by_constraints(const FourBarInstant& at, const geometry::analytic::Configuration<T>& q) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = at.analytic_lengths();
  const auto m = analytic::motion(crank_of<T>(at), q);
  const auto G2 = analytic::crank_point(q, m, middle_of<T>(g.A0A)),
             G3 = analytic::coupler_point(q, m, middle_of<T>(g.AB)),
             G4 = analytic::rocker_point(q, m, middle_of<T>(g.B0B));
  return {{m.omega_3, m.omega_4, m.alpha_3, m.alpha_4},
          {plane(G2.v), plane(G3.v), plane(G4.v), plane(G2.a), plane(G3.a), plane(G4.a)}};
}

template <class T>
Found<T> by_analysis(const FourBarInstant& at, const geometry::analytic::FourBarPosition<T>& p) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = at.analytic_lengths();
  const auto m = analytic::motion(g, crank_of<T>(at), p);
  const auto crank = analytic::crank(crank_of<T>(at));
  const auto coupler = analytic::coupler(p, m), rocker = analytic::rocker(g, m);
  const auto G2 = analytic::crank_point(p, middle_of<T>(g.A0A)), G3 = analytic::coupler_point(p, middle_of<T>(g.AB)),
             G4 = analytic::rocker_point(g, p, middle_of<T>(g.B0B));
  return {{m.omega_3, m.omega_4, m.alpha_3, m.alpha_4},
          {plane(crank.velocity(G2)), plane(coupler.velocity(G3)), plane(rocker.velocity(G4)),
           plane(crank.acceleration(G2)), plane(coupler.acceleration(G3)), plane(rocker.acceleration(G4))}};
}

template <class T>
Found<T> by_polar_diagram(const FourBarInstant& at, const geometry::FourBar<T>& here) {
  const auto m = motion_by_polar_diagram(here, at.omega_2<T>(), geometry::radians<T>(at.alpha_2));
  return {{m.coupler.omega, m.omega_4, m.coupler.alpha, m.alpha_4},
          midpoint_images(m.coupler.v_A, m.coupler.velocity(here.B), m.coupler.a_A, m.coupler.acceleration(here.B))};
}

template <class T>
void write(Ledger<T>& ledger, const Found<T>& found) {
  write_link_rates(ledger, found.rates);
  write_midpoint_motion(ledger, found.midpoints);
}

template <class T>
LinkDirections<T> analysed_links(const geometry::analytic::FourBarPosition<T>& p) {
  return {plane(p.coupler), plane(-p.rocker)};
}
template <class T>
geometry::analytic::FourBarPosition<T> analysed(const FourBarInstant& at) {
  return geometry::analytic::position(at.analytic_lengths(), crank_of<T>(at), at.analytic_branch());
}

// What is decided is decided once, for all numbers.
struct Routes {
  Problem of;
  HalfTurned back, back_by_analysis;  // links along -x

  explicit Routes(const Problem& problem)
      : of(problem),
        back(half_turned([&]<class T>() { return link_directions(of.instant.position<T>()); })),
        back_by_analysis(half_turned([&]<class T>() { return analysed_links(analysed<T>(of.instant)); })) {}

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("constraint equations");
    write_by_constraints(ledger);
    ledger.route("analytic");
    const auto p = analysed<T>(of.instant);
    write_link_angles(ledger, analysed_links(p), back_by_analysis);
    ledger.put("jacobian_determinant_psi_y", [&] { return T(-p.coupler_cross_rocker); });
    write(ledger, by_analysis(of.instant, p));

    ledger.route("polar diagram");
    const geometry::FourBar<T> at = of.instant.position<T>();
    write_link_angles(ledger, link_directions(at), back);
    ledger.put("jacobian_determinant_psi_y", [&] { return cross(at.B - at.A, at.B0 - at.B); });
    write(ledger, by_polar_diagram(of.instant, at));
    return ledger;
  }

 private:
  // In (-π, π]. The box of an angle that is π may lie about -π as well. Throws Undecided for a box that reaches to
  // one of these from another angle.
  template <class T>
  static T within_turn(const T& angle, bool is_half_turn) {
    using geometry::Sign;
    const T half_turn = geometry::pi<T>();
    if (is_half_turn) return geometry::sign(angle) == Sign::negative ? T(angle + T(2) * half_turn) : angle;
    if (geometry::sign(T(half_turn + angle)) == Sign::positive &&
        geometry::sign(T(half_turn - angle)) == Sign::positive)
      return angle;
    throw geometry::Undecided("on which side of -x a link points", "da quale parte di -x sia rivolto un membro");
  }

  // Near a limit position the iteration, in doubles, may end where more digits lead on to the other branch.
  template <class T>
  void demand_same_branch(const T& determinant) const {
    const bool is_left = of.instant.side == geometry::Side::left;
    if (geometry::sign(determinant) != (is_left ? geometry::Sign::negative : geometry::Sign::positive))
      throw geometry::Undecided("to which branch the iteration leads", "a quale ramo porti l'iterazione");
  }

  template <class T>
  void write_by_constraints(Ledger<T>& ledger) const {
    if constexpr (signs_only<T>) {
      write_undecided(ledger, {"the constraint equations are solved for angles, which are no algebraic numbers",
                               "le equazioni di vincolo si risolvono negli angoli, che non sono numeri algebrici"});
    } else {
      try {
        const auto q =
            geometry::analytic::configuration<T>(of.instant.analytic_lengths(), crank_of<T>(of.instant), of.run);
        demand_same_branch(q.determinant);
        const Found<T> found = by_constraints<T>(of.instant, q);
        write_configuration(ledger, within_turn(q.theta_3, back.coupler), within_turn(q.theta_4, back.rocker),
                            q.determinant);
        write(ledger, found);
      } catch (const geometry::Undecided& open) {
        write_undecided(ledger, open.words());
      }
    }
  }

  template <class T>
  static void write_configuration(Ledger<T>& ledger, const T& theta_3, const T& theta_4, const T& determinant) {
    ledger.put("theta_3", theta_3);
    ledger.put("theta_4", theta_4);
    ledger.put("jacobian_determinant_psi_y", determinant);
  }

  // The same quantities in the same order.
  template <class T>
  static void write_undecided(Ledger<T>& ledger, const Words& why) {
    Ledger<double> names("");
    write_configuration(names, 0.0, 0.0, 0.0);
    write(names, Found<double>{});
    for (const auto& [quantity, route, described] : names.entries())
      ledger.put(quantity, [&]() -> T { throw geometry::Undecided(why); });
  }
};

}  // namespace epure::four_bar_constraints
