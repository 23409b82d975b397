#include "exercises/four-bar-constraints/routes.h"

#include <cmath>

namespace epure::four_bar_constraints {
namespace {

using geometry::Deep;

MidpointMotion<double> rounded(const MidpointMotion<Deep>& m) {
  return {to_double(m.v_G2), to_double(m.v_G3), to_double(m.v_G4),
          to_double(m.a_G2), to_double(m.a_G3), to_double(m.a_G4)};
}

// What the three methods are compared in.
std::vector<double> numbers_of(const Found<Deep>& found, const Deep& theta_3, const Deep& theta_4) {
  std::vector<double> all{to_double(theta_3),
                          to_double(theta_4),
                          to_double(found.rates.omega_3),
                          to_double(found.rates.omega_4),
                          to_double(found.rates.alpha_3),
                          to_double(found.rates.alpha_4)};
  const MidpointMotion<double> m = rounded(found.midpoints);
  for (const Arrow2& v : {m.v_G2, m.v_G3, m.v_G4, m.a_G2, m.a_G3, m.a_G4}) all.push_back(magnitude(v));
  return all;
}

std::vector<double> numbers_of(const Found<Deep>& found, const LinkDirections<Deep>& links, const HalfTurned& back) {
  return numbers_of(found, angle_or_half_turn(links.coupler, back.coupler),
                    angle_or_half_turn(links.rocker, back.rocker));
}

std::vector<Compared> compared(const std::vector<double>& by_constraints, const std::vector<double>& by_analysis,
                               const std::vector<double>& by_polar_diagram) {
  const std::vector<std::pair<std::string, std::string>> names{
      {"θ_{3}", "rad"},    {"θ_{4}", "rad"},    {"ω_{3}", "rad/s"}, {"ω_{4}", "rad/s"},
      {"α_{3}", "rad/s²"}, {"α_{4}", "rad/s²"}, {"v_{G2}", "m/s"},  {"v_{G3}", "m/s"},
      {"v_{G4}", "m/s"},   {"a_{G2}", "m/s²"},  {"a_{G3}", "m/s²"}, {"a_{G4}", "m/s²"}};
  std::vector<Compared> rows;
  for (std::size_t i = 0; i < names.size(); ++i)
    rows.push_back({names[i].first, names[i].second, by_constraints[i], by_analysis[i], by_polar_diagram[i]});
  return rows;
}

}  // namespace

std::vector<RouteValue> solve(const Problem& of, Rung rung) { return settle(Routes{of}, rung); }

Drawn drawn(const Problem& of) {
  return deeply([&]() -> Drawn {
    namespace analytic = geometry::analytic;
    const FourBarInstant& instant = of.instant;
    const geometry::FourBar<Deep> at = instant.position<Deep>();
    const auto q = analytic::configuration<Deep>(instant.analytic_lengths(), crank_of<Deep>(instant), of.run);
    const auto p = analysed<Deep>(instant);
    const Routes routes(of);
    const LinkDirections<Deep> links = link_directions(at), links_by_analysis = analysed_links(p);
    const Found<Deep> constraints = by_constraints<Deep>(instant, q);
    const double sense = sign_of(instant.n);
    Drawn f{.of = of, .figure = drawn_four_bar(at, sense), .motion = rounded(constraints.midpoints)};
    f.figure.points = {{"$G_{2}$", to_double(midpoint(at.A0, at.A))},
                       {"$G_{3}$", to_double(midpoint(at.A, at.B))},
                       {"$G_{4}$", to_double(midpoint(at.B0, at.B))}};
    f.compared = compared(numbers_of(constraints, q.theta_3, q.theta_4),
                          numbers_of(by_analysis(instant, p), links_by_analysis, routes.back_by_analysis),
                          numbers_of(by_polar_diagram(instant, at), links, routes.back));
    return f;
  });
}

Place Drawn::coupler_end(std::size_t iterate) const {
  const double AB = CGAL::to_double(of.instant.lengths.AB), theta_3 = iterates().at(iterate).q(0);
  return {figure.A.x + AB * std::cos(theta_3), figure.A.y + AB * std::sin(theta_3)};
}

Place Drawn::rocker_end(std::size_t iterate) const {
  const double B0B = CGAL::to_double(of.instant.lengths.B0B), theta_4 = iterates().at(iterate).q(1);
  return {figure.B0.x - B0B * std::cos(theta_4), figure.B0.y - B0B * std::sin(theta_4)};
}

}  // namespace epure::four_bar_constraints
