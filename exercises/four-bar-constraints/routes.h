// The four-bar's angles and rates by constraint equations, by closed analysis and by the polar diagram.
#pragma once

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/linkages/four_bar_on_x.h"
#include "exercises/kit/linkages/four_bar_routes.h"
#include "geometry/analytic/constraints.h"

namespace epure::four_bar_constraints {

// ψ_q = (ψ_x, ψ_y): row 1 or 2 by the angle of link 2, 3 or 4.
inline Quantity jacobian(int row, int link) {
  const std::string r = std::to_string(row), i = std::to_string(link);
  return {"jacobian_psi_" + r + "_theta_" + i, "$∂ψ_{" + r + "}/∂θ_{" + i + "}$", "m",
          format_words("derivative of constraint {} by the angle of link {}",
                       "derivata del vincolo {} rispetto all'anomalia del membro {}", r, i)};
}
inline Quantity determinant() {
  return {"jacobian_determinant_psi_y",
          "det $ψ_{\\it{y}}$",
          "m^2",
          {"determinant of the constraints' Jacobian", "determinante dello jacobiano dei vincoli"}};
}

// What each route finds.
template <class T>
struct Found {
  LinkRates<T> rates;
  MidpointMotion<T> midpoints;
  T determinant;
  std::array<geometry::Vector<T>, 3> columns;  // of ψ_q
};

template <class T>
void write(Ledger<T>& ledger, const Found<T>& found) {
  write_link_rates(ledger, found.rates);
  write_midpoint_motion(ledger, found.midpoints);
  ledger.put(determinant(), found.determinant);
  for (int i = 0; i < 3; ++i) {
    ledger.put(jacobian(1, i + 2), found.columns[static_cast<std::size_t>(i)].x);
    ledger.put(jacobian(2, i + 2), found.columns[static_cast<std::size_t>(i)].y);
  }
}

template <class T>
geometry::analytic::CrankState<T> crank_of(const FourBarInstant& at) {
  return geometry::analytic::crank_at<T>(at.crank, at.omega_2<T>(), geometry::radians<T>(at.alpha_2));
}

// The middle of a link in its own frame.
template <class T>
geometry::analytic::Complex<T> middle_of(const Rational& length) {
  return {geometry::from_rational<T>(length / 2), T(0)};
}

// The Jacobian from the sines and cosines of the angles.
template <class T>
Found<T> by_constraints(const FourBarInstant& at, const geometry::analytic::Configuration<T>& q) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = at.analytic_lengths();
  const auto m = analytic::motion(crank_of<T>(at), q);
  const auto G2 = analytic::crank_point(q, m, middle_of<T>(g.A0A)),
             G3 = analytic::coupler_point(q, m, middle_of<T>(g.AB)),
             G4 = analytic::rocker_point(q, m, middle_of<T>(g.B0B));
  const auto psi_y = analytic::constraints::jacobian(q);
  return {{m.omega_3, m.omega_4, m.alpha_3, m.alpha_4},
          {plane(G2.v), plane(G3.v), plane(G4.v), plane(G2.a), plane(G3.a), plane(G4.a)},
          q.determinant,
          {geometry::Vector<T>{-(q.r_2 * q.e_2.im), q.r_2 * q.e_2.re},
           {psi_y(0, 0), psi_y(1, 0)},
           {psi_y(0, 1), psi_y(1, 1)}}};
}

// Turning a link by dθ moves its end by i r dθ.
template <class T>
Found<T> by_analysis(const FourBarInstant& at, const geometry::analytic::FourBarPosition<T>& p) {
  namespace analytic = geometry::analytic;
  const analytic::FourBar g = at.analytic_lengths();
  const auto m = analytic::motion(g, crank_of<T>(at), p);
  const auto crank = analytic::crank(crank_of<T>(at));
  const auto coupler = analytic::coupler(p, m), rocker = analytic::rocker(g, m);
  const auto G2 = analytic::crank_point(p, middle_of<T>(g.A0A)), G3 = analytic::coupler_point(p, middle_of<T>(g.AB)),
             G4 = analytic::rocker_point(g, p, middle_of<T>(g.B0B));
  const auto turned = [](const Rational& length, const analytic::Complex<T>& direction) {
    return plane(geometry::from_rational<T>(length) * analytic::times_i(direction));
  };
  return {{m.omega_3, m.omega_4, m.alpha_3, m.alpha_4},
          {plane(crank.velocity(G2)), plane(coupler.velocity(G3)), plane(rocker.velocity(G4)),
           plane(crank.acceleration(G2)), plane(coupler.acceleration(G3)), plane(rocker.acceleration(G4))},
          T(-p.coupler_cross_rocker),
          {turned(g.A0A, p.crank), turned(g.AB, p.coupler), turned(g.B0B, -p.rocker)}};
}

