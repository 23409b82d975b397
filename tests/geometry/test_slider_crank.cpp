// The slider-crank as it is constructed, route by route, against references that were differentiated numerically from
// positions (tests/corpus): an ordinary crank, dead centres, the pole at infinity, and both missed by 1e-3 to 1e-30.
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/geometry/slider_crank_constructed.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <set>

namespace epure::tests {
namespace {

// The bits that are enough for every case: one centre of curvature lies 1e-88 m off the guide.
constexpr long bits = 512;

enum class Kind { value, absent, undecided };

template <class T>
struct Outcome {
  Kind kind;
  std::optional<T> value = {};
  std::string reason = {};
};

template <class T>
Outcome<T> ask(const std::function<T()>& question) {
  try {
    return {Kind::value, question()};
  } catch (const Impossible& refusal) {
    return {Kind::absent, {}, refusal.what()};
  } catch (const Undecided& open) {
    return {Kind::undecided, {}, open.what()};
  }
}

bool has_prefix(const std::string& name, const std::string& prefix) { return name.rfind(prefix, 0) == 0; }

// Where α₃ vanishes by cancellation, or P₀ falls on B, no ball can tell zero from small; Exact and Calcium do, below.
bool needs_proof(const CorpusCase& c, const std::string& name) {
  return c.givens.at("l") == c.givens.at("r") && c.givens.at("t1") != 0 && has_prefix(name, "stationarity");
}

// Every answer of a route contains its reference, in all 40 digits; what the corpus calls infinite or undefined is
// proved absent. Returns how many were held.
int hold(const CorpusCase& c, const std::string& route, const Constructed<Deep>& answers) {
  int held = 0;
  for (const auto& [name, question] : answers) {
    const std::string reference = c.reference(name);
    if (reference.empty()) continue;
    CAPTURE(c.name, c.why, route, name, reference);
    const Outcome<Deep> found = ask<Deep>(question);
    CAPTURE(found.reason);
    if (found.kind == Kind::undecided && needs_proof(c, name)) continue;
    REQUIRE(found.kind == (is_value(reference) ? Kind::value : Kind::absent));
    ++held;
    if (found.kind != Kind::value) continue;
    CHECK(overlaps(*found.value, exact_decimal(reference)));
    if (reference != "0") CHECK(narrow(*found.value));
  }
  return held;
}

// The coupler's state by the polar diagrams, and by the method of poles.
template <class T>
PlaneMotion<T> by_diagrams(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const auto velocities = velocity_diagram(at, omega_2);
  const auto accelerations = acceleration_diagram(at, omega_2, alpha_2, velocities.omega_3);
  return {at.A, velocities.v_A, accelerations.a_A, velocities.omega_3, accelerations.alpha_3};
}

// Square to the guide: nothing but the position exists.
bool is_stuck(const CorpusCase& c) { return c.reference("omega_3") == "undefined"; }

// P₀ finite and apart from B, which the method of poles needs for the inflection circle.
bool poles_suffice(const CorpusCase& c) {
  return !is_stuck(c) && is_value(c.reference("P0_x")) && c.reference("P0B") != "0";
}

}  // namespace

TEST_CASE("slider-crank: every route contains all 40 digits of every reference", "[slider-crank]") {
  const Arithmetic<Deep> scope(bits);
  std::map<std::string, int> held, cases;
  std::set<std::string> asked;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || is_stuck(c)) continue;  // stuck: see below
    const SliderCrank<Deep> at = constructed_position<Deep>(c);
    const Deep omega_2 = crank_speed<Deep>(c), alpha_2 = from_rational<Deep>(c.givens.at("alpha_2"));
    const auto count = [&](const std::string& route, const Constructed<Deep>& answers) {
      held[route] += hold(c, route, answers);
      ++cases[route];
      for (const auto& [name, question] : answers) asked.insert(name);
    };
    count("position", positions_and_pole(at));
    count("polar diagram of velocity", velocities_by_polar_diagram(at, omega_2));
    count("poles", velocities_by_poles(at, omega_2));
    count("polar diagram of acceleration", accelerations_by_polar_diagram(at, omega_2, alpha_2));
    count("second order by diagrams", second_order(at, by_diagrams(at, omega_2, alpha_2)));
    if (poles_suffice(c)) count("second order by poles", second_order(at, motion_by_poles(at, omega_2, alpha_2)));
  }
  for (const auto& [route, count] : held)
    std::printf("slider-crank, %-30s %5d references in %d cases\n", route.c_str(), count, cases[route]);
  CHECK(cases["position"] >= 48);
  CHECK(cases["poles"] >= 45);
  CHECK(cases["second order by poles"] >= 38);
  CHECK(held["second order by diagrams"] > 1500);
  // Nothing of the corpus is left out but what the crank alone has.
  for (const Reference& r : corpus().front().references)
    if (!has_prefix(r.name, "omega_2") && !has_prefix(r.name, "crank_angle")) CHECK(asked.count(r.name) == 1);
}

