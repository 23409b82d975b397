// The dyads RRP, PRP and RPR on moving bodies against references differentiated numerically from positions
// (tests/corpus/dyads.txt): rates, velocity and acceleration of the joint, with every Coriolis term there is.
#include "geometry/mechanisms/dyad.h"
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

#include <cstdio>

namespace epure::tests {
namespace {

const std::vector<CorpusCase>& dyads() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/dyads.txt");
  return cases;
}

// A body of the corpus: turning about a fixed pivot, with a point and a guide.
template <class T>
struct Body {
  Vector<T> direction;
  PlaneMotion<T> motion;
  Pin<T> pin;
  Line<T> guide;
};
template <class T>
Body<T> body(const CorpusCase& c, const std::string& which) {
  const auto given = [&](const std::string& name) { return c.givens.at(which + "." + name); };
  const auto value = [&](const std::string& name) { return from_rational<T>(given(name)); };
  const Point<T> pivot{value("x"), value("y")};
  const Vector<T> s{cosine<T>(Turn{given("turn")}), sine<T>(Turn{given("turn")})};
  const PlaneMotion<T> motion = turning_about(pivot, value("omega"), value("alpha"));
  return {s, motion, pin_on(motion, pivot + value("arm") * s), line(pivot + value("offset") * quarter_turn(s), s)};
}

template <class T>
struct Solved {
  Point<T> X;
  DyadVelocity<T> velocity;
  DyadAcceleration<T> acceleration;
  std::optional<Vector<T>> slot = {};
};

template <class T, class First, class Second>
Solved<T> solve(const First& first, const Second& second, const Point<T>& X) {
  const DyadVelocity<T> v = dyad_velocity(first, second, X);
  return {X, v, dyad_acceleration(first, second, X, v)};
}

template <class T>
Solved<T> solve(const CorpusCase& c) {
  const Body<T> one = body<T>(c, "one"), other = body<T>(c, "other");
  const std::string kind = c.choices.at("kind");
  if (kind == "RRP") {
    const Along along = c.choices.at("along") == "ahead" ? Along::ahead : Along::behind;
    const T length = from_rational<T>(c.givens.at("length"));
    const Point<T> X = joint_on_guide(one.pin.at, length, other.guide, along);
    return solve(Bar<T>{one.pin}, Slide<T>{other.motion, other.direction}, X);
  }
  if (kind == "PRP") {
    const Point<T> X = joint_of_guides(one.guide, other.guide);
    return solve(Slide<T>{one.motion, one.direction}, Slide<T>{other.motion, other.direction}, X);
  }
  REQUIRE(kind == "RPR");
  const Vector<T> slot = slot_direction(other.pin.at, one.pin.at, from_rational<T>(c.givens.at("offset")));
  Solved<T> solved = solve(Bar<T>{other.pin}, PinInSlot<T>{one.pin, slot}, one.pin.at);
  solved.slot = slot;
  return solved;
}

// The answers under the names of the corpus.
template <class T>
std::map<std::string, T> answers(const Solved<T>& at) {
  std::map<std::string, T> all{{"X_x", at.X.x},
                               {"X_y", at.X.y},
                               {"v_X_x", at.velocity.v_X.x},
                               {"v_X_y", at.velocity.v_X.y},
                               {"a_X_x", at.acceleration.a_X.x},
                               {"a_X_y", at.acceleration.a_X.y},
                               {"first_rate", at.velocity.first_rate},
                               {"second_rate", at.velocity.second_rate},
                               {"first_rate_dot", at.acceleration.first_rate},
                               {"second_rate_dot", at.acceleration.second_rate}};
  if (at.slot) all.insert({{"slot_x", at.slot->x}, {"slot_y", at.slot->y}});
  return all;
}

}  // namespace

TEST_CASE("dyads: rates, velocities and accelerations contain all 40 digits of the references", "[dyads]") {
  const Arithmetic<Deep> scope(256);
  int held = 0;
  for (const CorpusCase& c : dyads()) {
    const auto found = answers(solve<Deep>(c));
    for (const Reference& r : c.references) {
      CAPTURE(c.name, c.why, r.name, r.value);
      REQUIRE(found.count(r.name) == 1);
      CHECK(overlaps(found.at(r.name), exact_decimal(r.value)));
      if (r.value != "0") CHECK(narrow(found.at(r.name)));
      ++held;
    }
    CHECK(found.size() == c.references.size());
  }
  std::printf("dyads: %d references in %zu cases\n", held, dyads().size());
  CHECK(held >= 130);
}

