// Every number keeps the promises of number.h. The same body for all of them wherever they promise the same.
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/given.h"
#include "geometry/numbers/numbers.h"
#include "geometry/numbers/threads.h"
#include "tests/support/aborts.h"
#include "tests/support/catch.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <thread>
#include <type_traits>

using namespace epure::geometry;
using epure::testing::aborts;

static_assert(Number<Fast> && Number<Bounded> && Number<Deep> && Number<Exact> && Number<Calcium>);
static_assert(NumberWithAngles<Fast> && NumberWithAngles<Bounded> && NumberWithAngles<Deep>);
static_assert(!NumberWithAngles<Exact> && !NumberWithAngles<Calcium>);
static_assert(!Number<float> && !Number<Rational>);

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

// A scope for any number; Deep takes its bits.
template <class T>
struct Scope {
  Arithmetic<T> arithmetic;
};
template <>
struct Scope<Deep> {
  Arithmetic<Deep> arithmetic{128};
};

Rational rational(const std::string& decimal) { return parse_given(decimal, "1"); }

// An ulp at x, as a rational.
Rational ulp(double x) {
  const double away = std::nextafter(std::abs(x), infinity);
  return Rational(away) - Rational(std::abs(x));
}

Rational absolute(const Rational& x) { return x < Rational(0) ? -x : x; }

// Does x say `truth`? The enclosing numbers must contain it; the exact ones must equal it; Fast must be within some
// ulp, as it should be after one operation on rounded operands without cancellation.
bool says(Fast x, const Rational& truth) { return absolute(Rational(x) - truth) <= Rational(4) * ulp(x); }
bool says(const Bounded& x, const Rational& truth) {
  return Rational(x.inf()) <= truth && truth <= Rational(x.sup());
}
bool says(const Deep& x, const Rational& truth) {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, truth.mpq());
  const bool contains = arb_contains_fmpq(x.ball(), fraction) != 0;
  fmpq_clear(fraction);
  return contains;
}
bool says(const Exact& x, const Rational& truth) { return x.is_rational() && x.rational() == truth; }
bool says(const Calcium& x, const Rational& truth) { return sign(x - Calcium(truth)) == Sign::zero; }

// Does x agree with a value known to 49 digits after which nothing is promised? And is it as narrow as it should be?
Deep reference(const std::string& decimal) {
  const Rational value = rational(decimal);
  const Rational half_a_digit = absolute(value) * rational("1e-49");
  const Deep center = from_rational<Deep>(value);
  Deep radius = from_rational<Deep>(half_a_digit);
  arb_t ball;
  arb_init(ball);
  arb_set(ball, center.ball());
  arb_add_error(ball, radius.ball());
  Deep result = Deep::from_ball(ball);
  arb_clear(ball);
  return result;
}

bool agrees(Fast x, const std::string& decimal) { return says(x, rational(decimal)); }
bool agrees(const Bounded& x, const std::string& decimal) {
  const Rational width = Rational(x.sup()) - Rational(x.inf());
  return says(x, rational(decimal)) && width <= Rational(2) * ulp(x.inf());
}
bool agrees(const Deep& x, const std::string& decimal) {
  const Arithmetic<Deep> scope(256);
  return arb_overlaps(x.ball(), reference(decimal).ball()) && arb_rel_accuracy_bits(x.ball()) >= 120;
}
bool agrees(const Exact& x, const std::string& decimal) {
  const Arithmetic<Deep> scope(256);
  return agrees(to_deep(x), decimal);
}
bool agrees(const Calcium& x, const std::string& decimal) {
  const Arithmetic<Deep> scope(256);
  return agrees(to_deep(x), decimal);
}

bool is_nan(const Bounded& x) { return std::isnan(x.inf()) || std::isnan(x.sup()); }

template <class T>
constexpr bool is_exact = std::is_same_v<T, Exact> || std::is_same_v<T, Calcium>;

// Rationals of every size and sign.
Rational random_rational(std::mt19937_64& random) {
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const Rational value(up_to(2001) - 1000, up_to(1000) + 1);
  Rational scale(1);
  for (int i = up_to(12); i > 0; --i) scale = scale * Rational(10);
  return random() % 2 ? value * scale : value / scale;
}

}  // namespace

#define ALL_NUMBERS Fast, Bounded, Deep, Exact, Calcium
#define NUMBERS_WITH_ANGLES Fast, Bounded, Deep

// ------------------------------------------------------------------------------------------------- the four
// operations

TEMPLATE_TEST_CASE("Operations say the rational result", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  std::mt19937_64 random(20240501);
  for (int i = 0; i < 300; ++i) {
    const Rational p = random_rational(random), q = random_rational(random);
    const TestType a = from_rational<TestType>(p), b = from_rational<TestType>(q);
    CAPTURE(to_text(p), to_text(q));
    CHECK(says(a, p));
    CHECK(says(TestType(-a), -p));
    CHECK(says(TestType(a * b), p * q));
    CHECK(says(square(a), p * p));
    if (!std::is_same_v<TestType, Fast>) {  // a double cancels
      CHECK(says(TestType(a + b), p + q));
      CHECK(says(TestType(a - b), p - q));
      TestType x = a;
      x += b;
      x -= a;
      CHECK(says(x, q));
      CHECK(sign(TestType(b - b - (a - a))) != Sign::positive);
    }
    if (q == Rational(0)) continue;
    CHECK(says(TestType(a / b), p / q));
    CHECK(says(quotient(a, b), p / q));
    CHECK(says(quotient(1, b), Rational(1) / q));
    TestType x = a;
    x *= b;
    x /= b;
    CHECK(says(x, p));
    CHECK(says(root(square(b)), absolute(q)));
  }
}

