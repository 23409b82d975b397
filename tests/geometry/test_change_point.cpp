// How linkages leave their change points: against angles differentiated numerically through the position
// (tests/corpus/change_points.txt), in the positions that fold, and in those that cannot move.
#include "geometry/mechanisms/change_point.h"
#include "tests/geometry/four_bar_cases.h"
#include "tests/support/catch.h"

#include <cstdio>

namespace epure::tests {
namespace {

// The one flat position of the linkage with these signs.
FlatPosition flat_position(const FourBarLengths& of, int crank, int coupler, int rocker) {
  for (const FlatPosition& flat : flat_positions(of))
    if (flat.A0A == crank * of.A0A && flat.AB == coupler * of.AB && flat.B0B == rocker * of.B0B) return flat;
  throw std::runtime_error("no such flat position");
}
int sign_given(const CorpusCase& c, const char* name) { return c.givens.at(name) > 0 ? 1 : -1; }

// (ω_2, ω_3, ω_4) leaves the hinges where the bars allow: the loop's velocity, and its acceleration along the line.
template <class T>
bool is_motion(const FlatPosition& flat, const ChangePointMotion<T>& m) {
  const auto r = [](const Rational& length) { return from_rational<T>(length); };
  return is(r(flat.A0A) * m.omega_2 + r(flat.AB) * m.omega_3, r(flat.B0B) * m.omega_4, 1e2) &&
         is(r(flat.A0A) * square(m.omega_2) + r(flat.AB) * square(m.omega_3), r(flat.B0B) * square(m.omega_4), 1e3);
}

}  // namespace

TEST_CASE("change points: both motions of the corpus, to all 40 digits", "[change-point]") {
  const Arithmetic<Deep> scope(256);
  int held = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/change_points.txt")) {
    CAPTURE(c.name, c.why);
    const FourBarLengths of = four_bar_lengths_of(c);
    const FlatPosition flat =
        flat_position(of, sign_given(c, "crank"), sign_given(c, "coupler"), sign_given(c, "rocker"));
    const FourBar<Deep> at = position<Deep>(of, flat);
    CHECK(is_closed(of, at));
    CHECK(is(at.A, at.A0 + from_rational<Deep>(of.A0A) * crank_direction<Deep>(of, flat)));
    const auto motions = change_point_motions<Deep>(flat);
    CHECK(motions[0].leaves_to == Side::left);
    CHECK(motions[1].leaves_to == Side::right);
    for (const auto& m : motions) {
      const std::string side = m.leaves_to == Side::left ? "left" : "right";
      CAPTURE(side);
      CHECK(is(m.omega_2, Deep(1)));
      const Rational omega_3 = exact_decimal(c.reference(side + ".omega_3"));
      const Rational omega_4 = exact_decimal(c.reference(side + ".omega_4"));
      CHECK(overlaps(m.omega_3, omega_3));
      CHECK(overlaps(m.omega_4, omega_4));
      if (omega_3 != 0) CHECK(narrow(m.omega_3));
      if (omega_4 != 0) CHECK(narrow(m.omega_4));
      ++held;
    }
  }
  std::printf("change points: %d motions\n", held);
  CHECK(held >= 22);
}

TEMPLATE_TEST_CASE("change points: integer sides 2, 5, 4 on 7", "[change-point]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBarLengths of = on_x(2, 5, 4, 7);
  const auto flats = flat_positions(of);
  REQUIRE(flats.size() == 1);
  CHECK(is(position<T>(of, flats[0]).A, {-2, 0}));
  CHECK(is(position<T>(of, flats[0]).B, {3, 0}));
  CHECK(is(crank_direction<T>(of, flats[0]), {-1, 0}));
  const auto motions = change_point_motions<T>(flats[0]);
  CHECK(is(motions[0].omega_4, (T(8) - root(T(280))) / T(36)));
  CHECK(is(motions[1].omega_4, (T(8) + root(T(280))) / T(36)));
  for (const auto& m : motions) CHECK(is_motion(flats[0], m));
}

