// The pin in a slot: its numbers, certain and by two routes, are those of a corpus that knows positions and energies
// only; and what the source printed.
#include <cmath>
#include <limits>
#include <set>

#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/pin-in-slot/cases.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

namespace {

double ulp(double x) { return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x); }

std::set<std::string> routes_of(const CheckedQuantity& quantity) {
  std::set<std::string> routes;
  for (const RouteValue& value : quantity.routes) routes.insert(value.route);
  return routes;
}

const Printed& printed(const std::string& text) {
  for (const Printed& each : pin_in_slot().about().printed())
    if (each.text == text) return each;
  throw std::logic_error("nothing like it is printed");
}

PrintedVerdict verdict_on(const Printed& number) { return judge(number, find(checked({}), number.quantity).settled); }

}  // namespace

TEST_CASE("the pin in a slot reports what it promises, with its units", "[pin-in-slot]") {
  const CheckedExercise result = checked({});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  const std::vector<std::pair<std::string, std::vector<std::string>>> promised{
      {"rad", {"lever_angle"}},
      {"m", {"B_x"}},
      {"m/s", {"b_dot", "v_B"}},
      {"rad/s", {"omega_disc"}},
      {"m/s^2", {"a_B"}},
      {"rad/s^2", {"alpha_disc"}},
      {"W", {"kinetic_power"}},
      {"N*m", {"gravity_torque", "C"}},
      {"N", {"slot_force_on_pin", "ground_normal_force", "ground_friction_force"}},
      {"1", {"required_friction_coefficient"}}};
  for (const auto& [unit, names] : promised)
    for (const std::string& name : names) {
      CAPTURE(name);
      CHECK(find(result, name).spec.unit == unit);
    }
}

TEST_CASE("its values are the corpus', to the last bit of a double, by every route", "[pin-in-slot]") {
  int values = 0, absent = 0;
  for (const CorpusCase& c : corpus()) {
    const CheckedExercise result = checked(assignments_of(c));
    CAPTURE(c.name, c.why, complaints(result));
    CHECK(result.passed());
    for (const CheckedQuantity& quantity : result.quantities) {
      const std::string reference = c.reference(quantity.spec.name);
      CAPTURE(quantity.spec.name, reference, quantity.settled.reason.english);
      REQUIRE_FALSE(reference.empty());
      CHECK(routes_of(quantity).size() >= 2);
      if (reference == "infinite" || reference == "undefined") {
        ++absent;
        CHECK(quantity.settled.kind == Settled::Kind::absent);
        CHECK_FALSE(quantity.settled.reason.english.empty());
        continue;
      }
      ++values;
      REQUIRE(quantity.settled.kind == Settled::Kind::certain);
      const auto& [lower, value, upper] = quantity.settled.enclosure;
      CHECK(value == std::stod(reference));
      CHECK_FALSE((value == 0 && std::signbit(value)));
      CHECK(lower <= value);
      CHECK(value <= upper);
      CHECK(upper - lower <= 4 * ulp(value));
    }
  }
  CHECK(corpus().size() == 20);
  CHECK(values == 20 * 26 - absent);
  CHECK(absent == 4);
}

TEST_CASE("the couple comes out of three laws", "[pin-in-slot]") {
  const CheckedExercise result = checked({});
  CHECK(routes_of(find(result, "C")) == std::set<std::string>{"Newton-Euler", "power balance", "analytic"});
  CHECK(routes_of(find(result, "v_B")) == std::set<std::string>{"polar diagram", "poles", "analytic"});
}

TEST_CASE("a disc that would lift off needs no friction, and the reason is told", "[pin-in-slot]") {
  const CheckedExercise result = checked({"omega_dot=-20"});
  const CheckedQuantity& friction = find(result, "required_friction_coefficient");
  CHECK(friction.settled.kind == Settled::Kind::absent);
  CHECK(friction.settled.reason.english.find("lift off") != std::string::npos);
  CHECK(value(result, "ground_normal_force") < 0);
}

TEST_CASE("a lever that is upright has its relative pole at infinity", "[pin-in-slot]") {
  const CheckedExercise result = checked({"OB=0.2"});
  CHECK(find(result, "P23_x").settled.kind == Settled::Kind::absent);
  CHECK(value(result, "b_dot") == 0);
  CHECK(value(result, "omega_disc") == -1);
}

TEST_CASE("a lever too short for its pin is refused with the values", "[pin-in-slot]") {
  CHECK_THROWS_AS(checked({"OB=0.15"}), BadGivens);
  try {
    checked({"OB=0.15"});
  } catch (const BadGivens& refused) {
    const std::string text = refused.what();
    CAPTURE(text);
    for (const char* part : {"OB = 0.15 m", "R = 0.2 m", "0.05 m"}) CHECK(text.find(part) != std::string::npos);
  }
  for (const char* wrong : {"R=0", "OB=-1", "AO=0", "M2=0", "J2=-1", "g=-9.81", "M1=-1", "J2=1kg", "omega=1Hz/s"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(givens_of({wrong}), BadGivens);
  }
  CHECK_NOTHROW(givens_of({"J2=2kg*m^2", "omega=0", "M1=500g", "omega=1rpm"}));
}

TEST_CASE("every printed number has its verdict, and each mistake gives its digits", "[pin-in-slot][printed]") {
  const CheckedExercise result = checked({});
  std::size_t count = 0;
  for (const CheckedQuantity& quantity : result.quantities) count += quantity.printed.size();
  CHECK(count == result.about.printed().size());
  for (const char* rounded : {"0.8", "-4", "3.1", "-15.5"}) {
    CAPTURE(rounded);
    CHECK(verdict_on(printed(rounded)).verdict == Verdict::rounding);
  }
  for (const char* explained : {"138.9", "120.2"}) {
    CAPTURE(explained);
    CHECK(verdict_on(printed(explained)).verdict == Verdict::disagrees);
    CHECK(verdict_on(printed(explained)).explanation);
  }
  Printed changed = printed("138.9");
  changed.text = "138.8";
  CHECK_FALSE(verdict_on(changed).explanation_holds);
}

// By hand: 30·9.81·0.3·cos 30° + 30·0.09·0.4 + 4·0.4·(20 + 1/0.04)·(0.4·0.4 + 0.4·√3) = 138.944; and with B = (0.4,
// 0.2), so OB² = 0.2 m², v_B = 1 m/s, a_B = 4.4 m/s²: 1.08 + 45·4.4 - 30·9.8·0.3·2/√5 = 120.192.
TEST_CASE("the mistaken formulas are evaluated", "[pin-in-slot][printed]") {
  CHECK(printed("138.9").explanation->evaluate() == Approx(138.9444462).epsilon(1e-9));
  CHECK(printed("120.2").explanation->evaluate() == Approx(120.1915218).epsilon(1e-9));
}
