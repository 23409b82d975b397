// The method of constraint equations: its iteration against one carried out with mpmath, its proved solutions against
// the corpus, and that it says what went wrong where there is nothing to find.
#include "geometry/analytic/constraints.h"
#include "tests/geometry/four_bar_answers.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

#include <cmath>
#include <cstdio>

namespace epure::tests::four_bar {
namespace {

using namespace analytic;

constexpr int enough_steps = 50;

// Exercise N.11: r1 = 0.8, r2 = 0.2, r3 = 0.5, r4 = 0.7 m, crank at 20°.
const FourBar n11{{1, 5}, {1, 2}, {7, 10}, {4, 5}, 0};

template <class T>
CrankState<T> twenty_degrees() {
  return crank_at<T>(Angle{{1, 18}}, T(1), T(0));
}

template <class T>
CrankState<T> crank_state(const CorpusCase& c) {
  return crank_along<T>(crank_of<T>(c), speed_of<T>(c), from_rational<T>(c.givens.at("alpha_2")));
}

// From the reference rounded to three decimals, as one would read it off a drawing.
NewtonRun from_a_drawing(const CorpusCase& c) {
  const auto read_off = [&](const char* name) { return std::round(std::stod(c.reference(name)) * 1000) / 1000; };
  return newton_raphson(linkage_of(c), crank_state<Fast>(c), read_off("theta_3"), read_off("theta_4"), enough_steps);
}

bool is_undefined_motion(const CorpusCase& c) { return c.reference("omega_3") == "undefined"; }

// What the constraint equations answer, under the corpus' names.
template <class T>
std::map<std::string, T> solved(const CorpusCase& c, const NewtonRun& run) {
  const FourBar g = linkage_of(c);
  const CrankState<T> crank = crank_state<T>(c);
  const Configuration<T> q = configuration<T>(g, crank, run);
  const ConstraintMotion<T> m = motion(crank, q);
  std::map<std::string, T> found = {
      {"theta_3", q.theta_3}, {"theta_4", q.theta_4}, {"psi_y_determinant", q.determinant},
      {"omega_3", m.omega_3}, {"omega_4", m.omega_4}, {"alpha_3", m.alpha_3},
      {"alpha_4", m.alpha_4}};
  const auto add = [&](const std::string& name, const MovingPoint<T>& point) {
    for (const auto& [prefix, w] : {std::pair{"", point.z}, {"v_", point.v}, {"a_", point.a}}) {
      found[prefix + name + "_x"] = w.re;
      found[prefix + name + "_y"] = w.im;
    }
  };
  const auto along = [](const Rational& length) { return Complex<T>{from_rational<T>(length), T(0)}; };
  add("A", crank_point(q, m, along(g.A0A)));
  add("G2", crank_point(q, m, along(g.A0A / 2)));
  add("B", rocker_point(q, m, along(g.B0B)));
  add("G3", coupler_point(q, m, along(g.AB / 2)));
  add("G4", rocker_point(q, m, along(g.B0B / 2)));
  add("C", coupler_point(q, m, right_angled_plate_point<T>(g, c.givens.at("AC"), C_side_of(c))));
  return found;
}

// Whether the run found the case's branch: beside a limit of the crank the other one is as near.
bool is_branch_of(const CorpusCase& c, const NewtonRun& run) {
  return (run.iterates.back().determinant < 0) == (branch_of(c) == Branch::left);
}

bool is_beside_a_limit(const CorpusCase& c) {
  return c.name.rfind("limit", 0) == 0 || c.name.rfind("near_change", 0) == 0 || c.name == "change_point";
}

// An angle of π may come out as -π.
bool is_whole_turn_off(const std::string& name, const Reference& r) {
  return name.rfind("theta", 0) == 0 && std::abs(std::abs(std::stod(r.value)) - pi<Fast>()) < 1e-3;
}

}  // namespace

TEST_CASE("constraint equations: the iterates of N.11", "[analytic][constraints]") {
  // By mpmath with 50 digits, from the source's start vector.
  struct Row {
    double theta_3, theta_4, residual_norm, determinant;
  };
  const Row rows[] = {{1.22, -0.87, 0.01151719272, -0.30387510420596439539},
                      {1.231400124018033653, -0.8808163150691950258, 3.734952654e-5, -0.29994219006116400191},
                      {1.2313431465858876468, -0.88079690983307689776, 7.522159736e-10, -0.29995596661298576606},
                      {1.2313431472543473203, -0.88079690859340827218, 0, -0.29995596671600376862}};
  const NewtonRun run = newton_raphson(n11, twenty_degrees<Fast>(), 1.22, -0.87, enough_steps);
  CHECK(run.end == NewtonEnd::converged);
  CHECK(run.reason.english.find("converged after 3 steps") == 0);
  REQUIRE(run.iterates.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    const NewtonIterate& now = run.iterates[k];
    // A few roundings of angles of size 1 and lengths below 1 m.
    CHECK(std::abs(now.q(0) - rows[k].theta_3) < 2e-15);
    CHECK(std::abs(now.q(1) - rows[k].theta_4) < 2e-15);
    CHECK(std::abs(now.q(2) - pi<Fast>() / 9) < 2e-15);
    CHECK(std::abs(now.residual_norm - rows[k].residual_norm) < 1e-9 * rows[k].residual_norm + 2e-15);
    CHECK(std::abs(now.residual_norm - std::hypot(now.residual(0), now.residual(1))) < 1e-16);
    CHECK(std::abs(now.determinant - rows[k].determinant) < 2e-15);
    if (k < 3)
      CHECK((now.q.head<2>() + now.step - run.iterates[k + 1].q.head<2>()).norm() < 1e-15);
    else
      CHECK(now.step.norm() == 0);
  }
}

TEST_CASE("constraint equations: the proved solution of N.11, as printed and to any depth",
          "[analytic][constraints]") {
  const NewtonRun run = newton_raphson(n11, twenty_degrees<Fast>(), 1.22, -0.87, enough_steps);
  {
    const Arithmetic<Bounded> scope;
    const auto q = configuration<Bounded>(n11, twenty_degrees<Bounded>(), run);
    const Enclosure theta_3 = enclosure(q.theta_3), theta_4 = enclosure(q.theta_4);
    CHECK(std::abs(theta_3.value - 1.231343147) < 5e-10);   // printed in N.10
    CHECK(std::abs(theta_4.value + 0.8807969084) < 3e-10);  // printed 0.8807969084; it is ...9086
    CHECK(theta_3.upper - theta_3.lower < 4e-15);
    CHECK(theta_4.upper - theta_4.lower < 4e-15);
  }
  for (const long bits : {64L, 128L, 1024L, 4096L}) {
    const Arithmetic<Deep> scope(bits);
    CAPTURE(bits);
    const auto q = configuration<Deep>(n11, twenty_degrees<Deep>(), run);
    CHECK(overlaps(q.theta_3, exact_decimal("1.23134314725434732031138773994690518797")));
    CHECK(arb_rel_accuracy_bits(q.theta_3.ball()) > bits - 12);
    CHECK(arb_rel_accuracy_bits(q.theta_4.ball()) > bits - 12);
  }
  CHECK(configuration<Fast>(n11, twenty_degrees<Fast>(), run).theta_3 == run.iterates.back().q(0));
}

TEST_CASE("constraint equations: the start decides the branch; whole turns do not matter",
          "[analytic][constraints]") {
  const auto crank = twenty_degrees<Fast>();
  const NewtonRun other = newton_raphson(n11, crank, -1.4, 0.6, enough_steps);
  CHECK(other.end == NewtonEnd::converged);
  CHECK(std::abs(other.iterates.back().q(0) + 1.453939572) < 5e-10);  // printed in N.10
  CHECK(std::abs(other.iterates.back().q(1) - 0.6582004834) < 1e-9);
  CHECK(other.iterates.back().determinant > 0);
  const double turn = 2 * pi<Fast>();
  const NewtonRun turned = newton_raphson(n11, crank, 1.22 + 3 * turn, -0.87 - 5 * turn, enough_steps);
  CHECK(turned.end == NewtonEnd::converged);
  CHECK(turned.iterates.back().q(0) > 3 * turn);
  const Arithmetic<Deep> scope(256);
  const auto q = configuration<Deep>(n11, twenty_degrees<Deep>(), turned);
  CHECK(std::abs(enclosure(q.theta_3).value - 1.231343147254347) < 1e-15);
  CHECK(std::abs(enclosure(q.theta_4).value + 0.880796908593408) < 1e-15);
}

TEST_CASE("constraint equations: 512 bits agree with all 40 digits of the corpus", "[analytic][constraints]") {
  const Arithmetic<Deep> scope(512);
  int agreed = 0, other_branch = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || is_undefined_motion(c)) continue;
    CAPTURE(c.name);
    const NewtonRun run = from_a_drawing(c);
    CAPTURE(run.reason.english);
    if (is_beside_a_limit(c) && (run.end != NewtonEnd::converged || !is_branch_of(c, run))) {
      ++other_branch;
      continue;
    }
    REQUIRE(run.end == NewtonEnd::converged);
    REQUIRE(is_branch_of(c, run));
    for (const auto& [name, value] : solved<Deep>(c, run)) {
      const Reference r{name, c.reference(name)};
      CAPTURE(r.name, r.value);
      if (is_whole_turn_off(name, r)) continue;
      CHECK(overlaps(value, exact_decimal(r.value)));
      if (r.value != "0") CHECK(narrow(value));
      ++agreed;
    }
  }
  std::printf("constraint equations, Deep 512: %d answers agree, %d cases beside a limit went elsewhere\n", agreed,
              other_branch);
  CHECK(agreed > 3500);
}

