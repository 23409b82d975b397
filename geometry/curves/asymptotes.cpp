#include "geometry/curves/asymptotes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <optional>

#include "geometry/curves/turn_arcs.h"

namespace epure::geometry {

namespace {

// Pieces looked at before what is left is stated as open. A simple zero takes some dozen; a stretch on which nothing
// can be decided would take any number.
constexpr int most_looks = 1024;

// Shorter pieces are not split: see `shortest` in trace.cpp.
constexpr double shortest = 0x1p-40;

struct Piece {
  int arc;
  double from, to;
};

// Neighbouring pieces overlap when widened, so that a zero at the end of one is inside of both.
Bounded widened(const Piece& piece) {
  const double margin = (piece.to - piece.from) / 8;
  return {piece.from - margin, piece.to + margin};
}

Bounded hull_of_middle(const Bounded& x) { return Bounded(x.inf() / 2 + x.sup() / 2); }

class Search {
 public:
  explicit Search(const TracedLocus& locus) : locus_(locus) {}

  Asymptotes operator()() {
    for (int arc = 0; arc < turn_arcs; ++arc) waiting_.push_back({arc, -1, 1});
    for (int look = 0; look < most_looks && !waiting_.empty(); ++look) {
      const Piece piece = waiting_.front();
      waiting_.pop_front();
      if (!is_settled(piece)) split(piece);
    }
    open_.insert(open_.end(), waiting_.begin(), waiting_.end());
    return result();
  }

 private:
  struct Found {
    TurnPlace place;
    Asymptote asymptote;
  };

  ProjectivePoint<BoundedTangent> at(int arc, const Bounded& t) const {
    return locus_.at(direction_on_turn(arc, BoundedTangent::parameter(t)));
  }

  void split(const Piece& piece) {
    if (piece.to - piece.from < shortest) {
      open_.push_back(piece);
      return;
    }
    const double middle = piece.from + (piece.to - piece.from) / 2;
    waiting_.push_back({piece.arc, piece.from, middle});
    waiting_.push_back({piece.arc, middle, piece.to});
  }

  // True when it is proved that the piece has no zero of w, or its only one was found.
  bool is_settled(const Piece& piece) {
    try {
      const Bounded t = widened(piece);
      const BoundedTangent w = at(piece.arc, t).w;
      const Sign value = sign(w), slope = sign(w.c[1]);
      if (value == Sign::positive || value == Sign::negative) return true;
      if (slope != Sign::positive && slope != Sign::negative) return false;
      const Sign before = sign(at(piece.arc, t.inf()).w), after = sign(at(piece.arc, t.sup()).w);
      if (!is_decided(before) || !is_decided(after)) return false;
      if (before != after) add(piece.arc, narrowed(piece.arc, t));
      return true;
    } catch (const Impossible&) {
      return true;
    } catch (const Undecided&) {
      return false;
    }
  }

  static bool is_decided(Sign s) { return s == Sign::positive || s == Sign::negative; }

  // Interval Newton: the zero lies in m - w(m)/w'(t). Stops when that is not less than half as wide.
  Bounded narrowed(int arc, Bounded t) const {
    for (;;) {
      const Bounded m = hull_of_middle(t);
      const Bounded next = m - quotient(at(arc, m).w.c[0], at(arc, t).w.c[1]);
      const Bounded both(std::max(t.inf(), next.inf()), std::min(t.sup(), next.sup()));
      if (!(both.sup() - both.inf() < (t.sup() - t.inf()) / 2)) return both;
      t = both;
    }
  }

  void add(int arc, const Bounded& t) {
    const Vector<Bounded> direction = direction_on_turn(arc, t);
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const Found& other) {
      const Vector<Bounded>& d = other.asymptote.direction;
      return d.x.do_overlap(direction.x) && d.y.do_overlap(direction.y);
    });
    if (known) return;
    const Line<Bounded> tangent = tangent_at_infinity(at(arc, t));
    const Line<double> line{hull_of_middle(tangent.a).inf(), hull_of_middle(tangent.b).inf(),
                            hull_of_middle(tangent.c).inf()};
    found_.push_back({{arc, hull_of_middle(t).inf()}, {tangent, line, direction}});
  }

  // P x P' with w = 0, which it is at the zero enclosed; to a unit normal.
  static Line<Bounded> tangent_at_infinity(const ProjectivePoint<BoundedTangent>& P) {
    const Bounded x = P.x.c[0], y = P.y.c[0], w_rate = P.w.c[1];
    const Line<Bounded> l{y * w_rate, -(x * w_rate), x * P.y.c[1] - y * P.x.c[1]};
    const Bounded size = root(square(l.a) + square(l.b));
    return {quotient(l.a, size), quotient(l.b, size), quotient(l.c, size)};
  }

  Asymptotes result() {
    const auto place_order = [](const TurnPlace& a, const TurnPlace& b) {
      return a.arc != b.arc ? a.arc < b.arc : a.t < b.t;
    };
    std::sort(found_.begin(), found_.end(),
              [&](const Found& a, const Found& b) { return place_order(a.place, b.place); });
    std::sort(open_.begin(), open_.end(), [&](const Piece& a, const Piece& b) {
      return place_order({a.arc, a.from}, {b.arc, b.from});
    });
    Asymptotes all;
    for (const Found& found : found_) all.lines.push_back(found.asymptote);
    for (auto piece = open_.begin(); piece != open_.end();) {
      const TurnPlace from{piece->arc, piece->from};
      TurnPlace to = from;
      for (; piece != open_.end() && is_same(to, {piece->arc, piece->from}); ++piece) to = {piece->arc, piece->to};
      all.open.push_back({Gap::Cause::undecided, direction_of(from), direction_of(to), turned_between(from, to)});
    }
    return all;
  }

  const TracedLocus& locus_;
  std::deque<Piece> waiting_;
  std::vector<Piece> open_;
  std::vector<Found> found_;
};

}  // namespace

Asymptotes asymptotes(const TracedLocus& locus) {
  const Arithmetic<Bounded> scope;
  return Search(locus)();
}

}  // namespace epure::geometry
