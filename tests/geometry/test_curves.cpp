// Tracing: the proved deviation is true and not silly, nothing is joined across infinity, what is left out is stated.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/analytic/polode_formulas.h"
#include "geometry/curves/asymptotes.h"
#include "geometry/curves/hermite.h"
#include "geometry/curves/polodes.h"
#include "geometry/curves/trace.h"
#include "geometry/mechanisms/four_bar.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

constexpr Frame frame{-0.8, -0.8, 1.2, 0.8};  // metres

bool is_inside(const Point<double>& P, const Frame& f) {
  return P.x > f.x_min && P.x < f.x_max && P.y > f.y_min && P.y < f.y_max;
}

struct Links {
  Rational r, l;
  Driver driver;
};

// The three loci of a slider-crank in the number T, with the reference position at 30° of the driving link.
template <class T>
struct Loci {
  SliderCrankLoop<T> loop;
  CouplerPosition<T> reference;
  Point<T> C;
  FixedPolode<T> fixed{loop};
  MovingPolode<T> moving{loop, reference};
  CouplerCurve<T> coupler{loop, reference, C};

  explicit Loci(const Links& links)
      : loop{from_rational<T>(links.r), from_rational<T>(links.l), links.driver, Along::ahead},
        reference(coupler_position(loop, {cosine<T>(Turn{Rational(1, 12)}), sine<T>(Turn{Rational(1, 12)})})),
        C{from_rational<T>(Rational(3, 10)), from_rational<T>(Rational(3, 10))} {}
};

const Links exercise{Rational(1, 5), Rational(1, 2), Driver::crank};
const Links long_crank{Rational(1, 2), Rational(1, 5), Driver::coupler};

Point<double> point_at(const BezierArc& b, double s) {
  const double u = 1 - s, p = u * u * u, q = 3 * u * u * s, v = 3 * u * s * s, w = s * s * s;
  return {p * b.start.x + q * b.first_control.x + v * b.second_control.x + w * b.end.x,
          p * b.start.y + q * b.first_control.y + v * b.second_control.y + w * b.end.y};
}

double gap_between(const Point<double>& P, const Point<double>& Q) { return std::hypot(Q.x - P.x, Q.y - P.y); }

// The distance from P to the nearest point of the arc that a search finds: never less than the true one.
double distance_to(const BezierArc& arc, const Point<double>& P) {
  const auto distance_at = [&](double s) { return gap_between(P, point_at(arc, s)); };
  constexpr int steps = 16;
  double best = 0;
  for (int i = 1; i <= steps; ++i)
    if (distance_at(i / 16.0) < distance_at(best)) best = i / 16.0;
  double low = std::max(0.0, best - 1.0 / steps), high = std::min(1.0, best + 1.0 / steps);
  for (int i = 0; i < 60; ++i) {
    const double third = (high - low) / 3;
    (distance_at(low + third) < distance_at(high - third) ? high : low) =
        distance_at(low + third) < distance_at(high - third) ? high - third : low + third;
  }
  return distance_at((low + high) / 2);
}

// A quick lower bound: the arc lies in the box of its control points.
double distance_to_box(const BezierArc& b, const Point<double>& P) {
  const auto [x0, x1] = std::minmax({b.start.x, b.first_control.x, b.second_control.x, b.end.x});
  const auto [y0, y1] = std::minmax({b.start.y, b.first_control.y, b.second_control.y, b.end.y});
  return std::hypot(std::max({0.0, x0 - P.x, P.x - x1}), std::max({0.0, y0 - P.y, P.y - y1}));
}

double distance_to(const Trace& traced, const Point<double>& P) {
  double nearest = 1e300;
  for (const Branch& branch : traced.branches)
    for (const BezierArc& arc : branch.arcs)
      if (distance_to_box(arc, P) < nearest) nearest = std::min(nearest, distance_to(arc, P));
  return nearest;
}

double distance_to_segment(const Point<double>& P, const Point<double>& A, const Point<double>& B) {
  const Vector<double> d = B - A, e = P - A;
  const double share = std::clamp(dot(d, e) / length_squared(d), 0.0, 1.0);
  return gap_between(P, A + share * d);
}

