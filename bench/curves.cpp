#include "bench/curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "bench/timing.h"
#include "drawings/page.h"
#include "exercises/kit/proof/place.h"
#include "geometry/curves/four_bar_loci.h"
#include "geometry/curves/polodes.h"
#include "geometry/curves/roulettes.h"
#include "geometry/mechanisms/second_order.h"

namespace epure::bench {
namespace {

using namespace geometry;

struct MeasuredCurve {
  const char* name;
  // The point at a share from 0 to 1 of the whole; none where it lies outside of what is drawn.
  std::function<std::optional<Place>(double)> at;
  // Drawn to a tolerance.
  std::function<SpanTrace(double)> arcs;
};

// metres
constexpr double full_turn = 2 * std::numbers::pi;
constexpr Frame frame{-1, -1, 1, 1};

bool is_inside(const Place& P) {
  return P.x > frame.x_min && P.x < frame.x_max && P.y > frame.y_min && P.y < frame.y_max;
}

// `at` of the rolling angle, by the closed formula on doubles: what who samples would write.
template <class At>
MeasuredCurve roulette(const char* name, const Rolling& rolling, double to, const At& at) {
  const Roulette curve{rolling};
  return {name, [=](double share) { return std::optional(at(share * to)); },
          [=](double tolerance) { return trace_span(curve, 0, to, tolerance); }};
}

// The point of a four-bar's coupler, its givens read once.
ProjectivePoint<double> coupler_point(const DrivenFourBar::On<double>& of, const Vector<double>& crank) {
  return projective(of.C(of.position(crank)));
}

template <class OnDoubles, class OnBounded>
MeasuredCurve locus(const char* name, const OnDoubles& fast, const OnBounded& bounded) {
  return {name,
          [=](double share) -> std::optional<Place> {
            const Vector<double> crank{std::cos(full_turn * share), std::sin(full_turn * share)};
            const ProjectivePoint<double> P = fast(crank);
            if (P.w == 0) return {};
            const Place at = finite(P);
            return is_inside(at) ? std::optional(at) : std::nullopt;
          },
          [=](double tolerance) {
            const Arithmetic<Bounded> scope;
            const Trace traced = trace(bounded, frame, tolerance);
            SpanTrace all{.deviation = traced.deviation()};
            for (const Branch& branch : traced.branches)
              all.arcs.insert(all.arcs.end(), branch.arcs.begin(), branch.arcs.end());
            return all;
          }};
}

template <class T>
SliderCrankLoop<T> slider_crank_of_n1() {
  return {.r = from_rational<T>(Rational(1, 5)), .l = from_rational<T>(Rational(1, 2))};
}

std::vector<MeasuredCurve> curves() {
  const FourBarCouplerCurve coupler{
      {Rational(3, 20), Rational(37, 100), Rational(9, 20), Rational(2, 5), Rational(0)},
      Side::left,
      Rational(1, 5),
      Rational(3, 20)};
  const DrivenFourBar::On<double> driven(
      DrivenFourBar{coupler.of, coupler.side, 1, 0, coupler.along / coupler.of.AB, coupler.across / coupler.of.AB});
  const auto cycloid = [](double phi) { return Place{0.1 * (phi - std::sin(phi)), 0.1 * (1 - std::cos(phi))}; };
  const auto involute = [](double phi) {
    return Place{0.1 * (std::cos(phi) + phi * std::sin(phi)), 0.1 * (std::sin(phi) - phi * std::cos(phi))};
  };
  const Arithmetic<Bounded> scope;
  return {roulette("cycloid", {.how = Rolls::circle_on_line, .r = Rational(1, 10), .d = Rational(1, 10)}, full_turn,
                   cycloid),
          roulette("involute", {.how = Rolls::line_on_circle, .R = Rational(1, 10)}, full_turn / 2, involute),
          locus(
              "coupler curve", [=](const Vector<double>& crank) { return coupler_point(driven, crank); }, coupler),
          locus("polode", FixedPolode<double>{slider_crank_of_n1<double>()},
                FixedPolode<Bounded>{slider_crank_of_n1<Bounded>()})};
}

Place on_arc(const BezierArc& arc, double t) {
  const double s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
  return {a * arc.start.x + b * arc.first_control.x + c * arc.second_control.x + d * arc.end.x,
          a * arc.start.y + b * arc.first_control.y + c * arc.second_control.y + d * arc.end.y};
}

// From the nearest of a few points of the arc on, by halving steps.
double from_arc(const BezierArc& arc, const Place& P) {
  constexpr int few = 8;
  double best_t = 0, best = INFINITY;
  const auto look = [&](double t) {
    if (t < 0 || t > 1) return;
    if (const double d = distance(P, on_arc(arc, t)); d < best) best = d, best_t = t;
  };
  for (int i = 0; i <= few; ++i) look(static_cast<double>(i) / few);
  for (double step = 0.5 / few; step > 1e-9; step /= 2) {
    const double t = best_t;
    look(t - step);
    look(t + step);
  }
  return best;
}

// How far points of the true curve are from the arcs at most.
double farthest_from(const std::vector<BezierArc>& arcs, const MeasuredCurve& of) {
  constexpr int points = 2000;
  double farthest = 0;
  for (int i = 0; i <= points; ++i) {
    const std::optional<Place> P = of.at(static_cast<double>(i) / points);
    if (!P) continue;
    // No arc is longer than its polygon: those that start too far away are passed over.
    double nearest = INFINITY;
    for (const BezierArc& arc : arcs) {
      const double reach = distance(arc.start, arc.first_control) + distance(arc.first_control, arc.second_control) +
                           distance(arc.second_control, arc.end);
      if (distance(*P, arc.start) - reach < nearest) nearest = std::min(nearest, from_arc(arc, *P));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

double from_segment(const Place& P, const Place& from, const Place& to) {
  const double x = to.x - from.x, y = to.y - from.y, squared = x * x + y * y;
  const double t = squared > 0 ? std::clamp(((P.x - from.x) * x + (P.y - from.y) * y) / squared, 0.0, 1.0) : 0;
  return distance(P, {from.x + t * x, from.y + t * y});
}

using Line = std::vector<Place>;

// The points at n equal steps; a new line after each gap.
std::vector<Line> uniform(const MeasuredCurve& of, std::size_t n) {
  std::vector<Line> lines(1);
  for (std::size_t i = 0; i <= n; ++i) {
    if (const auto P = of.at(static_cast<double>(i) / static_cast<double>(n)))
      lines.back().push_back(*P);
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  return lines;
}

double deviation_of_uniform(const MeasuredCurve& of, std::size_t n) {
  constexpr int between = 4;
  double farthest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = [&](double part) { return of.at((static_cast<double>(i) + part) / static_cast<double>(n)); };
    const std::optional<Place> from = at(0), to = at(1);
    if (!from || !to) continue;
    for (int k = 1; k < between; ++k)
      if (const auto P = at(static_cast<double>(k) / between))
        farthest = std::max(farthest, from_segment(*P, *from, *to));
  }
  return farthest;
}

// The deviation falls with the square of the number of lines. 0 when a hundred thousand are too few.
std::size_t lines_needed(const MeasuredCurve& of, double tolerance) {
  for (std::size_t n = 16; n <= 100000;) {
    const double deviation = deviation_of_uniform(of, n);
    if (deviation <= tolerance) return n;
    const double wanted = 1.02 * static_cast<double>(n) * std::sqrt(deviation / tolerance);
    n = std::max(n + 1, static_cast<std::size_t>(wanted));
  }
  return 0;
}

// Bytes that paths add to a PDF, 150 mm for a metre.
std::size_t bytes_of(const std::vector<drawings::Path>& paths) {
  drawings::Page page{"curve", "curve", "", {{0, 0}, {297, 210}}, drawings::Language::english, {}};
  const std::size_t empty = drawings::write_pdf({page}, {}).size();
  for (const drawings::Path& path : paths) {
    drawings::Stroke stroke;
    stroke.path = path;
    page.primitives.emplace_back(stroke);
  }
  return drawings::write_pdf({page}, {}).size() - empty;
}

drawings::Point on_paper(const Place& P) { return {150 + 150 * P.x, 100 + 150 * P.y}; }

std::vector<drawings::Path> paths_of(const std::vector<BezierArc>& arcs) {
  std::vector<drawings::Path> paths;
  for (const BezierArc& arc : arcs) {
    const drawings::Point start = on_paper(arc.start);
    const drawings::Point* before = paths.empty() ? nullptr : &paths.back().pieces.back().end;
    if (!before || before->x != start.x || before->y != start.y) paths.push_back({start, {}});
    paths.back().pieces.push_back(
        {false, on_paper(arc.first_control), on_paper(arc.second_control), on_paper(arc.end)});
  }
  return paths;
}

std::vector<drawings::Path> paths_of(const std::vector<Line>& lines) {
  std::vector<drawings::Path> paths;
  for (const Line& line : lines) {
    std::vector<drawings::Point> corners;
    for (const Place& P : line) corners.push_back(on_paper(P));
    if (corners.size() > 1) paths.push_back(drawings::polyline(corners, false));
  }
  return paths;
}

CurveResult measure(const MeasuredCurve& of, double tolerance, double budget) {
  CurveResult result{.curve = of.name, .tolerance = tolerance};
  const SpanTrace traced = of.arcs(tolerance);
  result.proved = traced.deviation;
  result.verified = farthest_from(traced.arcs, of);
  result.arcs = traced.arcs.size();
  result.ms = 1e3 * seconds_per_call([&] { of.arcs(tolerance); }, budget / 2);
  result.bytes = bytes_of(paths_of(traced.arcs));
  result.uniform_lines = lines_needed(of, tolerance);
  if (result.uniform_lines == 0) return result;
  result.uniform_ms = 1e3 * seconds_per_call([&] { uniform(of, result.uniform_lines); }, budget / 2);
  result.uniform_bytes = bytes_of(paths_of(uniform(of, result.uniform_lines)));
  return result;
}

}  // namespace

std::vector<CurveResult> measure_curves(int decades, double budget) {
  std::vector<CurveResult> results;
  for (const MeasuredCurve& curve : curves())
    for (int i = 0; i < decades; ++i) results.push_back(measure(curve, std::pow(10, -4 - i), budget / (4 * decades)));
  return results;
}

}  // namespace epure::bench