TEMPLATE_TEST_CASE("Integers mix with every number", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  const TestType x = from_rational<TestType>(Rational(3, 4));
  CHECK(says(TestType(2 * x + 1), Rational(5, 2)));
  CHECK(says(TestType(1 - x * 4), Rational(-2)));
  CHECK(says(TestType(1 / x), Rational(4, 3)));
}

TEMPLATE_TEST_CASE("Signs", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  static_assert(std::is_same_v<decltype(sign(TestType(1))), Sign>);
  static_assert(std::is_same_v<decltype(square(TestType(1))), TestType>);
  CHECK(sign(TestType(3)) == Sign::positive);
  CHECK(sign(TestType(-3)) == Sign::negative);
  CHECK(sign(TestType(0)) == Sign::zero);
  CHECK(sign(from_rational<TestType>(Rational(-1, 1000000000))) == Sign::negative);
  const TestType zero = root(TestType(2)) * root(TestType(2)) - 2;
  if (is_exact<TestType>) CHECK(sign(zero) == Sign::zero);
  if (std::is_same_v<TestType, Bounded> || std::is_same_v<TestType, Deep>) CHECK(sign(zero) == Sign::undecided);
}

TEMPLATE_TEST_CASE("Division by what may be zero throws Undecided, in every number", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  const TestType r = root(TestType(2));
  const TestType zero = r * r - 2;
  CHECK_THROWS_AS(quotient(TestType(1), TestType(0)), Undecided);
  CHECK_THROWS_AS(quotient(TestType(0), TestType(0)), Undecided);
  if constexpr (!std::is_same_v<TestType, Fast>) CHECK_THROWS_AS(quotient(TestType(1), zero), Undecided);
  if constexpr (std::is_same_v<TestType, Deep> || std::is_same_v<TestType, Calcium>) {
    CHECK_THROWS_AS(TestType(1) / zero, Undecided);
    CHECK_THROWS_AS(TestType(1) / TestType(0), Undecided);
    TestType x(1);
    CHECK_THROWS_AS(x /= zero, Undecided);
    CHECK(sign(TestType(x - 1)) == Sign::zero);  // and what was to be divided is as before
  }
}

TEST_CASE("Caller mistakes are assertions") {
  const Arithmetic<Bounded> bounded;
  const Arithmetic<Deep> deep(128);
  const Arithmetic<Exact> exact;
  const Arithmetic<Calcium> calcium;
  CHECK(aborts([] { Exact(1) / Exact(0); }));
  CHECK(aborts([] { root(Bounded(-1)); }));
  CHECK(aborts([] { root(Deep(-1)); }));
  CHECK(aborts([] { root(Exact(-1)); }));
  CHECK(aborts([] { root(Calcium(-1)); }));
  CHECK(aborts([] { Deep::from_double(std::nan("")); }));
  CHECK_FALSE(aborts([] { root(Exact(1)); }));  // the trap itself does not abort
}

TEST_CASE("A number without its scope is a caller's mistake") {
  CHECK(aborts([] { Deep(1) + Deep(1); }));
  CHECK(aborts([] { root(Exact(2)); }));
  CHECK(aborts([] { Calcium(1); }));
}

// ------------------------------------------------------------------------------------------------------ roots and
// turns

// All references by mpmath with 60 digits, printed with 50.

TEMPLATE_TEST_CASE("Roots", "", ALL_NUMBERS) {
  struct Row {
    int numerator, denominator;
    const char* root;
  };
  const Row rows[] = {
      {2, 1, "1.4142135623730950488016887242096980785696718753769"},
      {3, 1, "1.7320508075688772935274463415058723669428052538104"},
      {5, 7, "0.84515425472851657750961832736594529263078589011348"},
      {1, 3, "0.57735026918962576450914878050195745564760175127013"},
      {123456789, 1000, "351.36418286444621616658231167580770371591427181243"},
  };
  const Scope<TestType> scope;
  for (const Row& row : rows) {
    CAPTURE(row.numerator, row.denominator);
    const TestType x = root(from_rational<TestType>(Rational(row.numerator, row.denominator)));
    CHECK(agrees(x, row.root));
    CHECK(sign(x) == Sign::positive);
  }
  CHECK(says(root(from_rational<TestType>(Rational(9, 16))), Rational(3, 4)));
  CHECK(sign(root(TestType(0))) == Sign::zero);
}

TEMPLATE_TEST_CASE("An enclosure that reaches below zero is cut, and a square never is negative", "", Bounded, Deep) {
  const Scope<TestType> scope;
  const TestType r = root(TestType(2));
  const TestType noise = r * r - 2;
  REQUIRE(sign(noise) == Sign::undecided);
  CHECK(enclosure(root(noise)).upper < 1e-6);
  CHECK(enclosure(root(noise)).upper > 0);
  CHECK(enclosure(root(noise)).lower <= 0);
  CHECK(enclosure(square(noise)).lower >= 0);
  CHECK(enclosure(square(TestType(-3))).lower == 9);
}

