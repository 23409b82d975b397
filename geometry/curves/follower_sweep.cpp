#include "geometry/curves/follower_sweep.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/curves/taylor.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::geometry {
namespace {

using Wide = Taylor<Bounded, 4>;
using Narrow = Taylor<Deep, 3>;

// The lift at the angle, and its derivatives.
template <class Series, class T>
Series lift(const T& r, const T& l, const T& e, const T& angle) {
  const Series theta = Series::parameter(angle);
  const Series across = Series(e) - Series(r) * cosine_of_angle(theta);
  return Series(r) * sine_of_angle(theta) + root(square(Series(l)) - square(across));
}

struct Part {
  double low, high;
  double middle() const { return low + (high - low) / 2; }
};

class Search {
 public:
  Search(const Rational& r, const Rational& l, const Rational& e)
      : r_(from_rational<Bounded>(r)), l_(from_rational<Bounded>(l)), e_(from_rational<Bounded>(e)) {}

  // The hull of what may hold the least.
  Part run() {
    constexpr int first = 96, halvings = 44;
    std::vector<Part> parts;
    const double begin = -std::numbers::pi / 2, step = 2 * std::numbers::pi / first;
    // Beyond a whole turn at both ends: none is left out by rounding.
    for (int i = 0; i <= first; ++i) parts.push_back({begin + (i - 0.5) * step, begin + (i + 0.5) * step});
    for (int k = 0; k < halvings; ++k) {
      parts = left_of(parts);
      if (parts.empty()) break;
      const Part hull{parts.front().low, parts.back().high}, around = widened(hull);
      if (is_convex(around)) return around;
      std::vector<Part> halves;
      for (const Part& each : parts) {
        halves.push_back({each.low, each.middle()});
        halves.push_back({each.middle(), each.high});
      }
      parts = std::move(halves);
      if (parts.size() > most_parts) break;
    }
    throw Undecided("where over the turn the follower is accelerated least",
                    "dove nel giro l'accelerazione del cedente è minima");
  }

 private:
  static constexpr std::size_t most_parts = 4096;

  static Part widened(const Part& of) {
    const double half = (of.high - of.low) / 2;
    return {of.low - half, of.high + half};
  }
  Wide at(const Part& of) const { return lift<Wide>(r_, l_, e_, Bounded(of.low, of.high)); }
  bool is_convex(const Part& of) const {
    try {
      return of.high - of.low < std::numbers::pi && sign(at(of).c[4]) == Sign::positive;
    } catch (const Undecided&) {
      return false;
    }
  }
  // c[2] is half the acceleration, c[3] a sixth of its derivative.
  std::vector<Part> left_of(const std::vector<Part>& parts) {
    std::vector<Part> left;
    std::vector<double> lowest;
    for (const Part& each : parts) {
      least_ = std::min(least_, at({each.middle(), each.middle()}).c[2].sup());
      try {
        const Wide over = at(each);
        const Sign slope = sign(over.c[3]);
        if (slope == Sign::positive || slope == Sign::negative) continue;
        lowest.push_back(over.c[2].inf());
      } catch (const Undecided&) {  // a wide part, over which the root may vanish
        lowest.push_back(-std::numeric_limits<double>::infinity());
      }
      left.push_back(each);
    }
    std::vector<Part> may_be;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (lowest[i] <= least_) may_be.push_back(left[i]);
    return may_be;
  }

  Bounded r_, l_, e_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

FollowerSweep::FollowerSweep(const Rational& r, const Rational& l, const Rational& e) : r_(r), l_(l), e_(e) {
  const Arithmetic<Bounded> scope;
  const Part found = Search(r, l, e).run();
  from_ = found.low;
  width_ = found.high - found.low;
}

Deep FollowerSweep::found() const {
  const Deep r = from_rational<Deep>(r_), l = from_rational<Deep>(l_), e = from_rational<Deep>(e_),
             from = Deep::from_double(from_);
  const double high = std::log2(width_);
  return from +
         increasing_root([&](const Deep& x) { return lift<Narrow>(r, l, e, Deep(from + x)).c[3]; }, high - 60, high);
}

Deep FollowerSweep::angle_now() const {
  const Deep angle = found();
  return sign(angle) == Sign::negative ? Deep(2) * pi<Deep>() + angle : angle;
}

Deep FollowerSweep::least_now() const {
  return Deep(2) *
         lift<Narrow>(from_rational<Deep>(r_), from_rational<Deep>(l_), from_rational<Deep>(e_), found()).c[2];
}

}  // namespace epure::geometry
