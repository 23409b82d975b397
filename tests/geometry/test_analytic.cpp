// The analytic route against references that were differentiated numerically from positions (tests/corpus).
#include "tests/geometry/answers_against_corpus.h"
#include "tests/geometry/slider_crank_answers.h"
#include "tests/support/catch.h"

#include <cmath>
#include <cstdio>

namespace epure::tests {

TEST_CASE("corpus: it reads, and an empty or missing one does not", "[analytic]") {
  CHECK(corpus().size() >= 100);
  CHECK_THROWS(read_corpus("/dev/null"));
  CHECK_THROWS(read_corpus(EPURE_CORPUS "/no_such_file.txt"));
  CHECK(exact_decimal("-0.0125e2") == Rational(-5, 4));
  CHECK_THROWS(exact_decimal("12x"));
}

TEST_CASE("slider-crank: 512 bits agree with all 40 digits of every reference", "[analytic]") {
  // 256 would do, but for one centre of curvature that is 1e-88 m off the guide.
  const Arithmetic<Deep> scope(512);
  for (const CorpusCase& c : corpus()) {
    if (!closes(c)) continue;
    // A ball that touches zero cannot tell whether the coupler reaches the guide; Exact does, below.
    if (c.givens.at("e") != 0 && c.reference("omega_3") == "undefined") continue;
    const Answers<Deep> answers = answers_of<Deep>(c);
    for (const Reference& r : c.references) {
      CAPTURE(c.name, c.why, r.name, r.value);
      const Outcome<Deep> found = ask(answers, r.name);
      // l = r: α₃ = 0 by cancellation, which no ball can tell from a small number. Exact and Calcium do, below.
      if (c.givens.at("l") == c.givens.at("r") && r.name.rfind("stationarity", 0) == 0 &&
          found.kind == Kind::undecided)
        continue;
      REQUIRE(found.kind == expected_kind(r.value));
      if (found.kind != Kind::value) continue;
      CHECK(overlaps(*found.value, exact_decimal(r.value)));
      if (r.value != "0") CHECK(narrow(*found.value));
    }
  }
}

TEST_CASE("slider-crank: intervals contain every reference or say undecided", "[analytic]") {
  const auto [answered, undecided] = intervals_contain_references(
      corpus(), answers_of<Bounded>, [](const CorpusCase& c) { return c.name != "source"; });
  std::printf("slider-crank, Bounded: %d answers contain the reference, %d undecided\n", answered, undecided);
  CHECK(answered > 40 * undecided);
}

TEST_CASE("slider-crank: intervals of the source's case are narrower than 1e-12", "[analytic]") {
  const Arithmetic<Bounded> scope;
  intervals_are_narrow(corpus().front(), answers_of<Bounded>(corpus().front()), 1e-12);
}

// Where a component is the small difference of large ones (beside a dead centre, beside the upright crank) it has no
// correct digit left: that is what the intervals are for, so only the source's own case is a promise.
TEST_CASE("slider-crank: what double costs", "[analytic]") {
  for (const CorpusCase& c : corpus()) {
    if (!closes(c)) continue;
    const auto [worst, where] = worst_of_doubles(c, answers_of<Fast>(c));
    std::printf("slider-crank, Fast: %-28s worst relative error %.1e (%s)\n", c.name.c_str(), worst, where.c_str());
    if (c.name == "source") CHECK(worst < 1e-13);
  }
}

TEST_CASE("slider-crank: exact numbers decide every case of a constructible crank", "[analytic]") {
  int decided = 0;
  for (const CorpusCase& c : corpus()) {
    // Lengths and decisions do not depend on the speed when α₂ = 0: no π is needed.
    if (!closes(c) || c.givens.at("alpha_2") != 0 || (turn_of(c).turns * 24).denominator() != 1) continue;
    if ((c.givens.at("delta") / 15).denominator() != 1) continue;
    const Arithmetic<Deep> scope(256);
    decided +=
        exact_numbers_decide(c, [](const CorpusCase& of) { return answers_without_angles<Exact>(of, Exact(1)); });
  }
  CHECK(decided > 1000);
}

TEST_CASE("slider-crank: Calcium proves that equal lengths turn the coupler steadily", "[analytic]") {
  const Arithmetic<Calcium> scope;
  for (const CorpusCase& c : corpus()) {
    if (c.name != "equal_lengths") continue;
    const Scene<Calcium> s = scene_of<Calcium>(c, Calcium(1));
    CHECK(sign(s.motion().omega_3 + Calcium(1)) == Sign::zero);
    CHECK(sign(s.motion().alpha_3) == Sign::zero);
    CHECK_FALSE(s.coupler().stationarity_circle());
    return;
  }
  FAIL("no such case");
}

TEST_CASE("slider-crank: a linkage that does not close says by how much", "[analytic]") {
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
      }
    };
    complains([&] {
      const Arithmetic<Deep> scope(128);
      scene_of<Deep>(c, Deep(1));
    });
    if (c.name == "short_coupler_open") {  // short by 0.2 m exactly
      complains([&] { scene_of<Fast>(c, 1.0); });
      complains([&] {
        const Arithmetic<Bounded> scope;
        scene_of<Bounded>(c, Bounded(1));
      });
      complains([&] {
        const Arithmetic<Exact> tower;
        scene_of<Exact>(c, Exact(1));
      });
    }
  }
  CHECK(open >= 4);
}

