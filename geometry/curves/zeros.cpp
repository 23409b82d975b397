#include "geometry/curves/zeros.h"

#include "geometry/numbers/enclosure.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace epure::geometry {

namespace {

struct TurnPiece {
  int arc;
  double from, to;
};

// Neighbouring pieces overlap when widened, so that a zero at the end of one is inside of both.
Bounded widened(const TurnPiece& piece) {
  const double margin = (piece.to - piece.from) / 8;
  return {piece.from - margin, piece.to + margin};
}

// As far again beyond both ends.
Bounded with_surroundings(const Bounded& x) {
  const Bounded width(x.sup() - x.inf());
  return {(Bounded(x.inf()) - width).inf(), (Bounded(x.sup()) + width).sup()};
}

bool is_before(const TurnPlace& a, const TurnPlace& b) { return a.arc != b.arc ? a.arc < b.arc : a.t < b.t; }

class Search {
 public:
  Search(const TurnFunction& function, int most_looks) : at_(function), most_looks_(most_looks) {}

  Zeros operator()() {
    for (int arc = 0; arc < turn_arcs; ++arc) waiting_.push_back({arc, -1, 1});
    for (int look = 0; look < most_looks_ && !waiting_.empty(); ++look) {
      const TurnPiece piece = waiting_.front();
      waiting_.pop_front();
      if (!is_settled(piece)) split(piece);
    }
    open_.insert(open_.end(), waiting_.begin(), waiting_.end());
    std::sort(found_.begin(), found_.end(), [](const Zero& a, const Zero& b) {
      return is_before({a.arc, midpoint(a.t).inf()}, {b.arc, midpoint(b.t).inf()});
    });
    return {found_, joined(absent_, Gap::Cause::absent), joined(open_, Gap::Cause::undecided)};
  }

 private:
  void split(const TurnPiece& piece) {
    if (piece.to - piece.from < shortest_piece) {
      open_.push_back(piece);
      return;
    }
    const double half = piece.from + (piece.to - piece.from) / 2;
    waiting_.push_back({piece.arc, piece.from, half});
    waiting_.push_back({piece.arc, half, piece.to});
  }

  // True when it is proved that the piece has no zero, or its only one was found.
  bool is_settled(const TurnPiece& piece) {
    try {
      const Bounded t = widened(piece);
      const BoundedTangent value = at_(piece.arc, t);
      if (is_decided(sign(value)) || is_decided(sign(by_mean_value(piece.arc, t, value.c[1])))) return true;
      if (!is_decided(sign(value.c[1]))) return false;
      const Sign before = sign(at_(piece.arc, t.inf())), after = sign(at_(piece.arc, t.sup()));
      if (!is_decided(before) || !is_decided(after)) return false;
      if (before == after) return true;
      const std::optional<Zero> zero = narrowed({piece.arc, t, value.c[1]});
      if (zero) add(*zero);
      return zero.has_value();
    } catch (const Impossible&) {
      absent_.push_back(piece);
      return true;
    } catch (const Undecided&) {
      return false;
    }
  }

  // The function over t from its value in the middle and its slope: narrower than the value over t on a short piece.
  Bounded by_mean_value(int arc, const Bounded& t, const Bounded& slope) const {
    const Bounded m = midpoint(t);
    return at_(arc, m).c[0] + slope * (t - m);
  }

  static bool is_decided(Sign s) { return s == Sign::positive || s == Sign::negative; }

  // Interval Newton: the zero lies in m - f(m)/f'(t). Stops when that is not less than half as wide; none when it
  // never was, because the slope is not known well enough over t.
  std::optional<Zero> narrowed(Zero zero) const {
    for (bool is_narrower = false;; is_narrower = true) {
      const Bounded m = midpoint(zero.t);
      const Bounded next = m - quotient(at_(zero.arc, m).c[0], zero.slope);
      const Bounded both(std::max(zero.t.inf(), next.inf()), std::min(zero.t.sup(), next.sup()));
      if (!(both.sup() - both.inf() < (zero.t.sup() - zero.t.inf()) / 2))
        return is_narrower ? std::optional(zero) : std::nullopt;
      zero.t = both;
      zero.slope = at_(zero.arc, with_surroundings(both)).c[1];
    }
  }

  // Two that overlap are one, found from both of two pieces that overlap there.
  void add(const Zero& zero) {
    const Vector<Bounded> direction = zero.direction();
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const Zero& other) {
      const Vector<Bounded> d = other.direction();
      return d.x.do_overlap(direction.x) && d.y.do_overlap(direction.y);
    });
    if (!known) found_.push_back(zero);
  }

  static std::vector<Gap> joined(std::vector<TurnPiece> pieces, Gap::Cause cause) {
    std::sort(pieces.begin(), pieces.end(), [](const TurnPiece& a, const TurnPiece& b) {
      return is_before({a.arc, a.from}, {b.arc, b.from});
    });
    std::vector<Gap> gaps;
    for (auto piece = pieces.begin(); piece != pieces.end();) {
      const TurnPlace from{piece->arc, piece->from};
      TurnPlace to = from;
      for (; piece != pieces.end() && is_same(to, {piece->arc, piece->from}); ++piece) to = {piece->arc, piece->to};
      gaps.push_back({cause, direction_of(from), direction_of(to), turned_between(from, to)});
    }
    return gaps;
  }

  const TurnFunction& at_;
  const int most_looks_;
  std::deque<TurnPiece> waiting_;
  std::vector<TurnPiece> absent_, open_;
  std::vector<Zero> found_;
};

}  // namespace

Zeros search_zeros(const TurnFunction& function, int most_looks) {
  const Arithmetic<Bounded> scope;
  return Search(function, most_looks)();
}

}  // namespace epure::geometry
