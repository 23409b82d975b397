// The analytic four-bar against references measured on positions alone (tests/corpus/make_four_bar.py), and against
// what can be seen without any computation.
#include "tests/geometry/answers_against_corpus.h"
#include "tests/geometry/four_bar_answers.h"
#include "tests/support/catch.h"

#include <cmath>
#include <cstdio>

namespace epure::tests::four_bar {
namespace {

using namespace analytic;

// Cases that turn on a zero that comes about by cancelling, which no ball can tell from a small number: crank and
// rocker parallel (ω₃ = 0), coupler and rocker in line. Exact decides them, below.
bool stands_on_a_zero(const CorpusCase& c) {
  if (c.choices.at("crank_at").rfind("parallel", 0) == 0 || c.name == "parallelogram" || c.name == "change_point")
    return true;
  return c.givens.count("turn") == 1 && c.givens.at("turn") == 0 &&
         (c.name.rfind("parallel", 0) == 0 || c.name.rfind("limit", 0) == 0);
}

// An angle of π: a ball reaches across the cut of the arc tangent.
bool is_on_the_cut(const Reference& r) { return r.value.rfind("3.14159265358979", 0) == 0; }

const CorpusCase& case_named(const std::string& name) {
  for (const CorpusCase& c : corpus())
    if (c.name == name) return c;
  throw std::runtime_error("no case " + name);
}

// Exact can run the case: a crank direction of one root at most, and lengths and decisions that need no π.
bool is_constructible(const CorpusCase& c) {
  if (c.givens.at("alpha_2") != 0) return false;
  return c.givens.count("turn") == 0 || (c.givens.at("turn") * 24).denominator() == 1;
}

template <class T>
void open_scene(const CorpusCase& c) {
  scene_of<T>(c, T(1));
}

// A reference of the special positions by its name in the corpus: `POSITION_BRANCH.ANGLE` or `QUANTITY_BRANCH`.
template <class T>
T special_answer(const FourBar& g, const std::string& name) {
  const bool is_left = name.find("_left") != std::string::npos;
  const Branch branch = is_left ? Branch::left : Branch::right;
  const auto is = [&](const std::string& start) { return name.rfind(start, 0) == 0; };
  if (is("rocker_swing")) return rocker_stroke<T>(g, branch).swing;
  if (is("crank_rotation")) return rocker_stroke<T>(g, branch).crank_rotation;
  if (is("time_ratio")) return rocker_stroke<T>(g, branch).time_ratio;
  const auto direction = [&]() -> Complex<T> {
    if (is("crank_limit")) {
      const auto limits = crank_limits<T>(g, is("crank_limit_extended") ? CrankLimit::extended : CrankLimit::folded);
      return is_left ? limits.left : limits.right;
    }
    if (is("dead_centre_extended")) return crank_at_dead_centre<T>(g, DeadCentre::extended, branch);
    if (is("dead_centre_folded")) return crank_at_dead_centre<T>(g, DeadCentre::folded, branch);
    if (is("parallel_same_sense")) return crank_parallel_to_rocker<T>(g, Parallel::same_sense, branch);
    return crank_parallel_to_rocker<T>(g, Parallel::opposite_sense, branch);
  };
  const Complex<T> u = direction();
  if (name.find(".crank_angle") != std::string::npos) return arc_tangent(u.im, u.re);
  const Complex<T> w = position(g, crank_along<T>(u, T(1), T(0)), branch).rocker;
  return arc_tangent(w.im, w.re);
}

}  // namespace

TEST_CASE("four-bar: 512 bits agree with all 40 digits of every reference", "[analytic][four-bar]") {
  const Arithmetic<Deep> scope(512);
  int agreed = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c)) continue;
    Answers<Deep> answers;
    CAPTURE(c.name, c.why);
    try {
      answers = answers_of<Deep>(c);
    } catch (const Undecided&) {
      CHECK(stands_on_a_zero(c));
      continue;
    }
    for (const Reference& r : c.references) {
      CAPTURE(r.name, r.value);
      const Outcome<Deep> found = ask(answers, r.name);
      if (found.kind == Kind::undecided && (stands_on_a_zero(c) || is_on_the_cut(r))) continue;
      REQUIRE(found.kind == expected_kind(r.value));
      if (found.kind != Kind::value) continue;
      CHECK(overlaps(*found.value, exact_decimal(r.value)));
      if (r.value != "0") CHECK(narrow(*found.value));
      ++agreed;
    }
  }
  CHECK(agreed > 12000);
}