struct TurnRow {
  int numerator, denominator;
  const char* cosine;
  const char* sine;
};
const TurnRow turn_rows[] = {
    {1, 12, "0.86602540378443864676372317075293618347140262690519", "0.5"},
    {1, 8, "0.70710678118654752440084436210484903928483593768847",
     "0.70710678118654752440084436210484903928483593768847"},
    {1, 24, "0.9659258262890682867497431997288973676339048390084",
     "0.25881904510252076234889883762404832834906890131993"},
    {1, 7, "0.6234898018587335305250048840042398106322747308964",
     "0.78183148246802980870844452667405775023233451870869"},
    {1, 18, "0.93969262078590838405410927732473146993620813426446",
     "0.34202014332566873304409961468225958076308336751416"},
    {1, 3, "-0.5", "0.86602540378443864676372317075293618347140262690519"},
    {5, 24, "0.25881904510252076234889883762404832834906890131993",
     "0.9659258262890682867497431997288973676339048390084"},
    {17, 48, "-0.60876142900872063941609754289816400451639371196248",
     "0.79335334029123516457977696150129927662867592105191"},
    {-1, 9, "0.7660444431189780352023926505554166739358324570804",
     "-0.64278760968653932632264340990726343290755988420568"},
    {1234567, 10000000, "0.71393013106452611950009576106363472470301345655056",
     "0.70021694349550593911797147258093812882560310417735"},
    {3, 11, "-0.14231483827328514044379266861636966879105136112598",
     "0.98982144188093273237609203777671878737651937194872"},
};

TEMPLATE_TEST_CASE("Cosine and sine of rational turns", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  int seen = 0;
  for (const TurnRow& row : turn_rows) {
    const Rational fraction(row.numerator, row.denominator);
    CAPTURE(to_text(fraction));
    for (const Rational& same : {fraction, fraction + Rational(1), fraction - Rational(7)}) {
      if (std::is_same_v<TestType, Exact> && (fraction * Rational(24)).denominator() != 1) {
        CHECK_THROWS_AS(cosine<TestType>(Turn{same}), LeavesTheTower);
        CHECK_THROWS_AS(sine<TestType>(Turn{same}), LeavesTheTower);
        continue;
      }
      if (std::is_same_v<TestType, Calcium> && row.denominator > 1000) {  // of degree 2 000 000
        CHECK_THROWS_AS(cosine<TestType>(Turn{same}), Undecided);
        CHECK_THROWS_AS(sine<TestType>(Turn{same}), Undecided);
        continue;
      }
      ++seen;
      CHECK(agrees(cosine<TestType>(Turn{same}), row.cosine));
      CHECK(agrees(sine<TestType>(Turn{same}), row.sine));
    }
  }
  CHECK(seen >= 15);
}

TEMPLATE_TEST_CASE("Where cosine or sine is rational it is a point", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  const Rational half(1, 2);
  const Rational cosines[12] = {1,  0, half,  0, -half, 0,
                                -1, 0, -half, 0, half,  0};  // odd places but 3, 9: irrational
  for (const int twelfths : {0, 2, 3, 4, 6, 8, 9, 10, 12, -2, 26}) {
    CAPTURE(twelfths);
    const Rational truth = cosines[((twelfths % 12) + 12) % 12];
    const TestType c = cosine<TestType>(Turn{Rational(twelfths, 12)});
    const TestType s = sine<TestType>(Turn{Rational(twelfths + 3, 12)});
    CHECK(says(c, truth));
    CHECK(sign(TestType(c - from_rational<TestType>(truth))) == Sign::zero);
    CHECK(sign(TestType(s - from_rational<TestType>(truth))) == Sign::zero);
  }
}

TEMPLATE_TEST_CASE("All multiples of 15 degrees lie on the unit circle, at the right place", "", ALL_NUMBERS) {
  const Scope<TestType> scope;
  for (int n = -24; n <= 48; ++n) {
    CAPTURE(n);
    const TestType c = cosine<TestType>(Turn{Rational(n, 24)});
    const TestType s = sine<TestType>(Turn{Rational(n, 24)});
    const double angle = 2 * pi<Fast>() * n / 24;
    if constexpr (std::is_same_v<TestType, Fast>) {
      CHECK(std::abs(c - std::cos(angle)) < 1e-14);
      CHECK(std::abs(s - std::sin(angle)) < 1e-14);
    } else if constexpr (is_exact<TestType>) {
      const Arithmetic<Deep> deep(64);
      CHECK(sign(TestType(c * c + s * s - 1)) == Sign::zero);
      CHECK(std::abs(enclosure(to_deep(c)).value - std::cos(angle)) < 1e-14);
      CHECK(std::abs(enclosure(to_deep(s)).value - std::sin(angle)) < 1e-14);
    } else {
      CHECK(std::abs(enclosure(c).value - std::cos(angle)) < 1e-14);
      CHECK(std::abs(enclosure(s).value - std::sin(angle)) < 1e-14);
    }
  }
}

TEMPLATE_TEST_CASE("Next to a right angle the small cosine keeps its accuracy", "", NUMBERS_WITH_ANGLES) {
  const Scope<TestType> scope;
  // mpmath with 120 digits: cos(2 pi (1/4 + 1e-30))
  const TestType c = cosine<TestType>(Turn{Rational(1, 4) + rational("1e-30")});
  CHECK(agrees(c, "-6.2831853071795864769252867665590057683943387987502e-30"));
}

TEMPLATE_TEST_CASE("Pi", "", Fast, Bounded, Deep, Calcium) {
  const Scope<TestType> scope;
  CHECK(agrees(pi<TestType>(), "3.1415926535897932384626433832795028841971693993751"));
}