// Figures of 1 m, rates up to 20 1/s² and no poor angle: a thousand roundings of 2e-16 are far below 1e-11.
TEST_CASE("dyads: on intervals the references are contained, and doubles are as near", "[dyads]") {
  const Arithmetic<Bounded> scope;
  for (const CorpusCase& c : dyads()) {
    const auto bounded = answers(solve<Bounded>(c));
    const auto fast = answers(solve<Fast>(c));
    for (const Reference& r : c.references) {
      CAPTURE(c.name, r.name, r.value);
      const Enclosure e = enclosure(bounded.at(r.name));
      CHECK(overlaps(e, exact_decimal(r.value)));
      CHECK(e.upper - e.lower < 1e-11);
      CHECK(std::abs(fast.at(r.name) - e.value) < 1e-11);
    }
  }
}

// Told from the second side, term by term, the joint moves as told from the first.
TEST_CASE("dyads: both sides of both polygons are proved to end in one point", "[dyads]") {
  int proved = 0;
  for (const CorpusCase& c : dyads()) {
    if (c.name.find("seventh") != std::string::npos) continue;
    CAPTURE(c.name);
    const Arithmetic<Exact> tower;
    const Solved<Exact> at = solve<Exact>(c);
    const auto& [u, w, first, second, v_X] = at.velocity;
    const auto& [u_dot, w_dot, one, other, a_X] = at.acceleration;
    CHECK(is(first.known + first.closing, v_X));
    CHECK(is(second.known + second.closing, v_X));
    CHECK(is(one.known + one.normal + one.coriolis + one.closing, a_X));
    CHECK(is(other.known + other.normal + other.coriolis + other.closing, a_X));
    ++proved;
  }
  CHECK(proved >= 10);
}

TEMPLATE_TEST_CASE("dyads: a slot stands as its offset says, or does not reach", "[dyads]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // 3-4-5: the pin 5 from the pivot, the slot passing it at 3.
  const Point<T> Q{1, 1}, P{6, 1};
  CHECK(is(slot_direction(Q, P, T(0)), {1, 0}));
  // Q on the right of the slot: the slot passes above Q, and comes down to P.
  CHECK(is(slot_direction(Q, P, T(3)), {number<T>(4, 5), number<T>(-3, 5)}));
  CHECK(is(slot_direction(Q, P, T(-3)), {number<T>(4, 5), number<T>(3, 5)}));
  CHECK(is(slot_direction(Q, P, T(5)), {0, -1}));  // just reaches
  CHECK_THROWS_AS(slot_direction(Q, P, T(6)), Impossible);
  CHECK_THROWS_AS(slot_direction(Q, Q, T(0)), Impossible);
}

TEMPLATE_TEST_CASE("dyads: no rates in a limit position", "[dyads]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> P{0, 0}, X{0, 2};
  const Vector<T> level{1, 0}, upright{0, 3};
  const PlaneMotion<T> frame = turning_about(P, T(0), T(0));
  const Bar<T> bar{fixed_pin(P)};
  // The bar square to the guide; two guides alike; a bar along a slot's normal.
  CHECK_THROWS_AS((dyad_velocity<T>(bar, Slide<T>{frame, level}, X)), Impossible);
  CHECK_THROWS_AS((dyad_velocity<T>(Slide<T>{frame, level}, Slide<T>{frame, T(-2) * level}, X)), Impossible);
  CHECK_THROWS_AS((dyad_velocity<T>(bar, PinInSlot<T>{fixed_pin(X), level}, X)), Impossible);
  CHECK(is(dyad_velocity<T>(bar, Slide<T>{frame, upright}, X).v_X, {0, 0}));
  CHECK_THROWS_AS(joint_of_guides(line(P, level), line(X, T(-2) * level)), Impossible);
  CHECK(is(joint_of_guides(line(P, level), line(Point<T>{4, 1}, Vector<T>{1, 1})), {3, 0}));
}

}  // namespace epure::tests