// Parallelogram 3, 5: leaving stretched, the coupler only translates, or the antiparallelogram turns the rocker back.
TEMPLATE_TEST_CASE("change points: the two motions of a parallelogram", "[change-point]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBarLengths of = on_x(3, 5, 3, 5);
  CHECK(flat_positions(of).size() == 2);
  const auto stretched = change_point_motions<T>(flat_position(of, 1, 1, 1));
  CHECK(is(stretched[0].omega_3, T(0)));
  CHECK(is(stretched[0].omega_4, T(1)));
  CHECK(is(stretched[1].omega_3, T(-3)));
  CHECK(is(stretched[1].omega_4, T(-4)));
  const auto folded = change_point_motions<T>(flat_position(of, -1, 1, -1));
  CHECK(is(folded[0].omega_4, number<T>(-1, 4)));
  CHECK(is(folded[1].omega_4, T(1)));
}

// A on B0: coupler and rocker cover each other, and may turn together about B0 while the crank rests.
TEMPLATE_TEST_CASE("change points: motions that rest on a hinge", "[change-point]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // Kite 3, 5, 5 on 3: B at 8 or at -2. A moves up by 3, so the line A -> B0 turns down: B at 8 is on its left, at -2
  // on its right. With B at 8: crank and rocker turn as mirror images through the diagonal A0 B ... ω_4 = (5 + 3)/(2
  // · 5).
  const FourBarLengths kite = on_x(3, 5, 5, 3);
  CHECK(flat_positions(kite).size() == 2);
  const auto ahead = change_point_motions<T>(flat_position(kite, 1, 1, 1));
  CHECK(is(ahead[0].omega_2, T(1)));
  CHECK(is(ahead[0].omega_4, number<T>(4, 5)));
  CHECK(is(ahead[0].omega_3, number<T>(1, 5)));
  CHECK(ahead[0].leaves_to == Side::left);
  const auto back = change_point_motions<T>(flat_position(kite, 1, -1, -1));
  CHECK(is(back[0].omega_4, number<T>(1, 5)));
  CHECK(back[0].leaves_to == Side::right);
  for (const auto& motions : {ahead, back}) {
    CHECK(is(motions[1].omega_2, T(0)));
    CHECK(is(motions[1].omega_3, T(1)));
    CHECK(is(motions[1].omega_4, T(1)));
    CHECK_FALSE(motions[1].leaves_to);
  }
  for (const auto& flat : flat_positions(kite))
    for (const auto& m : change_point_motions<T>(flat)) CHECK(is_motion(flat, m));

  // Four equal links: stretched one way, folded onto the frame, and stretched the other way.
  const FourBarLengths rhombus = on_x(1, 1, 1, 1);
  const auto flats = flat_positions(rhombus);
  CHECK(flats.size() == 3);
  for (const auto& flat : flats)
    for (const auto& m : change_point_motions<T>(flat)) CHECK(is_motion(flat, m));
  const auto folded = change_point_motions<T>(flat_position(rhombus, 1, -1, -1));  // A on B0, B on A0
  CHECK(is(folded[0].omega_4, T(0)));
  CHECK(is(folded[0].omega_3, T(1)));
  CHECK(sign(folded[1].omega_2) == Sign::zero);
}

TEST_CASE("change points: stretched to the full nothing moves, and missed there is none", "[change-point]") {
  const Arithmetic<Exact> tower;
  for (const FourBarLengths& of : {on_x(1, 2, 3, 6), on_x(9, 2, 3, 4), on_x(2, 9, 3, 4), on_x(2, 3, 9, 4)}) {
    const auto flats = flat_positions(of);
    REQUIRE(flats.size() == 1);
    CHECK_THROWS_AS(change_point_motions<Exact>(flats[0]), Impossible);
  }
  for (const int exponent : {9, 15, 30}) {
    const Rational e = part(exponent);
    CHECK(flat_positions({2, 5, 4, 7, e}).empty());
    CHECK(flat_positions(on_x(2 + e, 5, 4, 7)).empty());
    CHECK(flat_positions(on_x(3, 5, 3 - e, 5)).empty());
    // Lengthened alike, the parallelogram keeps its change points.
    CHECK(flat_positions(on_x(3, 5 + e, 3, 5 + e)).size() == 2);
    CHECK(flat_positions(on_x(2 + e, 5, 4 + e, 7)).size() == 1);
  }
  CHECK(flat_positions({1, 1, 1, 1, 1}).empty());  // the frame √2
  CHECK(flat_positions(on_x(1, 1, 1, 0)).empty());
}

}  // namespace epure::tests