TEST_CASE("Pi leaves the tower") {
  const Arithmetic<Exact> scope;
  CHECK_THROWS_AS(pi<Exact>(), LeavesTheTower);
}

TEMPLATE_TEST_CASE("Arc tangent", "", NUMBERS_WITH_ANGLES) {
  struct Row {
    int y, x;
    const char* angle;
  };
  const Row rows[] = {
      {1, 1, "0.78539816339744830961566084581987572104929234984378"},
      {1, -1, "2.3561944901923449288469825374596271631478770495313"},
      {-1, -1, "-2.3561944901923449288469825374596271631478770495313"},
      {-1, 1, "-0.78539816339744830961566084581987572104929234984378"},
      {1, 3, "0.32175055439664219340140461435866131902075529555766"},
      {5, -2, "1.9513027039072615055349096084501845465959904133457"},
      {-7, -1, "-1.712693381399060542044173308742304525106366458416"},
      {2, 0, "1.5707963267948966192313216916397514420985846996876"},
      {-2, 0, "-1.5707963267948966192313216916397514420985846996876"},
      {0, -3, "3.1415926535897932384626433832795028841971693993751"},
  };
  const Scope<TestType> scope;
  for (const Row& row : rows) {
    CAPTURE(row.y, row.x);
    CHECK(agrees(arc_tangent(TestType(row.y), TestType(row.x)), row.angle));
  }
  CHECK(sign(arc_tangent(TestType(0), TestType(3))) == Sign::zero);
  CHECK_THROWS_AS(arc_tangent(TestType(0), TestType(0)), Undecided);
}

TEMPLATE_TEST_CASE("Across the cut and around the origin there is no angle", "", Bounded, Deep) {
  const Scope<TestType> scope;
  const TestType r = root(TestType(2));
  const TestType noise = r * r - 2;
  CHECK_THROWS_AS(arc_tangent(noise, TestType(-1)), Undecided);
  CHECK_THROWS_AS(arc_tangent(noise, noise), Undecided);
  CHECK_THROWS_AS(arc_tangent(TestType(0), noise), Undecided);
  CHECK(enclosure(arc_tangent(noise, TestType(1))).upper < 1e-14);
  CHECK(std::abs(enclosure(arc_tangent(TestType(1), noise)).value - 1.5707963267948966) < 1e-14);
}

TEST_CASE("The angles of a wide box lie between those of its corners") {
  const Arithmetic<Bounded> scope;
  const Bounded angle = arc_tangent(Bounded(1, 2), Bounded(-3, 4));
  CHECK(angle.inf() <= std::atan2(1, 4));
  CHECK(angle.inf() >= std::atan2(1, 4) - 1e-15);
  CHECK(angle.sup() >= std::atan2(1, -3));
  CHECK(angle.sup() <= std::atan2(1, -3) + 1e-15);
  CHECK_THROWS_AS(arc_tangent(Bounded(1, infinity), Bounded(1)), Undecided);
}

TEST_CASE("In every quadrant and across every axis but the cut, the angles of a box are enclosed tightly") {
  const Arithmetic<Bounded> scope;
  int boxes = 0;
  for (const double y : {-3.0, -1.0, 1.0, 2.0})
    for (const double x : {-4.0, -2.0, -0.5, 0.5, 3.0})
      for (const double size : {0.25, 0.75}) {
        const Bounded angle = arc_tangent(Bounded(y, y + size), Bounded(x, x + size));
        double least = infinity, most = -infinity;
        for (int i = 0; i <= 8; ++i)
          for (int j = 0; j <= 8; ++j) {
            const double sampled = std::atan2(y + size * i / 8, x + size * j / 8);
            least = std::min(least, sampled);
            most = std::max(most, sampled);
          }
        CAPTURE(y, x, size);
        CHECK(std::abs(angle.inf() - least) < 1e-15);
        CHECK(std::abs(angle.sup() - most) < 1e-15);
        ++boxes;
      }
  CHECK(boxes == 40);
}

TEMPLATE_TEST_CASE("Cosine and sine of an angle", "", NUMBERS_WITH_ANGLES) {
  struct Row {
    const char *angle, *cosine, *sine;
  };
  const Row rows[] = {
      {"0.5", "0.87758256189037271611628158260382965199164519710974",
       "0.4794255386042030002732879352155713880818033679406"},
      {"-2", "-0.41614683654714238699756822950076218976600077107554",
       "-0.90929742682568169539601986591174484270225497144789"},
      {"3", "-0.98999249660044545727157279473126130239367909661559",
       "0.14112000805986722210074480280811027984693326425227"},
      {"100", "0.86231887228768393410193851395084253551008400853551",
       "-0.50636564110975879365655761045978543206503272129066"},
      {"0.0009765625", "0.99999952316287969248636920294988906921551023520824",
       "9.7656234477957829890691016811978636680241804620826e-4"},
      {"22", "-0.99996082639463712645417473921269377413598846747942",
       "-8.8513092904038759216902568157723324632892039513326e-3"},
  };
  const Scope<TestType> scope;
  for (const Row& row : rows) {
    CAPTURE(row.angle);
    const TestType angle = from_rational<TestType>(rational(row.angle));
    CHECK(agrees(cosine_of_angle(angle), row.cosine));
    CHECK(agrees(sine_of_angle(angle), row.sine));
  }
  CHECK(sign(sine_of_angle(TestType(0))) == Sign::zero);
}

