#include "exercises/point-mass/routes.h"

namespace epure::point_mass {

Routes::Routes(const Problem& of)
    : of_(of),
      powers_(of_),
      steps_(of_),
      closed_(of_),
      slope_(3 * of_.A, 2 * of_.B, of_.C, of_.end()),
      zeros_(of_.A, of_.B, of_.C, of_.end()) {}

// Near zero the lowest power counts.
bool Routes::begins_positive() const { return (of_.C != 0 ? of_.C : of_.B != 0 ? of_.B : of_.A) > 0; }

std::vector<const Crossing*> Routes::zeros_in_order() const {
  std::vector<const Crossing*> all;
  for (const auto* zero : {&zeros_.falling, &zeros_.rising})
    if (*zero) all.push_back(&**zero);
  // They alternate, so the first of two is the one that changes the sign the force begins with.
  if (all.size() == 2 && all.front()->falls != begins_positive()) std::swap(all[0], all[1]);
  all.push_back(nullptr);
  return all;
}

std::size_t Routes::strip_of(const Rational& t) const {
  const std::vector<Rational> ends = of_.strip_ends();
  std::size_t strip = 0;
  while (ends[strip + 1] < t) ++strip;
  return strip;
}

// Sums of whole strips, and the part of the strip that t cuts.
TableRow Routes::polygon_in_closed_form(const Rational& t) const {
  const Powers v = powers_.a.middles(of_.strip), s = v.trapezoids(of_.strip);
  const std::size_t strip = strip_of(t);
  const Rational begin = Rational(static_cast<long>(strip)) * of_.strip;
  const Rational width = of_.end() - begin < of_.strip ? of_.end() - begin : of_.strip;
  const Rational a = powers_.a.at<Rational>(begin + width / 2), v_begin = v.at(begin);
  return {v_begin + (t - begin) * a, s.at(begin) + (t - begin) * (v_begin + width / 2 * a)};
}

std::vector<RouteValue> solved(const Routes& routes, Rung rung) { return settle(routes, rung); }

}  // namespace epure::point_mass
