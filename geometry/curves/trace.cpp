#include "geometry/curves/trace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>

#include "geometry/curves/hermite.h"
#include "geometry/curves/turn_arcs.h"
#include "geometry/curves/view.h"

namespace epure::geometry {

namespace {

constexpr double first_try = 0.25;

// Where noise drowns the curve, pieces settle here and there by luck. Such a scrap between two undecided gaps,
// shorter than this (radians: a locus of 200 mm on paper moves by some hundredths of a millimetre), is left out with
// them.
constexpr double least_scrap = 0x1p-12;

// Beside a root that touches zero and comes back (a change point) pieces must be as short as the square of their
// distance from it: a million of them. When an arc of the turn has had its looks, the shortest piece grows, four
// times for every sixteenth of them more, and the gap about the root becomes wider: some 1e-3 radians. After three
// times its looks it grows on, up to 1/32 of an arc (t goes from -1 to 1), so that no locus is looked for without
// end.
constexpr int times_coarser_in_as_many = 16;
constexpr double longest_left_out = 0x1p-4;

// What is known of the locus over one piece.
struct Piece {
  // coarse: near the frame, but the arc deviates too much; unsettled: nothing could be shown.
  enum class Kind { drawn, coarse, outside, absent, unsettled } kind;
  FittedArc fitted{};
  Knot end{};
};

// A branch or gap as it grows; places are kept so that what ends with the turn can be joined to what began with it.
struct Run {
  TurnPlace from, to;
  std::vector<BezierArc> arcs{};
  double deviation = 0;
};
struct Hole {
  Gap::Cause cause;
  TurnPlace from, to;
};

template <class Stretch>
bool begins_the_turn(const Stretch& s) {
  return s.from.arc == 0 && s.from.t == -1;
}
template <class Stretch>
bool ends_the_turn(const Stretch& s) {
  return s.to.arc == turn_arcs - 1 && s.to.t == 1;
}

class Tracer {
 public:
  Tracer(const TracedLocus& locus, const Frame& frame, double tolerance, int looks_of_an_arc)
      : locus_(locus), view_(frame), tolerance_(tolerance), looks_of_an_arc_(looks_of_an_arc) {}

  Trace operator()() {
    for (arc_ = 0; arc_ < turn_arcs; ++arc_) {
      start_.reset();  // its derivative is by another t
      looks_ = 0;
      march();
    }
    return result();
  }

 private:
  // Along one arc of the turn by pieces as long as tolerance and frame let them be.
  void march() {
    for (double t = -1; t < 1;) {
      const double end = stop(t), length = end - t;
      const Piece piece = look(t, end);
      if (piece.kind == Piece::Kind::coarse || piece.kind == Piece::Kind::unsettled) {
        const bool predictable = piece.kind == Piece::Kind::coarse;
        length_ = length * (predictable ? std::clamp(piece.fitted.growth(tolerance_), 0.125, 0.875) : 0.5);
        if (length_ < shortest()) t = leave_out_unsettled(t);
        continue;
      }
      length_ = length * (piece.kind == Piece::Kind::drawn ? piece.fitted.growth(tolerance_) : 2.0);
      if (piece.kind == Piece::Kind::drawn) {
        draw(t, piece);
      } else {
        lift_the_pen();
        if (piece.kind == Piece::Kind::absent) leave_out(Gap::Cause::absent, t, end);
      }
      if (length > least_scrap) stride_ = shortest();
      t = end;
    }
  }

  // What remains is shared out evenly, so that no arc of the turn ends with a crumb.
  double stop(double t) const {
    const double remaining = 1 - t, pieces = std::ceil(remaining / length_);
    return pieces <= 1 ? 1 : std::min(1.0, t + std::max(shortest_piece, remaining / pieces));
  }

