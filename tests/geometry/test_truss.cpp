// Trusses: regions and their order, Cremona's plan against the equations of all joints with every number, and what is
// no simple truss.
#include "geometry/analytic/truss_equations.h"
#include "geometry/statics/cremona.h"
#include "geometry/statics/support_polygon.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::tests;

namespace {

Rational q(int p, int over = 1) { return Rational(p, over); }

Truss truss_of(std::vector<std::pair<Rational, Rational>> joints, std::vector<TrussBar> bars,
               std::vector<std::size_t> outside) {
  Truss truss{{}, std::move(bars), std::move(outside)};
  for (const auto& [x, y] : joints) truss.joints.push_back({x, y});
  return truss;
}

// A triangle on its base, hinge left and roller right, with its apex at (4, 3).
Truss triangle() { return truss_of({{q(0), q(0)}, {q(8), q(0)}, {q(4), q(3)}}, {{0, 1}, {0, 2}, {2, 1}}, {0, 1, 2}); }

// A strip of triangles between two rows of joints, each bound to the two before it.
Truss strip(Random& random, std::size_t joints) {
  Truss truss;
  for (std::size_t i = 0; i < joints; ++i) {
    const Rational height = Rational(i % 2 == 0 ? 0 : 2) + random.fraction() / 2;
    truss.joints.push_back({Rational(static_cast<int>(i)) + random.fraction() / 3, height});
    if (i > 0) truss.bars.push_back({i - 1, i});
    if (i > 1) truss.bars.push_back({i - 2, i});
    truss.outside.push_back(i);
  }
  std::swap(truss.outside[1], truss.outside.back());  // hinge first, roller last
  return truss;
}

template <class T>
Point<T> place(const Truss& truss, std::size_t joint) {
  return {from_rational<T>(truss.joints[joint].x), from_rational<T>(truss.joints[joint].y)};
}

// What a force of `loads[k]` at the joint outside[k + 2] makes of the plan, the roller pushing along (1, 2).
template <class T>
struct Solved {
  std::vector<Point<T>> plan;
  std::vector<Vector<T>> outside;
};
template <class T>
Solved<T> by_plan(const Truss& truss, const BowNotation& bow, const std::vector<Vector<T>>& loads) {
  std::vector<Line<T>> lines;
  for (std::size_t k = 0; k < loads.size(); ++k)
    lines.push_back(line(place<T>(truss, truss.outside[k + 2]), loads[k]));
  const auto [hinge, roller] = support_reactions<T>(
      lines, place<T>(truss, truss.outside[0]), {place<T>(truss, truss.outside[1]), {number<T>(1), number<T>(2)}});
  std::vector<Vector<T>> outside{hinge, roller};
  outside.insert(outside.end(), loads.begin(), loads.end());
  return {cremona_plan<T>(truss, bow, outside), outside};
}
template <class T>
std::vector<T> by_equations(const Truss& truss, const std::vector<Vector<T>>& loads) {
  std::vector<analytic::Complex<T>> joints;
  for (std::size_t i = 0; i < truss.joints.size(); ++i)
    joints.push_back({place<T>(truss, i).x, place<T>(truss, i).y});
  analytic::TrussEquations<T> equations(joints);
  for (const TrussBar& bar : truss.bars) equations.bar(bar.from, bar.to);
  equations.support(truss.outside[0], {T(1), T(0)});
  equations.support(truss.outside[0], {T(0), T(1)});
  equations.support(truss.outside[1], {T(1), T(2)});
  for (std::size_t k = 0; k < loads.size(); ++k) equations.load(truss.outside[k + 2], {loads[k].x, loads[k].y});
  return equations.solve();
}

// Fink's compound truss of two halves, each braced twice, joined at the ridge and by a tie.
Truss fink() {
  std::vector<std::pair<Rational, Rational>> left{{q(0), q(0)}, {q(3, 2), q(3, 2)}, {q(3), q(3)}, {q(9, 2), q(9, 2)},
                                                  {q(6), q(6)}, {q(4), q(0)},       {q(2), q(0)}, {q(5), q(3)}};
  std::vector<TrussBar> bars{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 6}, {6, 5}, {5, 7},
                             {7, 4}, {2, 5}, {1, 6}, {6, 2}, {2, 7}, {7, 3}};
  std::vector<std::pair<Rational, Rational>> joints = left;
  const auto mirrored = [](std::size_t joint) { return joint < 4 ? joint + 8 : joint == 4 ? 4 : joint + 7; };
  for (std::size_t i = 0; i < left.size(); ++i)
    if (i != 4) joints.push_back({q(12) - left[i].first, left[i].second});
  const std::size_t half = bars.size();
  for (std::size_t i = 0; i < half; ++i) bars.push_back({mirrored(bars[i].from), mirrored(bars[i].to)});
  bars.push_back({5, mirrored(5)});
  return truss_of(joints, bars, {0, 8, 4});
}