TEST_CASE("four-bar: intervals contain every reference or say undecided", "[analytic][four-bar]") {
  const auto [answered, undecided] =
      intervals_contain_references(corpus(), answers_of<Bounded>, [](const CorpusCase&) { return true; });
  std::printf("four-bar, Bounded: %d answers contain the reference, %d undecided\n", answered, undecided);
  CHECK(answered > 6 * undecided);
}

TEST_CASE("four-bar: intervals of the sources' cases are narrower than 1e-11", "[analytic][four-bar]") {
  const Arithmetic<Bounded> scope;
  for (const char* name : {"n3", "n10"})
    intervals_are_narrow(case_named(name), answers_of<Bounded>(case_named(name)), 1e-11);
}

// Beside a dead centre a component is the small difference of large ones, beside a limit of the crank everything:
// that is what the intervals are for, so only the sources' own cases are a promise.
TEST_CASE("four-bar: what double costs", "[analytic][four-bar]") {
  for (const CorpusCase& c : corpus()) {
    if (!closes(c)) continue;
    std::pair<double, std::string> found{0, "does not close by its doubles"};
    try {
      found = worst_of_doubles(c, answers_of<Fast>(c));
    } catch (const Impossible&) {
    }
    const auto& [worst, where] = found;
    std::printf("four-bar, Fast: %-34s worst relative error %.1e (%s)\n", c.name.c_str(), worst, where.c_str());
    if (c.name == "n3" || c.name == "n10") CHECK(worst < 2e-13);
  }
}

TEST_CASE("four-bar: exact numbers decide every case of a constructible crank", "[analytic][four-bar]") {
  int decided = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || !is_constructible(c)) continue;
    const Arithmetic<Deep> scope(512);
    decided +=
        exact_numbers_decide(c, [](const CorpusCase& of) { return answers_without_angles<Exact>(of, Exact(1)); });
  }
  std::printf("four-bar, Exact: %d answers decided\n", decided);
  CHECK(decided > 2000);
}

TEST_CASE("four-bar: the special positions of every linkage, and their absence", "[analytic][four-bar]") {
  const Arithmetic<Deep> scope(256);
  int present = 0, absent = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/four_bar_special.txt")) {
    const FourBar g = linkage_of(c);
    for (const Reference& r : c.references) {
      CAPTURE(c.name, r.name, r.value);
      std::optional<Deep> found;
      try {
        found = special_answer<Deep>(g, r.name);
      } catch (const Impossible&) {
      } catch (const Undecided&) {
        CHECK(is_on_the_cut(r));
        continue;
      }
      REQUIRE(found.has_value() == (r.value != "absent"));
      found ? ++present : ++absent;
      if (!found) continue;
      CHECK(overlaps(*found, exact_decimal(r.value)));
      if (r.value != "0") CHECK(narrow(*found));
    }
  }
  CHECK(present > 150);
  CHECK(absent > 100);
}

