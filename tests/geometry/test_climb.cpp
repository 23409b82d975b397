// Which number answers, and what it may say.
#include "geometry/numbers/climb.h"
#include "tests/support/catch.h"

#include <cmath>
#include <limits>

using namespace epure::geometry;
using Kind = Settled::Kind;

namespace {

// A scene of one quantity: []<class T>() -> T.
template <class Quantity>
auto one(const Quantity& quantity) {
  return [quantity]<class T>() -> std::vector<Reading<T>> {
    return {Reading<T>::from([&] { return quantity.template operator()<T>(); })};
  };
}

template <class Quantity>
Settled climb_one(const Quantity& quantity) {
  const auto settled = climb(one(quantity));
  REQUIRE(settled.size() == 1);
  return settled.front();
}

template <class T>
constexpr bool is_exact = std::is_same_v<T, Exact> || std::is_same_v<T, Generic> || std::is_same_v<T, Calcium>;

void require_point(const Settled& settled, double value, const std::string& rung) {
  CHECK(settled.kind == Kind::certain);
  CHECK(settled.enclosure.lower == value);
  CHECK(settled.enclosure.value == value);
  CHECK(settled.enclosure.upper == value);
  CHECK_FALSE(std::signbit(settled.enclosure.lower));
  CHECK(settled.rung == rung);
  CHECK(settled.reason.english.empty());
}

// Certain, at most 2 ulp wide, and not a point.
void require_tight(const Settled& settled, double value, const std::string& rung) {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(settled.kind == Kind::certain);
  CHECK(settled.enclosure.value == value);
  CHECK(settled.enclosure.lower >= std::nextafter(value, -infinity));
  CHECK(settled.enclosure.upper <= std::nextafter(value, infinity));
  CHECK(settled.enclosure.lower <= value);
  CHECK(settled.enclosure.upper >= value);
  CHECK(settled.rung == rung);
}

}  // namespace

TEST_CASE("A point interval is settled by Bounded") {
  require_point(climb_one([]<class T>() { return T(3) * T(4) - T(5); }), 7, "Bounded");
  require_point(climb_one([]<class T>() { return root(T(16)); }), 4, "Bounded");
  require_point(climb_one([]<class T>() { return T(0); }), 0, "Bounded");
}

TEST_CASE("An irrational number is certain with 128 bits") {
  // mpmath, 50 digits: sqrt(2) = 1.4142135623730950488016887242096980785696718753769
  require_tight(climb_one([]<class T>() { return root(T(2)); }), 1.4142135623730950488, "Deep 128");
  // mpmath: cos(2*pi/7) = 0.62348980185873353052500488400423981063227473089641
  require_tight(climb_one([]<class T>() { return cosine<T>(Turn{Rational(1, 7)}); }), 0.62348980185873353053,
                "Deep 128");
  require_tight(climb_one([]<class T>() { return from_rational<T>(Rational(1, 3)); }), 1.0 / 3.0, "Deep 128");
}

TEST_CASE("Cancellation calls for the precision it needs, and no exact number") {
  // sqrt(1 + 2^-k) - 1 = 2^-(k+1) - 2^-(2k+3) + ...: with k = 300 the terms after the first are far below half an
  // ulp.
  const auto small = []<class T>(int k) {
    T step(1);
    for (int i = 0; i < k; ++i) step = step * from_rational<T>(Rational(1, 2));
    return T(root(1 + step) - 1);
  };
  const auto at = [&](int k) {
    return climb_one([&small, k]<class T>() { return small.template operator()<T>(k); });
  };
  // The root must be right to 2^-(k+1) times half an ulp of a double: k + 55 bits and a few for rounding.
  require_tight(at(60), std::ldexp(1.0, -61), "Deep 128");
  require_tight(at(100), std::ldexp(1.0, -101), "Deep 256");
  require_tight(at(300), std::ldexp(1.0, -301), "Deep 512");
  require_tight(at(600), std::ldexp(1.0, -601), "Deep 1024");
}

