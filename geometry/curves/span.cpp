#include "geometry/curves/span.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "geometry/curves/hermite.h"

namespace epure::geometry {

namespace {

// The shortest piece tried, as a part of the span. Where a root vanishes shorter ones would fail too, and doubles
// still tell its two ends apart.
constexpr double shortest_share = 0x1p-40;
// How many pieces are tried. A curve on paper takes some hundreds; a span of which doubles tell few points apart, any
// number.
constexpr int most_pieces = 65536;

class SpanTracer {
 public:
  SpanTracer(const SpannedCurve& curve, double to, double tolerance)
      : curve_(curve), to_(to), tolerance_(tolerance) {}

  SpanTrace from(double from) {
    const double shortest = (to_ - from) * shortest_share;
    start_ = knot_at(from);
    length_ = to_ - from;
    for (int look = 0; start_->t < to_; ++look) {
      if (look == most_pieces || !(length_ >= shortest) || stop() <= start_->t)
        throw Undecided("intervals of doubles cannot follow a curve to the tolerance it is to be drawn with",
                        "gli intervalli di double non possono seguire una curva con la tolleranza del disegno");
      try_piece(stop());
    }
    return std::move(trace_);
  }

 private:
  // What remains is shared out evenly, so that the span does not end with a crumb.
  double stop() const {
    const double remaining = to_ - start_->t, pieces = std::ceil(remaining / length_);
    return pieces <= 1 ? to_ : std::min(to_, start_->t + remaining / pieces);
  }

  // Draws up to `end` and proposes the length of the next piece, or only proposes a shorter one.
  void try_piece(double end) {
    const double length = end - start_->t;
    const Knot there = knot_at(end);
    const auto fourth = fourth_coefficients(end);
    if (!fourth) {
      length_ = length / 2;
      return;
    }
    const FittedArc fitted = fit(*start_, there, *fourth);
    // Half of the tolerance at most for what doubles miss: a shorter piece would not help.
    const bool is_settled = fitted.rounding <= tolerance_ / 2, keeps = fitted.deviation() <= tolerance_;
    length_ = length * (is_settled ? std::max(0.125, fitted.growth(tolerance_)) : 0.5);
    if (!is_settled || !keeps) {
      length_ = std::min(length_, 0.875 * length);
      return;
    }
    trace_.arcs.push_back(fitted.arc);
    trace_.deviation = std::max(trace_.deviation, fitted.deviation());
    start_ = there;
  }

  Knot knot_at(double t) const { return knot(t, curve_.at(BoundedTangent::parameter(Bounded(t)))); }

  // Empty when the construction cannot decide over so long a piece.
  std::optional<Vector<Bounded>> fourth_coefficients(double end) const {
    const double m = start_->t + (end - start_->t) / 2;
    const Bounded all(start_->t, end);
    try {
      const Point<BoundedSeries> over = curve_.over(BoundedSeries::parameter(all));
      const Point<BoundedSeries> middle = curve_.over(BoundedSeries::parameter(Bounded(m)));
      return Vector<Bounded>{fourth_coefficient(over.x, middle.x, all, m),
                             fourth_coefficient(over.y, middle.y, all, m)};
    } catch (const Undecided&) {
      return std::nullopt;
    }
  }

  const SpannedCurve& curve_;
  const double to_, tolerance_;
  std::optional<Knot> start_;
  double length_ = 0;  // of the next piece to try
  SpanTrace trace_;
};

}  // namespace

SpanTrace trace_span(const SpannedCurve& curve, double from, double to, double tolerance) {
  assert(std::isfinite(from) && std::isfinite(to) && from <= to && "a span that runs backwards");
  if (from == to)
    throw Undecided("the ends of a curve are one double, which cannot tell its course",
                    "gli estremi di una curva sono un solo double, che non può dirne l'andamento");
  assert(tolerance > 0 && "a tolerance that is not positive");
  const Arithmetic<Bounded> scope;
  return SpanTracer(curve, to, tolerance).from(from);
}

}  // namespace epure::geometry