// The links of the figure turned through a right angle.
template <class T>
Found<T> by_polar_diagram(const FourBarInstant& at, const geometry::FourBar<T>& here) {
  const auto m = motion_by_polar_diagram(here, at.omega_2<T>(), geometry::radians<T>(at.alpha_2));
  const geometry::Vector<T> AB = here.B - here.A, BB0 = here.B0 - here.B;
  return {{m.coupler.omega, m.omega_4, m.coupler.alpha, m.alpha_4},
          midpoint_images(m.coupler.v_A, m.coupler.velocity(here.B), m.coupler.a_A, m.coupler.acceleration(here.B)),
          cross(AB, BB0),
          {quarter_turn(here.A - here.A0), quarter_turn(AB), quarter_turn(BB0)}};
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
    const geometry::FourBar<T> at = of.instant.position<T>();
    write_by_constraints(ledger);
    write_iterates(ledger, at);

    ledger.route("analytic");
    const auto p = analysed<T>(of.instant);
    write_link_angles(ledger, analysed_links(p), back_by_analysis);
    write(ledger, by_analysis(of.instant, p));

    ledger.route("polar diagram");
    draw_points(ledger, at);
    write_link_angles(ledger, link_directions(at), back);
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
        const T theta_3 = within_turn(q.theta_3, back.coupler), theta_4 = within_turn(q.theta_4, back.rocker);
        ledger.put(coupler_angle(), theta_3);
        ledger.put(rocker_angle(), theta_4);
        write(ledger, found);
      } catch (const geometry::Undecided& open) {
        write_undecided(ledger, open.words());
      }
    }
  }

  // The same quantities in the same order.
  template <class T>
  static void write_undecided(Ledger<T>& ledger, const Words& why) {
    Ledger<double> names("");
    names.put(coupler_angle(), 0.0);
    names.put(rocker_angle(), 0.0);
    write(names, Found<double>{});
    for (const LedgerEntry& entry : names.entries())
      ledger.put(*entry.described, [&]() -> T { throw geometry::Undecided(why); });
  }

  // The run in doubles, as it was, and the open linkage of each iterate.
  template <class T>
  void write_iterates(Ledger<T>& ledger, const geometry::FourBar<T>& at) const {
    if constexpr (std::is_same_v<T, geometry::Deep>) {
      const auto& [AB, B0B] = std::pair{geometry::from_rational<T>(of.instant.lengths.AB),
                                        geometry::from_rational<T>(of.instant.lengths.B0B)};
      const LinkDirections<T> links = link_directions(at);
      const T solution_3 = angle_or_half_turn(links.coupler, back.coupler),
              solution_4 = angle_or_half_turn(links.rocker, back.rocker);
      const auto double_told = [&](const Quantity& quantity, double x) {
        ledger.tells(quantity, [&] { return geometry::from_rational<T>(Rational(x)); });
      };
      for (std::size_t k = 0; k < of.run.iterates.size(); ++k) {
        const auto& now = of.run.iterates[k];
        double_told(iterate(coupler_angle(), k), now.q(0));
        double_told(iterate(rocker_angle(), k), now.q(1));
        double_told(iterate(residual(), k), now.residual_norm);
        const T theta_3 = geometry::from_rational<T>(Rational(now.q(0))),
                theta_4 = geometry::from_rational<T>(Rational(now.q(1)));
        ledger.tells(iterate(error_of(coupler_angle()), k), [&] { return miss<T>(theta_3, solution_3); });
        ledger.tells(iterate(error_of(rocker_angle()), k), [&] { return miss<T>(theta_4, solution_4); });
        const auto along = [](const T& angle) {
          return geometry::Vector<T>{cosine_of_angle(angle), sine_of_angle(angle)};
        };
        ledger.draws_point(end_of_coupler(k), at.A + AB * along(theta_3));
        ledger.draws_point(end_of_rocker(k), at.B0 + -B0B * along(theta_4));
      }
    }
  }

  // Whole turns aside.
  template <class T>
  static T miss(const T& angle, const T& solution) {
    const T difference = angle - solution, turn = T(2) * geometry::pi<T>();
    const double turns = std::round(geometry::enclosure(geometry::quotient(difference, turn)).value);
    return geometry::root(geometry::square(T(difference - geometry::from_rational<T>(Rational(turns)) * turn)));
  }

  template <class T>
  static void draw_points(Ledger<T>& ledger, const geometry::FourBar<T>& at) {
    const Midpoints<T> G = midpoints(at);
    for (const auto& [name, P] :
         {std::pair{"A0", at.A0}, {"A", at.A}, {"B", at.B}, {"B0", at.B0}, {"G2", G.G2}, {"G3", G.G3}, {"G4", G.G4}})
      ledger.draws_point(name, P);
  }
};

}  // namespace epure::four_bar_constraints