TEST_CASE("Zero is proved by Exact, in every enclosure a point") {
  // sqrt(3 + 2 sqrt 2) - 1 - sqrt 2
  const auto denested = []<class T>() { return T(root(T(3 + 2 * root(T(2)))) - 1 - root(T(2))); };
  require_point(climb_one(denested), 0, "Exact");
}

TEST_CASE("Zero for every direction is proved by Generic when the scene leaves the tower") {
  const auto with_pi = []<class T>() { return T(square(pi<T>() + 1) - square(pi<T>()) - 2 * pi<T>() - 1); };
  require_point(climb_one(with_pi), 0, "Generic");
  const auto unit = []<class T>() {
    return T(square(cosine<T>(Turn{Rational(23, 360)})) + square(sine<T>(Turn{Rational(23, 360)})) - 1);
  };
  require_point(climb_one(unit), 0, "Generic");
}

TEST_CASE("What Generic knows not to be zero is not asked of Calcium") {
  int calcium_runs = 0;
  const auto tiny = [&]<class T>() {
    if constexpr (std::is_same_v<T, Calcium>) ++calcium_runs;
    T step(1);
    for (int i = 0; i < 700; ++i) step = step * from_rational<T>(Rational(1, 2));
    const T c = cosine<T>(Turn{Rational(1, 18)}), s = sine<T>(Turn{Rational(1, 18)});
    return T(c * c + s * s - 1 + step);
  };
  require_tight(climb_one(tiny), std::ldexp(1.0, -700), "Deep 1024");
  CHECK(calcium_runs == 0);
}

TEST_CASE("Zero at one direction only is proved by Calcium, of a direction of low degree") {
  // 4c³ - 3c = cos 60° for c = cos 20°
  const auto triple_angle = []<class T>() {
    const T c = cosine<T>(Turn{Rational(1, 18)});
    return T(4 * c * c * c - 3 * c - from_rational<T>(Rational(1, 2)));
  };
  require_point(climb_one(triple_angle), 0, "Calcium");
  // The same of 1/19 of that: Calcium could, at the cost of minutes in a longer scene.
  const auto by_steps = []<class T>() {
    const T c = cosine<T>(Turn{Rational(1, 342)}), third = T(4 * c * c * c - 3 * c);
    return T(third - cosine<T>(Turn{Rational(1, 114)}) + cosine<T>(Turn{Rational(1, 6)}) -
             from_rational<T>(Rational(1, 2)));
  };
  require_point(climb_one(by_steps), 0, "Generic");
  const auto of_degree_28 = []<class T>() {  // the cosines of all 29ths of a turn add up to nothing
    T sum(0);
    for (int k = 0; k < 29; ++k) sum += cosine<T>(Turn{Rational(k, 29)});
    return sum;
  };
  const Settled open = climb_one(of_degree_28);
  CHECK(open.enclosure.lower < 0);  // near zero, but not proved to be it
  CHECK(open.enclosure.upper > 0);
}

TEST_CASE("Of an exact run only zeros and absences are used, never a value or a sign") {
  // Exact runs here at another scale and even another sign: only that it is not zero may count.
  const auto scaled = []<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) return {Reading<T>::of(T(-7)), Reading<T>::of(T(0))};
    const T zero = root(T(2)) * root(T(2)) - 2;
    const T tiny = root(T(1 + from_rational<T>(Rational(1, 1000000000)))) - 1;
    return {Reading<T>::of(tiny), Reading<T>::of(zero)};
  };
  const auto settled = climb(scaled);
  REQUIRE(settled.size() == 2);
  // mpmath: sqrt(1 + 1e-9) - 1 = 4.9999999987500000006249999996093750002734374997949e-10
  require_tight(settled[0], 4.9999999987500000006e-10, "Deep 128");
  require_point(settled[1], 0, "Exact");
}