TEST_CASE("constraint equations: intervals contain every reference or say undecided", "[analytic][constraints]") {
  int answered = 0, undecided = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || is_undefined_motion(c)) continue;
    const NewtonRun run = from_a_drawing(c);
    const Arithmetic<Bounded> scope;
    CAPTURE(c.name, run.reason.english);
    if (run.end != NewtonEnd::converged || !is_branch_of(c, run)) continue;
    try {
      for (const auto& [name, value] : solved<Bounded>(c, run)) {
        const Reference r{name, c.reference(name)};
        CAPTURE(r.name, r.value);
        if (!is_whole_turn_off(name, r)) CHECK(overlaps(enclosure(value), exact_decimal(r.value)));
        ++answered;
      }
    } catch (const Undecided&) {
      ++undecided;
      CHECK(is_beside_a_limit(c));
    }
  }
  std::printf("constraint equations, Bounded: %d answers contain the reference, %d cases undecided\n", answered,
              undecided);
  CHECK(answered > 3500);
}

TEST_CASE("constraint equations: a singular Jacobian is recognised, not divided by", "[analytic][constraints]") {
  const auto crank = twenty_degrees<Fast>();
  for (const double theta_3 : {0.0, 1.0, -2.5})
    for (const double folded : {0.0, pi<Fast>()}) {
      const NewtonRun run = newton_raphson(n11, crank, theta_3, theta_3 + folded, enough_steps);
      CHECK(run.end == NewtonEnd::singular);
      CHECK(run.iterates.size() == 1);
      CHECK(run.reason.english.find("Jacobian is singular") != std::string::npos);
      const Arithmetic<Bounded> scope;
      CHECK_THROWS_AS(configuration<Bounded>(n11, twenty_degrees<Bounded>(), run), Undecided);
    }
}

