// A sweep against the digits of the corpora (mpmath), against Deep, and against the plain loop on Bounded, bit for
// bit.
#include "bench/sweeping/second_order_sweep.h"
#include "bench/sweeping/uniform_turns.h"
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

#include <cfenv>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

using namespace epure::geometry;
using namespace epure::tests;

namespace {

DrivenFourBar four_bar_of(Rational A0A, Rational AB, Rational B0B, Rational x_B0, Rational y_B0, Side side) {
  return {{A0A, AB, B0B, x_B0, y_B0}, side, 2, 1, Rational(3, 2), Rational(1, 3)};
}
DrivenFourBar crank_rocker(Rational scale = 1) {
  return four_bar_of(scale * Rational(1, 5), scale * Rational(1, 2), scale * Rational(7, 10), scale * Rational(4, 5),
                     scale * Rational(1, 100), Side::left);
}
DrivenSliderCrank slider_crank_of(Rational r, Rational l, Rational e) {
  return {{r, l, l / 2, l * Rational(3, 4), e}, 2, 1};
}

// The numbers of a position, with what each depends on.
template <class T>
struct Named {
  const char* name;
  T value;
  Truth is_known;
};
template <class T>
std::vector<Named<T>> named(const SecondOrder<T>& of, const Swept& known) {
  return {{"x_A", of.A.x, known.position},
          {"y_A", of.A.y, known.position},
          {"x_B", of.B.x, known.position},
          {"y_B", of.B.y, known.position},
          {"x_C", of.C.x, known.position},
          {"y_C", of.C.y, known.position},
          {"omega_3", of.omega_3, known.motion},
          {"alpha_3", of.alpha_3, known.motion},
          {"driven_velocity", of.driven_velocity, known.motion},
          {"driven_acceleration", of.driven_acceleration, known.motion},
          {"x_P0", of.P0.x, known.P0},
          {"y_P0", of.P0.y, known.P0},
          {"x_K", of.K.x, known.K},
          {"y_K", of.K.y, known.K},
          {"x_centre", of.centre.x, known.centre},
          {"y_centre", of.centre.y, known.centre}};
}

template <class Driven>
std::vector<Swept> sweep(const Driven& driven, std::size_t n, SweepCount& count, unsigned threads = 1) {
  std::vector<Swept> results(n);
  count = sweep_second_order(driven, results, threads);
  CHECK(count.side_by_side + count.handed_over() == n);
  return results;
}
template <class Driven>
std::vector<Swept> sweep(const Driven& driven, std::size_t n) {
  SweepCount count;
  return sweep(driven, n, count);
}

bool is_same(const Bounded& a, const Bounded& b) { return a.inf() == b.inf() && a.sup() == b.sup(); }

bool holds(const Bounded& x, const Deep& value) {
  return (std::isinf(x.inf()) || sign(value - Deep::from_double(x.inf())) != Sign::negative) &&
         (std::isinf(x.sup()) || sign(Deep::from_double(x.sup()) - value) != Sign::negative);
}

// How many positions are wholly known; each of them is held against 256 bits.
template <class Driven>
int held_against_deep(const Driven& driven, std::size_t n, std::size_t step = 1) {
  const std::vector<Swept> results = sweep(driven, n);
  const Arithmetic<Bounded> rounding;
  const Arithmetic<Deep> precision(256);
  const typename Driven::template On<Deep> of(driven);
  int held = 0;
  for (std::size_t k = 0; k < n; k += step) {
    const Turn turn{Rational(static_cast<int>(k), static_cast<int>(n))};
    const Swept& found = results[k];
    INFO("position " << k << " of " << n);
    try {
      const SecondOrder<Deep> truth = second_order(of, Vector<Deep>{cosine<Deep>(turn), sine<Deep>(turn)});
      const auto theirs = named(truth, found);
      const auto ours = named(found.at, found);
      for (std::size_t i = 0; i < ours.size(); ++i) {
        INFO(ours[i].name);
        REQUIRE(ours[i].is_known == Truth::yes);
        REQUIRE(holds(ours[i].value, theirs[i].value));
      }
      ++held;
    } catch (const Undecided&) {
    } catch (const Impossible&) {
      REQUIRE(found.motion == Truth::no);
      REQUIRE(found.K == Truth::no);
    }
  }
  return held;
}

template <class Driven>
void agrees_with_the_plain_loop(const Driven& driven, std::size_t n) {
  SweepCount count;
  const std::vector<Swept> results = sweep(driven, n, count);
  REQUIRE(count.side_by_side == n);
  const Arithmetic<Bounded> rounding;
  const UniformTurns turns(n);
  std::vector<Vector<Bounded>> cranks;
  for (std::size_t k = 0; k < n; ++k) {
    const auto both = turns(k / turns.width(), k % turns.width() / 2);
    const int i = static_cast<int>(k % turns.width() % 2);
    cranks.push_back({both.cosine.lane(i), both.sine.lane(i)});
  }
  std::vector<SecondOrder<Bounded>> plain(n);
  second_order_one_by_one<Bounded>(driven, cranks, plain);
  for (std::size_t k = 0; k < n; ++k) {
    const auto ours = named(results[k].at, results[k]), theirs = named(plain[k], results[k]);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      INFO("position " << k << " of " << n << ", " << ours[i].name);
      REQUIRE(is_same(ours[i].value, theirs[i].value));
    }
  }
}

}  // namespace

