// The four-bar as it is constructed - compasses, the polar diagrams of its dyad, the method of poles with
// Euler-Savary - against references differentiated numerically from positions (tests/corpus/four_bar.txt).
#include "tests/geometry/four_bar_cases.h"
#include "tests/support/catch.h"

#include <cstdio>

namespace epure::tests {
namespace {

const std::vector<CorpusCase>& positions() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/four_bar.txt");
  return cases;
}

const CorpusCase& named(const std::string& name) {
  for (const CorpusCase& c : positions())
    if (c.name == name) return c;
  throw std::runtime_error("no case " + name);
}

Side side_named(const CorpusCase& c, const char* choice) {
  return c.choices.at(choice) == "left" ? Side::left : Side::right;
}

// The linkage with its crank at the turn, or in the special position, of the case.
template <class T>
FourBar<T> constructed(const CorpusCase& c) {
  const FourBarLengths of = four_bar_lengths_of(c);
  const Side branch = side_named(c, "branch");
  const std::string at = c.choices.at("crank_at");
  if (at == "dead_centre_extended") return dead_centre<T>(of, Reach::extended, branch).at;
  if (at == "dead_centre_folded") return dead_centre<T>(of, Reach::folded, branch).at;
  if (at == "parallel_same_sense") return parallel_position<T>(of, Sense::same, branch).at;
  if (at == "parallel_opposite_sense") return parallel_position<T>(of, Sense::opposite, branch).at;
  const Turn turn{c.givens.at("turn")};
  return four_bar(of, Vector<T>{cosine<T>(turn), sine<T>(turn)}, branch);
}

template <class T>
T crank_speed(const CorpusCase& c) {
  return from_rational<T>(c.givens.at("n") / 30) * pi<T>();
}

bool does_close(const CorpusCase& c) { return c.reference("closure_gap").empty(); }
bool has_motion(const CorpusCase& c) { return does_close(c) && is_value(c.reference("omega_3")); }
bool has_finite_pole(const CorpusCase& c) { return has_motion(c) && is_value(c.reference("P0_x")); }

using Answers = std::map<std::string, Deep>;

void add(Answers& answers, const std::string& name, const Deep& x, const Deep& y) {
  answers.insert({{name + "_x", x}, {name + "_y", y}});
}

Answers by_polar_diagrams(const CorpusCase& c, const FourBar<Deep>& at, const FourBarMotion<Deep>& m) {
  const Point<Deep> C =
      right_angled_corner(at.A, at.B, c.givens.at("AB"), c.givens.at("AC"), side_named(c, "C_side"));
  Answers answers{{"omega_3", m.coupler.omega},
                  {"omega_4", m.rocker.omega},
                  {"alpha_3", m.coupler.alpha},
                  {"alpha_4", m.rocker.alpha}};
  add(answers, "A", at.A.x, at.A.y);
  add(answers, "B", at.B.x, at.B.y);
  add(answers, "C", C.x, C.y);
  const auto v_C = m.coupler.velocity(C), a_C = m.coupler.acceleration(C);
  add(answers, "v_B", m.velocity.v_X.x, m.velocity.v_X.y);
  add(answers, "v_C", v_C.x, v_C.y);
  add(answers, "a_B", m.acceleration.a_X.x, m.acceleration.a_X.y);
  add(answers, "a_C", a_C.x, a_C.y);
  answers.insert({{"a_BA_n", length(m.acceleration.first.normal)},
                  {"a_BA_t", length(m.acceleration.first.closing)},
                  {"a_B_n", length(m.acceleration.second.normal)},
                  {"a_B_t", length(m.acceleration.second.closing)}});
  return answers;
}

// From the pole on: no velocity but that of A.
Answers by_poles(const FourBar<Deep>& at, const FourBarMotion<Deep>& m) {
  const Point<Deep> P0 = finite(at.pole()), J = finite(inflection_pole_by_poles(at, P0));
  const Vector<Deep> v_A = m.crank.velocity(at.A), a_A = m.crank.acceleration(at.A);
  const PlaneMotion<Deep> coupler = motion_by_poles(P0, J, at.A, v_A, a_A);
  Answers answers{{"omega_3", coupler.omega}, {"alpha_3", coupler.alpha}};
  add(answers, "P0", P0.x, P0.y);
  add(answers, "inflection_pole", J.x, J.y);
  const Vector<Deep> v_B = coupler.velocity(at.B), a_B = coupler.acceleration(at.B);
  add(answers, "v_B", v_B.x, v_B.y);
  add(answers, "a_B", a_B.x, a_B.y);
  return answers;
}

int hold(const CorpusCase& c, const Answers& answers) {
  for (const auto& [name, value] : answers) {
    const std::string reference = c.reference(name);
    CAPTURE(c.name, c.why, name, reference);
    REQUIRE(is_value(reference));
    CHECK(overlaps(value, exact_decimal(reference)));
    if (reference != "0") CHECK(narrow(value));
  }
  return static_cast<int>(answers.size());
}

}  // namespace