TEST_CASE("constraint equations: almost singular flies off and says so", "[analytic][constraints]") {
  const NewtonRun run = newton_raphson(n11, twenty_degrees<Fast>(), 1, 1 + 1e-10, enough_steps);
  CHECK(run.end == NewtonEnd::diverged);
  CHECK(run.iterates.size() == 1);
  CHECK(run.reason.english.find("diverged") == 0);
}

TEST_CASE("constraint equations: too few steps are said to be too few", "[analytic][constraints]") {
  for (const int steps : {0, 1, 2}) {
    const NewtonRun run = newton_raphson(n11, twenty_degrees<Fast>(), 1.22, -0.87, steps);
    CHECK(run.end == NewtonEnd::exhausted);
    CHECK(run.iterates.size() == static_cast<std::size_t>(steps + 1));
    CHECK(run.reason.english.find("no convergence after " + std::to_string(steps) + " step") == 0);
  }
}

TEST_CASE("constraint equations: nothing is found where nothing closes", "[analytic][constraints]") {
  int open = 0;
  std::map<NewtonEnd, int> ends;
  for (const CorpusCase& c : corpus()) {
    if (closes(c) || std::stod(c.reference("closure_gap")) < 1e-8) continue;  // the rest is in line within doubles
    for (int i = 0; i < 12; ++i)
      for (int k = 0; k < 12; ++k) {
        CAPTURE(c.name, i, k);
        const NewtonRun run = newton_raphson(linkage_of(c), crank_state<Fast>(c), 0.1 + i / 2.0, 0.2 + k / 2.0, 100);
        CHECK(run.end != NewtonEnd::converged);
        ++ends[run.end];
        ++open;
      }
  }
  std::printf("constraint equations, open linkages: %d starts, %d singular, %d diverged, %d exhausted\n", open,
              ends[NewtonEnd::singular], ends[NewtonEnd::diverged], ends[NewtonEnd::exhausted]);
  CHECK(open >= 4 * 144);
}