TEST_CASE("Sweep: the same enclosures as Bounded, one position after the other") {
  agrees_with_the_plain_loop(crank_rocker(), 1009);
  agrees_with_the_plain_loop(slider_crank_of(Rational(1, 5), Rational(1, 2), Rational(1, 50)), 1009);
}

TEST_CASE("Sweep: what 256 bits give lies inside") {
  CHECK(held_against_deep(crank_rocker(), 1000) == 1000);
  CHECK(held_against_deep(four_bar_of(Rational(3, 20), Rational(37, 100), Rational(9, 20), Rational(-9, 50),
                                      Rational(-4, 25), Side::right),
                          600) > 590);
  CHECK(held_against_deep(slider_crank_of(Rational(1, 5), Rational(1, 2), Rational(1, 50)), 1001) == 1001);
  CHECK(held_against_deep(slider_crank_of(Rational(1, 5), Rational(3, 20), Rational(0)), 601) > 100);
}

TEST_CASE("Sweep: random linkages of all sizes and both sides") {
  Random random(seed());
  int held = 0;
  for (int i = 0; i < 60; ++i) {
    const Rational size = random.power_of_ten(-9, 8);
    const auto length = [&] { return Rational(size * abs(random.fraction())); };
    INFO("seed " << seed() << ", linkage " << i);
    held += held_against_deep(four_bar_of(length(), length(), length(), size * random.fraction(),
                                          size * random.fraction(), i % 2 == 0 ? Side::left : Side::right),
                              60);
    const Rational r = length();
    held += held_against_deep(slider_crank_of(r, r + length(), size * random.fraction() / 10), 30);
  }
  CHECK(held > 2000);
}

TEST_CASE("Sweep: linkages of 1e-9 m, and with B0 1e8 m away") {
  CHECK(held_against_deep(crank_rocker(exact_decimal("1e-9")), 200) == 200);
  const Rational far = exact_decimal("1e8");
  CHECK(held_against_deep(four_bar_of(Rational(1, 5), far, Rational(1, 2), far, 0, Side::left), 200) > 190);
}

TEST_CASE("Sweep: numbers that overflow or underflow are handed over, and then enclosed") {
  for (const char* size : {"1e200", "1e-200"}) {
    SweepCount count;
    const DrivenFourBar driven = crank_rocker(exact_decimal(size));
    sweep(driven, 50, count);
    CHECK(count.side_by_side == 0);
    CHECK(held_against_deep(driven, 50) == 50);
    const Rational l = exact_decimal(size);
    CHECK(held_against_deep(slider_crank_of(l / 3, l, l / 50), 51) == 51);
  }
}

TEST_CASE("Sweep: a crank so fast that accelerations overflow") {
  DrivenFourBar driven = crank_rocker();
  driven.omega_2 = exact_decimal("1e100");  // ω⁴ is beyond the doubles, and with it both terms of K, but K is not
  SweepCount count;
  const std::vector<Swept> results = sweep(driven, 50, count);
  CHECK(count.side_by_side == 0);
  for (const Swept& found : results) {
    REQUIRE(found.K == Truth::yes);
    REQUIRE(found.at.K.x.sup() - found.at.K.x.inf() < 1e-14);
    REQUIRE(found.at.K.y.sup() - found.at.K.y.inf() < 1e-14);
  }
  CHECK(held_against_deep(driven, 50) == 50);
}

TEST_CASE("Sweep: a plate that barely closes, and one that does not by as little") {
  DrivenSliderCrank driven = slider_crank_of(Rational(1, 5), Rational(1, 2), Rational(1, 50));
  driven.lengths.AC = driven.lengths.BC = Rational(1, 4) + exact_decimal("1e-30");
  CHECK(held_against_deep(driven, 11) == 11);
  std::vector<Swept> results(11);
  for (const char* gap : {"1e-30", "1e-3"}) {
    driven.lengths.AC = driven.lengths.BC = Rational(1, 4) - exact_decimal(gap);
    CHECK_THROWS_AS(sweep_second_order(driven, results), Impossible);
  }
}

