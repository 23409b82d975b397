// A wheel that the ground sets turning: in closed form and by power series, against mpmath's quadratures over the
// speed (tests/corpus/make_spin_up.py).
#include "geometry/analytic/spin_up.h"
#include "tests/geometry/holds_reference.h"

namespace epure::tests {

using namespace geometry;
using namespace geometry::analytic;

namespace {

SpinUp law_of(const CorpusCase& c) {
  const auto of = [&](const char* name) { return c.givens.at(name); };
  return {of("A"), of("B"), of("C"), of("D"), of("v_0"), of("omega_0"), of("R")};
}

void state_holds(const CorpusCase& c, const SpinState& found) {
  holds(c, "t", found.t);
  holds(c, "v", found.v);
  holds(c, "omega", found.omega);
  holds(c, "path", found.path);
  holds(c, "angle", found.angle);
  holds(c, "cubes", found.cubes);
  holds(c, "of_wheel", found.of_wheel);
  holds(c, "of_load", found.of_load);
}

std::vector<CorpusCase> spins() { return read_corpus(EPURE_CORPUS "/spin_up.txt"); }

}  // namespace

TEST_CASE("slip ends as the reference has it, in closed form and by series, and with the flaps' forces almost zero") {
  const Arithmetic<Deep> scope(512);
  CHECK(spins().size() == 6);
  for (const CorpusCase& c : spins()) {
    state_holds(c, end_of_slip(law_of(c)));
    state_holds(c, end_of_slip_by_series(law_of(c)));
  }
}

TEST_CASE("at the instant of the end both laws give that end, and at touch-down the start") {
  const Arithmetic<Deep> scope(512);
  for (const CorpusCase& c : spins()) {
    const SpinUp of = law_of(c);
    const Deep end = end_of_slip(of).t;
    holds(c, "omega", spun_up(of, end).omega);
    holds(c, "angle", spun_up_by_series(of, end).angle);
    for (const SpinState& start : {spun_up(of, Deep(0)), spun_up_by_series(of, Deep(0))}) {
      CAPTURE(c.name);
      CHECK(overlaps(start.v, of.v_0));
      CHECK(overlaps(start.omega, of.omega_0));
      CHECK(overlaps(start.path, 0));
      CHECK(overlaps(start.of_wheel, 0));
    }
  }
}

}  // namespace epure::tests
