// The unknowns of a linkage as a column, x, y and θ of each moving link, and as states of its links.
#pragma once

#include <vector>

#include "geometry/analytic/joint_equations.h"

namespace epure::geometry::analytic::joints {

constexpr int unknowns_of_a_link = 3;  // x, y, θ

template <class T>
using Column = std::vector<T>;

template <class T>
std::vector<LinkState<T>> states(const Column<T>& q) {
  const Complex<T> none{T(0), T(0)};
  std::vector<LinkState<T>> links{{none, none, none, T(0), T(0), T(0), {T(1), T(0)}}};
  for (std::size_t k = 0; k < q.size(); k += unknowns_of_a_link)
    links.push_back(
        {{q[k], q[k + 1]}, none, none, q[k + 2], T(0), T(0), {cosine_of_angle(q[k + 2]), sine_of_angle(q[k + 2])}});
  return links;
}

// Where drives turn links, these stand as they are driven: of an angle that no number holds its sine and cosine may
// be whole, as at 180°.
template <class T>
std::vector<LinkState<T>> as_driven(const Linkage& linkage, const Column<T>& q) {
  std::vector<LinkState<T>> links = states(q);
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive)) {
      LinkState<T>& link = links[static_cast<std::size_t>(turned->link)];
      link.theta = radians<T>(turned->angle);
      link.x = {cosine<T>(turned->angle), sine<T>(turned->angle)};
    }
  return links;
}

// With these rates.
template <class T>
std::vector<LinkState<T>> moving(const Column<T>& q, const Column<T>& rates) {
  std::vector<LinkState<T>> links = states(q);
  for (std::size_t k = 0; k < rates.size(); k += unknowns_of_a_link) {
    LinkState<T>& link = links[k / unknowns_of_a_link + 1];
    link.v = Complex<T>{rates[k], rates[k + 1]};
    link.omega = rates[k + 2];
  }
  return links;
}

// The first derivatives of the unknowns, or the second ones.
template <class T>
Column<T> rates_of(const std::vector<LinkState<T>>& links, bool is_first) {
  Column<T> rates;
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Complex<T>& of_origin = is_first ? links[i].v : links[i].a;
    for (const T& rate : {of_origin.re, of_origin.im, is_first ? links[i].omega : links[i].alpha})
      rates.push_back(rate);
  }
  return rates;
}

}  // namespace epure::geometry::analytic::joints