TEST_CASE("Sweep: positions that only another number decides") {
  SweepCount count;
  SECTION("a slider-crank with its crank square to the guide: pole at infinity") {
    const std::vector<Swept> found = sweep(slider_crank_of(Rational(1, 5), Rational(1, 2), Rational(0)), 360, count);
    for (const std::size_t k : {90u, 270u}) {
      CHECK(found[k].P0 == Truth::no);
      CHECK(found[k].motion == Truth::yes);
      CHECK(found[k].K == Truth::yes);
    }
    CHECK(count.bounded >= 2);
    CHECK(count.bounded <= 8);
    CHECK(count.handed_over() == count.bounded);
  }
  SECTION("a slider-crank with equal links: B stands still on A0 while the crank points back") {
    const std::vector<Swept> found = sweep(slider_crank_of(Rational(1, 5), Rational(1, 5), Rational(0)), 97, count);
    for (std::size_t k = 25; k < 73; ++k) {
      REQUIRE(found[k].motion == Truth::yes);
      REQUIRE(is_same(found[k].at.B.x, Bounded(0)));
      REQUIRE(is_same(found[k].at.B.y, Bounded(0)));
    }
  }
  SECTION("a crank that cannot turn fully: where it does not close, and the limit at 60 degrees hit") {
    // AB₀² = 1 + 1 - 2 cos φ <= (1/2 + 1/2)²
    const std::vector<Swept> found =
        sweep(four_bar_of(1, Rational(1, 2), Rational(1, 2), 1, 0, Side::left), 360, count);
    CHECK(found[60].motion == Truth::no);
    CHECK(found[300].motion == Truth::no);
    for (std::size_t k = 61; k < 300; ++k) REQUIRE(found[k].position == Truth::no);
    for (std::size_t k = 1; k < 60; ++k) REQUIRE(found[k].position == Truth::yes);
    CHECK(count.handed_over() <= 12);
  }
  SECTION("a limit position that two at a time prove: it closes nevertheless") {
    const std::vector<Swept> found = sweep(four_bar_of(1, 2, 2, 5, 0, Side::left), 1, count);
    CHECK(found[0].motion == Truth::no);
    CHECK(found[0].position == Truth::yes);
    CHECK(is_same(found[0].at.B.x, Bounded(3)));
  }
  SECTION("a change point at zero degrees") {
    // 1/5 + 7/10 = 1/2 + 2/5
    const std::vector<Swept> found = sweep(
        four_bar_of(Rational(1, 5), Rational(1, 2), Rational(2, 5), Rational(7, 10), 0, Side::left), 100, count);
    CHECK(found[50].motion == Truth::no);
    CHECK(found[49].motion == Truth::yes);
    CHECK(count.open <= 1);
  }
  SECTION("a parallelogram: the coupler is shifted along") {
    const std::vector<Swept> found =
        sweep(four_bar_of(Rational(1, 5), Rational(1, 2), Rational(1, 5), Rational(1, 2), 0, Side::left), 24, count);
    for (const std::size_t k : {4u, 5u, 7u, 8u}) CHECK(found[k].P0 != Truth::yes);
  }
}

TEST_CASE("Sweep: any number of positions and threads gives the same") {
  const DrivenFourBar driven = crank_rocker();
  for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 97u, 1000u}) {
    const std::vector<Swept> once = sweep(driven, n);
    for (const unsigned threads : {0u, 2u, 5u}) {
      SweepCount count;
      const std::vector<Swept> again = sweep(driven, n, count, threads);
      for (std::size_t k = 0; k < n; ++k) {
        const auto a = named(once[k].at, once[k]), b = named(again[k].at, again[k]);
        for (std::size_t i = 0; i < a.size(); ++i) REQUIRE(is_same(a[i].value, b[i].value));
      }
    }
  }
  CHECK(sweep_second_order(driven, {}).handed_over() == 0);
}

TEST_CASE("Sweep: rounding mode and flags of the caller are as before") {
  const DrivenFourBar driven = crank_rocker(exact_decimal("1e200"));
  std::vector<Swept> results(50);
  for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD}) {
    std::fesetround(mode);
    std::feclearexcept(FE_ALL_EXCEPT);
    sweep_second_order(driven, results, 2);
    CHECK(std::fegetround() == mode);
    CHECK(std::fetestexcept(FE_OVERFLOW | FE_INVALID) == 0);
  }
  std::fesetround(FE_TONEAREST);
}

