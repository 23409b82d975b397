// What is written down is computed when it is asked for.
#include "exercises/kit/proof/ledger.h"
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