  double shortest() const {
    const auto grown = [this](double from, int looks_before) {
      const int beyond = std::max(0, looks_ - looks_before);
      return std::ldexp(from, 2 * (beyond * times_coarser_in_as_many / looks_of_an_arc_));
    };
    return std::min(
        {grown(shortest_piece, looks_of_an_arc_), grown(least_scrap, 3 * looks_of_an_arc_), longest_left_out});
  }

  Piece look(double t, double end) {
    ++looks_;
    try {
      return judge(t, end, series(Bounded(t, end)));
    } catch (const Impossible&) {
      return {Piece::Kind::absent};
    } catch (const Undecided&) {
      return {Piece::Kind::unsettled};
    }
  }

  ProjectivePoint<BoundedSeries> series(const Bounded& t) const {
    return locus_.over(direction_on_turn(arc_, BoundedSeries::parameter(t)));
  }

  Piece judge(double t, double end, const ProjectivePoint<BoundedSeries>& P) {
    if (view_.is_outside({P.x.c[0], P.y.c[0], P.w.c[0]})) return {Piece::Kind::outside};
    const Point<BoundedSeries> over = finite(P);
    if (!view_.is_near({over.x.c[0], over.y.c[0]})) return {Piece::Kind::unsettled};
    Piece piece{Piece::Kind::drawn, {}, knot_at(end)};
    if (closes_the_turn(end)) piece.end.drawn = runs_.front().arcs.front().start;
    piece.fitted = fit(start_at(t), piece.end, fourth_coefficients(t, end, over));
    // Half of the tolerance at most for what doubles miss: a shorter piece would not help.
    if (!(piece.fitted.rounding <= tolerance_ / 2)) return {Piece::Kind::unsettled};
    if (!(piece.fitted.deviation() <= tolerance_)) piece.kind = Piece::Kind::coarse;
    return piece;
  }

  Vector<Bounded> fourth_coefficients(double t, double end, const Point<BoundedSeries>& over) const {
    const double m = t + (end - t) / 2;
    const Point<BoundedSeries> middle = finite(series(Bounded(m)));
    const Bounded all(t, end);
    return {fourth_coefficient(over.x, middle.x, all, m), fourth_coefficient(over.y, middle.y, all, m)};
  }

  Knot knot_at(double t) const {
    return knot(t, finite(locus_.at(direction_on_turn(arc_, BoundedTangent::parameter(Bounded(t))))));
  }

  // Where the pen is down, it draws on from the very double it stopped at.
  const Knot& start_at(double t) {
    if (!start_ || start_->t != t) start_ = knot_at(t);
    if (pen_) start_->drawn = *pen_;
    return *start_;
  }

  bool closes_the_turn(double end) const {
    return arc_ == turn_arcs - 1 && end == 1 && !runs_.empty() && begins_the_turn(runs_.front());
  }

  void draw(double t, const Piece& piece) {
    if (!pen_) runs_.push_back({{arc_, t}, {arc_, t}});
    Run& run = runs_.back();
    run.to = {arc_, piece.end.t};
    run.arcs.push_back(piece.fitted.arc);
    run.deviation = std::max(run.deviation, piece.fitted.deviation());
    pen_ = piece.end.drawn;
    start_ = piece.end;
  }

  void lift_the_pen() { pen_.reset(); }

  void leave_out(Gap::Cause cause, double t, double end) {
    const TurnPlace from{arc_, t}, to{arc_, end};
    if (cause == Gap::Cause::undecided && ends_in_scrap(from)) {
      runs_.pop_back();
      holes_.back().to = to;
    } else if (!holes_.empty() && holes_.back().cause == cause && is_same(holes_.back().to, from)) {
      holes_.back().to = to;
    } else {
      holes_.push_back({cause, from, to});
    }
  }

  // The run that ends here began at an undecided gap not long ago.
  bool ends_in_scrap(const TurnPlace& here) const {
    if (runs_.empty() || holes_.empty() || holes_.back().cause != Gap::Cause::undecided) return false;
    const Run& run = runs_.back();
    return is_same(run.to, here) && is_same(holes_.back().to, run.from) &&
           turned_between(run.from, run.to) < least_scrap;
  }

