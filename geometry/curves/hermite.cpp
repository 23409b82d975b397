#include "geometry/curves/hermite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epure::geometry {

namespace {

double middle(const Bounded& x) { return x.inf() / 2 + x.sup() / 2; }
Point<double> middle(const Point<Bounded>& P) { return {middle(P.x), middle(P.y)}; }

// In this file doubles are rounded upwards, as the scope of Bounded has it: sums, products and roots of what is not
// negative are upper bounds, and so is a single difference.
double magnitude_bound(const Bounded& x) { return std::max(std::fabs(x.inf()), std::fabs(x.sup())); }

// Infinite when x has no bounds: its middle may then be infinite too, or not a number.
double farthest(const Bounded& x, double drawn) {
  if (!std::isfinite(x.inf()) || !std::isfinite(x.sup())) return std::numeric_limits<double>::infinity();
  return std::max(x.sup() - drawn, drawn - x.inf());
}

struct Miss {
  double x = 0, y = 0;
  double length() const { return std::sqrt(x * x + y * y); }
  void cover(const Point<Bounded>& control, const Point<double>& drawn) {
    x = std::max(x, farthest(control.x, drawn.x));
    y = std::max(y, farthest(control.y, drawn.y));
  }
};

Miss interpolation_miss(const Bounded& h, const Vector<Bounded>& fourth) {
  const double share = square(square(h)).sup() / 16;
  return {share * magnitude_bound(fourth.x), share * magnitude_bound(fourth.y)};
}

}  // namespace

Knot knot(double t, const Point<BoundedTangent>& at) {
  const Point<Bounded> position{at.x.c[0], at.y.c[0]};
  return {t, position, {at.x.c[1], at.y.c[1]}, middle(position)};
}

double FittedArc::deviation() const { return interpolation + rounding; }

double FittedArc::growth(double tolerance) const {
  return 0.95 * std::min(2.0, std::pow((tolerance - rounding) / interpolation, 0.25));
}

FittedArc fit(const Knot& a, const Knot& b, const Vector<Bounded>& fourth) {
  const Bounded h = Bounded(b.t) - Bounded(a.t), third = h / Bounded(3);
  const Point<Bounded> first = a.position + third * a.derivative, second = b.position + (-third) * b.derivative;
  const BezierArc arc{a.drawn, middle(first), middle(second), b.drawn};
  Miss rounding;
  rounding.cover(a.position, arc.start);
  rounding.cover(first, arc.first_control);
  rounding.cover(second, arc.second_control);
  rounding.cover(b.position, arc.end);
  return {arc, interpolation_miss(h, fourth).length(), rounding.length()};
}

Bounded fourth_coefficient(const BoundedSeries& over, const BoundedSeries& middle, const Bounded& t, double m) {
  const Bounded by_mean_value = middle.c[4] + Bounded(5) * over.c[5] * (t - Bounded(m));
  return {std::max(over.c[4].inf(), by_mean_value.inf()), std::min(over.c[4].sup(), by_mean_value.sup())};
}

}  // namespace epure::geometry
