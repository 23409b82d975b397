#include "exercises/kit/panels/funicular_of_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/crossing.h"

namespace epure {
namespace {

Place centroid_of(const std::vector<Place>& points) {
  Arrow2 sum{0, 0};
  for (const Place& P : points) sum = sum + (P - Place{0, 0});
  return Place{0, 0} + (1.0 / static_cast<double>(points.size())) * sum;
}
double diameter_of(const std::vector<Place>& points) {
  double size = 0;
  for (const Place& P : points)
    for (const Place& Q : points) size = std::max(size, distance(P, Q));
  return size;
}

// One after the other across the direction of their resultant; loads in equilibrium keep the order of the outline.
std::vector<std::size_t> loads_in_order(const TrussFigure& figure) {
  std::vector<std::size_t> loads;
  Arrow2 whole{0, 0};
  double all_across = 0;
  const Place& A = figure.joints[figure.outside[0].joint];
  const auto across = [&](std::size_t k) { return cross(whole, figure.joints[figure.outside[k].joint] - A); };
  for (const std::size_t k : figure.bow.forces)
    if (k > 1 && magnitude(figure.outside[k].f) != 0) {
      loads.push_back(k);
      whole = whole + figure.outside[k].f;
    }
  for (const std::size_t k : loads) all_across += across(k);
  const double sense = all_across < 0 ? -1 : 1;  // from the hinge on
  std::stable_sort(loads.begin(), loads.end(),
                   [&](std::size_t k, std::size_t l) { return sense * across(k) < sense * across(l); });
  return loads;
}

}  // namespace

FunicularOfLoads funicular_of_loads(const TrussFigure& figure) {
  FunicularOfLoads found{loads_in_order(figure), {}};
  std::vector<geometry::ForceAt<double>> loads;
  std::vector<Place> corners{{0, 0}};
  for (const std::size_t k : found.loads) {
    loads.push_back({figure.joints[figure.outside[k].joint], figure.outside[k].f});
    corners.push_back(corners.back() + figure.outside[k].f);
  }
  const Place &A = figure.joints[figure.outside[0].joint], &B = figure.joints[figure.outside[1].joint];
  // By the force where there is one: of an angle near the right one a double knows little of the cosine.
  const Arrow2& R_B = figure.outside[1].f;
  const double size_of_R_B = magnitude(R_B);
  const Arrow2 along_roller =
      size_of_R_B > 0 ? (1 / size_of_R_B) * R_B : Arrow2{std::cos(figure.roller_down), std::sin(figure.roller_down)};
  const auto worst_crossing = [&](const Place& pole) {
    double worst = crossing_angle(corners.back() - pole, along_roller);
    for (std::size_t i = 0; i < loads.size(); ++i)
      for (const std::size_t end : {i, i + 1})
        worst = std::min(worst, crossing_angle(corners[end] - pole, loads[i].f));
    return worst;
  };
  // Round the loads, so far off that the polygon is neither flat nor steep. Of those that cross well the one whose
  // strings take little room and lie clear of the truss.
  constexpr int directions = 12;
  constexpr double off = 0.8, well = 0.4;  // of the loads' size; radians
  double best = -1;
  const Place middle = centroid_of(corners), of_truss = centroid_of(figure.joints);
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const Place pole = middle + off * diameter_of(corners) * Arrow2{std::cos(angle), std::sin(angle)};
    const double worst = worst_crossing(pole);
    if (worst <= 0 || (best > 0 && worst < std::min(best, well))) continue;
    const geometry::SupportPolygon<double> polygon =
        geometry::support_polygon<double>(loads, A, {B, along_roller}, pole);
    const Place of_strings = centroid_of(polygon.vertices);
    std::vector<Place> all = polygon.vertices;
    all.insert(all.end(), figure.joints.begin(), figure.joints.end());
    const double size = diameter_of(all), compact = diameter_of(figure.joints) / size;
    const double fitness = worst < well ? worst : well + compact * (1 + distance(of_strings, of_truss) / size);
    if (fitness <= best) continue;
    best = fitness;
    found.polygon = polygon;
  }
  return found;
}

}  // namespace epure