TEST_CASE("An exact proof is not asked for when nothing may be zero") {
  int exact_runs = 0;
  const auto scene = [&]<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) ++exact_runs;
    return {Reading<T>::of(root(T(2)))};
  };
  climb(scene);
  CHECK(exact_runs == 0);

  // Almost half way between two doubles: open after 256 bits, but not because it may be zero.
  const auto nearly_a_tie = [&]<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) ++exact_runs;
    const T half_an_ulp = from_rational<T>(Rational(std::ldexp(1.0, -53)));
    const T more = from_rational<T>(Rational(std::ldexp(1.0, -300)));
    return {Reading<T>::of(1 + half_an_ulp + more * root(T(2)))};
  };
  const auto settled = climb(nearly_a_tie);
  REQUIRE(settled.size() == 1);
  require_tight(settled[0], std::nextafter(1.0, 2.0), "Deep 512");
  CHECK(exact_runs == 0);
}

TEST_CASE("The exact run happens once, and after 512 bits") {
  std::vector<std::string> order;
  const auto scene = [&]<class T>() -> std::vector<Reading<T>> {
    if constexpr (std::is_same_v<T, Exact>) order.push_back("Exact");
    if constexpr (std::is_same_v<T, Calcium>) order.push_back("Calcium");
    if constexpr (std::is_same_v<T, Bounded>) order.push_back("Bounded");
    if constexpr (std::is_same_v<T, Deep>) order.push_back(std::to_string(Arithmetic<Deep>::bits()));
    return {Reading<T>::undecided({"never", "never"})};
  };
  const auto settled = climb(scene);
  CHECK(order == std::vector<std::string>{"Bounded", "128", "256", "512", "Exact", "1024", "2048", "4096"});
  REQUIRE(settled.size() == 1);
  CHECK(settled[0].kind == Kind::undecided);
  CHECK(settled[0].reason.english ==
        "never (tried: intervals of doubles, exact square roots, balls of up to 4096 bits)");
}

// Two routes to zero: once with a cancellation that only an exact number can prove.
TEST_CASE("An exact run is spared when nothing is worth a proof") {
  int exact_runs = 0;
  const auto scene = [&]<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) ++exact_runs;
    const T x = root(T(2));
    return {Reading<T>::of(T(0)), Reading<T>::of(x * x - T(2))};
  };
  const auto is_open = [](std::size_t, const std::vector<Settled>& so_far) {
    REQUIRE(so_far.size() == 2);
    return so_far[0].kind != Kind::certain;
  };
  const auto spared = climb(scene, is_open);
  CHECK(exact_runs == 0);
  CHECK(spared[0].kind == Kind::certain);
  CHECK(spared[1].enclosure.lower < 0);  // not proved zero, only small
  CHECK(spared[1].enclosure.upper > 0);
  require_point(climb(scene)[1], 0, "Exact");
  CHECK(exact_runs == 1);
}

TEST_CASE("An exact run is told what is wanted of it") {
  std::vector<bool> wanted;
  const auto scene = [&]<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) wanted = {climbing::Wanted::is(0), climbing::Wanted::is(1)};
    const T x = root(T(2));
    return {Reading<T>::of(x), Reading<T>::of(x * x - T(2))};
  };
  require_point(climb(scene)[1], 0, "Exact");
  CHECK(wanted == std::vector<bool>{false, true});
  CHECK(climbing::Wanted::is(0));
}

TEST_CASE("What is proved absent is absent, with its reason, on the rung that proved it") {
  const auto parallel = [](auto slope) {
    return [slope]<class T>() {
      const T m = slope.template operator()<T>();
      switch (sign(m)) {
        case Sign::zero:
          throw Impossible("the lines are parallel");
        case Sign::undecided:
          throw Undecided("whether the lines are parallel");
        default:
          return quotient(1, m);
      }
    };
  };
  const Settled by_bounded = climb_one(parallel([]<class T>() { return T(0); }));
  CHECK(by_bounded.kind == Kind::absent);
  CHECK(by_bounded.reason.english == "the lines are parallel");
  CHECK(by_bounded.rung == "Bounded");

  const Settled by_exact = climb_one(parallel([]<class T>() { return T(root(T(2)) * root(T(2)) - 2); }));
  CHECK(by_exact.kind == Kind::absent);
  CHECK(by_exact.reason.english == "the lines are parallel");
  CHECK(by_exact.rung == "Exact");
}

