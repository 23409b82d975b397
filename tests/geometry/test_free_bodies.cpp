// Bodies cut free: forces known beforehand, what is unstable, what is undetermined.
#include "geometry/statics/free_bodies.h"

#include "geometry/numbers/enclosure.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::geometry;

namespace {

using Bodies = FreeBodies<Fast>;

// A load of 10 N downwards at x = 1.
Bodies loaded() {
  Bodies bodies(2);
  bodies.load("F", 2, 1, 0, 0, -10);
  return bodies;
}

void is(const Bodies& bodies, const std::string& name, double x, double y) {
  CAPTURE(name);
  CHECK(bodies.force(name).x == Approx(x).margin(1e-12));
  CHECK(bodies.force(name).y == Approx(y).margin(1e-12));
}

}  // namespace

TEST_CASE("a beam on a hinge and a roller: parallel forces by the funicular polygon", "[statics]") {
  Bodies bodies = loaded();
  bodies.contact("roller", 1, 2, 4, 0, 0, 1);
  bodies.hinge("hinge", 1, 2, 0, 0);
  bodies.solve();
  is(bodies, "roller", 0, 2.5);
  is(bodies, "hinge", 0, 7.5);
}

TEST_CASE("the roller's line inclined: three forces meet in one point", "[statics]") {
  Bodies bodies = loaded();
  bodies.contact("roller", 1, 2, 4, 0, -1, 1);  // meets the load in (1, 3)
  bodies.hinge("hinge", 1, 2, 0, 0);
  bodies.solve();
  is(bodies, "roller", -2.5, 2.5);
  is(bodies, "hinge", 2.5, 7.5);
  CHECK(finite(bodies.H(2)).x == Approx(1));
  CHECK(finite(bodies.H(2)).y == Approx(3));
}

TEST_CASE("a body on three lines: Culmann, also where two of them are parallel", "[statics]") {
  Bodies bodies = loaded();
  bodies.contact("a", 1, 2, 0, 0, -1, 1);
  bodies.contact("b", 1, 2, 4, 0, 0, 1);
  bodies.contact("c", 1, 2, 0, 0, 1, 0);
  bodies.solve();
  is(bodies, "a", -7.5, 7.5);
  is(bodies, "b", 0, 2.5);
  is(bodies, "c", 7.5, 0);

  Bodies parallel = loaded();
  parallel.contact("a", 1, 2, 1, 0, 1, 1);  // through the load's point: the others carry 10 N along x, level with it
  parallel.contact("b", 1, 2, 0, 3, 1, 0);
  parallel.contact("c", 1, 2, 0, 2, 1, 0);
  parallel.solve();
  is(parallel, "a", 10, 10);
  is(parallel, "b", 20, 0);
  is(parallel, "c", -30, 0);
}

TEST_CASE("what cannot be in equilibrium is named", "[statics]") {
  Bodies unstable = loaded();
  unstable.contact("roller", 1, 2, 4, 0, 1, 0);  // along the line through the hinge
  unstable.hinge("hinge", 1, 2, 0, 0);
  CHECK_THROWS_WITH(unstable.solve(), Contains("body 2: it is unstable"));

  Bodies undetermined(2);
  undetermined.load("F", 2, 1, 0, 10, 0);
  undetermined.contact("roller", 1, 2, 4, 0, 1, 0);
  undetermined.hinge("hinge", 1, 2, 0, 0);
  CHECK_THROWS_WITH(undetermined.solve(), Contains("statically undetermined"));

  Bodies held_twice = loaded();
  held_twice.hinge("one", 1, 2, 0, 0);
  held_twice.hinge("other", 1, 2, 4, 0);
  CHECK_THROWS_WITH(held_twice.solve(), Contains("statically undetermined"));

  Bodies through_hinge(2);  // the load passes through the hinge, which carries all of it
  through_hinge.load("F", 2, 0, 3, 0, -10);
  through_hinge.contact("roller", 1, 2, 4, 0, 0, 1);
  through_hinge.hinge("hinge", 1, 2, 0, 0);
  through_hinge.solve();
  is(through_hinge, "roller", 0, 0);
  is(through_hinge, "hinge", 0, 10);
}

TEST_CASE("lines at known angles: what intervals cannot tell is decided on the angles", "[statics]") {
  using Number = Bounded;
  const Arithmetic<Number> scope;
  const Angle twenty{Rational(20, 360)}, five{Rational(5, 360)};
  const auto along = [](const Angle& angle) { return Vector<Number>{cosine<Number>(angle), sine<Number>(angle)}; };
  // The roller's line is that of the load: 20° turned by 5°.
  const Vector<Number> F = along(twenty + five), turned = cosine<Number>(five) * along(twenty) +
                                                          sine<Number>(five) * quarter_turn(along(twenty));
  const auto solved = [&](double x, bool knows_angles, bool knows_hinge) {
    FreeBodies<Number> bodies(2);
    bodies.load("F", 2, Number(1), Number(0), -F.x, -F.y);
    if (knows_hinge) {
      bodies.contact("roller", 1, 2, Number(x), Number(0), Number(0), Number(1));
      bodies.hinge("hinge", 1, 2, Number(1) - turned.x, -turned.y);
      bodies.through("F", "hinge");
    } else {
      bodies.contact("roller", 1, 2, Number(x), Number(0), turned.x, turned.y);
      bodies.hinge("hinge", 1, 2, Number(0), Number(0));
    }
    if (knows_angles) {
      bodies.directed("F", twenty + five);
      bodies.directed("roller", twenty + five);
    }
    bodies.solve();
    return enclosure(bodies.along("roller")).value;
  };
  CHECK_THROWS_AS(solved(4, false, false), Undecided);
  CHECK(solved(4, true, false) == Approx(0.25).epsilon(1e-14));
  CHECK(solved(4, false, true) == 0);
}