void refuses(const Truss& truss, const std::string& why) {
  CAPTURE(why);
  CHECK_THROWS_WITH(bow_notation(truss), Contains(why));
}

}  // namespace

TEST_CASE("Bow's letters run clockwise from the hinge: a triangle has three regions outside and one inside",
          "[truss]") {
  const BowNotation bow = bow_notation(triangle());
  CHECK(bow.forces == std::vector<std::size_t>{2, 1, 0});  // the apex, the roller, the hinge
  CHECK(bow.regions() == 4);
  REQUIRE(bow.outline.size() == 3);
  CHECK(bow.outline[0].bar == 1);
  CHECK(bow.outline[1].bar == 2);
  CHECK(bow.outline[2].bar == 0);
  CHECK_FALSE(bow.outline[2].is_forward);
  REQUIRE(bow.steps.size() == 1);
  CHECK(bow.corners[0].size() == 3);
  CHECK(bow.sides[1].left == 0);
  CHECK(bow.sides[1].right == 3);
  CHECK(bow.sides[0].left == 3);
  CHECK(bow.sides[0].right == 2);
}

// 6 N down at the apex: each support answers 3 N, each rafter is pressed with 3/sin = 5 N, the tie pulled with
// 3/tan = 4 N.
TEMPLATE_TEST_CASE("a triangle's rafters are pressed, its tie is pulled", "[truss]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Truss truss = triangle();
  const BowNotation bow = bow_notation(truss);
  const Vector<T> load{T(0), T(-6)}, half{T(0), T(3)};
  const auto [hinge, roller] =
      support_reactions<T>({line(place<T>(truss, 2), load)}, place<T>(truss, 0), {place<T>(truss, 1), {T(0), T(7)}});
  CHECK(is(hinge, half));
  CHECK(is(roller, half));
  const auto plan = cremona_plan<T>(truss, bow, {hinge, roller, load});
  CHECK(is(force_times_length(truss, bow, plan, 0), number<T>(4 * 8), 100));
  CHECK(is(force_times_length(truss, bow, plan, 1), number<T>(-5 * 5), 100));
  CHECK(is(force_times_length(truss, bow, plan, 2), number<T>(-5 * 5), 100));
}

TEMPLATE_TEST_CASE("the plan closes by its last bar, at every joint, and has the forces of the equations", "[truss]",
                   Exact, Calcium) {
  using T = TestType;
  Random random(seed());
  for (int round = 0; round < (std::is_same_v<T, Exact> ? 40 : 4); ++round) {
    const Scope<T> scope;
    const Truss truss = strip(random, static_cast<std::size_t>(3 + random.up_to(8)));
    const BowNotation bow = bow_notation(truss);
    std::vector<Vector<T>> loads;
    for (std::size_t k = 2; k < truss.outside.size(); ++k)
      loads.push_back({from_rational<T>(random.fraction()), from_rational<T>(random.fraction())});
    const Solved<T> solved = by_plan(truss, bow, loads);
    const std::vector<T> densities = by_equations(truss, loads);
    std::vector<Vector<T>> at_joint(truss.joints.size(), {T(0), T(0)});
    for (std::size_t k = 0; k < truss.outside.size(); ++k) at_joint[truss.outside[k]] = solved.outside[k];
    for (std::size_t i = 0; i < truss.bars.size(); ++i) {
      CAPTURE(round, truss.joints.size(), i);
      const Vector<T> d = direction_of<T>(truss, i),
                      force = solved.plan[bow.sides[i].right] - solved.plan[bow.sides[i].left];
      CHECK(is(cross(force, d), T(0)));  // of the closing bar nobody has seen to it
      CHECK(is(force_times_length(truss, bow, solved.plan, i), densities[i] * length_squared(d)));
      at_joint[truss.bars[i].from] = at_joint[truss.bars[i].from] + force;
      at_joint[truss.bars[i].to] = at_joint[truss.bars[i].to] - force;
    }
    for (const Vector<T>& sum : at_joint) CHECK(is(sum, Vector<T>{T(0), T(0)}));
    CHECK(is(densities[truss.bars.size() + 2], solved.outside[1].x));
  }
}