TEST_CASE("constraint equations: at a limit of the crank no solution is proved", "[analytic][constraints]") {
  int tried = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || !is_undefined_motion(c)) continue;
    CAPTURE(c.name);
    const NewtonRun run = from_a_drawing(c);
    {
      const Arithmetic<Bounded> scope;
      CHECK_THROWS_AS(configuration<Bounded>(linkage_of(c), crank_state<Bounded>(c), run), Undecided);
    }
    const Arithmetic<Deep> scope(256);
    CHECK_THROWS_AS(configuration<Deep>(linkage_of(c), crank_state<Deep>(c), run), Undecided);
    ++tried;
  }
  CHECK(tried == 3);
}

TEST_CASE("constraint equations: exact numbers leave the answer to other routes", "[analytic][constraints]") {
  const NewtonRun run = newton_raphson(n11, twenty_degrees<Fast>(), 1.22, -0.87, enough_steps);
  {
    const Arithmetic<Exact> tower;
    const CrankState<Exact> ahead{Exact(1), Exact(0), Exact(1), Exact(0)};
    CHECK_THROWS_AS(configuration<Exact>(n11, ahead, run), Undecided);
  }
  const Arithmetic<Calcium> scope;
  CHECK_THROWS_AS(configuration<Calcium>(n11, twenty_degrees<Calcium>(), run), Undecided);
}

TEST_CASE("constraint equations: a scope of intervals around the iteration changes nothing",
          "[analytic][constraints]") {
  const auto crank = twenty_degrees<Fast>();
  const NewtonRun alone = newton_raphson(n11, crank, 1.0, -0.5, enough_steps);
  const Arithmetic<Bounded> upwards;
  const NewtonRun inside = newton_raphson(n11, crank, 1.0, -0.5, enough_steps);
  REQUIRE(alone.iterates.size() == inside.iterates.size());
  for (std::size_t k = 0; k < alone.iterates.size(); ++k) CHECK(alone.iterates[k].q == inside.iterates[k].q);
}

TEST_CASE("constraint equations: there is no frame without a length", "[analytic][constraints]") {
  CHECK_THROWS_AS(newton_raphson({1, 2, 2, 0, 0}, twenty_degrees<Fast>(), 0, 1, 5), Impossible);
}

}  // namespace epure::tests::four_bar
