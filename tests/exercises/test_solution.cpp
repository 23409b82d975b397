// What sheets read.
#include "exercises/kit/proof/solution.h"

#include "exercises/kit/proof/ledger.h"
#include "tests/support/catch.h"

using namespace epure;
using geometry::Deep;

namespace {

Solution solution_of(const auto& write) { return {Givens({}), settle(write, Rung::drawing)}; }

}  // namespace

TEST_CASE("solution: the first route that knows a quantity gives it") {
  const Solution solution = solution_of([]<class T>() {
    Ledger<T> ledger("first");
    ledger.put("both", T(1));
    ledger.put("later", [&]() -> T { throw geometry::Impossible("not by this route", "non per questa via"); });
    ledger.route("second");
    ledger.put("both", T(2));
    ledger.put("later", T(3));
    return ledger;
  });
  CHECK(solution["both"] == 1);
  CHECK(solution["later"] == 3);
  CHECK(solution.has("both"));
  CHECK_FALSE(solution.has("neither"));
}

TEST_CASE("solution: what does not exist has no value, what may be zero is drawn as zero") {
  const Solution solution = solution_of([]<class T>() {
    Ledger<T> ledger("route");
    ledger.put("none", [&]() -> T { throw geometry::Impossible("at infinity", "all'infinito"); });
    const T root = geometry::root(T(2));
    ledger.put("nothing", T(root * root - T(2)));
    return ledger;
  });
  CHECK_FALSE(solution.value("none").has_value());
  CHECK(solution.value("nothing") == 0);
  CHECK_THROWS_WITH(solution["none"], "at infinity");
}

TEST_CASE("solution: a vector of which the length is reported is drawn by its components") {
  const auto write = []<class T>() {
    Ledger<T> ledger("route");
    ledger.put_length(velocity("B"), {T(3), T(-4)});
    ledger.put(point("A"), geometry::Point<T>{T(1), T(2)});
    ledger.draws_point("O", {T(5), T(6)});
    return ledger;
  };
  const Solution solution = solution_of(write);
  CHECK(solution["v_B"] == 5);
  CHECK(solution.vector("v_B").x == 3);
  CHECK(solution.vector("v_B").y == -4);
  CHECK(solution.place("O").y == 6);
  CHECK(solution.point("A")->x == 1);
  CHECK(solution.is_reported("v_B"));
  CHECK_FALSE(solution.is_reported("v_B_x"));
  CHECK_FALSE(solution.is_reported("O_x"));
  CHECK(solution.described("v_B").symbol == "$v_{B}$");

  // What is only drawn is not proved and not reported.
  std::vector<std::string> proved;
  for (const RouteValue& value : settle(write, Rung::climb)) proved.push_back(value.quantity);
  CHECK(proved == std::vector<std::string>{"v_B", "A_x", "A_y"});
}

TEST_CASE("solution: what each route says is kept apart, and what a sheet tells on the way is not reported") {
  const auto write = []<class T>() {
    Ledger<T> ledger("first");
    ledger.put("both", T(1));
    ledger.tells({"iterate", "$x^{k}$", "m", {"on the way", "per via"}}, [] { return T(4); });
    ledger.route("second");
    ledger.put("both", T(2));
    return ledger;
  };
  const Solution solution(Givens({}), settle(write, Rung::drawing, epure::Drawn::by_every_route));
  CHECK(solution.value("both", "first") == 1);
  CHECK(solution.value("both", "second") == 2);
  CHECK_FALSE(solution.value("both", "third").has_value());
  CHECK(solution["iterate"] == 4);
  CHECK(solution.described("iterate").symbol == "$x^{k}$");
  for (const RouteValue& value : settle(write, Rung::climb)) CHECK(value.quantity == "both");
}

TEST_CASE("solution: of parts the first is found at once, another when one of its quantities is asked for") {
  std::vector<std::string> found;
  const auto part = [&](const std::string& of_case, int value) {
    return Solution::FindPart{of_case, [&found, of_case, value] {
                                found.push_back(of_case);
                                return settle(
                                    [&]<class T>() {
                                      Ledger<T> ledger("route");
                                      if (!of_case.empty()) ledger.begin_case(of_case + ".");
                                      ledger.put("x", T(value));
                                      return ledger;
                                    },
                                    Rung::drawing);
                              }};
  };
  const Solution solution(Givens({}), {part("", 1), part("other", 2), part("third", 3)});
  CHECK(found == std::vector<std::string>{""});
  CHECK_FALSE(solution.has("y"));
  CHECK_FALSE(solution.has("neither.x"));
  CHECK(solution["x"] == 1);
  CHECK(found == std::vector<std::string>{""});
  CHECK_FALSE(solution.has("third.y"));
  CHECK(solution["third.x"] == 3);
  CHECK(solution.value("third.x", "route") == 3);
  CHECK(found == std::vector<std::string>{"", "third"});
  CHECK(solution.values().size() == 3);
  CHECK(found == std::vector<std::string>{"", "third", "other"});
}