// Of the points of the true curve inside the frame, the farthest from what was traced.
template <class Locus>
double worst_of_curve(const Locus& locus, const Trace& traced) {
  double worst = 0;
  for (const Sample& s : sample(locus, 6007)) {
    const Point<double> P{s.point.x / s.point.w, s.point.y / s.point.w};
    if (is_inside(P, frame)) worst = std::max(worst, distance_to(traced, P));
  }
  return worst;
}

// Of the points traced inside the frame, the farthest from the true curve; the chords of the sample are within
// chord²/(8 R) of it, which the caller allows for.
template <class Locus>
double worst_of_trace(const Locus& locus, const Trace& traced) {
  std::vector<Point<double>> curve;
  for (const Sample& s : sample(locus, 20011)) curve.push_back({s.point.x / s.point.w, s.point.y / s.point.w});
  double worst = 0;
  for (const Branch& branch : traced.branches)
    for (const BezierArc& arc : branch.arcs)
      for (const double s : {0.0, 0.2, 0.35, 0.5, 0.7, 0.9}) {
        const Point<double> P = point_at(arc, s);
        if (!is_inside(P, frame)) continue;
        double nearest = 1e300;
        for (std::size_t i = 1; i < curve.size(); ++i)
          if (gap_between(curve[i - 1], P) < nearest + 0.01)
            nearest = std::min(nearest, distance_to_segment(P, curve[i - 1], curve[i]));
        worst = std::max(worst, nearest);
      }
  return worst;
}

void check_continuous(const Branch& branch) {
  for (std::size_t i = 1; i < branch.arcs.size(); ++i) {
    CHECK(branch.arcs[i].start.x == branch.arcs[i - 1].end.x);
    CHECK(branch.arcs[i].start.y == branch.arcs[i - 1].end.y);
  }
  if (!branch.closed) return;
  CHECK(branch.arcs.front().start.x == branch.arcs.back().end.x);
  CHECK(branch.arcs.front().start.y == branch.arcs.back().end.y);
}

// Within one frame beside the frame: what trace promises. An arc across infinity would not be.
void check_reach(const Trace& traced) {
  const Frame reach{-2.8, -2.4, 3.2, 2.4};
  for (const Branch& branch : traced.branches)
    for (const BezierArc& arc : branch.arcs)
      for (int i = 0; i <= 8; ++i) CHECK(is_inside(point_at(arc, i / 8.0), reach));
}

template <class Locus, class FastLocus>
void check_trace(const char* name, const Locus& locus, const FastLocus& in_doubles, double tolerance) {
  const Trace traced = trace(locus, frame, tolerance);
  const double of_curve = worst_of_curve(in_doubles, traced), of_trace = worst_of_trace(in_doubles, traced);
  INFO(name << ": tolerance " << tolerance << ", promised " << traced.deviation() << ", curve to arcs " << of_curve
            << ", arcs to curve " << of_trace << ", arcs " << traced.arcs());
  CHECK(traced.arcs() > 0);
  CHECK(traced.deviation() <= tolerance);
  CHECK(traced.deviation() > tolerance / 4);
  CHECK(of_curve <= traced.deviation() + 1e-12);  // noise of doubles
  CHECK(of_trace <= traced.deviation() + 2e-6);   // chords of at most 2 mm on a radius of at least 0.25 m
  // The promise counts what is missed along the curve too, and pieces that reach out of the frame; on coarse pieces
  // the intervals are wide as well.
  if (tolerance <= 1e-5) CHECK(of_curve >= traced.deviation() / 15);
  CHECK(traced.gaps.empty());
  for (const Branch& branch : traced.branches) check_continuous(branch);
  check_reach(traced);
}

// A locus made of a formula, for the cases no mechanism offers.
template <class Formula>
struct Locus {
  Formula formula;
  template <class X>
  ProjectivePoint<X> operator()(const Vector<X>& d) const {
    return formula(d);
  }
};
template <class Formula>
Locus(Formula) -> Locus<Formula>;

}  // namespace

