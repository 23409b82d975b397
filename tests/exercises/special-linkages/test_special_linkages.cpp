// What holds for every direction of the links is proved at every direction, within the budget of every proof.
// EPURE_SPECIAL_CASES says how many cases are asked (a night takes 100000), EPURE_SPECIAL_SEED which; what they cost
// is then told, but never a reason to fail.
#include "exercises/kit/proof/checked.h"
#include "tests/exercises/special-linkages/families.h"

#include "tests/support/catch.h"

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

namespace {

// What became of a case: refused, or by quantity and route what is known of it.
struct Outcome {
  bool is_refused = false;
  std::vector<std::string> open = {};  // undecided, with the reasons
  std::map<std::string, bool> absent = {};
  std::vector<RouteValue> values = {};
};

const Exercise& named(const std::string& id) {
  for (const auto& exercise : catalogue())
    if (exercise->about().id == id) return *exercise;
  throw std::logic_error(id);
}

Outcome answer_to(const SpecialCase& of) {
  const Exercise& exercise = named(of.exercise);
  Outcome found;
  try {
    Givens givens(exercise.about().givens);
    for (const std::string& assignment : of.assignments()) givens.set(assignment);
    found.values = exercise.solve(givens, Rung::climb);
  } catch (const BadGivens&) {
    found.is_refused = true;
  } catch (const geometry::Undecided& open) {
    found.open.push_back(open.what());
  }
  for (const RouteValue& value : found.values) {
    if (value.settled.kind == Settled::Kind::undecided)
      found.open.push_back(value.quantity + " by " + value.route + ": " + value.settled.reason.english);
    bool& is_absent = found.absent[value.quantity];
    is_absent = is_absent || value.settled.kind == Settled::Kind::absent;
  }
  return found;
}

bool is_known(const Settled& settled) {
  return settled.kind == Settled::Kind::certain || settled.kind == Settled::Kind::enclosed;
}

// The routes agree that a quantity exists, and their enclosures meet.
void require_agreement(const Outcome& verdict) {
  std::map<std::string, const Settled*> first;
  for (const RouteValue& value : verdict.values) {
    INFO(value.quantity << " by " << value.route);
    if (is_known(value.settled)) {
      CHECK_FALSE(verdict.absent.at(value.quantity));
      const Settled*& other = first[value.quantity];
      if (!other) other = &value.settled;
      CHECK(value.settled.enclosure.lower <= other->enclosure.upper);
      CHECK(value.settled.enclosure.upper >= other->enclosure.lower);
    }
  }
}

void require_same(const Outcome& verdict, const SpecialCase& moved) {
  INFO(moved.text());
  const Outcome other = answer_to(moved);
  CHECK(other.is_refused == verdict.is_refused);
  CHECK(other.open == std::vector<std::string>{});
  CHECK(other.absent == verdict.absent);
}

long from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtol(text, nullptr, 10) : otherwise;
}

}  // namespace

TEST_CASE("Special linkages are decided at every direction", "[special]") {
  const long cases = from_environment("EPURE_SPECIAL_CASES", 160);
  const long seed = from_environment("EPURE_SPECIAL_SEED", 20261122);
  const bool is_told = std::getenv("EPURE_SPECIAL_CASES") != nullptr;
  CAPTURE(seed);
  Random random(static_cast<std::uint64_t>(seed));
  long answered = 0, undecided = 0;
  double worst = 0, in_all = 0;
  for (long k = 0; k < cases; ++k) {
    const SpecialCase one = special_case(random);
    INFO(one.text());
    const std::clock_t begin = std::clock();
    const Outcome verdict = answer_to(one);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    in_all += seconds;
    if (is_told && seconds > worst) std::cout << seconds << " s: " << one.text() << "\n";
    worst = std::max(worst, seconds);
    answered += verdict.is_refused ? 0 : 1;
    undecided += verdict.open.empty() ? 0 : 1;
    if (is_told && !verdict.open.empty()) std::cout << "UNDECIDED " << one.text() << "\n";
    for (const std::string& reason : verdict.open) UNSCOPED_INFO(reason);
    CHECK(verdict.open.empty());
    require_agreement(verdict);
    if (k % 16 == 0) require_same(verdict, scaled(one, Rational(700, 9)));
    if (k % 16 == 1 && can_be_turned(one)) require_same(verdict, turned(one, random));
  }
  CHECK(answered > cases / 2);  // the lots are not all refused
  if (is_told)
    std::cout << cases << " cases, " << answered << " answered, " << undecided << " undecided; "
              << in_all / static_cast<double>(cases) << " s of processor time each, " << worst << " s the longest\n";
}
