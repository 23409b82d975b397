// What is written down is computed when it is asked for.
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
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

TEST_CASE("ledger: names are those of all quantities, whatever is asked") {
  int asked[3] = {0, 0, 0};
  const std::vector<std::string> another{"y"};
  const Asked scope(another);
  CHECK(settle(ThreeRoutes{asked}, Rung::names).size() == 3);
  CHECK(settle(ThreeRoutes{asked}, Rung::fast).empty());
}

TEST_CASE("ledger: components and size of a vector are named as the vector is, and found by the first route alone") {
  const auto write = [&]<class T>() {
    Ledger<T> ledger("first");
    const geometry::Vector<T> v{T(3), T(4)}, other{T(5), T(6)};
    ledger.put(velocity("B"), v);
    ledger.put(point("P"), geometry::Point<T>{T(1), T(2)});
    ledger.route("second");
    ledger.put(velocity("B"), other);
    return ledger;
  };
  const std::vector<RouteValue> drawn = settle(write, Rung::drawing), all = settle(write, Rung::fast);
  CHECK(all.size() == 8);
  REQUIRE(drawn.size() == 5);
  const std::vector<std::string> names{"v_B_x", "v_B_y", "v_B", "P_x", "P_y"};
  const std::vector<double> values{3, 4, 5, 1, 2};
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(drawn[i].quantity == names[i]);
    CHECK(drawn[i].route == "first");
    CHECK(drawn[i].settled.enclosure.value == values[i]);
    REQUIRE(drawn[i].described);
    CHECK(drawn[i].described->name == names[i]);
  }
}

TEST_CASE("once: copies share what is found, and the finding") {
  int times = 0;
  const auto alive = std::make_shared<int>(7);
  const auto find = once([&times, alive] {
    ++times;
    return *alive;
  });
  const auto copy = find;
  CHECK(alive.use_count() == 2);
  CHECK(times == 0);
  CHECK(copy() + find() == 14);
  CHECK(times == 1);
}

TEST_CASE("exercise: its quantities are listed when they are first asked for") {
  int runs = 0;
  const auto exercise = exercise_of_panels({},
                                           [&runs](const Givens&, Rung rung) {
                                             ++runs;
                                             return settle(
                                                 []<class T>() {
                                                   Ledger<T> ledger("route");
                                                   ledger.put(distance("A", "B"), T(2));
                                                   ledger.put("not described", T(3));
                                                   return ledger;
                                                 },
                                                 rung);
                                           },
                                           {}, {});
  const Description copy = exercise->about();
  CHECK(runs == 0);
  REQUIRE(copy.quantities().size() == 1);
  CHECK(exercise->about().quantities().front().name == "AB");
  CHECK(runs == 1);
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