TEST_CASE("fit: the bound for t⁴ is what the cubic misses at the middle, h⁴/16", "[curves]") {
  const Arithmetic<Bounded> scope;
  const double h = GENERATE(1.0, 0.5, 0.125);
  const auto curve = []<class X>(const X& t) { return Point<X>{t, square(square(t))}; };
  const auto knot_at = [&](double t) { return knot(t, curve(BoundedTangent::parameter(Bounded(t)))); };
  const FittedArc fitted = fit(knot_at(2), knot_at(2 + h), {Bounded(0), Bounded(1)});
  const double middle = 2 + h / 2,
               missed = std::fabs(point_at(fitted.arc, 0.5).y - middle * middle * middle * middle);
  CHECK(missed == Approx(std::pow(h, 4) / 16));
  CHECK(fitted.deviation() >= missed);
  CHECK(fitted.deviation() <= missed * 1.0001);
}

TEST_CASE("fit: the rounding of the control points is in the bound", "[curves]") {
  const Arithmetic<Bounded> scope;
  // A point that no double is: all that is missed is rounding, known exactly.
  const auto curve = []<class X>(const X&) { return Point<X>{X(1) / X(3), X(1) / X(7)}; };
  const auto knot_at = [&](double t) { return knot(t, curve(BoundedTangent::parameter(Bounded(t)))); };
  FittedArc fitted = fit(knot_at(0), knot_at(1), {Bounded(0), Bounded(0)});
  const Rational x = Rational(fitted.arc.start.x) - Rational(1, 3), y = Rational(fitted.arc.start.y) - Rational(1, 7);
  CHECK(fitted.interpolation == 0);
  CHECK(Rational(fitted.deviation()) * Rational(fitted.deviation()) >= x * x + y * y);
  CHECK(fitted.deviation() < 1e-15);
  // A start drawn elsewhere, where the pen is, counts as well.
  Knot moved = knot_at(0);
  moved.drawn.x += 0.25;
  fitted = fit(moved, knot_at(1), {Bounded(0), Bounded(0)});
  CHECK(fitted.deviation() >= 0.25);
  CHECK(fitted.deviation() < 0.250001);
}

TEST_CASE("fit: so is the rounding of inner control points between ends that are exact", "[curves]") {
  const Arithmetic<Bounded> scope;
  // t(t-1)/3 from 0 to 1: the ends are 0, the inner control points both -1/9.
  const auto curve = []<class X>(const X& t) { return Point<X>{t * (t - X(1)) / X(3), t}; };
  const auto knot_at = [&](double t) { return knot(t, curve(BoundedTangent::parameter(Bounded(t)))); };
  const FittedArc fitted = fit(knot_at(0), knot_at(1), {Bounded(0), Bounded(0)});
  CHECK(fitted.arc.start.x == 0);
  CHECK(fitted.arc.end.x == 0);
  for (const double control : {fitted.arc.first_control.x, fitted.arc.second_control.x}) {
    const Rational missed = Rational(control) + Rational(1, 9);
    CHECK(missed != Rational(0));
    CHECK(Rational(fitted.deviation()) * Rational(fitted.deviation()) >= missed * missed);
  }
}

TEST_CASE("fit: each component and each control point has its part in the bound", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Bounded wide(-1, 3), point(0);
  const auto bound = [](const Vector<Bounded>& d0, const Vector<Bounded>& d1, const Vector<Bounded>& fourth) {
    const Knot a{0, {Bounded(0), Bounded(0)}, d0, {0, 0}}, b{3, {Bounded(0), Bounded(0)}, d1, {0, 0}};
    return fit(a, b, fourth).deviation();
  };
  // The widths of a third of h = 3 times the derivative are those of the derivative: 2 to each side of the middle.
  CHECK(bound({wide, point}, {point, point}, {point, point}) == 2);
  CHECK(bound({point, wide}, {point, point}, {point, point}) == 2);
  CHECK(bound({point, point}, {wide, point}, {point, point}) == 2);
  CHECK(bound({point, point}, {point, wide}, {point, point}) == 2);
  CHECK(bound({point, point}, {point, point}, {wide, point}) == 81 * 3 / 16.0);
  CHECK(bound({point, point}, {point, point}, {point, wide}) == 81 * 3 / 16.0);
}