TEST_CASE("The cosine of the double nearest to a right angle of all doubles keeps its digits") {
  const Arithmetic<Bounded> scope;
  const Bounded cosine = cosine_of_angle(Bounded(std::ldexp(6381956970095103.0, 797)));
  CHECK(sign(cosine) != Sign::undecided);
  CHECK(std::abs(cosine.inf() / -4.6871659242546276111e-19 - 1) < 1e-15);
  CHECK(cosine.sup() <= std::nextafter(cosine.inf(), infinity));
}

TEST_CASE("The cosine of a wide angle contains all that is in between, and nothing beyond 1") {
  const Arithmetic<Bounded> scope;
  const Bounded cosine = cosine_of_angle(Bounded(-0.5, 1));
  CHECK(cosine.inf() <= std::cos(1.0));
  CHECK(cosine.sup() == 1);
  const Bounded sine = sine_of_angle(Bounded(-100, 100));
  CHECK(sine.inf() == -1);
  CHECK(sine.sup() == 1);
  CHECK_THROWS_AS(sine_of_angle(Bounded(0, infinity)), Undecided);
}

TEMPLATE_TEST_CASE("Midpoint and widening", "", Bounded, Deep) {
  const Scope<TestType> scope;
  const TestType third = from_rational<TestType>({1, 3}), point = midpoint(third);
  const Enclosure at = enclosure(point), around = enclosure(widened(third, TestType(2)));
  CHECK(at.lower <= 1. / 3);
  CHECK(at.upper >= 0.3333333333333333);
  CHECK(sign(point - point) == Sign::zero);
  CHECK(around.lower <= -5. / 3);
  CHECK(around.lower >= -1.66666668);  // a ball keeps 30 bits of its radius
  CHECK(around.upper >= 7. / 3);
  CHECK(around.upper <= 2.33333335);
  CHECK(enclosure(widened(TestType(1), third)).upper >= 1.3333333333333333);
}

TEST_CASE("Fast reads a -0.0 as a zero on the near side of the cut") {
  CHECK(arc_tangent(-0.0, -1.0) == pi<Fast>());
  CHECK(arc_tangent(-0.0, 1.0) == 0);
}

// --------------------------------------------------------------------------------------------- conversions to
// doubles

TEST_CASE("The nearest double of a rational: ties, subnormals, overflow") {
  const auto fast = [](const Rational& x) { return from_rational<Fast>(x); };
  const Rational e(std::ldexp(1.0, -53));
  CHECK(fast(Rational(1, 10)) == 0.1);
  CHECK(fast(Rational(2, 3)) == 2.0 / 3);
  CHECK(fast(Rational(1) + e) == 1);  // tie to even
  CHECK(fast(Rational(1) + Rational(3) * e) == 1 + std::ldexp(1.0, -51));
  CHECK(fast(Rational(1) + e + e * e) == 1 + std::ldexp(1.0, -52));
  CHECK(fast(Rational(smallest) / Rational(2)) == 0);  // tie to even
  CHECK(fast(Rational(smallest) * Rational(3, 4)) == smallest);
  CHECK(fast(Rational(smallest) * Rational(3, 2)) == 2 * smallest);
  CHECK(fast(Rational(smallest) * (Rational(9, 2) + e * e)) == 5 * smallest);  // rounded once, not to 4.5 first
  CHECK(fast(-Rational(largest)) == -largest);
  CHECK(fast(rational("1e400")) == infinity);
}

TEST_CASE("A rational becomes the narrowest interval") {
  const Arithmetic<Bounded> scope;
  for (const char* text : {"0.1", "-1/3", "1e-330", "-1e-330", "1e400", "-1e400", "0.5", "0", "1e308"}) {
    CAPTURE(text);
    const Bounded x = from_rational<Bounded>(rational(text));
    CHECK(x.inf() <= x.sup());
    if (std::isfinite(x.inf())) CHECK(Rational(x.inf()) <= rational(text));
    if (std::isfinite(x.sup())) CHECK(rational(text) <= Rational(x.sup()));
    CHECK((x.inf() == x.sup() || std::nextafter(x.inf(), infinity) == x.sup()));
  }
  CHECK(from_rational<Bounded>(Rational(1, 2)).is_point());
}

TEST_CASE("Certain doubles") {
  const Arithmetic<Deep> scope(128);
  const auto of = [](const Rational& x) { return certain_double(from_rational<Deep>(x)); };
  CHECK(of(Rational(1, 3)) == 1.0 / 3);
  CHECK(of(Rational(0)) == 0.0);
  CHECK_FALSE(std::signbit(*of(-rational("1e-390"))));  // the nearest double is zero, without a sign
  CHECK(of(-rational("1e-390")) == 0.0);
  CHECK_FALSE(of(rational("1e400")));
  // A tie is certain when the ball is a point, and never when it has a width.
  const Deep tie = from_rational<Deep>(Rational(1) + Rational(std::ldexp(1.0, -53)));
  CHECK(certain_double(tie) == 1.0);
  const Deep r = root(Deep(2));
  CHECK_FALSE(certain_double(tie + (r * r - 2)));
  CHECK_FALSE(certain_double(root(Deep(2)) * from_rational<Deep>(rational("1e400"))));
}

TEST_CASE("Balls become enclosures that contain them, at most 2 ulp wide") {
  const Arithmetic<Deep> scope(128);
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Rational x = random_rational(random);
    const Enclosure e = enclosure(from_rational<Deep>(x));
    CAPTURE(to_text(x));
    CHECK(Rational(e.lower) <= x);
    CHECK(x <= Rational(e.upper));
    CHECK(e.value == from_rational<Fast>(x));
    CHECK(e.upper <= std::nextafter(e.lower, infinity));
  }
}