TEST_CASE("slider-crank: sides that close no plate are refused", "[analytic]") {
  using analytic::plate_point;
  CHECK_THROWS_AS(plate_point<Fast>({{1, 5}, {1, 2}, {1, 10}, {3, 10}}), Impossible);
  CHECK_THROWS_AS(plate_point<Fast>({{1, 5}, {1, 2}, {9, 10}, {3, 10}}), Impossible);
  const auto flat = plate_point<Fast>({{1, 10}, {3, 10}, {1, 10}, {1, 5}});
  CHECK(flat.im == 0.0);
}

TEST_CASE("polodes and coupler curves: closed forms lie on their implicit curves", "[analytic]") {
  const Arithmetic<Deep> scope(512);
  const auto vanishes = [](const Deep& residual, const Deep& scale) {
    const Deep tiny = from_rational<Deep>(exact_decimal("1e-120")) * scale;
    return sign(residual - tiny) == Sign::negative && sign(residual + tiny) == Sign::positive;
  };
  const auto differs = [](const Deep& residual) {
    return sign(residual) == Sign::negative || sign(residual) == Sign::positive;
  };
  int polodes = 0, curves = 0;
  for (const CorpusCase& c : corpus()) {
    if (!closes(c) || c.reference("omega_3") == "undefined") continue;
    CAPTURE(c.name);
    const Scene<Deep> s = scene_of<Deep>(c, Deep(1));
    const Deep l = from_rational<Deep>(s.linkage.l);
    const auto fixed = analytic::fixed_polode(s.crank, s.place);
    const auto moving = analytic::moving_polode(s.linkage, s.crank, s.place);
    const auto pole = s.coupler().pole();
    REQUIRE(fixed.has_value() == pole.has_value());
    REQUIRE(moving.has_value() == pole.has_value());
    if (pole) {
      const Deep size = square(l) + squared_modulus(*pole);
      const auto from_guide = [&](const Complex<Deep>& z) { return analytic::seen_from_guide(s.linkage, z); };
      CHECK(vanishes(squared_modulus(*fixed - *pole), size));
      CHECK(vanishes(squared_modulus(s.place.A + *moving * s.place.theta - *pole), size));
      const Deep size6 = size * size * size;
      CHECK(vanishes(analytic::fixed_polode_residual(s.linkage, from_guide(*fixed)), size6));
      CHECK(vanishes(analytic::moving_polode_residual(s.linkage, *moving), square(size6)));
      // Beside the curve they do not vanish, however far away the pole is.
      const Complex<Deep> aside{l / Deep(8), l / Deep(5)};
      CHECK(differs(analytic::fixed_polode_residual(s.linkage, from_guide(*fixed) + aside)));
      CHECK(differs(analytic::moving_polode_residual(s.linkage, *moving + aside)));
      ++polodes;
    }
    const Complex<Deep> w = analytic::plate_point<Deep>(s.linkage);
    const Complex<Deep> to_M{from_rational<Deep>(s.linkage.l / 2), Deep(0)};
    const Deep l2 = square(l), size6 = l2 * l2 * l2 + l2 * square(squared_modulus(w));
    for (const auto& [at, z] : {std::pair{w, s.place.C}, std::pair{to_M, s.place.M}}) {
      CHECK(vanishes(squared_modulus(analytic::coupler_curve(s.place, at) - z), l2));
      CHECK(
          vanishes(analytic::coupler_curve_residual(s.linkage, at, analytic::seen_from_guide(s.linkage, z)), size6));
      const Complex<Deep> off = z + Complex<Deep>{l / Deep(7), l / Deep(9)};
      CHECK(!vanishes(analytic::coupler_curve_residual(s.linkage, at, analytic::seen_from_guide(s.linkage, off)),
                      size6));
      ++curves;
    }
  }
  CHECK(polodes > 75);
  CHECK(curves > 170);
}

}  // namespace epure::tests