TEST_CASE("slider-crank: on intervals every route contains its references or says undecided", "[slider-crank]") {
  const Arithmetic<Bounded> scope;
  int held = 0, undecided = 0;
  const auto hold_intervals = [&](const CorpusCase& c, const auto& find) {
    Constructed<Bounded> answers;
    try {
      answers = find();
    } catch (const Undecided&) {
      CHECK(c.name != "source");
      ++undecided;
      return;
    }
    for (const auto& [name, question] : answers) {
      const std::string reference = c.reference(name);
      if (reference.empty()) continue;
      CAPTURE(c.name, name, reference);
      const Outcome<Bounded> found = ask<Bounded>(question);
      if (found.kind == Kind::undecided) {
        ++undecided;
        CHECK(c.name != "source");
        continue;
      }
      ++held;
      REQUIRE(found.kind == (is_value(reference) ? Kind::value : Kind::absent));
      if (found.kind != Kind::value) continue;
      const Enclosure e = enclosure(*found.value);
      CHECK(overlaps(e, exact_decimal(reference)));
      if (c.name == "source") CHECK(e.upper - e.lower <= 1e-11 * std::max(std::abs(e.value), 1.0));
    }
  };
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || is_stuck(c)) continue;
    const auto at = [&] { return constructed_position<Bounded>(c); };
    const Bounded omega_2 = crank_speed<Bounded>(c), alpha_2 = from_rational<Bounded>(c.givens.at("alpha_2"));
    hold_intervals(c, [&] { return positions_and_pole(at()); });
    hold_intervals(c, [&] { return velocities_by_polar_diagram(at(), omega_2); });
    hold_intervals(c, [&] { return velocities_by_poles(at(), omega_2); });
    hold_intervals(c, [&] { return second_order(at(), by_diagrams(at(), omega_2, alpha_2)); });
    if (poles_suffice(c))
      hold_intervals(c, [&] { return second_order(at(), motion_by_poles(at(), omega_2, alpha_2)); });
  }
  std::printf("slider-crank, Bounded: %d answers contain the reference, %d undecided\n", held, undecided);
  CHECK(held > 3000);
  CHECK(held > 10 * undecided);
}

// The routes meet exactly, not only within balls.
TEST_CASE("slider-crank: on the constructible cranks the routes are proved equal", "[slider-crank]") {
  int proved = 0;
  for (const CorpusCase& c : corpus()) {
    const Rational turn = c.givens.at("n") * c.givens.at("t1") / 60;
    if (!closes(c) || !poles_suffice(c) || (turn * 24).denominator() != 1) continue;
    CAPTURE(c.name);
    const Arithmetic<Exact> tower;
    const SliderCrank<Exact> at = constructed_position<Exact>(c);
    const Exact unit(1), alpha_2 = from_rational<Exact>(c.givens.at("alpha_2"));
    const PlaneMotion<Exact> m = by_diagrams(at, unit, alpha_2), poles = motion_by_poles(at, unit, alpha_2);
    const RotationAboutPole<Exact> rotation(at.pole(), at.A, m.v_A);
    CHECK(is(poles.omega, m.omega));
    CHECK(is(poles.alpha, m.alpha));
    CHECK(is(rotation.omega(), m.omega));
    CHECK(is(rotation.velocity(at.C), m.velocity(at.C)));
    CHECK(is(finite(m.pole()), finite(at.pole())));
    CHECK(is(m.velocity(at.B).y, Exact(0)));
    CHECK(is(m.acceleration(at.B).y, Exact(0)));
    // B runs straight, A on a circle about A₀.
    CHECK(is(m.inflection_circle().power(at.B), Exact(0)));
    CHECK(is(finite(m.centre_of_curvature(at.A)), at.A0));
    CHECK(is(finite(inflection_pole_by_poles(at)), finite(m.inflection_pole())));
    ++proved;
  }
  CHECK(proved >= 12);
}