  // Resumes where a piece as long as the stride is settled again: by doubled steps, the last of them searched by
  // bisection, so that a wide unsettled stretch costs no more than a narrow one. The stride is the shortest piece,
  // and longer from gap to gap until the curve is clear again.
  double leave_out_unsettled(double t) {
    lift_the_pen();
    stride_ = std::max(stride_, shortest());
    double unsettled = t, resumed = t + stride_;
    for (double step = stride_; resumed < 1 && !is_settled(resumed); resumed = unsettled + step) {
      unsettled = resumed;
      step *= 2;
    }
    resumed = std::min(resumed, 1.0);
    while (resumed - unsettled > stride_) {
      const double middle = unsettled + (resumed - unsettled) / 2;
      (is_settled(middle) ? resumed : unsettled) = middle;
    }
    leave_out(Gap::Cause::undecided, t, resumed);
    length_ = stride_;
    stride_ *= 4;
    return resumed;
  }

  bool is_settled(double t) {
    const Piece::Kind kind = look(t, t + stride_).kind;
    return kind != Piece::Kind::coarse && kind != Piece::Kind::unsettled;
  }

  Trace result();

  const TracedLocus& locus_;
  const View view_;
  const double tolerance_;
  const int looks_of_an_arc_;

  int arc_ = 0, looks_ = 0;           // of this arc
  double length_ = first_try;         // of the next piece to try
  double stride_ = shortest_piece;    // of the next search for the end of a gap
  std::optional<Knot> start_;         // of the piece being tried, once it was needed
  std::optional<Point<double>> pen_;  // where it is down
  std::vector<Run> runs_;
  std::vector<Hole> holes_;
};

// What ends with the turn goes on with what began it.
template <class Stretch, class Join>
void join_over_the_end(std::vector<Stretch>& all, Join join) {
  if (all.size() < 2 || !begins_the_turn(all.front()) || !ends_the_turn(all.back())) return;
  if (!join(all.back(), all.front())) return;
  all.back().to = all.front().to;
  all.erase(all.begin());
}

Branch branch_of(Run& run) {
  const bool closed = begins_the_turn(run) && ends_the_turn(run);
  return {std::move(run.arcs), run.deviation, direction_of(run.from), direction_of(run.to), closed};
}

Gap gap_of(const Hole& hole) {
  return {hole.cause, direction_of(hole.from), direction_of(hole.to), turned_between(hole.from, hole.to)};
}

Trace Tracer::result() {
  join_over_the_end(runs_, [](Run& last, const Run& first) {
    last.arcs.insert(last.arcs.end(), first.arcs.begin(), first.arcs.end());
    last.deviation = std::max(last.deviation, first.deviation);
    return true;
  });
  join_over_the_end(holes_, [](const Hole& last, const Hole& first) { return last.cause == first.cause; });
  Trace trace;
  std::transform(runs_.begin(), runs_.end(), std::back_inserter(trace.branches), branch_of);
  std::transform(holes_.begin(), holes_.end(), std::back_inserter(trace.gaps), gap_of);
  return trace;
}

}  // namespace

std::size_t Trace::arcs() const {
  std::size_t count = 0;
  for (const Branch& branch : branches) count += branch.arcs.size();
  return count;
}

double Trace::deviation() const {
  double worst = 0;
  for (const Branch& branch : branches) worst = std::max(worst, branch.deviation);
  return worst;
}

Trace trace(const TracedLocus& locus, const Frame& frame, double tolerance, int looks_of_an_arc) {
  assert(tolerance > 0 && "a tolerance that is not positive");
  const Arithmetic<Bounded> scope;
  return Tracer(locus, frame, tolerance, looks_of_an_arc)();
}

}  // namespace epure::geometry
