#include "geometry/gears/flank_fit.h"

#include "geometry/curves/span.h"
#include "geometry/gears/involute.h"
#include "geometry/numbers/enclosure.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace epure::geometry {

namespace {

// The weights of the control points at u from 0 to 1.
std::array<double, 4> weights(double u) {
  const double v = 1 - u;
  return {v * v * v, 3 * v * v * u, 3 * v * u * u, u * u * u};
}

Point<Fast> at(const BezierArc& arc, double u) {
  const auto w = weights(u);
  const auto mixed = [&](double a, double b, double c, double d) {
    return w[0] * a + w[1] * b + w[2] * c + w[3] * d;
  };
  return {mixed(arc.start.x, arc.first_control.x, arc.second_control.x, arc.end.x),
          mixed(arc.start.y, arc.first_control.y, arc.second_control.y, arc.end.y)};
}

// The length of the tangent from Q to the base circle. Throws Undecided unless Q is proved to lie outside; on
// doubles, which only propose an arc, zero is then a good enough answer.
template <class X, class T>
X tangent_length(const RightFlank<T>& flank, const Point<X>& Q) {
  const X squared = square(Q.x) + square(Q.y) - square(X(flank.r_b));
  if constexpr (!std::is_same_v<X, Fast>)
    if (sign(squared) != Sign::positive)
      throw Undecided("whether a drawn flank lies outside the base circle",
                      "se un fianco disegnato stia fuori dalla circonferenza di base");
  return root(squared);
}

// How far Q lies outside the flank, along its normal.
template <class T>
T outside_at(const RightFlank<T>& flank, const Point<T>& Q) {
  const T inv = involute(quotient(tangent_length(flank, Q), flank.r_b));
  return flank.r_b * (arc_tangent(Q.x, Q.y) + (flank.ring ? -inv : inv) - flank.half_angle);
}

// The unit normal there, out of the tooth.
template <class X, class T>
Vector<X> normal_at(const RightFlank<T>& flank, const Point<X>& Q) {
  const X length = tangent_length(flank, Q), along = flank.ring ? -length : length, r_b = X(flank.r_b);
  const X share = quotient(X(1), square(Q.x) + square(Q.y));
  return {share * (along * Q.x + r_b * Q.y), share * (along * Q.y - r_b * Q.x)};
}

// ---- the fit, in doubles

BezierArc hermite(const RightFlank<Fast>& flank, double from, double to) {
  const auto derivative = [&](double t) {  // r_b t u, in the direction of growing t
    const double psi = (flank.ring ? -t : t) - flank.half_angle;
    return Vector<Fast>{-flank.r_b * t * std::sin(psi), flank.r_b * t * std::cos(psi)};
  };
  const Point<Fast> start = flank(from), end = flank(to);
  const double third = (to - from) / 3;
  return {start, start + third * derivative(from), end + (-third) * derivative(to), end};
}

constexpr int misses = 5, steps = 12, steps_before_exchange = 3, looks = 16;
using Places = std::array<double, misses>;

// Where the Chebyshev polynomial T6, stretched until its first and last zero are 0 and 1, is ±1.
Places first_places() {
  Places u{};
  for (int k = 0; k < misses; ++k)
    u[static_cast<std::size_t>(k)] = (1 - std::cos((k + 1) * pi<Fast>() / 6) / std::cos(pi<Fast>() / 12)) / 2;
  return u;
}

// One step of Newton's method towards an arc that misses by +E, -E, ... at the places. Returns E.
double level(BezierArc& arc, const Places& places, const RightFlank<Fast>& flank) {
  Eigen::Matrix<double, misses, misses> by_unknowns;  // the handles and E
  Eigen::Matrix<double, misses, 1> miss;
  for (int k = 0; k < misses; ++k) {
    const double u = places[static_cast<std::size_t>(k)];
    const Point<Fast> Q = at(arc, u);
    const Vector<Fast> n = normal_at(flank, Q);
    const std::array<double, 4> w = weights(u);
    by_unknowns.row(k) << w[1] * n.x, w[1] * n.y, w[2] * n.x, w[2] * n.y, k % 2 == 0 ? -1 : 1;
    miss[k] = -outside_at(flank, Q);
  }
  const Eigen::Matrix<double, misses, 1> change = by_unknowns.partialPivLu().solve(miss);
  arc.first_control = arc.first_control + Vector<Fast>{change[0], change[1]};
  arc.second_control = arc.second_control + Vector<Fast>{change[2], change[3]};
  return change[4];
}

// The places where the arc misses most on the side on which it is meant to, each looked for halfway to its
// neighbours.
Places exchanged(const BezierArc& arc, const Places& places, const RightFlank<Fast>& flank, double first_miss) {
  Places worst = places;
  double side = first_miss;
  for (std::size_t k = 0; k < misses; ++k, side = -side) {
    const double from = k == 0 ? places[0] / 2 : (places[k - 1] + places[k]) / 2;
    const double to = k + 1 == misses ? (places[k] + 1) / 2 : (places[k] + places[k + 1]) / 2;
    double most = -INFINITY;
    for (int look = 0; look <= looks; ++look) {
      const double u = from + (to - from) * look / looks, miss = side * outside_at(flank, at(arc, u));
      if (miss > most) most = miss, worst[k] = u;
    }
  }
  return worst;
}

bool is_finite(const BezierArc& arc) {
  for (const Point<double>& P : {arc.start, arc.first_control, arc.second_control, arc.end})
    if (!std::isfinite(P.x) || !std::isfinite(P.y)) return false;
  return true;
}

// Remez' method. What it yields is judged afterwards; nothing is promised here.
BezierArc fitted(const RightFlank<Fast>& flank, double from, double to) {
  BezierArc arc = hermite(flank, from, to);
  Places places = first_places();
  for (int step = 0; step < steps; ++step) {
    const double first_miss = level(arc, places, flank);
    if (!is_finite(arc)) break;
    if (step >= steps_before_exchange) places = exchanged(arc, places, flank, first_miss);
  }
  return arc;
}

// ---- the proof, in intervals

// A coordinate of the arc in powers of the distance from a place on it: intervals of that distance stay narrow.
std::array<Bounded, 4> powers(double a, double b, double c, double d, const Bounded& u) {
  const Bounded first = Bounded(b) - Bounded(a), second = Bounded(c) - Bounded(b), third = Bounded(d) - Bounded(c);
  const Bounded one = Bounded(3) * first, two = Bounded(3) * (second - first),
                three = third - Bounded(2) * second + first;
  return {Bounded(a) + u * (one + u * (two + u * three)), one + u * (Bounded(2) * two + Bounded(3) * u * three),
          two + Bounded(3) * u * three, three};
}

struct LocalCubic {
  std::array<Bounded, 4> x, y;
  LocalCubic(const BezierArc& arc, double u)
      : x(powers(arc.start.x, arc.first_control.x, arc.second_control.x, arc.end.x, Bounded(u))),
        y(powers(arc.start.y, arc.first_control.y, arc.second_control.y, arc.end.y, Bounded(u))) {}