namespace {

std::size_t whole(const Rational& x) { return static_cast<std::size_t>(x.numerator().to_double()); }

DrivenFourBar four_bar_of(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {{given("A0A"), given("AB"), given("B0B"), given("x_B0"), given("y_B0")},
          c.choices.at("branch") == "left" ? Side::left : Side::right,
          given("omega_2"),
          given("alpha_2"),
          given("along"),
          given("across")};
}
DrivenSliderCrank slider_crank_of(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {{given("r"), given("l"), given("AC"), given("BC"), given("e")}, given("omega_2"), given("alpha_2")};
}

// The sweep of n positions, at the position of the case.
Swept swept(const CorpusCase& c, std::size_t n) {
  const std::size_t k = whole(c.givens.at("turn") * Rational(static_cast<int>(n)));
  return c.givens.count("A0A") > 0 ? sweep(four_bar_of(c), n)[k] : sweep(slider_crank_of(c), n)[k];
}

std::string reference(const CorpusCase& c, const std::string& name) {
  const bool is_four_bar = c.givens.count("A0A") > 0;
  if (name == "driven_velocity") return c.reference(is_four_bar ? "omega_4" : "v_B");
  if (name == "driven_acceleration") return c.reference(is_four_bar ? "alpha_4" : "a_B");
  return c.reference(name);
}

// How many numbers the case has; each is held against its digits, and what it says is absent is not found. At a
// multiple of 15° Exact has proved that it is absent.
int held_against(const CorpusCase& c, std::size_t n) {
  const Swept found = swept(c, n);
  const bool is_provable = Rational(24 * c.givens.at("turn")).denominator() == 1;
  const auto is_absent = [&](Truth is_known) { return is_provable ? is_known == Truth::no : is_known != Truth::yes; };
  const bool has_motion = !c.reference("omega_3").empty();
  INFO(c.name << " among " << n);
  if (!has_motion) CHECK(is_absent(found.motion));
  int held = 0;
  for (const auto& [name, value, is_known] : named(found.at, found)) {
    const std::string wanted = reference(c, name);
    INFO(name);
    if (wanted == "absent") CHECK(is_absent(is_known));
    if (wanted.empty() || wanted == "absent" || (!has_motion && is_known != Truth::yes)) continue;
    REQUIRE(is_known == Truth::yes);
    REQUIRE(overlaps(enclosure(value), exact_decimal(wanted)));
    ++held;
  }
  return held;
}

}  // namespace

TEST_CASE("Sweep: whole turns with special positions among their steps, against 120 digits") {
  int held = 0;
  for (const CorpusCase& c : read_corpus(EPURE_HARD_CORPUS "/sweep.txt"))
    for (const std::size_t finer : {1u, 7u, 50u}) held += held_against(c, finer * whole(c.givens.at("positions")));
  CHECK(held >= 4500);
}

TEST_CASE("Sweep: subnormal numbers are kept, whatever the caller has set") {
  const DrivenFourBar driven =
      crank_rocker(exact_decimal("1e-78"));  // the fourth powers of its lengths are subnormal
  SweepCount count;
  const std::vector<Swept> kept = sweep(driven, 50, count);
  CHECK(count.side_by_side == 50);
  CHECK(held_against_deep(driven, 50) == 50);
#ifdef __SSE2__
  const unsigned found = _mm_getcsr();
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  _mm_setcsr(found | flush_to_zero | denormals_are_zero);
  std::vector<Swept> again(50);
  sweep_second_order(driven, again, 2);
  const unsigned afterwards = _mm_getcsr();
  _mm_setcsr(found);
  CHECK((afterwards & flush_to_zero) != 0);
  for (std::size_t k = 0; k < 50; ++k) {
    const auto a = named(kept[k].at, kept[k]), b = named(again[k].at, again[k]);
    for (std::size_t i = 0; i < a.size(); ++i) REQUIRE(is_same(a[i].value, b[i].value));
  }
#endif
}

TEST_CASE("Sweep: the corpora of hard cases, wherever the crank stands at a turn") {
  int held = 0;
  for (const char* corpus : {"/four_bar.txt", "/slider_crank.txt"})
    for (const CorpusCase& c : read_corpus(std::string(EPURE_HARD_CORPUS) + corpus)) {
      const auto turn = c.givens.find("turn");
      if (turn == c.givens.end()) continue;
      held += held_against(c, static_cast<std::size_t>(turn->second.denominator().to_double()));
    }
  CHECK(held >= 400);
}
