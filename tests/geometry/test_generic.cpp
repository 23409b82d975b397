// What is zero for every direction is proved so at directions that no ruler constructs; nothing else ever is.
#include "geometry/mechanisms/four_bar.h"
#include "geometry/numbers/angle.h"
#include "geometry/numbers/climb.h"

#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

Turn degrees(const Rational& angle) { return {angle / 360}; }
const Turn odd = degrees(Rational(23));

Rational power_of_ten(int n) {
  Rational power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

}  // namespace

TEST_CASE("What is zero for every direction is zero", "[generic]") {
  const Arithmetic<Generic> scope;
  for (const Turn& turn : {odd, degrees(Rational(2300001, 100000)), degrees(Rational(20)), Turn{Rational(5, 13)}}) {
    CAPTURE(turn.fraction);
    const Generic c = cosine<Generic>(turn), s = sine<Generic>(turn);
    CHECK(sign(c * c + s * s - 1) == Sign::zero);
    CHECK(sign(square(c + s) - 1 - 2 * s * c) == Sign::zero);
    CHECK(sign(quotient(s, 1 + c) - quotient(1 - c, s)) == Sign::zero);
    // Directions that hang together: sums, multiples, right angles, and what 15° does.
    const Generic c3 = cosine<Generic>(Turn{3 * turn.fraction});
    const bool is_special = turn.fraction == Rational(1, 18);  // 60° is known, and 20° left open
    CHECK(sign(4 * c * c * c - 3 * c - c3) == (is_special ? Sign::undecided : Sign::zero));
    CHECK(sign(cosine<Generic>(Turn{turn.fraction + Rational(1, 4)}) + s) == Sign::zero);
    const Generic half(Rational(1, 2)), beyond_30 = cosine<Generic>(Turn{turn.fraction + Rational(1, 12)});
    CHECK(sign(beyond_30 - (root(Generic(3)) * half * c - half * s)) == Sign::zero);
  }
}

TEST_CASE("Directions hang together whichever is asked for first", "[generic]") {
  const Arithmetic<Generic> scope;
  const Generic coarse = cosine<Generic>(degrees(69)), fine = cosine<Generic>(degrees(23));
  CHECK(sign(coarse - (4 * fine * fine * fine - 3 * fine)) == Sign::zero);
}

TEST_CASE("Radians and pi are left open too", "[generic]") {
  const Arithmetic<Generic> scope;
  const Angle one{0, 1}, both{Rational(1, 8), Rational(-178, 100)};
  for (const Angle& angle : {one, both}) {
    const Generic c = cosine<Generic>(angle), s = sine<Generic>(angle);
    CHECK(sign(c * c + s * s - 1) == Sign::zero);
    CHECK(sign(cosine<Generic>(Rational(2) * angle) - (2 * c * c - 1)) == Sign::zero);
    CHECK(sign(c) == Sign::positive);  // cos 1, cos (0.785 - 1.78)
    CHECK(sign(s) == (angle.radians == 1 ? Sign::positive : Sign::negative));
  }
  const Generic p = pi<Generic>();
  CHECK(sign(square(p + 1) - square(p) - 2 * p - 1) == Sign::zero);
  CHECK(sign(7 * p - 22) == Sign::negative);
}

TEST_CASE("A root takes the sign it has at the direction itself", "[generic]") {
  const Arithmetic<Generic> scope;
  for (const int angle : {23, 157, 203, 337}) {
    CAPTURE(angle);
    const Generic c = cosine<Generic>(degrees(angle)), s = sine<Generic>(degrees(angle));
    const Generic size = root(1 - c * c);
    CHECK(sign(size) == Sign::positive);
    CHECK(sign(size - s) == (angle < 180 ? Sign::zero : Sign::positive));
    CHECK(sign(size + s) == (angle < 180 ? Sign::positive : Sign::zero));
    // Of roots of roots: √(3 + 2√2 c') with c' = 1 is 1 + √2; and √((a + √b)²) for a + √b of either sign.
    const Generic inner = root(2 + c), nested = root(square(c - inner));
    CHECK(sign(nested - (inner - c)) == Sign::zero);
    CHECK(sign(nested + (inner - c)) == Sign::positive);
  }
}

