// Curves over a span: the arcs join, keep to the tolerance against points of the curve computed apart, also at a
// cusp; and the series' cosine and sine behind them.
#include "geometry/curves/span.h"
#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace epure::geometry;

namespace {

struct Cycloid {
  template <class X>
  Point<X> operator()(const X& t) const {
    const X angle = X(2) * t;
    return {angle - sine_of_angle(angle), X(1) - cosine_of_angle(angle)};
  }
};

struct HalfParabola {  // (t, √t)
  template <class X>
  Point<X> operator()(const X& t) const {
    return {t, root(t)};
  }
};

Point<double> on_arc(const BezierArc& a, double s) {
  const double r = 1 - s;
  const auto mix = [&](double p, double q, double u, double v) {
    return r * r * r * p + 3 * r * r * s * q + 3 * r * s * s * u + s * s * s * v;
  };
  return {mix(a.start.x, a.first_control.x, a.second_control.x, a.end.x),
          mix(a.start.y, a.first_control.y, a.second_control.y, a.end.y)};
}

// From P to the cycloid of the unit circle: by thirds from every sample that is nearer than its neighbours, because
// at a cusp two branches run side by side.
double distance_to_cycloid(const Point<double>& P) {
  const double step = 1e-3;
  const auto distance_at = [&](double angle) {
    return std::hypot(angle - std::sin(angle) - P.x, 1 - std::cos(angle) - P.y);
  };
  double least = 1e9;
  for (int i = -1000; i <= 7000; ++i) {
    double from = (i - 1) * step, to = (i + 1) * step;
    if (distance_at(i * step) > std::min(distance_at(from), distance_at(to))) continue;
    for (int k = 0; k < 80; ++k) {
      const double third = (to - from) / 3;
      if (distance_at(from + third) < distance_at(to - third))
        to -= third;
      else
        from += third;
    }
    least = std::min(least, distance_at(from));
  }
  return least;
}

}  // namespace

TEST_CASE("series: cosine and sine of an angle that is a series", "[taylor]") {
  const Arithmetic<Bounded> scope;
  const BoundedSeries t = BoundedSeries::parameter(Bounded(0)), u = BoundedSeries(quotient(Bounded(1), Bounded(2)));
  const BoundedSeries cosine = cosine_of_angle(u + t + t * t), sine = sine_of_angle(u + t + t * t);
  // mpmath, 30 digits: taylor(lambda t: cos(0.5 + t + t*t), 0, 5) and the same of the sine.
  const std::array<double, 6> of_cosine{0.87758256189037271612,  -0.47942553860420300027, -0.91821681954938935833,
                                        -0.79767830545633888274, -0.16251257156431932808, 0.38198131679546192782},
      of_sine{0.47942553860420300027,  0.87758256189037271612,  0.63786979258827121598,
              -0.62568929891926511963, -0.65852798613877939985, -0.35157383649539941871};
  for (std::size_t k = 0; k < 6; ++k) {
    INFO("coefficient " << k);
    // Off by half an ulp at most as printed here; a few operations on numbers near 1 lose no more than 1e-14.
    CHECK(std::fabs(cosine.c[k].inf() - of_cosine[k]) < 1e-14);
    CHECK(std::fabs(cosine.c[k].sup() - of_cosine[k]) < 1e-14);
    CHECK(std::fabs(sine.c[k].inf() - of_sine[k]) < 1e-14);
    CHECK(std::fabs(sine.c[k].sup() - of_sine[k]) < 1e-14);
  }
}

TEST_CASE("span: a cycloid over two cusps is drawn to the tolerance, each arc from where the last one ended",
          "[span]") {
  const double tolerance = GENERATE(1e-2, 1e-4, 1e-7);
  const SpanTrace traced = trace_span(Cycloid{}, -0.5, 3.5, tolerance);
  REQUIRE(!traced.arcs.empty());
  CHECK(traced.deviation <= tolerance);
  CHECK(traced.arcs.front().start.x == Approx(-1 + std::sin(1.0)));
  CHECK(traced.arcs.back().end.y == Approx(1 - std::cos(7.0)));
  for (std::size_t i = 1; i < traced.arcs.size(); ++i) {
    CHECK(traced.arcs[i].start.x == traced.arcs[i - 1].end.x);
    CHECK(traced.arcs[i].start.y == traced.arcs[i - 1].end.y);
  }
  double worst = 0;
  for (const BezierArc& arc : traced.arcs)
    for (const double s : {0.1, 0.3, 0.5, 0.7, 0.9}) worst = std::max(worst, distance_to_cycloid(on_arc(arc, s)));
  CHECK(worst <= tolerance);
  // f⁗ = 1 by the angle: arcs of (384 tolerance)^(1/4) radians would just do. A tenth of that length is lost to
  // growing by less than the bound allows and to sharing out the rest.
  const double needed = 8 / std::pow(384 * tolerance, 0.25);
  CHECK(static_cast<double>(traced.arcs.size()) <= 1.1 * needed + 4);
}

TEST_CASE("span: the bound holds at equal parameters, and is not idle", "[span]") {
  const auto circle = []<class X>(const X& t) { return Point<X>{cosine_of_angle(t), sine_of_angle(t)}; };
  const SpanTrace traced = trace_span(circle, 0, 1, 1e-1);
  REQUIRE(traced.arcs.size() == 1);
  double worst = 0;
  for (int k = 0; k <= 100; ++k) {
    const double t = k / 100.0;
    const Point<double> P = on_arc(traced.arcs[0], t);
    worst = std::max(worst, std::hypot(P.x - std::cos(t), P.y - std::sin(t)));
  }
  CHECK(worst <= traced.deviation);
  CHECK(worst >= traced.deviation / 4);
}

TEST_CASE("span: what cannot be drawn is said", "[span]") {
  CHECK_THROWS_AS(trace_span(HalfParabola{}, 0, 1, 1e-6), Undecided);
  CHECK_THROWS_AS(trace_span(Cycloid{}, 0, 1, 1e-20), Undecided);
  CHECK_NOTHROW(trace_span(HalfParabola{}, 0.25, 1, 1e-6));
  const auto absent = []<class X>(const X& t) -> Point<X> {
    if (sign(t) == Sign::positive) throw Impossible("no curve here");
    return {t, t};
  };
  CHECK_THROWS_AS(trace_span(absent, 1, 2, 1e-3), Impossible);
}
