// Deep in doubles answers as Deep with bits does, or refuses.
#include <random>

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

// Every function a number has, on numbers that depend on `seed`.
std::vector<Deep> medley(int seed) {
  const Deep a = from_rational<Deep>(Rational(seed, 7)), b = cosine<Deep>(Turn{Rational(seed, 61)});
  const Deep c = root(square(a) + square(b) + Deep(1)), d = arc_tangent(c, a) * pi<Deep>();
  return {a,
          b - c,
          c * d,
          quotient(d, c + a),
          -d / c,
          sine<Deep>(Turn{Rational(1, 9)}) + Deep::from_double(0.1),
          sine_of_angle(d) + cosine_of_angle(c),
          midpoint(c) - d};
}

}  // namespace

TEST_CASE("what is found in doubles is what is found with bits") {
  for (int seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    std::vector<Enclosure> in_bits, found;
    {
      const Arithmetic<Deep> scope(256);
      for (const Deep& x : medley(seed)) in_bits.push_back(enclosure(x));
    }
    {
      const Arithmetic<Deep> scope(in_doubles);
      for (const Deep& x : medley(seed)) {
        CHECK(x.is_in_doubles());
        found.push_back(enclosure(x));
      }
    }
    for (std::size_t i = 0; i + 1 < found.size(); ++i) {
      CAPTURE(i);
      CHECK(found[i].lower == in_bits[i].lower);
      CHECK(found[i].value == in_bits[i].value);
      CHECK(found[i].upper == in_bits[i].upper);
    }
  }
}

TEST_CASE("what doubles leave open is refused, never answered") {
  const Arithmetic<Deep> scope(in_doubles);
  const Deep r = root(Deep(2)), noise = r * r - Deep(2);
  CHECK_THROWS_AS(sign(noise), TooCoarse);
  CHECK_THROWS_AS(quotient(r, noise), TooCoarse);
  CHECK_THROWS_AS(r / noise, TooCoarse);
  CHECK_THROWS_AS(arc_tangent(noise, Deep(-1)), TooCoarse);
  CHECK_THROWS_AS(enclosure(noise), TooCoarse);
  CHECK(noise.may_be_zero());
  // A third, and twice that, less a double: that of the middle between two doubles, which one is nearest is open.
  const Deep third = from_rational<Deep>(Rational(1, 3)), middle = third + third + third + Deep::from_double(0x1p-53);
  CHECK_THROWS_AS(enclosure(middle), TooCoarse);
  CHECK_THROWS_AS(certain_double(middle), TooCoarse);
  CHECK_THROWS_AS(to_bounded(third * Deep(3)), TooCoarse);
  CHECK_THROWS_AS(r.ball(), TooCoarse);
  CHECK_THROWS_AS(Arithmetic<Deep>::bits(), TooCoarse);
  CHECK(sign(Deep(0)) == Sign::zero);
  CHECK_FALSE(r.may_be_zero());
  CHECK(Deep(0).may_be_zero());
}

TEST_CASE("numbers in doubles and balls do not mix") {
  const Arithmetic<Deep> scope(in_doubles);
  const Deep interval = root(Deep(2));
  const Arithmetic<Deep> bits(128);
  const Deep ball = root(Deep(2));
  CHECK_THROWS_AS(ball + interval, TooCoarse);
  CHECK_THROWS_AS(interval * ball, TooCoarse);
  Deep assigned = ball;
  assigned = interval;
  CHECK(assigned.is_in_doubles());
  assigned = ball;
  CHECK_FALSE(assigned.is_in_doubles());
  CHECK(sign(assigned - ball) == Sign::undecided);
  CHECK(sign(Deep(assigned) - Deep(1)) == Sign::positive);
}
