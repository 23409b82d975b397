// Where an iteration begins.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/analytic/joints/states.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry::analytic::joints {

inline double near(Fast x) { return x; }
template <class T>
double near(const T& x) {
  return enclosure(x).value;
}

inline Fast point_in(Fast x) { return x; }
inline Bounded point_in(const Bounded& x) { return midpoint(x); }
inline Deep point_in(const Deep& x) { return midpoint(x); }

// With half of the digits.
inline Fast about(Fast x) { return static_cast<double>(static_cast<float>(x)); }
inline Bounded about(const Bounded& x) { return about(enclosure(x).value); }
inline Deep about(const Deep& x) {
  const Arithmetic<Deep> scope(Arithmetic<Deep>::bits() / 2);
  return midpoint(x + Deep(0));
}

// Where the wheel points, where the beginning has its centre, in doubles.
template <class T>
double rolled_to(const Linkage& linkage, const RollingWheel& roll, const Beginning<T>& beginning, double carrier) {
  const LinkLine& line = linkage.line(roll.line);
  const LinkState<T>&body = beginning[static_cast<std::size_t>(linkage.link_of_line(roll.line))],
        &wheel = beginning[static_cast<std::size_t>(roll.wheel)];
  const T ahead = dot(direction(line, body),
                      point_of(wheel, linkage.place(roll.wheel, roll.centre)).z - point_of(body, line.through).z);
  return carrier + to_double(roll.phase) + (CGAL::to_double(roll.at) - near(ahead)) / CGAL::to_double(roll.radius);
}

// Without the frame. The angle of a link that is turned has as many whole turns as it is given with, or the first
// step would turn the link by these.
template <class T>
Column<T> moving_links(const Linkage& linkage, const Beginning<T>& beginning) {
  std::vector<double> turned;
  for (const LinkState<T>& link : beginning) turned.push_back(near(link.theta));
  for (const Drive& drive : linkage.drives)
    if (const auto* crank = std::get_if<TurnedLink>(&drive))
      turned[static_cast<std::size_t>(crank->link)] = to_double(crank->angle);
  Column<T> q;
  for (std::size_t i = 1; i < beginning.size(); ++i) {
    const auto &O = beginning[i].O, &x = beginning[i].x;
    const T angle = about(arc_tangent(point_in(x.im), point_in(x.re)));
    const double turns = std::round((turned[i] - near(angle)) / (2 * pi<Fast>()));
    const T theta = angle + from_rational<T>(Rational(2 * turns)) * pi<T>();
    q.insert(q.end(), {point_in(O.re), point_in(O.im), point_in(theta)});
  }
  for (const RollingWheel& roll : linkage.rolls) {
    const auto theta = [&](int link) {
      return link == 0 ? 0 : near(q[static_cast<std::size_t>(unknowns_of_a_link * link - 1)]);
    };
    const int carrier = linkage.link_of_line(roll.line);
    const double turns =
        std::round((rolled_to(linkage, roll, beginning, theta(carrier)) - theta(roll.wheel)) / (2 * pi<Fast>()));
    T& of_wheel = q[static_cast<std::size_t>(unknowns_of_a_link * roll.wheel - 1)];
    of_wheel = point_in(of_wheel + from_rational<T>(Rational(2 * turns)) * pi<T>());
  }
  return q;
}

}  // namespace epure::geometry::analytic::joints
