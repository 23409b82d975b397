#include "exercises/kit/panels/coupler_figure.h"

#include <algorithm>
#include <cmath>

namespace epure {

double CouplerFigure::greatest_acceleration() const {
  double greatest = 0;
  for (const CouplerPoint& X : points) greatest = std::max(greatest, magnitude(X.a));
  return greatest;
}

double CouplerFigure::greatest_velocity() const {
  double greatest = 0;
  for (const CouplerPoint& X : points) greatest = std::max(greatest, magnitude(X.v));
  return greatest;
}

Place CouplerFigure::middle() const {
  const std::vector<Place> corners = mechanism->corners();
  Place sum{0, 0};
  for (const Place& P : corners) sum = {sum.x + P.x, sum.y + P.y};
  const auto count = static_cast<double>(corners.size());
  return {sum.x / count, sum.y / count};
}

bool CouplerFigure::is_near(const std::optional<Place>& P, double times) const {
  if (!P) return false;
  const Place O = mechanism->corners().front();
  return distance(O, *P) < times * mechanism->reach();
}

CouplerFigure coupler_figure(const MechanismFigure& mechanism, const geometry::PlaneMotion<geometry::Deep>& motion,
                             const std::vector<FollowedPoint>& points) {
  CouplerFigure figure{.mechanism = &mechanism};
  figure.omega_3 = to_double(motion.omega);
  figure.alpha_3 = to_double(motion.alpha);
  figure.P0 = to_double(motion.pole());
  figure.J = to_double(motion.inflection_pole());
  figure.K = to_double(motion.acceleration_pole());
  figure.inflection = to_double(motion.inflection_circle());
  figure.stationarity = to_double(motion.stationarity_circle());
  for (const FollowedPoint& X : points) {
    figure.points.push_back({.letter = X.letter,
                             .at = to_double(X.at),
                             .v = to_double(motion.velocity(X.at)),
                             .a = to_double(motion.acceleration(X.at)),
                             .on_circle = to_double(motion.on_inflection_circle(X.at)),
                             .centre = to_double(motion.centre_of_curvature(X.at)),
                             .symbol = X.symbol});
  }
  return figure;
}

}  // namespace epure