TEST_CASE("fit: without bounds there is no promise", "[curves]") {
  const Arithmetic<Bounded> scope;
  const double infinity = std::numeric_limits<double>::infinity();
  const Point<Bounded> at{Bounded(0), Bounded(0)};
  const Vector<Bounded> calm{Bounded(1), Bounded(0)};
  for (const Bounded& wild : {Bounded(-infinity, infinity), Bounded(1, infinity), Bounded(-infinity, 0)}) {
    const Knot a{0, at, calm, {0, 0}}, end{1, at, calm, {0, 0}}, b{1, at, {Bounded(0), wild}, {0, 0}};
    CHECK(fit(a, b, calm).deviation() == infinity);
    CHECK(fit(a, end, {Bounded(0), wild}).deviation() == infinity);
  }
}

TEST_CASE("fit: the mean value theorem narrows the fourth coefficient and keeps what is true", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Bounded t(1, 1.5);
  const auto fifth_power = []<class X>(const X& x) { return square(square(x)) * x; };  // c[4] = 5 t
  const Bounded true_range = fourth_coefficient(fifth_power(BoundedSeries::parameter(t)),
                                                fifth_power(BoundedSeries::parameter(Bounded(1.25))), t, 1.25);
  CHECK(true_range.inf() == 5);
  CHECK(true_range.sup() == 7.5);
  const auto bell = []<class X>(const X& x) { return quotient(X(1), X(1) + square(x)); };
  const Bounded piece(1, 1.0625);
  const BoundedSeries over = bell(BoundedSeries::parameter(piece));
  const double middle = 1.03125;
  const Bounded narrow = fourth_coefficient(over, bell(BoundedSeries::parameter(Bounded(middle))), piece, middle);
  CHECK(narrow.sup() - narrow.inf() < (over.c[4].sup() - over.c[4].inf()) / 2);
  for (const double x : {1.0, 1.015625, middle, 1.046875, 1.0625})
    CHECK(narrow.do_overlap(bell(BoundedSeries::parameter(Bounded(x))).c[4]));
}

TEST_CASE("trace: the promised deviation holds against dense samples, and is not silly", "[curves]") {
  const Arithmetic<Bounded> scope;
  const double tolerance = GENERATE(1e-3, 1e-4, 1e-5);
  const bool is_crank_shorter = GENERATE(true, false);
  const Links& links = is_crank_shorter ? exercise : long_crank;
  const Loci<Bounded> loci(links);
  const Loci<Fast> in_doubles(links);
  check_trace("fixed polode", loci.fixed, in_doubles.fixed, tolerance);
  check_trace("moving polode", loci.moving, in_doubles.moving, tolerance);
  check_trace("coupler curve", loci.coupler, in_doubles.coupler, tolerance);
}

TEST_CASE("trace: the number of arcs grows with the fourth root of what is asked", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Loci<Bounded> loci(exercise);
  const auto arcs = [&](double tolerance) {
    return static_cast<double>(trace(loci.coupler, frame, tolerance).arcs());
  };
  CHECK(arcs(1e-8 / 2) / arcs(1e-8) == Approx(std::pow(2, 0.25)).epsilon(0.05));
  CHECK(arcs(1e-8 / 16) / arcs(1e-8) == Approx(2).epsilon(0.05));
  CHECK(arcs(1e-8 / 256) / arcs(1e-8) == Approx(4).epsilon(0.05));
}

TEST_CASE("trace: the fixed polode leaves the frame and comes back, and is not joined across", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Trace traced = trace(Loci<Bounded>(exercise).fixed, frame, 1e-4);
  REQUIRE(traced.branches.size() == 2);
  CHECK(traced.gaps.empty());
  for (const Branch& branch : traced.branches) {
    CHECK(!branch.closed);
    CHECK(!is_inside(branch.arcs.front().start, frame));
    CHECK(!is_inside(branch.arcs.back().end, frame));
    // Each on its side of the asymptote, from below to above or back.
    const double asymptote = std::sqrt(0.21);
    const bool is_outer = branch.arcs.front().start.x > asymptote;
    for (const BezierArc& arc : branch.arcs) CHECK((arc.end.x > asymptote) == is_outer);
    CHECK(branch.arcs.front().start.y * branch.arcs.back().end.y < 0);
    CHECK(branch.from.x * branch.to.x > 0);  // the crank does not pass ±90° on the way
  }
}

