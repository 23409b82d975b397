// The slider-crank as it is constructed, route by route, against references that were differentiated numerically from
// positions (tests/corpus): an ordinary crank, dead centres, the pole at infinity, and both missed by 1e-3 to 1e-30;
// guides that pass A₀ at a distance, and guides of any direction.
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/geometry/slider_crank_constructed.h"
#include "tests/support/catch.h"

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

bool is_special(const CorpusCase& c) { return c.reference("P0_x") == "infinite" || c.reference("P0B") == "0"; }

// Where α₃ vanishes by cancellation no ball can tell zero from small; nor whether a crank is along an inclined guide
// or square to it. Exact and Calcium do, below.
bool needs_proof(const CorpusCase& c, const std::string& name) {
  if (c.givens.at("delta") != 0 && is_special(c)) return true;
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

// Square to the guide: nothing but the position exists.
bool is_stuck(const CorpusCase& c) { return c.reference("omega_3") == "undefined"; }

// The method of poles needs one that is finite.
bool poles_suffice(const CorpusCase& c) { return !is_stuck(c) && is_value(c.reference("P0_x")); }

Rational crank_turn(const CorpusCase& c) { return c.givens.at("n") * c.givens.at("t1") / 60; }

// Crank and guide at multiples of 15°, which the tower of fields holds.
bool is_constructible(const CorpusCase& c) {
  return (crank_turn(c) * 24).denominator() == 1 && (c.givens.at("delta") / 15).denominator() == 1;
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
    const SliderCrankMotion<Deep> motion = slider_crank_motion(at, omega_2, alpha_2);
    count("polar diagram of velocity", velocities_by_polar_diagram(at, motion));
    count("poles", velocities_by_poles(at, omega_2));
    count("polar diagram of acceleration", accelerations_by_polar_diagram(at, motion));
    count("second order by diagrams", second_order(at, motion.coupler));
    if (poles_suffice(c)) count("second order by poles", second_order(at, motion_by_poles(at, omega_2, alpha_2)));
  }
  for (const auto& [route, count] : held)
    std::printf("slider-crank, %-30s %5d references in %d cases\n", route.c_str(), count, cases[route]);
  CHECK(cases["position"] >= 88);
  CHECK(cases["poles"] >= 88);
  CHECK(cases["second order by poles"] >= 76);
  CHECK(held["second order by diagrams"] > 3600);
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
    const auto motion = [&] { return slider_crank_motion(at(), omega_2, alpha_2); };
    hold_intervals(c, [&] { return velocities_by_polar_diagram(at(), motion()); });
    hold_intervals(c, [&] { return velocities_by_poles(at(), omega_2); });
    hold_intervals(c, [&] { return second_order(at(), motion().coupler); });
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
    if (!closes(c) || !poles_suffice(c) || !is_constructible(c)) continue;
    CAPTURE(c.name);
    const Arithmetic<Exact> tower;
    const SliderCrank<Exact> at = constructed_position<Exact>(c);
    const Exact unit(1), alpha_2 = from_rational<Exact>(c.givens.at("alpha_2"));
    const PlaneMotion<Exact> m = slider_crank_motion(at, unit, alpha_2).coupler;
    const PlaneMotion<Exact> poles = motion_by_poles(at, unit, alpha_2);
    const RotationAboutPole<Exact> rotation(at.pole(), at.A, m.v_A);
    CHECK(is(poles.omega, m.omega));
    CHECK(is(poles.alpha, m.alpha));
    CHECK(is(rotation.omega(), m.omega));
    CHECK(is(rotation.velocity(at.C), m.velocity(at.C)));
    CHECK(is(finite(m.pole()), finite(at.pole())));
    CHECK(is_on(at.B, at.guide));
    CHECK(is(cross(m.velocity(at.B), at.guide.direction()), Exact(0)));
    CHECK(is(cross(m.acceleration(at.B), at.guide.direction()), Exact(0)));
    // B runs straight, A on a circle about A₀.
    CHECK(is(m.inflection_circle().power(at.B), Exact(0)));
    CHECK(is(finite(m.centre_of_curvature(at.A)), at.A0));
    const Point<Exact> J = finite(inflection_pole_by_poles(at, finite(at.pole())));
    CHECK(is(J, finite(m.inflection_pole())));
    CHECK(is_on(J, at.guide));
    ++proved;
  }
  CHECK(proved >= 26);
}

TEST_CASE("slider-crank: special positions of a constructible crank are proved", "[slider-crank]") {
  int dead = 0, infinite = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || is_stuck(c) || !is_constructible(c)) continue;
    CAPTURE(c.name);
    const Arithmetic<Exact> tower;
    const SliderCrank<Exact> at = constructed_position<Exact>(c);
    const ProjectivePoint<Exact> P0 = at.pole();
    const bool is_far = c.reference("P0_x") == "infinite", is_dead = c.reference("P0B") == "0";
    CHECK((sign(P0.w) == Sign::zero) == is_far);
    CHECK((sign(cross(at.A - at.A0, at.B - at.A0)) == Sign::zero) == is_dead);
    if (is_dead) CHECK(is(finite(P0), at.B));
    if (is_dead) CHECK(is(slider_crank_motion(at, Exact(1), Exact(0)).v_B(), {0, 0}));
    dead += is_dead;
    infinite += is_far;
  }
  CHECK(dead >= 10);
  CHECK(infinite >= 5);
}