TEST_CASE("A run that throws Undecided as a whole leaves the question to the next rung") {
  const auto scene = []<class T>() -> std::vector<Reading<T>> {
    const T zero = root(T(3)) * root(T(3)) - 3;
    if (sign(zero) == Sign::undecided) throw Undecided("which branch");
    return {Reading<T>::of(zero), Reading<T>::of(T(5))};
  };
  const auto settled = climb(scene);
  REQUIRE(settled.size() == 2);
  require_point(settled[0], 0, "Exact");
  // Only Exact could run the scene, and its values are never used.
  CHECK(settled[1].kind == Kind::undecided);
  CHECK(settled[1].reason.english ==
        "which branch (tried: intervals of doubles, exact square roots, balls of up to 4096 bits)");
}

TEST_CASE("A scene that no number can run throws Undecided") {
  const auto scene = []<class T>() -> std::vector<Reading<T>> { throw Undecided("whether it closes"); };
  CHECK_THROWS_AS(climb(scene), Undecided);
  CHECK_THROWS_WITH(climb(scene), "whether it closes");
}

TEST_CASE("Impossible goes through the climb") {
  const auto scene = []<class T>() -> std::vector<Reading<T>> { throw Impossible("the linkage does not close"); };
  CHECK_THROWS_AS(climb(scene), Impossible);
}

TEST_CASE("What stays open is enclosed, with a reason") {
  // 1 + 2^-53 + (an exact-looking zero that no number proves): half way between two doubles for ever.
  const auto scene = []<class T>() -> std::vector<Reading<T>> {
    if constexpr (is_exact<T>) return {Reading<T>::undecided({"not asked", "not asked"})};
    const T noise = root(T(2)) * root(T(2)) - 2;
    return {Reading<T>::of(1 + from_rational<T>(Rational(std::ldexp(1.0, -53))) + noise)};
  };
  const auto settled = climb(scene);
  REQUIRE(settled.size() == 1);
  CHECK(settled[0].kind == Kind::enclosed);
  CHECK(settled[0].enclosure.lower == 1.0);
  CHECK(settled[0].enclosure.upper == std::nextafter(1.0, 2.0));
  CHECK_FALSE(settled[0].reason.english.empty());
}

TEST_CASE("Rungs that enclose a quantity differently together enclose what they share") {
  const auto scene = []<class T>() -> std::vector<Reading<T>> {
    if constexpr (std::is_same_v<T, Bounded>) return {Reading<T>::of(Bounded(1, 3))};
    if constexpr (std::is_same_v<T, Deep>) return {Reading<T>::of(Deep::from_bounded(Bounded(2, 4)))};
    return {Reading<T>::undecided({"not asked", "not asked"})};
  };
  const auto settled = climb(scene);
  REQUIRE(settled.size() == 1);
  CHECK(settled[0].kind == Kind::enclosed);
  CHECK(settled[0].enclosure.lower == Approx(2));
  CHECK(settled[0].enclosure.upper == 3);
  CHECK(settled[0].rung == "Deep 128");
}

TEST_CASE("A quantity beyond the doubles is neither infinite nor certain") {
  const auto huge = []<class T>() -> std::vector<Reading<T>> {
    T x = from_rational<T>(Rational(10));
    for (int i = 0; i < 9; ++i) x = x * x;  // 10^512
    return {Reading<T>::of(x)};
  };
  const auto settled = climb(huge);
  REQUIRE(settled.size() == 1);
  CHECK(settled[0].kind == Kind::undecided);
}