TEST_CASE("trace: however coarse the tolerance, nothing reaches farther than a frame beside the frame", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Loci<Bounded> loci(exercise);
  check_reach(trace(loci.fixed, frame, 1e3));
  check_reach(trace(loci.moving, frame, 1e3));
}

TEST_CASE("trace: the coupler curve is one closed branch, also with the crank longer", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Frame wide{-3, -3, 3, 3};
  for (const Links& links : {exercise, long_crank}) {
    const Trace traced = trace(Loci<Bounded>(links).coupler, wide, 1e-4);
    REQUIRE(traced.branches.size() == 1);
    CHECK(traced.branches.front().closed);
    CHECK(traced.gaps.empty());
    check_continuous(traced.branches.front());
  }
}

TEST_CASE("trace: a crank longer than the coupler closes for part of the turn, and the rest is stated", "[curves]") {
  const Arithmetic<Bounded> scope;
  const SliderCrankLoop<Bounded> loop{Bounded(5) / Bounded(10), Bounded(2) / Bounded(10)};
  const Trace traced = trace(FixedPolode<Bounded>{loop}, frame, 1e-4);
  CHECK(traced.branches.size() == 2);
  double absent = 0, undecided = 0;
  for (const Gap& gap : traced.gaps) (gap.cause == Gap::Cause::absent ? absent : undecided) += gap.width;
  CHECK(absent == Approx(2 * (M_PI - 2 * std::asin(0.4))));
  CHECK(undecided > 0);
  CHECK(undecided < 1e-10);
  // At the ends the coupler stands square to the guide, B under A: the crank at arcsin(l/r), and P₀ in A.
  for (const Branch& branch : traced.branches) {
    CHECK(std::fabs(branch.from.y) == Approx(0.4));
    CHECK(std::fabs(branch.arcs.front().start.y) == Approx(0.2).margin(1e-4));
    CHECK(std::fabs(branch.arcs.back().end.y) == Approx(0.2).margin(1e-4));
  }
}

TEST_CASE("trace: Cardano's circles for l = r, but for the instant at which the linkage folds", "[curves]") {
  const Arithmetic<Bounded> scope;
  const SliderCrankLoop<Bounded> loop{Bounded(3) / Bounded(10), Bounded(3) / Bounded(10)};
  const auto reference = coupler_position(loop, Vector<Bounded>{Bounded(15) / Bounded(17), Bounded(8) / Bounded(17)});
  const auto check_circle = [](const Branch& branch, const Point<double>& centre, double radius) {
    for (const BezierArc& arc : branch.arcs)
      for (int i = 0; i <= 8; ++i)
        CHECK(std::fabs(gap_between(centre, point_at(arc, i / 8.0)) - radius) <= branch.deviation + 1e-15);
  };
  const Trace fixed = trace(FixedPolode<Bounded>{loop}, frame, 1e-4);
  const Trace moving = trace(MovingPolode<Bounded>{loop, reference}, frame, 1e-4);
  for (const Trace& traced : {fixed, moving}) {
    CHECK(traced.branches.size() == 2);
    REQUIRE(traced.gaps.size() == 2);
    for (const Gap& gap : traced.gaps) {
      CHECK(gap.cause == Gap::Cause::undecided);
      CHECK(std::fabs(gap.from.y) == Approx(1));
      CHECK(gap.width < 1e-4);
    }
  }
  // For half of the turn the pole runs along half of the large circle; for the other half it rests at A₀ = B.
  const Point<double> A{0.3 * 15 / 17, 0.3 * 8 / 17};
  for (const Branch& branch : fixed.branches)
    check_circle(branch, {0, 0}, std::fabs(branch.arcs.front().end.y) > 0.01 ? 0.6 : 0.0);
  for (const Branch& branch : moving.branches) check_circle(branch, A, 0.3);
}