TEST_CASE("What is zero by accident of the direction is not proved, and never denied", "[generic]") {
  const Arithmetic<Generic> scope;
  // 4c³ - 3c = 1/2 at 20° only.
  const Generic c = cosine<Generic>(degrees(20));
  CHECK(sign(4 * c * c * c - 3 * c - Generic(Rational(1, 2))) == Sign::undecided);
  CHECK_THROWS_AS(quotient(Generic(1), 4 * c * c * c - 3 * c - Generic(Rational(1, 2))), Undecided);
  CHECK_THROWS_AS(root(4 * c * c * c - 3 * c - Generic(Rational(1, 2))), Undecided);
}

TEST_CASE("Near misses have their sign", "[generic]") {
  const Arithmetic<Generic> scope;
  const Generic c = cosine<Generic>(odd), s = sine<Generic>(odd);
  for (const int digits : {3, 12, 40, 300}) {
    const Generic tiny(Rational(1) / power_of_ten(digits));
    CHECK(sign(c * c + s * s - 1 + tiny) == Sign::positive);
    CHECK(sign(c * c + s * s - 1 - tiny) == Sign::negative);
  }
  // Two directions that only lie near each other are two.
  const Generic near = cosine<Generic>(degrees(Rational(23) + Rational(1) / power_of_ten(30)));
  CHECK(sign(c - near) == Sign::positive);
}

TEST_CASE("A divisor that is zero for every direction is refused, as is a root that may vanish", "[generic]") {
  const Arithmetic<Generic> scope;
  const Generic c = cosine<Generic>(odd), s = sine<Generic>(odd), zero = c * c + s * s - 1;
  CHECK_THROWS_AS(quotient(Generic(1), zero), Undecided);
  CHECK(sign(root(zero)) == Sign::zero);
}

TEST_CASE("A proof that grows too long is given up, and says so by undecided", "[generic]") {
  const Arithmetic<Generic> scope;
  const Generic c = cosine<Generic>(odd), s = sine<Generic>(degrees(Rational(41, 7)));
  Generic a = c + s + 1, b = c + s + 1;
  for (int i = 0; i < 7; ++i) {  // the 128th power of a sum of two directions, made in two ways
    a = square(a + Generic(Rational(1, 3)) * c);
    b = b * b + Generic(Rational(2, 3)) * c * b + Generic(Rational(1, 9)) * c * c;
  }
  CHECK(sign(a - b) == Sign::undecided);
  CHECK(sign(c * c + square(sine<Generic>(odd)) - 1) == Sign::undecided);  // nothing is left of the budget
  const Arithmetic<Generic> fresh;
  const Generic d = cosine<Generic>(odd);
  CHECK(sign(d * d + square(sine<Generic>(odd)) - 1) == Sign::zero);
}

// ω₃ = 0 in a parallelogram and the pole on the crank's line: through circles and polygons, with their roots.
TEST_CASE("A linkage special by its lengths is decided at any direction", "[generic]") {
  for (const Rational& angle : {Rational(23), Rational(20), Rational(12345678, 100000)}) {
    CAPTURE(angle);
    const Side away_from_A0 = angle < 53 ? Side::right : Side::left;  // the frame points to 53.13°
    const Turn turn = degrees(angle);
    const FourBarLengths parallelogram{Rational(2, 10), Rational(5, 10), Rational(2, 10), Rational(3, 10),
                                       Rational(4, 10)};
    const Decision turns = decide([&]<class T>() -> T {
      const FourBar<T> at = four_bar<T>(parallelogram, {cosine<T>(turn), sine<T>(turn)}, away_from_A0);
      return four_bar_motion(at, T(1), T(0)).coupler.omega;
    });
    CHECK(turns.sign == Sign::zero);
    CHECK(turns.rung == "Generic");
    // The velocity of B across B₀B, of a linkage with nothing special: a root stands in B.
    const FourBarLengths any{Rational(2, 10), Rational(5, 10), Rational(7, 10), Rational(8, 10), Rational(0)};
    const Decision along = decide([&]<class T>() -> T {
      const FourBar<T> at = four_bar<T>(any, {cosine<T>(turn), sine<T>(turn)}, Side::left);
      return dot(at.B - at.B0, four_bar_motion(at, T(1), T(0)).coupler.velocity(at.B));
    });
    CHECK(along.sign == Sign::zero);
    CHECK(along.rung == "Generic");
  }
}