TEST_CASE("four-bar: special positions close, on their branch, and are proved special", "[analytic][four-bar]") {
  for (const char* name : {"n3", "n10", "n10_tilted"})
    for (const Branch branch : {Branch::left, Branch::right}) {
      const Arithmetic<Exact> tower;
      const FourBar g = linkage_of(case_named(name));
      const auto at = [&](const Complex<Exact>& u) {
        const auto crank = crank_along<Exact>(u, Exact(1), Exact(0));
        const auto p = position(g, crank, branch);
        return std::pair{p, motion(g, crank, p)};
      };
      const Exact ratio = from_rational<Exact>(g.A0A / g.B0B);
      for (const DeadCentre which : {DeadCentre::extended, DeadCentre::folded}) {
        const auto [p, m] = at(crank_at_dead_centre<Exact>(g, which, branch));
        CHECK(sign(cross(p.crank, p.coupler)) == Sign::zero);
        CHECK((sign(dot(p.crank, p.coupler)) == Sign::positive) == (which == DeadCentre::extended));
        CHECK(sign(m.omega_4) == Sign::zero);
        CHECK(sign(m.alpha_4) != Sign::zero);
      }
      for (const Parallel sense : {Parallel::same_sense, Parallel::opposite_sense}) {
        const auto [p, m] = at(crank_parallel_to_rocker<Exact>(g, sense, branch));
        CHECK(sign(cross(p.crank, p.rocker)) == Sign::zero);
        CHECK(sign(m.omega_3) == Sign::zero);
        CHECK(sign(m.omega_4 - (sense == Parallel::same_sense ? ratio : -ratio)) == Sign::zero);
        CHECK_FALSE(coupler(p, m).pole());
      }
    }
}

TEST_CASE("four-bar: at a limit of the crank both branches meet and nothing moves", "[analytic][four-bar]") {
  const Arithmetic<Exact> tower;
  const FourBar g = linkage_of(case_named("long_crank_left"));
  for (const CrankLimit which : {CrankLimit::extended, CrankLimit::folded}) {
    const MirroredCranks<Exact> limits = crank_limits<Exact>(g, which);
    for (const Complex<Exact>& u : {limits.left, limits.right}) {
      const auto crank = crank_along<Exact>(u, Exact(1), Exact(0));
      const auto left = position(g, crank, Branch::left), right = position(g, crank, Branch::right);
      CHECK(sign(squared_modulus(left.B - right.B)) == Sign::zero);
      CHECK((sign(dot(left.coupler, left.rocker)) == Sign::negative) == (which == CrankLimit::extended));
      CHECK_THROWS_AS(motion(g, crank, left), Impossible);
    }
  }
}

TEST_CASE("four-bar: Grashof's class of every linkage", "[analytic][four-bar]") {
  const std::map<std::string, Mobility> named = {
      {"crank_rocker", Mobility::crank_rocker},   {"rocker_crank", Mobility::rocker_crank},
      {"double_crank", Mobility::double_crank},   {"double_rocker", Mobility::double_rocker},
      {"triple_rocker", Mobility::triple_rocker}, {"change_point", Mobility::change_point}};
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/four_bar_special.txt")) {
    CAPTURE(c.name);
    CHECK(mobility(linkage_of(c)) == named.at(c.choices.at("mobility")));
  }
  const auto links = [](int a, int b, int c, int f) { return FourBar{a, b, c, f, 0}; };
  CHECK(mobility(links(2, 5, 2, 5)) == Mobility::change_point);  // parallelogram
  CHECK(mobility(links(2, 2, 5, 5)) == Mobility::change_point);  // kite
  CHECK(mobility(links(1, 4, 5, 8)) == Mobility::change_point);  // 1 + 8 = 4 + 5
  // 1 + √50 < 4.04 + 4.04 < 1 + √51: decided by comparing squares.
  const Rational rod(404, 100);
  CHECK(mobility({1, rod, rod, 5, 5}) == Mobility::crank_rocker);
  CHECK(mobility({1, rod, rod, 7, Rational(142, 100)}) == Mobility::triple_rocker);
  CHECK_THROWS_AS(mobility(links(1, 2, 3, 6)), Impossible);
  CHECK_THROWS_AS(mobility(links(1, 2, 3, 7)), Impossible);
  CHECK_THROWS_AS(mobility(links(9, 2, 3, 4)), Impossible);
  CHECK_THROWS_AS(mobility(links(1, 2, 3, 0)), Impossible);
}