TEST_CASE("Enclosures at the ends of the doubles") {
  const Arithmetic<Deep> scope(128);
  const auto of = [](const char* text) { return enclosure(from_rational<Deep>(rational(text))); };
  CHECK(of("1e400").lower == largest);
  CHECK(of("1e400").upper == infinity);
  CHECK(of("-1e400").lower == -infinity);
  CHECK(of("-1e400").upper == -largest);
  CHECK(of("1e-400").lower == 0);
  CHECK(of("1e-400").value == 0);
  CHECK(of("1e-400").upper == smallest);
  CHECK(of("-1e-400").lower == -smallest);
  CHECK(of("-1e-400").upper == 0);
  CHECK_FALSE(std::signbit(of("-1e-400").upper));
  CHECK(of("3e-324").lower == 0);  // between 0 and the smallest double, 4.9e-324
  CHECK(of("3e-324").value == smallest);
  CHECK(of("3e-324").upper == smallest);
}

TEST_CASE("Enclosures of intervals: the midpoint, and no NaN at infinity") {
  const Arithmetic<Bounded> scope;
  CHECK(enclosure(Bounded(1, 3)).value == 2);
  CHECK(enclosure(Bounded(-largest, largest)).value == 0);
  CHECK(enclosure(Bounded(largest / 2, largest)).value == largest / 4 * 3);
  CHECK(enclosure(Bounded(-infinity, infinity)).value == 0);
  CHECK(enclosure(Bounded(5, infinity)).value == 5);
}

TEST_CASE("Bounded never is NaN, even when everything overflows") {
  const Arithmetic<Bounded> scope;
  const Bounded huge = square(from_rational<Bounded>(rational("1e300")));
  REQUIRE(huge.sup() == infinity);
  const Bounded wide = huge - huge;
  for (const Bounded& x : {huge, -huge, wide, Bounded(0), Bounded(0, 1), Bounded(-1, 0), Bounded(-1, 1)})
    for (const Bounded& y : {huge, -huge, wide, Bounded(0), Bounded(0, 1), Bounded(-1, 0), Bounded(-1, 1)}) {
      CAPTURE(x.inf(), x.sup(), y.inf(), y.sup());
      for (const Bounded& z : {x + y, x - y, x * y, square(x), root(square(x))}) CHECK_FALSE(is_nan(z));
      if (sign(y) == Sign::positive || sign(y) == Sign::negative) CHECK_FALSE(is_nan(quotient(x, y)));
    }
  CHECK((huge * Bounded(0)).inf() <= 0);
  CHECK((huge * Bounded(0)).sup() >= 0);
}

TEST_CASE("Deep from doubles and intervals") {
  const Arithmetic<Deep> scope(64);
  CHECK(says(Deep::from_double(0.1), Rational(0.1)));
  CHECK(arb_is_exact(Deep::from_double(0.1).ball()));
  const Deep x = Deep::from_bounded(Bounded(1, 3));
  CHECK(says(x, Rational(1)));
  CHECK(says(x, Rational(3)));
  const Bounded back = to_bounded(Deep::from_bounded(Bounded(0.1, 0.2)));
  CHECK(back.inf() <= 0.1);
  CHECK(back.sup() >= 0.2);
}

// --------------------------------------------------------------------------------------------------------------
// scopes

namespace {

// What the processor does, not what a library remembers (fegetround reads the x87 unit, which computes nothing here).
bool rounds_upwards() {
  volatile double one = 1, little = std::ldexp(1.0, -80);
  return one + little > 1 && -one - little == -1;
}
bool rounds_to_nearest() {
  volatile double one = 1, little = std::ldexp(1.0, -80), much = std::ldexp(1.0, -53) * 1.5;
  return one + little == 1 && one + much > 1 && -one - much < -1;
}

}  // namespace

TEST_CASE("The rounding mode comes back, also through an exception") {
  REQUIRE(rounds_to_nearest());
  {
    const Arithmetic<Bounded> scope;
    CHECK(rounds_upwards());
    {
      const Arithmetic<Bounded> again;
      CHECK(rounds_upwards());
    }
    CHECK(rounds_upwards());
  }
  CHECK(rounds_to_nearest());
  try {
    const Arithmetic<Bounded> scope;
    throw Undecided("on purpose");
  } catch (const Undecided&) {
    CHECK(rounds_to_nearest());
  }
}

namespace {

// Something of everything the number can do.
template <class T>
T medley() {
  const T c = cosine<T>(Turn{Rational(1, 24)});
  const T r = root(T(7 + 2 * c));
  return quotient(T(r - from_rational<T>(Rational(1, 3))), T(square(c) + r)) - c / 3;
}

template <class T>
T medley_with_angles() {
  return medley<T>() * arc_tangent(T(2), T(3)) + pi<T>() * cosine<T>(Turn{Rational(1, 7)});
}

}  // namespace