TEST_CASE("slider-crank: the inflection pole lies on the guide without a proof", "[slider-crank]") {
  const Arithmetic<Bounded> scope;
  for (const CorpusCase& c : corpus()) {
    if (c.name != "source" && c.name != "crank_20_degrees" && c.name != "crank_seventh") continue;
    const ProjectivePoint<Bounded> J = inflection_pole_by_poles(constructed_position<Bounded>(c));
    CAPTURE(c.name);
    CHECK(sign(J.y) == Sign::zero);
    CHECK(overlaps(enclosure(finite(J).x), exact_decimal(c.reference("inflection_pole_x"))));
  }
}

TEST_CASE("slider-crank: what balls leave open is proved", "[slider-crank]") {
  int proved = 0;
  for (const CorpusCase& c : corpus()) {
    if (c.name != "equal_lengths" && c.name != "equal_lengths_locked") continue;
    CAPTURE(c.name);
    const Arithmetic<Calcium> scope;
    const SliderCrank<Calcium> at = constructed_position<Calcium>(c);
    const PlaneMotion<Calcium> m = by_diagrams(at, Calcium(1), Calcium(0));
    // Coupler and crank turn against each other, or are locked together with B on A₀.
    const bool locked = c.name == "equal_lengths_locked";
    CHECK(is(m.omega, Calcium(locked ? 1 : -1)));
    CHECK(is(m.alpha, Calcium(0)));
    CHECK(sign(m.stationarity_circle().k) == Sign::zero);
    if (locked) CHECK(is(finite(at.pole()), at.B));
    ++proved;
  }
  CHECK(proved == 2);
}

TEST_CASE("slider-crank: a linkage that does not close is refused, and one at its limit", "[slider-crank]") {
  int open = 0, stuck = 0;
  for (const CorpusCase& c : corpus()) {
    CAPTURE(c.name);
    const Arithmetic<Deep> scope(256);
    if (!closes(c)) {
      ++open;
      CHECK_THROWS_AS(constructed_position<Deep>(c), Impossible);
    } else if (is_stuck(c) && c.name != "equal_lengths_touch") {
      ++stuck;
      const Arithmetic<Exact> tower;
      const SliderCrank<Exact> at = constructed_position<Exact>(c);
      CHECK(is(at.A.x, at.B.x));
      CHECK_THROWS_AS(velocity_diagram(at, Exact(1)), Impossible);
    }
  }
  CHECK(open >= 4);
  CHECK(stuck == 2);
}

TEST_CASE("slider-crank: a plate is on the left of AB, flat, or not to be built", "[slider-crank]") {
  const Arithmetic<Exact> tower;
  const Point<Exact> A{0, 0}, B{number<Exact>(1, 2), 0};
  // 3-4-5: AC ⊥ BC, height 12/50 over AB, foot 9/50 from A.
  const SliderCrankLengths right_angled{{1, 5}, {1, 2}, {3, 10}, {2, 5}};
  CHECK(is(plate_corner(A, B, right_angled), {number<Exact>(9, 50), number<Exact>(12, 50)}));
  CHECK(is(plate_corner(A, B, {{1, 5}, {1, 2}, {1, 5}, {3, 10}}), {number<Exact>(1, 5), 0}));
  const SliderCrankLengths short_sides{{1, 5}, {1, 2}, {1, 5}, {1, 4}};
  CHECK_THROWS_AS(plate_corner(A, B, short_sides), Impossible);
}

}  // namespace epure::tests