TEST_CASE("four-bar: polar diagrams and poles contain all 40 digits of the references", "[four-bar]") {
  const Arithmetic<Deep> scope(1024);
  int moving = 0, with_pole = 0, held = 0;
  for (const CorpusCase& c : positions()) {
    if (!has_motion(c)) continue;
    CAPTURE(c.name);
    const FourBar<Deep> at = constructed<Deep>(c);
    const FourBarMotion<Deep> m =
        four_bar_motion(at, crank_speed<Deep>(c), from_rational<Deep>(c.givens.at("alpha_2")));
    held += hold(c, by_polar_diagrams(c, at, m));
    ++moving;
    if (!has_finite_pole(c)) continue;
    held += hold(c, by_poles(at, m));
    ++with_pole;
  }
  std::printf("four-bar: %d references, %d positions, %d of them by poles\n", held, moving, with_pole);
  CHECK(moving == 125 - 14);  // eleven do not close, three have no velocities
  CHECK(with_pole == moving - 9);
}

TEST_CASE("four-bar: a linkage that does not close is refused, a limit position has no velocities", "[four-bar]") {
  int open = 0, stuck = 0;
  for (const CorpusCase& c : positions()) {
    CAPTURE(c.name);
    if (!does_close(c)) {
      const Arithmetic<Deep> scope(512);
      CHECK_THROWS_AS(constructed<Deep>(c), Impossible);
      ++open;
    } else if (!has_motion(c)) {
      const Arithmetic<Exact> tower;
      const FourBar<Exact> at = constructed<Exact>(c);
      CHECK_THROWS_AS(four_bar_motion(at, Exact(1), Exact(0)), Impossible);
      ++stuck;
    }
  }
  CHECK(open == 11);
  CHECK(stuck == 3);
}

TEST_CASE("four-bar: where crank and rocker are parallel the coupler is proved not to turn", "[four-bar]") {
  for (const char* name : {"n3_parallel_same_sense_left", "n3_parallel_opposite_sense_right", "parallel_same_sense",
                           "parallel_opposite_sense_braking", "parallelogram"}) {
    CAPTURE(name);
    const Arithmetic<Exact> tower;
    const FourBar<Exact> at = constructed<Exact>(named(name));
    const FourBarMotion<Exact> m = four_bar_motion(at, Exact(1), Exact(2));
    CHECK(sign(at.pole().w) == Sign::zero);
    CHECK(sign(m.coupler.omega) == Sign::zero);
    CHECK(sign(m.coupler.pole().w) == Sign::zero);
  }
}

TEMPLATE_TEST_CASE("four-bar: a plate with its right angle over AB", "[four-bar]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // 3-4-5: foot 9/5 from A, height 12/5.
  const Point<T> A{1, 0}, B{6, 0};
  CHECK(is(right_angled_corner(A, B, 5, 3, Side::left), {number<T>(14, 5), number<T>(12, 5)}));
  CHECK(is(right_angled_corner(A, B, 5, 3, Side::right), {number<T>(14, 5), number<T>(-12, 5)}));
  CHECK(is(right_angled_corner(A, B, 5, 5, Side::left), B));
  CHECK_THROWS_AS(right_angled_corner(A, B, 5, 6, Side::left), Impossible);
}

}  // namespace epure::tests