TEST_CASE("every bar but one has served to find a region", "[truss]") {
  Random random(seed());
  for (std::size_t joints = 3; joints < 14; ++joints) {
    const Truss truss = strip(random, joints);
    const BowNotation bow = bow_notation(truss);
    std::vector<int> used(truss.bars.size(), 0);
    for (const auto& step : bow.steps)
      for (const std::size_t bar : step.bars) ++used[bar];
    CAPTURE(joints);
    CHECK(used[bow.closing_bar] == 0);
    CHECK(std::count(used.begin(), used.end(), 1) == static_cast<int>(truss.bars.size()) - 1);
  }
}

TEST_CASE("what is no simple truss held by a hinge and a roller is named", "[truss]") {
  Truss fourbar =
      truss_of({{q(0), q(0)}, {q(4), q(0)}, {q(4), q(3)}, {q(0), q(3)}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {0, 1, 2});
  refuses(fourbar, "unstable: 4 bars and 3 components of reaction, against 8 equations");
  Truss braced = fourbar;
  braced.bars.push_back({0, 2});
  CHECK(bow_notation(braced).steps.size() == 2);
  Truss crossed = braced;
  crossed.bars.push_back({1, 3});
  refuses(crossed, "bars 5 and 6 cross");

  Truss middle = triangle();  // a joint inside, bound to all three
  middle.joints.push_back({q(4), q(1)});
  for (std::size_t i = 0; i < 3; ++i) middle.bars.push_back({i, 3});
  refuses(middle, "statically undetermined: 6 bars and 3 components of reaction, against 8 equations");
  Truss loose = middle;  // as many bars as it takes, but not where: a frame that gives way hangs on it
  loose.joints.push_back({q(9), q(2)});
  loose.joints.push_back({q(6), q(5)});
  for (const TrussBar& bar : {TrussBar{1, 4}, {4, 5}, {5, 2}}) loose.bars.push_back(bar);
  refuses(loose, "no region that is left has two known neighbours");
  const std::vector<Vector<Exact>> load{{Exact(0), Exact(-1)}};
  const Scope<Exact> scope;
  CHECK_THROWS_WITH(by_equations<Exact>(loose, load), Contains("not independent"));
}

// The tie by a section through the ridge, 6 m above it: the roller answers 2.5 N along x and 5 N upwards, 6 m to the
// right, so that 6·5 + 6·2.5 = 6 N.
TEST_CASE("a compound truss stops Cremona's plan, and not the equations", "[truss]") {
  refuses(fink(), "no region that is left has two known neighbours");
  const Scope<Exact> scope;
  const std::vector<Exact> found = by_equations<Exact>(fink(), {{Exact(0), Exact(-10)}});
  CHECK(is(found[26] * Exact(4), number<Exact>(15, 2)));
}

TEST_CASE("what is no flat figure is named", "[truss]") {
  Truss doubled = triangle();
  doubled.bars.push_back({2, 0});
  refuses(doubled, "bars 2 and 4 cross or touch");
  Truss on_bar = triangle();  // a joint on the tie that the tie passes by
  on_bar.joints.push_back({q(2), q(0)});
  on_bar.bars.push_back({3, 2});
  refuses(on_bar, "bars 1 and 4 cross or touch");
  Truss together = triangle();
  together.joints.push_back({q(4), q(3)});
  refuses(together, "joints 3 and 4 are in one place");
  Truss apart = triangle();
  for (const auto& joint : triangle().joints) apart.joints.push_back({joint.x + q(20), joint.y});
  for (const TrussBar& bar : triangle().bars) apart.bars.push_back({bar.from + 3, bar.to + 3});
  refuses(apart, "in parts");
  Truss single = triangle();
  single.joints.push_back({q(20), q(0)});
  refuses(single, "no bar ends in joint 4");
  Truss hidden = truss_of({{q(0), q(0)}, {q(6), q(0)}, {q(3), q(6)}, {q(3), q(2)}},
                          {{0, 2}, {2, 1}, {0, 3}, {3, 1}, {3, 2}}, {0, 1, 3});
  CHECK(bow_notation(hidden).steps.size() == 2);  // open from below
  hidden.bars[4] = {0, 1};                        // closed, and the last joint stands on two bars
  hidden.joints[3] = {q(3), q(1)};
  refuses(hidden, "a force acts inside of the truss, at joint 4");
}

TEST_CASE("a roller whose line passes through the hinge holds nothing", "[truss]") {
  const Truss truss = triangle();
  CHECK_THROWS_WITH(
      (support_reactions<Fast>({line(Point<Fast>{4, 3}, Vector<Fast>{0, -6})}, {0, 0}, {{8, 0}, {1, 0}})),
      Contains("unstable"));
}

TEST_CASE("the funicular polygon that begins in the hinge finds the reactions, whatever the pole", "[truss]") {
  const Scope<Exact> scope;
  const auto finds = [](const std::vector<ForceAt<Exact>>& loads, const LineOfAction<Exact>& roller,
                        const Point<Exact>& pole) {
    const Point<Exact> A{number<Exact>(1), number<Exact>(-2)};
    std::vector<Line<Exact>> lines;
    lines.reserve(loads.size());
    for (const auto& load : loads) lines.push_back(line(load.at, load.f));
    const SupportReactions<Exact> by_moments = support_reactions<Exact>(lines, A, roller);
    const SupportPolygon<Exact> polygon = support_polygon<Exact>(loads, A, roller, pole);
    REQUIRE(polygon.vertices.size() == loads.size() + 1);
    const Vector<Exact> by_roller = polygon.between - polygon.corners.back(),
                        by_hinge = polygon.corners.front() - polygon.between;
    CHECK(is(by_roller, by_moments.roller));
    CHECK(is(by_hinge, by_moments.hinge));
    for (std::size_t i = 0; i < loads.size(); ++i)
      CHECK(is(cross(polygon.vertices[i] - loads[i].at, loads[i].f), Exact(0)));
    CHECK(is(cross(polygon.vertices.back() - roller.at, roller.along), Exact(0)));
  };
  const LineOfAction<Exact> oblique{{number<Exact>(9), number<Exact>(0)}, {number<Exact>(1), number<Exact>(2)}},
      upright{{number<Exact>(9), number<Exact>(0)}, {number<Exact>(0), number<Exact>(1)}};
  const std::vector<ForceAt<Exact>> wind{
      {{number<Exact>(2), number<Exact>(3)}, {number<Exact>(5), number<Exact>(-7)}},
      {{number<Exact>(4), number<Exact>(6)}, {number<Exact>(3), number<Exact>(-1)}}},
      level{{{number<Exact>(2), number<Exact>(3)}, {number<Exact>(0), number<Exact>(-7)}},
            {{number<Exact>(4), number<Exact>(6)}, {number<Exact>(0), number<Exact>(-2)}}},
      couple{{{number<Exact>(2), number<Exact>(3)}, {number<Exact>(5), number<Exact>(-7)}},
             {{number<Exact>(4), number<Exact>(7)}, {number<Exact>(-5), number<Exact>(7)}}};
  for (const Point<Exact>& pole :
       {Point<Exact>{number<Exact>(11), number<Exact>(-3)}, {number<Exact>(-6), number<Exact>(-13, 3)}})
    for (const auto& loads : {wind, level, couple})
      for (const auto& roller : {oblique, upright}) finds(loads, roller, pole);
  // On the line of a load in the force polygon a pole has no string that meets that load.
  CHECK_THROWS(support_polygon<Exact>(level, {number<Exact>(1), number<Exact>(-2)}, oblique,
                                      {number<Exact>(0), number<Exact>(4)}));
}