TEST_CASE("The other numbers leave the rounding mode alone and do not depend on it") {
  const auto same = [](const Deep& a, const Deep& b) { return arb_equal(a.ball(), b.ball()) != 0; };
  for (const long bits : {53L, 128L, 1000L}) {
    const Arithmetic<Deep> deep(bits);
    const Deep to_nearest = medley_with_angles<Deep>();
    const Arithmetic<Bounded> upwards;
    CHECK(same(medley_with_angles<Deep>(), to_nearest));
    CHECK(rounds_upwards());
  }
  const Arithmetic<Exact> exact;
  const Arithmetic<Calcium> calcium;
  const Exact e = medley<Exact>();
  const Calcium c = medley<Calcium>();
  const Enclosure nearest = [] {
    const Arithmetic<Deep> deep(128);
    return enclosure(root(Deep(2)));
  }();
  const Arithmetic<Bounded> upwards;
  CHECK((medley<Exact>() - e).is_zero());
  CHECK(sign(e) == Sign::positive);
  CHECK(sign(medley<Calcium>() - c) == Sign::zero);
  CHECK(from_rational<Fast>(Rational(1, 10)) == 0.1);
  CHECK(from_rational<Fast>(Rational(-1, 10)) == -0.1);
  const Arithmetic<Deep> deep(128);
  const Enclosure under_upwards = enclosure(root(Deep(2)));
  CHECK(under_upwards.lower == nearest.lower);
  CHECK(under_upwards.value == nearest.value);
  CHECK(under_upwards.upper == nearest.upper);
  CHECK(rounds_upwards());
}

TEST_CASE("Bounded stays right while scopes of other numbers are open") {
  const Arithmetic<Bounded> bounded;
  const auto contains_reference = [] {
    const Arithmetic<Deep> deep(128);
    const Enclosure truth = enclosure(medley_with_angles<Deep>());
    const Bounded x = medley_with_angles<Bounded>();
    return x.inf() <= truth.lower && truth.upper <= x.sup() && x.inf() < x.sup();
  };
  CHECK(contains_reference());
  const Arithmetic<Exact> exact;
  const Arithmetic<Calcium> calcium;
  sign(medley<Exact>());
  sign(medley<Calcium>());
  CHECK(contains_reference());
}

TEST_CASE("The precision of the innermost scope counts, and the outer one comes back") {
  const auto accuracy = [] { return arb_rel_accuracy_bits(root(Deep(2)).ball()); };
  const Arithmetic<Deep> outer(128);
  const long outside = accuracy();
  {
    const Arithmetic<Deep> inner(1024);
    CHECK(Arithmetic<Deep>::bits() == 1024);
    CHECK(accuracy() > 1000);
  }
  CHECK(Arithmetic<Deep>::bits() == 128);
  CHECK(accuracy() == outside);
  try {
    const Arithmetic<Deep> inner(256);
    throw Undecided("on purpose");
  } catch (const Undecided&) {
    CHECK(Arithmetic<Deep>::bits() == 128);
  }
}

TEST_CASE("Two threads, each with its own scopes") {
  const auto work = [](long bits, int* failures) {
    for (int i = 0; i < 200; ++i) {
      const Arithmetic<Bounded> bounded;
      const Arithmetic<Deep> deep(bits);
      const Arithmetic<Exact> exact;
      const Arithmetic<Calcium> calcium;
      const Exact zero = root(Exact(3 + 2 * root(Exact(2)))) - 1 - root(Exact(2));
      const Calcium c = cosine<Calcium>(Turn{Rational(1, 5)});
      const Bounded x = medley_with_angles<Bounded>();
      const Enclosure truth = enclosure(medley_with_angles<Deep>());
      if (!zero.is_zero() || sign(4 * c * c + 2 * c - 1) != Sign::zero || Arithmetic<Deep>::bits() != bits ||
          !(x.inf() <= truth.lower && truth.upper <= x.sup()))
        ++*failures;
    }
  };
  int here = 0, there = 0;
  std::thread other([&] {
    const ThreadCaches caches;
    work(256, &there);
  });
  work(128, &here);
  other.join();
  CHECK(here == 0);
  CHECK(there == 0);
  CHECK(rounds_to_nearest());
}

// How many of 64 threads come to work when there is no room for the stacks of all of them.
int workers_without_memory() {
  std::size_t pages_in_use = 0;
  std::ifstream("/proc/self/statm") >> pages_in_use;
  const rlim_t limit = pages_in_use * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (100 << 20);
  const rlimit little{limit, limit};
  setrlimit(RLIMIT_AS, &little);
  std::atomic<int> workers = 0;
  std::atomic<bool> all_there = false;
  in_threads(64, [&, first = std::this_thread::get_id()] {
    if (std::this_thread::get_id() == first) {  // the last to be called
      all_there = true;
      all_there.notify_all();
    }
    all_there.wait(false);
    ++workers;
  });
  return workers;
}

TEST_CASE("Where the system gives no further thread, those that are there do the work") {
  CHECK_FALSE(aborts([]() noexcept {
    const int workers = workers_without_memory();
    if (workers < 1 || workers >= 64) std::abort();
  }));
}

// ----------------------------------------------------------------------------------------------------------- the
// tower

