// A linkage by both routes, for tests.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "geometry/analytic/joint_equations.h"
#include "geometry/linkages/carried_out.h"

namespace epure::tests {

// A link there, at rest.
template <class T>
geometry::analytic::LinkState<T> link_at(double x, double y, double theta) {
  using namespace geometry;
  const auto number = [](double d) { return from_rational<T>(Rational(d)); };
  const analytic::Complex<T> none{T(0), T(0)};
  return {{number(x), number(y)},
          none,
          none,
          number(theta),
          T(0),
          T(0),
          {number(std::cos(theta)), number(std::sin(theta))}};
}

// Where the placed links are, to a hundredth.
template <class T>
geometry::analytic::Beginning<T> beginning(const geometry::Linkage& linkage,
                                           const std::vector<geometry::Step>& steps) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const auto hundredths = [](double x) { return std::round(x * 100) / 100; };
  std::vector<double> angles;
  const auto placed = geometry::CarriedOut<geometry::Fast>(linkage, steps).position().links;
  for (const auto& link : placed) angles.push_back(std::atan2(link.x.y, link.x.x));
  for (const geometry::Step& step : steps)
    if (const auto* wheel = std::get_if<geometry::GearedWheel>(&step))
      angles[static_cast<std::size_t>(wheel->link)] = geometry::to_double(geometry::angle_of(wheel->turn, linkage));
  geometry::analytic::Beginning<T> links;
  for (std::size_t i = 0; i < placed.size(); ++i)
    links.push_back(link_at<T>(hundredths(placed[i].O.x), hundredths(placed[i].O.y), hundredths(angles[i])));
  return links;
}

// What one route says and the other does: rates of every link, place, velocity and acceleration of every point.
template <class T, class Compare>
void compare_routes(const geometry::Linkage& linkage, const std::vector<geometry::Step>& steps,
                    const geometry::analytic::Beginning<T>& start, const Compare& compare) {
  using namespace geometry;
  const CarriedOut<T> carried_out(linkage, steps);
  const LinkagePosition<T> at = carried_out.position();
  const LinkageMotion<T> motion = carried_out.motion(at, carried_out.rates());
  const std::vector<analytic::LinkState<T>> states =
      analytic::solve_joints<T>(with_sides_in_full(linkage, steps), start);
  for (std::size_t i = 0; i < linkage.links.size(); ++i) {
    const std::string link = "link " + std::to_string(i + 1);
    compare(link + ", omega", motion.links[i].omega, states[i].omega);
    compare(link + ", alpha", motion.links[i].alpha, states[i].alpha);
    for (const LinkPoint& p : linkage.links[i].points) {
      const auto k = static_cast<std::size_t>(p.point);
      const analytic::PointState<T> point = analytic::point_of(states[i], p.at);
      const std::string name = link + ", point " + std::to_string(p.point);
      compare(name + ", x", at.points[k].x, point.z.re);
      compare(name + ", y", at.points[k].y, point.z.im);
      compare(name + ", v_x", motion.points[k].v.x, point.v.re);
      compare(name + ", v_y", motion.points[k].v.y, point.v.im);
      compare(name + ", a_x", motion.points[k].a.x, point.a.re);
      compare(name + ", a_y", motion.points[k].a.y, point.a.im);
    }
  }
}

}  // namespace epure::tests