  Point<Bounded> middle() const { return {x[0], y[0]}; }
  Point<BoundedSeries> at(const BoundedSeries& h) const { return {value(x, h), value(y, h)}; }
  Vector<BoundedSeries> slope(const BoundedSeries& h) const { return {slope(x, h), slope(y, h)}; }

 private:
  static BoundedSeries value(const std::array<Bounded, 4>& q, const BoundedSeries& h) {
    return BoundedSeries(q[0]) + h * (BoundedSeries(q[1]) + h * (BoundedSeries(q[2]) + h * BoundedSeries(q[3])));
  }
  static BoundedSeries slope(const std::array<Bounded, 4>& q, const BoundedSeries& h) {
    return BoundedSeries(q[1]) + h * (BoundedSeries(Bounded(2) * q[2]) + h * BoundedSeries(Bounded(3) * q[3]));
  }
};

// How far the arc lies outside the flank up to `reach` before and behind the middle: the value there, and the
// integral of the slope's series from there, whose last coefficient is taken over the whole piece.
Bounded outside_over(const RightFlank<Bounded>& flank, const LocalCubic& cubic, double reach) {
  const auto series = [&](const Bounded& from_middle) {
    const BoundedSeries h = BoundedSeries::parameter(from_middle);
    return dot(normal_at(flank, cubic.at(h)), cubic.slope(h));
  };
  const Bounded h(-reach, reach);
  const BoundedSeries here = series(Bounded(0)), over = series(h);
  Bounded sum = over.c[5] / Bounded(6);
  for (int k = 5; k >= 1; --k) sum = here.c[static_cast<std::size_t>(k - 1)] / Bounded(k) + h * sum;
  return outside_at(flank, cubic.middle()) + h * sum;
}

// Shorter pieces of an arc than this are not looked at.
constexpr double shortest = 0x1p-12;

// Whether the arc from u = a to b keeps within the band to either side of the flank, proved; halved where that stays
// open.
bool keeps(const RightFlank<Bounded>& flank, const BezierArc& arc, double band, double a, double b,
           double& deviation) {
  const double middle = a / 2 + b / 2;
  try {
    const LocalCubic cubic(arc, middle);
    const Bounded here = outside_at(flank, cubic.middle());
    if (here.inf() > band || here.sup() < -band) return false;
    const Bounded found = outside_over(flank, cubic, (b - a) / 2);  // a and b are binary fractions: exact
    if (found.inf() >= -band && found.sup() <= band) {
      deviation = std::max({deviation, -found.inf(), found.sup()});
      return true;
    }
  } catch (const Undecided&) {
  }
  if (b - a <= shortest) return false;
  return keeps(flank, arc, band, a, middle, deviation) && keeps(flank, arc, band, middle, b, deviation);
}

// In `pieces` arcs; empty when one of them does not keep to the tolerance. The error of an arc of length h in t about
// t grows with h⁶/t², so equal pieces of t^(2/3) share it evenly.
FlankArcs in_pieces(const RightFlank<Bounded>& flank, double from, double to, double tolerance, int pieces) {
  const RightFlank<Fast> drawn{midpoint(flank.r_b).inf(), midpoint(flank.half_angle).inf(), flank.ring};
  const double first = std::pow(from, 2.0 / 3), last = std::pow(to, 2.0 / 3);
  FlankArcs result;
  double start = from;
  for (int k = 1; k <= pieces; ++k) {
    const double end = k == pieces ? to : std::pow(first + (last - first) * k / pieces, 1.5);
    // Where a flank is so short that its normals are all but parallel, the handles cannot be solved for.
    std::optional<BezierArc> arc;
    for (const auto& propose : {fitted, hermite})
      if (const BezierArc proposed = propose(drawn, start, end);
          !arc && is_finite(proposed) && keeps(flank, proposed, tolerance, 0, 1, result.deviation))
        arc = proposed;
    if (!arc) return {};
    result.arcs.push_back(*arc);
    start = end;
  }
  return result;
}

constexpr int most_pieces = 256;

}  // namespace

FlankArcs flank_arcs(const RightFlank<Bounded>& flank, double from, double to, double tolerance) {
  // Beyond it the flank is more than twice the tolerance away from the base circle: r_b (√(1 + t²) - 1).
  const double clear = std::max(from, std::sqrt(5 * tolerance / flank.r_b.inf()));
  FlankArcs result;
  if (from < clear) {
    SpanTrace cusp = trace_span(flank, from, std::min(clear, to), tolerance);
    result = {std::move(cusp.arcs), cusp.deviation};
  }
  for (int pieces = 1; clear < to; pieces += 1 + pieces / 8) {
    if (pieces > most_pieces)
      throw Undecided("doubles cannot follow a flank to the tolerance it is to be drawn with",
                      "i double non possono seguire un fianco con la tolleranza del disegno");
    const FlankArcs rest = in_pieces(flank, clear, to, tolerance, pieces);
    if (rest.arcs.empty()) continue;
    if (!result.arcs.empty()) result.arcs.back().end = rest.arcs.front().start;
    result.arcs.insert(result.arcs.end(), rest.arcs.begin(), rest.arcs.end());
    result.deviation = std::max(result.deviation, rest.deviation);
    break;
  }
  return result;
}

}  // namespace epure::geometry