TEST_CASE("trace: a change of scale by a power of two changes nothing but the scale", "[curves]") {
  const Arithmetic<Bounded> scope;
  const int power = GENERATE(-300, -30, 30, 200);
  const double scale = std::ldexp(1.0, power);
  const auto traced = [](double s) {
    const SliderCrankLoop<Bounded> loop{Bounded(s * 0.25), Bounded(s * 0.5)};
    return trace(FixedPolode<Bounded>{loop}, {-s, -s, s, s}, s * 1e-4);
  };
  const Trace small = traced(1), large = traced(scale);
  REQUIRE(small.branches.size() == large.branches.size());
  REQUIRE(small.arcs() == large.arcs());
  CHECK(small.deviation() * scale == large.deviation());
  CHECK(small.branches[0].arcs[3].end.x * scale == large.branches[0].arcs[3].end.x);
}

// A four-bar that can be folded flat, on an oblique frame: the square whose root places B touches zero there, of
// which intervals see no more than that it may. Without an end pieces would have to be as short as the square of
// their distance from that crank: five million looks (observed), here for a frame that B never enters.
TEST_CASE("trace: beside a change point the looks are counted", "[curves]") {
  const FourBarLengths lengths{Rational(1, 10), Rational(2, 5), Rational(1, 5), Rational(3, 10), Rational(2, 5)};
  long looks = 0;
  const auto B = [&]<class X>(const Vector<X>& crank) {
    ++looks;
    return projective(four_bar(lengths, crank, Side::left).B);
  };
  for (const Frame& shown : {Frame{-0.8, -0.8, 1.2, 0.8}, Frame{-0.03, -0.03, 0.03, 0.03}}) {
    looks = 0;
    const Trace traced = trace(B, shown, 1e-5);
    CHECK(looks < 150000);
    double left_out = 0;
    for (const Gap& gap : traced.gaps) left_out += gap.width;
    CHECK(left_out < 0.02);
  }
}

TEST_CASE("trace: what doubles cannot follow is a stated gap, never a number that is not finite", "[curves]") {
  const Arithmetic<Bounded> scope;
  const double s = 1e200;  // squares overflow
  const Trace huge = trace(FixedPolode<Bounded>{{Bounded(s * 0.25), Bounded(s * 0.5)}}, {-s, -s, s, s}, s * 1e-4);
  CHECK(huge.branches.empty());
  REQUIRE(huge.gaps.size() == 1);
  CHECK(huge.gaps.front().width == Approx(2 * M_PI));

  // On the way there: derivatives overflow before positions do.
  for (double scale = 1e60; scale < 1e160; scale *= 10) {
    const SliderCrankLoop<Bounded> loop{Bounded(scale * 0.25), Bounded(scale * 0.5)};
    const Trace large = trace(FixedPolode<Bounded>{loop}, {-scale, -scale, scale, scale}, scale * 1e-4);
    for (const Branch& branch : large.branches) {
      CHECK(branch.deviation <= scale * 1e-4);
      for (const BezierArc& arc : branch.arcs)
        CHECK(
            (std::isfinite(arc.first_control.x) && std::isfinite(arc.second_control.y) && std::isfinite(arc.end.x)));
    }
  }

  const Locus nowhere{[]<class X>(const Vector<X>&) -> ProjectivePoint<X> { throw Undecided("always"); }};
  const Trace nothing = trace(nowhere, frame, 1e-4);
  CHECK(nothing.branches.empty());
  REQUIRE(nothing.gaps.size() == 1);
  CHECK(nothing.gaps.front().cause == Gap::Cause::undecided);
  CHECK(nothing.gaps.front().width == Approx(2 * M_PI));

  // A tolerance finer than doubles are at this size.
  const Trace too_fine = trace(Loci<Bounded>(exercise).coupler, frame, 1e-17);
  CHECK(too_fine.branches.empty());
  REQUIRE(too_fine.gaps.size() == 1);
}

