#include "geometry/curves/follower_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/curves/taylor.h"
#include "geometry/numbers/at_each_precision.h"
#include "geometry/numbers/increasing_root.h"

namespace epure::geometry {
namespace {

using Wide = Taylor<Bounded, 4>;
using Narrow = Taylor<Deep, 3>;

// The lift at the angle, and its derivatives. AB along the guide is the root of (l - d)(l + d), d = e - r cos θ
// across it; by half angles both factors are sums of what is positive, however wide the interval.
template <class T>
struct Lengths {
  T r, before, beyond;  // eccentricity, l - e - r, l + e - r
  Lengths(const Rational& of_r, const Rational& l, const Rational& e)
      : r(from_rational<T>(of_r)),
        before(from_rational<T>(Rational(l - e - of_r))),
        beyond(from_rational<T>(Rational(l + e - of_r))) {}
};
template <class Series, class T>
Series lift(const Lengths<T>& of, const T& angle) {
  const Series theta = Series::parameter(angle), half = Series(quotient(T(1), T(2))) * theta;
  const Series twice_r(T(2) * of.r);
  const Series squared = (Series(of.before) + twice_r * square(cosine_of_angle(half))) *
                         (Series(of.beyond) + twice_r * square(sine_of_angle(half)));
  return Series(of.r) * sine_of_angle(theta) + root(squared);
}

struct Stretch {
  double low, high;
  double middle() const { return low + (high - low) / 2; }
};

class SearchOfTurn {
 public:
  SearchOfTurn(const Rational& r, const Rational& l, const Rational& e) : of_(r, l, e) {}

  // The hull of what may hold the least.
  Stretch run() {
    constexpr int first = 96, halvings = 50;
    std::vector<Stretch> parts;
    const double begin = -std::numbers::pi / 2, step = 2 * std::numbers::pi / first;
    // Beyond a whole turn at both ends: none is left out by rounding.
    for (int i = 0; i <= first; ++i) parts.push_back({begin + (i - 0.5) * step, begin + (i + 0.5) * step});
    for (int k = 0; k < halvings; ++k) {
      parts = left_of(parts);
      if (parts.empty()) break;
      const Stretch hull{parts.front().low, parts.back().high}, around = widened(hull);
      if (is_convex(around)) return around;
      std::vector<Stretch> halves;
      for (const Stretch& each : parts) {
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

  static Stretch widened(const Stretch& of) {
    const double half = (of.high - of.low) / 2;
    return {of.low - half, of.high + half};
  }
  Wide at(const Stretch& of) const { return lift<Wide>(of_, Bounded(of.low, of.high)); }
  bool is_convex(const Stretch& of) const {
    return of.high - of.low < std::numbers::pi && sign(at(of).c[4]) == Sign::positive;
  }
  // c[2] is half the acceleration, c[3] a sixth of its derivative. Where the roller all but reaches its axis they are
  // huge and cancel badly, but never is y'' less than -y: with f = l - d, g = l + d and their least values p, q
  //   y'' + y = u'' + u = (3pfg² + 3qf²g + qf³ + pg³ - pq(f + g)²)/4u³ >= (pfg² + 3qf²g)/4u³ > 0.
  std::vector<Stretch> left_of(const std::vector<Stretch>& parts) {
    std::vector<Stretch> left;
    std::vector<double> lowest;
    for (const Stretch& each : parts) {
      least_ = std::min(least_, at({each.middle(), each.middle()}).c[2].sup());
      const Wide over = at(each);
      const Sign slope = sign(over.c[3]);
      if (slope == Sign::positive || slope == Sign::negative) continue;
      lowest.push_back(std::max(-over.c[0].sup() / 2, over.c[2].inf()));
      left.push_back(each);
    }
    std::vector<Stretch> may_be;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (lowest[i] <= least_) may_be.push_back(left[i]);
    return may_be;
  }

  Lengths<Bounded> of_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

FollowerSweep::FollowerSweep(const Rational& r, const Rational& l, const Rational& e) : r_(r), l_(l), e_(e) {
  const Arithmetic<Bounded> scope;
  try {
    found_ = at_each_precision([r, l, e, part = SearchOfTurn(r, l, e).run()] {
      const Lengths<Deep> of(r, l, e);
      const Deep from = Deep::from_double(part.low);
      const double high = std::log2(part.high - part.low);
      return Deep(from + increasing_root([&](const Deep& x) { return lift<Narrow>(of, Deep(from + x)).c[3]; },
                                         high - 60, high));
    });
  } catch (const Undecided& open) {
    found_ = [open]() -> Deep { throw open; };
  }
}

Deep FollowerSweep::angle_now() const {
  const Deep angle = found_();
  return sign(angle) == Sign::negative ? Deep(2) * pi<Deep>() + angle : angle;
}

Deep FollowerSweep::least_now() const { return Deep(2) * lift<Narrow>(Lengths<Deep>(r_, l_, e_), found_()).c[2]; }

}  // namespace epure::geometry