TEST_CASE("four-bar: a linkage that does not close says by how much", "[analytic][four-bar]") {
  int open = 0;
  for (const CorpusCase& c : corpus()) {
    if (closes(c)) continue;
    ++open;
    const double gap = std::stod(c.reference("closure_gap"));
    const auto complains = [&](const auto& position) {
      try {
        position();
        FAIL(c.name + " closes");
      } catch (const Impossible& refusal) {
        const std::string text = refusal.what();
        const auto at = text.find("short by ");
        REQUIRE(at != std::string::npos);
        CAPTURE(c.name, text);
        CHECK(std::abs(std::stod(text.substr(at + 9)) / gap - 1) < 1e-5);
        CHECK((text.find("come no nearer") != std::string::npos) ==
              (c.name == "open_near" || c.name.rfind("limit_folded", 0) == 0));
      }
    };
    complains([&] {
      const Arithmetic<Deep> scope(256);
      open_scene<Deep>(c);
    });
    if (c.name != "open_far" && c.name != "open_near") continue;
    complains([&] { open_scene<Fast>(c); });
    complains([&] {
      const Arithmetic<Bounded> scope;
      open_scene<Bounded>(c);
    });
    complains([&] {
      const Arithmetic<Exact> tower;
      open_scene<Exact>(c);
    });
  }
  CHECK(open >= 11);
}

TEST_CASE("four-bar: what has no position is refused", "[analytic][four-bar]") {
  const Arithmetic<Exact> tower;
  const CrankState<Exact> ahead{Exact(1), Exact(0), Exact(1), Exact(0)};
  const auto at = [&](const FourBar& g) { return position(g, ahead, Branch::left); };
  CHECK_THROWS_AS(at({1, 2, 2, 0, 0}), Impossible);  // no frame
  CHECK_THROWS_AS(at({1, 2, 2, 1, 0}), Impossible);  // A on B0, B anywhere around it
  CHECK_THROWS_AS(at({1, 2, 3, 1, 0}), Impossible);  // A on B0, does not close
  CHECK_THROWS_AS(crank_parallel_to_rocker<Exact>({2, 3, 2, 3, 0}, Parallel::same_sense, Branch::left), Impossible);
  CHECK_THROWS_AS(crank_at_dead_centre<Exact>({2, 2, 3, 3, 0}, DeadCentre::folded, Branch::left), Impossible);
  CHECK_THROWS_AS(rocker_stroke<Fast>({3, 3, 3, 1, 0}, Branch::left), Impossible);  // double crank
}

TEST_CASE("four-bar: a square and a 3-4-5 triangle, by eye", "[analytic][four-bar]") {
  const Arithmetic<Exact> tower;
  // Unit square A0 A B B0, the crank upright: B on the left of A -> B0, and it only shifts.
  const FourBar square_links{1, 1, 1, 1, 0};
  const CrankState<Exact> upright{Exact(0), Exact(1), Exact(2), Exact(3)};
  const auto p = position(square_links, upright, Branch::left);
  CHECK(sign(squared_modulus(p.B - Complex<Exact>{Exact(1), Exact(1)})) == Sign::zero);
  const auto m = motion(square_links, upright, p);
  CHECK(sign(m.omega_3) == Sign::zero);
  CHECK(sign(m.alpha_3) == Sign::zero);
  CHECK(sign(m.omega_4 - Exact(2)) == Sign::zero);
  CHECK(sign(m.alpha_4 - Exact(3)) == Sign::zero);
  // The other branch folds the square onto A0 A: B on A0, coupler and rocker at right angles.
  CHECK(sign(squared_modulus(position(square_links, upright, Branch::right).B)) == Sign::zero);
  // Right angle at C over AB = 5 with AC = 4: foot 16/5 from A, height 12/5.
  const FourBar g{1, 5, 3, 4, 0};
  for (const Side side : {Side::left, Side::right}) {
    const auto C = right_angled_plate_point<Exact>(g, 4, side);
    CHECK(sign(C.re - from_rational<Exact>({16, 5})) == Sign::zero);
    CHECK(sign(C.im - from_rational<Exact>(side == Side::left ? Rational(12, 5) : Rational(-12, 5))) == Sign::zero);
  }
  CHECK(sign(right_angled_plate_point<Exact>(g, 5, Side::left).im) == Sign::zero);
  CHECK_THROWS_AS(right_angled_plate_point<Exact>(g, Rational(51, 10), Side::left), Impossible);
}

}  // namespace epure::tests::four_bar
