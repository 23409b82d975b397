// Sines, cosines and angles found with doubles alone, against Arb.
#include "geometry/numbers/direction.h"

#include <cmath>
#include <limits>
#include <random>

#include "geometry/numbers/numbers.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

bool contains(const Bounded& x, const Deep& truth) {
  return sign(truth - Deep::from_double(x.inf())) != Sign::negative &&
         sign(Deep::from_double(x.sup()) - truth) != Sign::negative;
}

bool is_tight(const Bounded& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return x.sup() <= std::nextafter(std::nextafter(x.inf(), infinity), infinity);
}

// What is said of a number of values, one after the other.
class Tally {
 public:
  void add(const std::optional<Bounded>& found, const Deep& truth) {
    ++all_;
    if (!found) return;
    if (!contains(*found, truth)) ++outside_;
    if (is_tight(*found)) ++tight_;
  }
  int all() const { return all_; }
  int outside() const { return outside_; }
  double tight() const { return static_cast<double>(tight_) / all_; }

 private:
  int all_ = 0, outside_ = 0, tight_ = 0;
};

std::mt19937_64 random_numbers(20261122);
double between(double low, double high) {
  return low + (high - low) * static_cast<double>(random_numbers() >> 11) * 0x1p-53;
}
double of_any_size(double most) { return std::ldexp(between(-most, most), -static_cast<int>(random_numbers() % 60)); }

void add_direction(Tally& tally, const std::optional<SplitAngle>& angle, const Deep& cosine, const Deep& sine) {
  const Arithmetic<Bounded> scope;
  if (!angle) return;
  const auto found = direction(*angle);
  tally.add(found.cosine.value(), cosine);
  tally.add(found.sine.value(), sine);
}

constexpr long bits = 400;

}  // namespace

TEST_CASE("sines and cosines in doubles contain the true ones, and nearly all are two ulp wide at most") {
  const Arithmetic<Deep> deep(bits);
  for (const double most : {1.0, 4.0, 100.0, 1e6}) {
    Tally anywhere, at_right_angles;
    for (int i = 0; i < 20000; ++i) {
      double x = i % 2 == 0 ? between(-most, most) : of_any_size(most);
      const bool is_at_right_angle = i % 16 == 0;  // as far as doubles know, or a double beside it
      if (is_at_right_angle) x = std::nearbyint(x) * 1.5707963267948966;
      if (i % 32 == 0) x = std::nextafter(x, 0);
      const Deep angle = Deep::from_double(x);
      add_direction(is_at_right_angle ? at_right_angles : anywhere, split_angle(x), cosine_of_angle(angle),
                    sine_of_angle(angle));
    }
    CAPTURE(most);
    CHECK(anywhere.all() == 2 * 18750);
    CHECK(anywhere.outside() == 0);
    CHECK(anywhere.tight() > 0.995);
    CHECK(at_right_angles.all() > 1000);
    CHECK(at_right_angles.outside() == 0);
  }
}

// Such a double is all that is left of a right angle: sin(-π) is where a cycloid ends.
TEST_CASE("next to right angles too they are two ulp wide at most") {
  const Arithmetic<Deep> deep(bits);
  for (const double right_angles : {1, -1, 2, -2, 4, 8, -1024}) {
    CAPTURE(right_angles);
    const double x = right_angles * 1.5707963267948966;
    Tally tally;
    add_direction(tally, split_angle(x), cosine_of_angle(Deep::from_double(x)), sine_of_angle(Deep::from_double(x)));
    CHECK(tally.outside() == 0);
    CHECK(tally.tight() == 1);
  }
}

TEST_CASE("so do those of fractions of a turn") {
  const Arithmetic<Deep> deep(bits);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const auto q = static_cast<long>(1 + random_numbers() % (i % 2 == 0 ? 400 : 1000000007));
    const Turn turn{Rational(static_cast<long>(random_numbers() % static_cast<unsigned long>(6 * q)) - 3 * q, q)};
    add_direction(tally, split_angle(turn), cosine<Deep>(turn), sine<Deep>(turn));
  }
  CHECK(tally.all() > 39900);
  CHECK(tally.outside() == 0);
  CHECK(tally.tight() == 1);
}

TEST_CASE("so do angles of directions") {
  const Arithmetic<Deep> deep(bits);
  Tally tally;
  for (int i = 0; i < 40000; ++i) {
    double x = of_any_size(1e9), y = of_any_size(1);
    if (i % 100 == 1) x = 0;
    if (i % 100 == 2) y = 0;
    if (i % 100 == 3) x = -y;
    const Arithmetic<Bounded> scope;
    tally.add(split_arc_tangent(y, x), arc_tangent(Deep::from_double(y), Deep::from_double(x)));
  }
  CHECK(tally.outside() == 0);
  CHECK(tally.tight() == 1);
}

TEST_CASE("the sine and cosine of a wide angle contain those of every angle in it, also where they turn") {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep(bits);
  int outside = 0;
  for (int i = 0; i < 10000; ++i) {
    double middle = between(-30, 30);
    if (i % 4 == 0) middle = std::nearbyint(middle) * 1.5707963267948966;
    const double reach = std::abs(of_any_size(8));
    const Bounded angle = i % 8 == 1   ? Bounded(middle, middle + reach)
                          : i % 8 == 3 ? Bounded(middle - reach, middle)
                                       : Bounded(middle - reach, middle + reach);
    const Bounded sine = sine_of_angle(angle), cosine = cosine_of_angle(angle);
    for (int k = 0; k <= 12; ++k) {
      const double x = std::min(angle.inf() + (angle.sup() - angle.inf()) * k / 12, angle.sup());
      const Deep at = Deep::from_double(x);
      if (!contains(sine, sine_of_angle(at)) || !contains(cosine, cosine_of_angle(at))) ++outside;
    }
  }
  CHECK(outside == 0);
}
