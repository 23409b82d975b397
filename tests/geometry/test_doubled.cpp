// Enclosures with twice the digits of a double, against Arb.
#include "geometry/numbers/doubled.h"

#include <cmath>
#include <random>

#include "geometry/numbers/numbers.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

std::mt19937_64 random_numbers(20261122);
double any_double() {
  const double part = 1 + static_cast<double>(random_numbers() >> 12) * 0x1p-52;
  const double sign = random_numbers() % 2 == 0 ? 1 : -1;
  return std::ldexp(sign * part, static_cast<int>(random_numbers() % 80) - 40);
}

// A Doubled and the ball of many bits that it stands for.
struct Pair {
  Doubled doubled;
  Deep truth;
};

Pair any_pair() {
  const Rational value = Rational(any_double()) + Rational(any_double()) * Rational(0x1p-60);
  return {doubled(value), from_rational<Deep>(value)};
}

// What is said of a number of values, one after the other: `part` is how far apart the ends may be.
class Tally {
 public:
  explicit Tally(double part) : part_(part) {}
  void add(const Doubled& found, const Deep& truth) {
    ++all_;
    const Bounded error = to_bounded(truth - Deep::from_double(found.near()));
    const Bounded rest = (found - Doubled(found.near())).value();
    if (rest.inf() > error.inf() || rest.sup() < error.sup()) ++outside_;
    if (rest.sup() - rest.inf() > part_ * std::abs(found.near())) ++wide_;
    const auto nearest = found.certain_double();
    if (!nearest) ++open_;
    if (nearest && *nearest != certain_double(truth)) ++wrong_;
    if (const auto bounds = found.certain_bounds(); bounds && !bounds->is_same(to_bounded(truth))) ++wrong_;
  }
  void check(int at_least) const {
    CHECK(all_ >= at_least);
    CHECK(outside_ == 0);
    CHECK(wide_ == 0);
    CHECK(open_ <= all_ / 1000);
    CHECK(wrong_ == 0);
  }

 private:
  double part_;
  int all_ = 0, outside_ = 0, wide_ = 0, open_ = 0, wrong_ = 0;
};

constexpr long bits = 500;

}  // namespace

TEST_CASE("sums, products, quotients and roots of two doubles each are known to 2^-100 of themselves") {
  const Arithmetic<Deep> deep(bits);
  const Arithmetic<Bounded> scope;
  Tally tally(0x1p-100);
  for (int i = 0; i < 20000; ++i) {
    const auto [a, of_a] = any_pair();
    const auto [b, of_b] = any_pair();
    if (std::abs(a.near() + b.near()) > std::abs(a.near()) / 16) tally.add(a + b, of_a + of_b);
    tally.add(a * b, of_a * of_b);
    tally.add(a / b, of_a / of_b);
    tally.add(square(a), square(of_a));
    tally.add(root(square(a)), root(square(of_a)));
    if (a.near() > 0) tally.add(root(a), root(of_a));
  }
  tally.check(100000);
}

TEST_CASE("what cancels is enclosed, and its sign is not invented") {
  const Arithmetic<Deep> deep(bits);
  const Arithmetic<Bounded> scope;
  const Doubled two = square(root(Doubled(2)));
  CHECK(sign(two - Doubled(2)) == Sign::undecided);
  CHECK(sign(Doubled(2) - Doubled(2)) == Sign::zero);
  CHECK(sign(two + Doubled(0x1p-90) - Doubled(2)) == Sign::positive);
  CHECK_FALSE(two.certain_bounds());
  CHECK_FALSE((two + Doubled(0x1p-52)).certain_double());  // the middle of two doubles
  CHECK_THROWS_AS(Doubled(1) / (two - Doubled(2)), Undecided);
  CHECK_THROWS_AS(Doubled(1e300) * Doubled(1e300), Undecided);
}

TEST_CASE("so are sines, cosines and angles in two doubles") {
  const Arithmetic<Deep> deep(bits);
  const Arithmetic<Bounded> scope;
  Tally directions(0x1p-97), turns(0x1p-97), angles(0x1p-97);
  for (int i = 0; i < 5000; ++i) {
    const double x = std::ldexp(any_double(), static_cast<int>(random_numbers() % 40) - 40);
    if (std::abs(x) < 4 && std::abs(std::remainder(x, 1.5707963267948966)) > 0x1p-4) {
      directions.add(cosine_of_angle(Doubled(x)), cosine_of_angle(Deep::from_double(x)));
      directions.add(sine_of_angle(Doubled(x)), sine_of_angle(Deep::from_double(x)));
    }
    const auto q = static_cast<long>(1 + random_numbers() % 1000);
    const Turn turn{Rational(static_cast<long>(random_numbers() % 3000) - 1500, q)};
    turns.add(doubled_cosine(turn), cosine<Deep>(turn));
    turns.add(doubled_sine(turn), sine<Deep>(turn));
    const auto [a, of_a] = any_pair();
    const auto [b, of_b] = any_pair();
    angles.add(arc_tangent(a, b), arc_tangent(of_a, of_b));
  }
  directions.check(1000);
  turns.check(9000);
  angles.check(5000);
}