TEST_CASE("trace: what is proved outside is neither drawn nor a gap; the start of the turn is no end", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Locus circle{[]<class X>(const Vector<X>& d) { return ProjectivePoint<X>{d.x, d.y, X(1)}; }};
  const Trace away = trace(circle, {3, 3, 4, 4}, 1e-4);
  CHECK(away.branches.empty());
  CHECK(away.gaps.empty());
  // A frame about (3/5, -4/5), where the turn begins: one branch, not two.
  const Trace about_start = trace(circle, {0.5, -0.9, 0.7, -0.7}, 1e-6);
  REQUIRE(about_start.branches.size() == 1);
  CHECK(!about_start.branches.front().closed);
  check_continuous(about_start.branches.front());
  const Trace whole = trace(circle, {-2, -2, 2, 2}, 1e-4);
  REQUIRE(whole.branches.size() == 1);
  CHECK(whole.branches.front().closed);
}

// Where the coupler touches the square to the guide and the linkage could change its closure, the pieces are short;
// in whatever direction the guide lies they must not be millions.
TEST_CASE("trace: a linkage that just closes, on a guide of any direction", "[curves]") {
  const Arithmetic<Bounded> scope;
  const auto rational = [](int p, int q) { return from_rational<Bounded>(Rational(p, q)); };
  const auto [l, e] = GENERATE(std::pair{20, 0}, std::pair{30, 10});
  const Turn guide{Rational(GENERATE(0, 1, 7), 18)};
  const SliderCrankLoop<Bounded> loop{rational(1, 5),   rational(l, 100),
                                      Driver::crank,    Along::ahead,
                                      rational(e, 100), {cosine<Bounded>(guide), sine<Bounded>(guide)}};
  const Trace traced = trace(FixedPolode<Bounded>{loop}, frame, 1e-4);
  CHECK(traced.arcs() < 1000);
  REQUIRE(traced.gaps.size() == (e == 0 ? 2U : 1U));
  for (const Gap& gap : traced.gaps) {
    CHECK(gap.cause == Gap::Cause::undecided);
    CHECK(gap.width < 1e-5);
  }
}

TEST_CASE("asymptotes: the fixed polode's is x = √(l² - r²), with the crank at ±90°", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Loci<Bounded> loci(exercise);
  const Asymptotes found = asymptotes(loci.fixed);
  const Bounded closed_form = root(from_rational<Bounded>(Rational(21, 100)));
  REQUIRE(found.lines.size() == 2);
  CHECK(found.open.empty());
  for (const Asymptote& asymptote : found.lines) {
    const Bounded offset = -(asymptote.enclosure.c / asymptote.enclosure.a);
    CHECK(offset.do_overlap(closed_form));
    CHECK(offset.sup() - offset.inf() < 1e-14);
    CHECK(asymptote.enclosure.b.do_overlap(Bounded(0)));
    CHECK(asymptote.direction.x.do_overlap(Bounded(0)));
    CHECK(asymptote.enclosure.c.inf() <= asymptote.line.c);
    CHECK(asymptote.line.c <= asymptote.enclosure.c.sup());
  }
}

TEST_CASE("asymptotes: the moving polode's, carried forth, is the fixed one's: both are rolled on at infinity",
          "[curves]") {
  const Arithmetic<Bounded> scope;
  const Loci<Bounded> loci(exercise);
  const Asymptotes found = asymptotes(loci.moving);
  REQUIRE(found.lines.size() == 2);
  const Bounded closed_form = root(from_rational<Bounded>(Rational(21, 100)));
  for (const Asymptote& asymptote : found.lines) {
    const auto position = coupler_position(loci.loop, asymptote.direction);
    const Transport<Bounded> forth(loci.reference.A, loci.reference.B, position.A, position.B);
    const Line<Bounded>& l = asymptote.enclosure;
    const Point<Bounded> on_line{-(l.a * l.c), -(l.b * l.c)}, carried = forth(on_line);
    const Vector<Bounded> along = forth(l.direction());
    CHECK(carried.x.do_overlap(closed_form));
    CHECK(carried.x.sup() - carried.x.inf() < 1e-12);
    CHECK(along.x.do_overlap(Bounded(0)));
  }
}