TEST_CASE("One rung alone") {
  const auto scene = []<class T>() -> std::vector<Reading<T>> {
    return {Reading<T>::of(root(T(2))), Reading<T>::of(T(2)), Reading<T>::absent({"at infinity", "at infinity"}),
            Reading<T>::from([] { return quotient(T(1), T(root(T(2)) * root(T(2)) - 2)); })};
  };
  const auto fast = only_fast(scene);
  REQUIRE(fast.size() == 4);
  CHECK(fast[0].kind == Kind::unbounded);
  CHECK(fast[0].enclosure.value == std::sqrt(2.0));
  CHECK(fast[0].enclosure.lower == -std::numeric_limits<double>::infinity());
  CHECK(fast[0].rung == "Fast");
  CHECK(fast[1].kind == Kind::unbounded);  // a double proves nothing, even when it happens to be right
  CHECK(fast[2].kind == Kind::absent);

  const auto bounded = only_bounded(scene);
  REQUIRE(bounded.size() == 4);
  CHECK(bounded[0].kind == Kind::enclosed);
  CHECK(bounded[0].enclosure.lower < bounded[0].enclosure.upper);
  require_point(bounded[1], 2, "Bounded");
  CHECK(bounded[2].kind == Kind::absent);
  CHECK(bounded[3].kind == Kind::undecided);
}

TEST_CASE("Decisions: which rung answers") {
  const auto answer = [](Sign sign, const std::string& rung, const Decision& decision) {
    CHECK(decision.sign == sign);
    CHECK(decision.rung == rung);
  };
  answer(Sign::positive, "Bounded", decide([]<class T>() { return T(root(T(2)) - 1); }));
  // A convergent of sqrt 2: |665857/470832 - sqrt 2| = 1.6e-12 is in reach of doubles ...
  answer(Sign::positive, "Bounded",
         decide([]<class T>() { return T(from_rational<T>(Rational(665857, 470832)) - root(T(2))); }));
  // ... the square of that fraction's step, 9e-25, is not.
  answer(Sign::positive, "Deep 128",
         decide([]<class T>() { return T(from_rational<T>(Rational(886731088897, 627013566048)) - root(T(2))); }));
  answer(Sign::zero, "Exact", decide([]<class T>() { return T(root(T(12)) - 2 * root(T(3))); }));
  answer(Sign::zero, "Calcium", decide([]<class T>() {
           const T c = cosine<T>(Turn{Rational(1, 5)});
           return T(4 * c * c + 2 * c - 1);
         }));
  const Decision never = decide([]<class T>() -> T { throw Undecided("too close"); });
  CHECK(never.sign == Sign::undecided);
  CHECK(never.rung.empty());
  CHECK(never.reason.english == "too close");
}

TEST_CASE("Questions of several signs") {
  // Is (√3, 1)/2 on the unit circle and above the x axis?
  const Answer on = ask([]<class T>() {
    const T x = cosine<T>(Turn{Rational(1, 12)});
    const T y = sine<T>(Turn{Rational(1, 12)});
    const Sign off = sign(T(x * x + y * y - 1));
    const Sign above = sign(y);
    if (off == Sign::undecided || above == Sign::undecided) return Truth::undecided;
    return off == Sign::zero && above == Sign::positive ? Truth::yes : Truth::no;
  });
  CHECK(on.truth == Truth::yes);
  CHECK(on.rung == "Exact");
}

TEST_CASE("What is larger than any double is undecided, with that reason") {
  const auto power = []<class T>(int n) {
    T x(1);
    for (int i = 0; i < n; ++i) x = x * T(3);
    return x;
  };
  const Settled large = climb_one([&]<class T>() { return power.template operator()<T>(1000); });
  CHECK(large.kind == Kind::undecided);
  CHECK(large.reason.english.find("it may be larger than any double") == 0);
  CHECK(large.reason.italian.find("può superare ogni double") == 0);
  CHECK(only_deep(one([&]<class T>() { return power.template operator()<T>(1000); }), 128).front().kind ==
        Kind::undecided);
  const Settled small = climb_one([&]<class T>() { return quotient(T(1), power.template operator()<T>(1000)); });
  CHECK(small.kind != Kind::undecided);
  CHECK(small.enclosure.upper > 0);
  CHECK(climb_one([&]<class T>() { return power.template operator()<T>(600); }).kind == Kind::certain);
}