TEST_CASE("A root that is there already adds no storey") {
  const Arithmetic<Exact> scope;
  const Exact r2 = root(Exact(2));
  REQUIRE(Arithmetic<Exact>::storeys() == 1);
  SECTION("a nested root: sqrt(3 + 2 sqrt 2) = 1 + sqrt 2, and its conjugate") {
    CHECK((root(3 + 2 * r2) - 1 - r2).is_zero());
    CHECK((root(3 - 2 * r2) + 1 - r2).is_zero());  // sqrt 2 - 1: the positive root
    CHECK((root(6 + 4 * r2) - 2 - r2).is_zero());  // here the rational part is the larger one
    CHECK((root(6 - 4 * r2) - 2 + r2).is_zero());
    CHECK(Arithmetic<Exact>::storeys() == 1);
  }
  SECTION("a rational multiple of a root") {
    CHECK((root(Exact(50)) - 5 * r2).is_zero());
    CHECK((root(Exact(Rational(1, 2))) * 2 - r2).is_zero());
    CHECK(Arithmetic<Exact>::storeys() == 1);
  }
  SECTION("two storeys: sqrt 6, sqrt 12, sqrt(5 + 2 sqrt 6)") {
    const Exact r3 = root(Exact(3));
    REQUIRE(Arithmetic<Exact>::storeys() == 2);
    CHECK((root(Exact(6)) - r2 * r3).is_zero());
    CHECK((root(Exact(12)) - 2 * r3).is_zero());
    CHECK((root(5 + 2 * root(Exact(6))) - r2 - r3).is_zero());
    CHECK((root(5 - 2 * root(Exact(6))) - r3 + r2).is_zero());
    CHECK(Arithmetic<Exact>::storeys() == 2);
  }
  SECTION("on a storey of its own: the roots of 2 + sqrt 2 and of its conjugate multiply to sqrt 2") {
    const Exact s = root(2 + r2);
    CHECK(Arithmetic<Exact>::storeys() == 2);
    CHECK((root(2 - r2) * s - r2).is_zero());
    CHECK(Arithmetic<Exact>::storeys() == 2);
  }
}

TEST_CASE("Rational squares add no storey: there is no sqrt 4 whose conjugate could vanish") {
  const Arithmetic<Exact> scope;
  const Exact two = root(Exact(4));
  CHECK(Arithmetic<Exact>::storeys() == 0);
  CHECK(two.is_rational());
  CHECK((1 / (2 + two)).rational() == Rational(1, 4));  // with a formal sqrt 4 the norm of 2 + sqrt 4 is zero
  CHECK(root(Exact(Rational(49, 36))).rational() == Rational(7, 6));
}

TEST_CASE("A number does not depend on the order in which its roots came") {
  const auto build = [](bool six_first) {
    const Arithmetic<Exact> scope;
    if (six_first) root(Exact(6));
    const Exact sum = root(Exact(2)) + root(Exact(3));
    CHECK(Arithmetic<Exact>::storeys() == 2);
    CHECK((square(sum) - 5 - 2 * root(Exact(6))).is_zero());
    CHECK((1 / sum - root(Exact(3)) + root(Exact(2))).is_zero());
  };
  build(false);
  build(true);
}

TEST_CASE("The sixth independent root leaves the tower, and Calcium answers") {
  const auto six_roots = []<class T>() {
    T product(1);
    for (const int p : {2, 3, 5, 7, 11, 13}) product *= root(T(p));
    return T(product - root(T(2 * 3 * 5 * 7 * 11 * 13)));
  };
  {
    const Arithmetic<Exact> scope;
    CHECK_THROWS_AS(six_roots.operator()<Exact>(), LeavesTheTower);
    CHECK(Arithmetic<Exact>::storeys() == 5);
    CHECK((root(Exact(2 * 3 * 5 * 7 * 11)) * root(Exact(22)) - root(Exact(105)) * 22)
              .is_zero());  // what is there, works
  }
  const Arithmetic<Calcium> scope;
  CHECK(sign(six_roots.operator()<Calcium>()) == Sign::zero);
}

TEST_CASE("Towers nest and do not mix") {
  const Arithmetic<Exact> outer;
  const Exact r2 = root(Exact(2));
  {
    const Arithmetic<Exact> inner;
    CHECK(Arithmetic<Exact>::storeys() == 0);
    const Exact r3 = root(Exact(3));
    CHECK((r3 * r3).rational() == Rational(3));
    CHECK(aborts([&] { r2 + r3; }));
    CHECK(aborts([&] { r2* r2; }));
  }
  CHECK(Arithmetic<Exact>::storeys() == 1);
  CHECK((r2 * r2).rational() == Rational(2));
}

TEST_CASE("Exact signs of tiny differences") {
  const Arithmetic<Exact> scope;
  const Exact r2 = root(Exact(2));
  Exact power = r2 - 1;
  for (int i = 0; i < 10; ++i)
    power = square(power);  // (sqrt 2 - 1)^1024 = 1.1e-392, from coefficients of 392 digits
  CHECK(sign(power) == Sign::positive);
  CHECK(sign(-power) == Sign::negative);
  CHECK(sign(power - power) == Sign::zero);
}

TEST_CASE("What Calcium cannot prove it leaves undecided; a number next to zero it never takes for zero") {
  const Arithmetic<Calcium> scope;
  Calcium sum(0);
  for (const int p : {2, 3, 5, 7, 11, 13}) sum += root(Calcium(p));
  const Calcium zero = root(square(sum)) - sum;
  CHECK(sign(zero) == Sign::undecided);
  CHECK_THROWS_AS(1 / zero, Undecided);
  CHECK(sign(zero + from_rational<Calcium>(rational("1e-100"))) == Sign::positive);
}

TEST_CASE("Calcium leaves a turn with a large denominator undecided, and says why") {
  const Arithmetic<Calcium> scope;
  const Turn turn{Rational(123457, 1000000)};
  CHECK_THROWS_AS(cosine<Calcium>(turn), Undecided);
  CHECK_THROWS_AS(sine<Calcium>(turn), Undecided);
}