// The closed forms √(l² - (r ∓ e)²) of the second route, for r = 1/5, l = 1/2, e = 2/25, guide along (4/5, 3/5).
TEST_CASE("asymptotes: those of an offset, inclined slider-crank are two, square to the guide", "[curves]") {
  const Arithmetic<Bounded> scope;
  const auto rational = [](int p, int q) { return from_rational<Bounded>(Rational(p, q)); };
  const Vector<Bounded> along{rational(4, 5), rational(3, 5)};
  const SliderCrankLoop<Bounded> loop{rational(1, 5), rational(1, 2),  Driver::crank,
                                      Along::ahead,   rational(2, 25), along};
  const auto reference = coupler_position(loop, {rational(15, 17), rational(8, 17)});
  const Asymptotes fixed = asymptotes(FixedPolode<Bounded>{loop});
  const Asymptotes moving = asymptotes(MovingPolode<Bounded>{loop, reference});
  REQUIRE(fixed.lines.size() == 2);
  REQUIRE(moving.lines.size() == 2);
  CHECK(fixed.open.empty());
  const analytic::SliderCrank linkage{{1, 5}, {1, 2}, {3, 10}, {2, 5}, {2, 25}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Asymptote& asymptote = fixed.lines[i];
    const bool on_left = asymptote.direction.y.inf() > 0;  // of the crank, as seen from the guide
    const Bounded expected = *analytic::asymptote_of_fixed_polode<Bounded>(linkage, on_left);
    // Its normal is the guide's direction, up to the sense; so is its distance from A₀.
    const Vector<Bounded> normal{asymptote.enclosure.a, asymptote.enclosure.b};
    const Bounded sense = dot(normal, along);
    CHECK(cross(normal, along).do_overlap(Bounded(0)));
    CHECK((-(asymptote.enclosure.c * sense)).do_overlap(expected));
    CHECK(expected.sup() - expected.inf() < 1e-14);
    // The moving polode's, carried forth, is the same line.
    const auto position = coupler_position(loop, asymptote.direction);
    const Transport<Bounded> forth(reference.A, reference.B, position.A, position.B);
    const Line<Bounded>& l = moving.lines[i].enclosure;
    const Point<Bounded> carried = forth(Point<Bounded>{-(l.a * l.c), -(l.b * l.c)});
    const Bounded beside = dot(carried - Point<Bounded>{Bounded(0), Bounded(0)}, along) - expected;
    CHECK(beside.do_overlap(Bounded(0)));
    CHECK(beside.sup() - beside.inf() < 1e-12);
  }
  CHECK(fixed.lines[0].direction.y.inf() * fixed.lines[1].direction.y.inf() < 0);
}

TEST_CASE("asymptotes: at a joint of the turn found once; a touching zero is left open", "[curves]") {
  const Arithmetic<Bounded> scope;
  const Locus at_joint{[]<class X>(const Vector<X>& d) {
    return ProjectivePoint<X>{d.x, d.y, X(4) * d.x - X(3) * d.y};
  }};
  const Asymptotes joint = asymptotes(at_joint);
  REQUIRE(joint.lines.size() == 2);
  CHECK(joint.open.empty());
  const Locus touching{[]<class X>(const Vector<X>& d) { return ProjectivePoint<X>{d.x, d.y, square(d.y)}; }};
  const Asymptotes open = asymptotes(touching);
  CHECK(open.lines.empty());
  REQUIRE(open.open.size() == 2);
  for (const Gap& gap : open.open) CHECK(gap.width < 1e-6);
  // Intervals find this wider than it is: pieces beside a zero seem to have one, until the signs at their ends tell.
  const Locus wide{[]<class X>(const Vector<X>& d) {
    return ProjectivePoint<X>{d.x, d.y, d.y * (square(d.x) + square(d.y)) - X(13) / X(16)};
  }};
  const Asymptotes both = asymptotes(wide);
  REQUIRE(both.lines.size() == 2);
  CHECK(both.open.empty());
  for (const Asymptote& asymptote : both.lines) CHECK(asymptote.direction.y.do_overlap(Bounded(0.8125)));
  CHECK(asymptotes(Loci<Bounded>(exercise).coupler).lines.empty());
}
