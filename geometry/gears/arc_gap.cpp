#include "geometry/gears/arc_gap.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace epure::geometry {

namespace {

// Pairs that are halved. Two flanks a thousandth of a millimetre apart take some hundred; a set of arcs that touches
// another would take any number.
constexpr int most_looks = 200000;

Point<double> middle(const Point<Bounded>& P) {
  return {P.x.inf() / 2 + P.x.sup() / 2, P.y.inf() / 2 + P.y.sup() / 2};
}

struct Range {
  double low = INFINITY, high = -INFINITY;
  void cover(const Bounded& x) { low = std::min(low, x.inf()), high = std::max(high, x.sup()); }
};

// How far apart two ranges are at least; negative by as much as they overlap. Rounded down: upwards is the scope's
// way.
double apart(const Range& a, const Range& b) { return std::max(-(a.high - b.low), -(b.high - a.low)); }

struct Piece {
  EnclosedArc arc;
  Range x, y;

  explicit Piece(const EnclosedArc& of) : arc(of) {
    for (const Point<Bounded>& P : arc) x.cover(P.x), y.cover(P.y);
  }
  Range along(const Vector<double>& n) const {
    Range range;
    for (const Point<Bounded>& P : arc) range.cover(Bounded(n.x) * P.x + Bounded(n.y) * P.y);
    return range;
  }
  Vector<double> chord() const { return middle(arc[3]) - middle(arc[0]); }
  double size() const { return std::hypot(x.high - x.low, y.high - y.low); }
};

Point<Bounded> halfway(const Point<Bounded>& P, const Point<Bounded>& Q) {
  return {Bounded(0.5) * (P.x + Q.x), Bounded(0.5) * (P.y + Q.y)};
}

std::array<Piece, 2> halves(const Piece& piece) {
  const auto& [a, b, c, d] = piece.arc;
  const Point<Bounded> ab = halfway(a, b), bc = halfway(b, c), cd = halfway(c, d);
  const Point<Bounded> abc = halfway(ab, bc), bcd = halfway(bc, cd), on = halfway(abc, bcd);
  return {Piece({a, ab, abc, on}), Piece({on, bcd, cd, d})};
}

Point<Bounded> at(const EnclosedArc& arc, double parameter) {
  const Bounded u(parameter), v = Bounded(1) - u;
  const auto mixed = [&](const Bounded& a, const Bounded& b, const Bounded& c, const Bounded& d) {
    return v * square(v) * a + Bounded(3) * u * v * (v * b + u * c) + u * square(u) * d;
  };
  return {mixed(arc[0].x, arc[1].x, arc[2].x, arc[3].x), mixed(arc[0].y, arc[1].y, arc[2].y, arc[3].y)};
}

double box_gap(const Piece& a, const Piece& b) {
  const double beside = apart(a.x, b.x), above = apart(a.y, b.y);
  if (beside <= 0 || above <= 0) return std::max(beside, above);
  return root(square(Bounded(beside)) + square(Bounded(above))).inf();
}

// By the shadows on the normal n; of no use without a direction.
double shadow_gap(const Piece& a, const Piece& b, const Vector<double>& n) {
  const double gap = apart(a.along(n), b.along(n));
  const Bounded length = root(square(Bounded(n.x)) + square(Bounded(n.y)));
  if (!(length.inf() > 0)) return -INFINITY;
  return (Bounded(gap) / length).inf();
}

double least_gap(const Piece& a, const Piece& b) {
  return std::max(
      {box_gap(a, b), shadow_gap(a, b, quarter_turn(a.chord())), shadow_gap(a, b, quarter_turn(b.chord()))});
}

// The parameter at which the chord of the piece is nearest to P.
double nearest_on_chord(const Piece& piece, const Point<double>& P) {
  const Vector<double> chord = piece.chord();
  const double squared = dot(chord, chord);
  return squared > 0 ? std::clamp(dot(P - middle(piece.arc[0]), chord) / squared, 0.0, 1.0) : 0;
}

// Of two points that lie about opposite each other.
double most_gap(const Piece& a, const Piece& b) {
  const Point<Bounded> on_a = at(a.arc, nearest_on_chord(a, middle(at(b.arc, 0.5))));
  return distance(on_a, at(b.arc, nearest_on_chord(b, middle(on_a)))).sup();
}

bool runs_through(const Range& start, const Range& end, const Range& across) {
  return (start.high < across.low && end.low > across.high) || (end.high < across.low && start.low > across.high);
}

// Each arc runs from one side of the other's hull to the other side: then they cross. The sides are those of the
// chords.
bool cross_surely(const Piece& a, const Piece& b) {
  const auto passes = [](const Piece& one, const Piece& other) {
    const Vector<double> n = quarter_turn(other.chord());
    const auto shadow = [&](const Point<Bounded>& P) {
      Range range;
      range.cover(Bounded(n.x) * P.x + Bounded(n.y) * P.y);
      return range;
    };
    return runs_through(shadow(one.arc[0]), shadow(one.arc[3]), other.along(n));
  };
  return passes(a, b) && passes(b, a);
}

struct Pair {
  double low;
  Piece first, second;
  bool operator<(const Pair& other) const { return low > other.low; }  // the queue's top is the greatest
};

class Search {
 public:
  Search(double accuracy, double horizon) : accuracy_(accuracy), horizon_(horizon) {}

  void consider(const Piece& a, const Piece& b) {
    if (box_gap(a, b) > std::min(high_, horizon_)) return;
    const double low = least_gap(a, b);
    if (low > std::min(high_, horizon_)) return;
    high_ = std::min(high_, most_gap(a, b));
    pairs_.push({low, a, b});
  }

  ArcGap result() {
    for (int look = 0; look < most_looks && !pairs_.empty(); ++look) {
      const Pair nearest = pairs_.top();
      if (nearest.low > 0 && (high_ - nearest.low <= accuracy_ || nearest.low >= horizon_)) break;
      pairs_.pop();
      if (nearest.low <= 0 && cross_surely(nearest.first, nearest.second)) return {-INFINITY, 0};
      halve(nearest);
    }
    if (pairs_.empty()) return {std::min(high_, horizon_), high_};
    const double low = std::min({pairs_.top().low, high_, horizon_});
    return {low > 0 ? low : -INFINITY, high_};
  }

 private:
  void halve(const Pair& pair) {
    if (pair.first.size() > pair.second.size())
      for (const Piece& half : halves(pair.first)) consider(half, pair.second);
    else
      for (const Piece& half : halves(pair.second)) consider(pair.first, half);
  }

  double accuracy_, horizon_, high_ = INFINITY;
  std::priority_queue<Pair> pairs_;
};

}  // namespace

ArcGap arc_gap(const std::vector<EnclosedArc>& first, const std::vector<EnclosedArc>& second, double accuracy,
               double horizon) {
  const std::vector<Piece> of_first(first.begin(), first.end()), of_second(second.begin(), second.end());
  Search search(accuracy, horizon);
  for (const Piece& a : of_first)
    for (const Piece& b : of_second) search.consider(a, b);
  return search.result();
}

}  // namespace epure::geometry
