// What is written down is computed when it is asked for.
#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/solution.h"
#include "tests/support/catch.h"

using namespace epure;

TEST_CASE("ledger: exact numbers compute what is to be proved, and nothing else") {
  int proofs = 0, others = 0;
  const auto write = [&]<class T>() {
    Ledger<T> ledger("route");
    const T x = geometry::root(T(2));
    ledger.put("root", [&] {
      if constexpr (signs_only<T>) ++others;
      return x;
    });
    ledger.put("zero", [&] {
      if constexpr (signs_only<T>) ++proofs;
      return T(x * x - T(2));
    });
    return ledger;
  };
  const std::vector<RouteValue> found = settle(write, Rung::climb);
  REQUIRE(found.size() == 2);
  CHECK(found[0].settled.kind == geometry::Settled::Kind::certain);
  CHECK(found[1].settled.rung == "Exact");
  CHECK(proofs == 1);
  CHECK(others == 0);
}

namespace {

// A quantity by three routes, the first of which cannot decide it; counts how often each is asked.
struct ThreeRoutes {
  int* asked;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("cannot");
    ledger.put("x", [this]() -> T {
      ++asked[0];
      throw geometry::Undecided("whether it is", "se sia");
    });
    ledger.route("can");
    ledger.put("x", [this] {
      ++asked[1];
      return T(2);
    });
    ledger.route("can too");
    ledger.put("x", [this] {
      ++asked[2];
      return T(2);
    });
    return ledger;
  }
};

}  // namespace

TEST_CASE("ledger: a drawing asks one route after the other, until one knows the quantity") {
  int asked[3] = {0, 0, 0};
  const std::vector<RouteValue> found = settle(ThreeRoutes{asked}, Rung::drawing);
  CHECK(asked[1] > 0);
  CHECK(asked[2] == 0);
  const Solution solution(Givens({}), found);
  CHECK(solution["x"] == 2);

  const std::vector<RouteValue> every = settle(ThreeRoutes{asked}, Rung::drawing, epure::Drawn::by_every_route);
  CHECK(every.size() == 3);
  CHECK(asked[2] > 0);
}

TEST_CASE("ledger: for names nothing is found, and the names are those of a check") {
  int asked[3] = {0, 0, 0};
  const std::vector<RouteValue> names = settle(ThreeRoutes{asked}, Rung::names);
  CHECK(asked[0] + asked[1] + asked[2] == 0);
  const std::vector<RouteValue> checked = settle(ThreeRoutes{asked}, Rung::climb);
  REQUIRE(names.size() == checked.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(names[i].quantity == checked[i].quantity);
    CHECK(names[i].route == checked[i].route);
  }
}

TEST_CASE("description: printed numbers are found when they are first looked at, and once") {
  int times = 0;
  const auto find = [&times] {
    ++times;
    return std::vector<Printed>{{"x", "2", "can"}};
  };
  Description about;
  about.printed = find;
  const Description copy = about;
  CHECK(times == 0);
  CHECK(about.printed().size() == 1);
  CHECK(copy.printed().front().text == "2");
  CHECK(times == 1);
}