// The whole mechanism on a sheet that is turned, for multiples of 15°, or laid face down.
TEST_CASE("slider-crank: turned and mirrored", "[slider-crank]") {
  const int e = GENERATE(-10, 0, 8), crank = GENERATE(1, 5, 14), guide = GENERATE(2, 13, 21);
  CAPTURE(e, crank, guide);
  const Arithmetic<Exact> tower;
  const auto direction = [](int of_24) {
    const Turn turn{Rational(of_24, 24)};
    return Vector<Exact>{cosine<Exact>(turn), sine<Exact>(turn)};
  };
  const SliderCrankLengths lengths{{1, 5}, {1, 2}, {3, 10}, {2, 5}, {e, 100}};
  const SliderCrank<Exact> level = slider_crank(lengths, direction(crank));
  const SliderCrank<Exact> turned = slider_crank(lengths, direction(crank + guide), direction(guide));
  const Vector<Exact> u = direction(guide);
  const auto on_turned = [&](const Vector<Exact>& v) { return v.x * u + v.y * quarter_turn(u); };
  for (const auto& [P, Q] :
       {std::pair{level.A, turned.A}, {level.B, turned.B}, {level.C, turned.C}, {level.M, turned.M}})
    CHECK(is(on_turned(P - level.A0), Q - turned.A0));
  const auto here = slider_crank_motion(level, Exact(1), Exact(2)),
             there = slider_crank_motion(turned, Exact(1), Exact(2));
  CHECK(is(here.coupler.omega, there.coupler.omega));
  CHECK(is(here.coupler.alpha, there.coupler.alpha));
  CHECK(is(on_turned(here.v_B()), there.v_B()));
  CHECK(is(on_turned(here.a_B()), there.a_B()));

  const SliderCrankLengths below{{1, 5}, {1, 2}, {3, 10}, {2, 5}, {-e, 100}};
  const SliderCrank<Exact> mirrored = slider_crank(below, direction(-crank));
  CHECK(is(mirrored.B, {level.B.x, -level.B.y}));
  CHECK(is(slider_crank_motion(mirrored, Exact(-1), Exact(-2)).a_B(), {here.a_B().x, -here.a_B().y}));
}

// r = 2, l = 5: on integers the limits can be read off.
TEST_CASE("slider-crank: how far the crank turns", "[slider-crank]") {
  const auto range = [](int r, int l, const Rational& e) { return crank_range({r, l, 1, l, e}); };
  CHECK(range(2, 5, 0).is_full_turn());
  CHECK(range(2, 5, 3).is_full_turn());
  CHECK(range(2, 5, -3).is_full_turn());
  CHECK(range(3, 3, 0).is_full_turn());
  const Rational little = exact_decimal("1e-30");
  CHECK(range(2, 5, 3 - little).is_full_turn());
  const CrankRange one = range(2, 5, 3 + little);  // A cannot pass below A₀
  CHECK(!one.is_full_turn());
  CHECK(one.lowest == Rational(-1 + little / 2));
  CHECK(!one.highest);
  CHECK(range(2, 5, -4).highest == Rational(1, 2));
  CHECK(!range(2, 5, -4).lowest);
  const CrankRange both = range(5, 2, 1);
  CHECK(both.lowest == Rational(-1, 5));
  CHECK(both.highest == Rational(3, 5));
  CHECK(!range(2, 5, 7).is_empty);  // at one angle
  CHECK(range(2, 5, 7 + little).is_empty);
  CHECK(range(2, 5, -7 - little).is_empty);
  CHECK(!range(2, 5, 7 + little).is_full_turn());

  const auto turns = [](int r, int l, const Rational& e) { return coupler_turns_fully({r, l, 1, l, e}); };
  CHECK(turns(5, 2, 3));
  CHECK(turns(5, 2, -3));
  CHECK(turns(3, 3, 0));
  CHECK(!turns(5, 2, 3 + little));
  CHECK(!turns(5, 2, -3 - little));
  CHECK(!turns(2, 5, 0));
}

TEST_CASE("slider-crank: at the ends of its range the crank brings the coupler square to the guide",
          "[slider-crank]") {
  const SliderCrankLengths lengths{5, 2, 1, 2, 1};
  const Rational limit = GENERATE(Rational(-1, 5), Rational(3, 5)), little = exact_decimal("1e-20");
  const Rational outwards = limit < 0 ? Rational(-little) : little;
  const int side = GENERATE(-1, 1);
  const Arithmetic<Exact> tower;
  const CrankRange range = crank_range(lengths);
  CHECK((limit < 0 ? range.lowest : range.highest) == limit);
  const auto at = [&](const Rational& sine) {
    const Exact cosine = root(from_rational<Exact>(1 - sine * sine));
    return slider_crank(lengths, Vector<Exact>{Exact(side) * cosine, from_rational<Exact>(sine)});
  };
  CHECK(is(at(limit).B.x, at(limit).A.x));
  CHECK_THROWS_AS(slider_crank_motion(at(limit), Exact(1), Exact(0)), Impossible);
  CHECK_THROWS_AS(at(limit + outwards), Impossible);
  CHECK_NOTHROW(slider_crank_motion(at(limit - outwards), Exact(1), Exact(0)));
}

TEST_CASE("slider-crank: the inflection pole lies on the guide without a proof", "[slider-crank]") {
  const Arithmetic<Bounded> scope;
  for (const CorpusCase& c : corpus()) {
    if (c.name != "source" && c.name != "crank_20_degrees" && c.name != "crank_seventh") continue;
    const SliderCrank<Bounded> at = constructed_position<Bounded>(c);
    const ProjectivePoint<Bounded> J = inflection_pole_by_poles(at, finite(at.pole()));
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
    const PlaneMotion<Calcium> m = slider_crank_motion(at, Calcium(1), Calcium(0)).coupler;
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
      CHECK(is(dot(at.B - at.A, at.guide.direction()), Exact(0)));
      CHECK_THROWS_AS(slider_crank_motion(at, Exact(1), Exact(0)), Impossible);
    }
  }
  CHECK(open >= 7);
  CHECK(stuck == 4);
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
