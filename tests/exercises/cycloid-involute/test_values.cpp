// Cycloid and involute: the numbers are those of a corpus that knows positions only; the cusp on both sides; the
// source's numbers and the mistakes that give them.
#include <cmath>

#include "tests/exercises/cycloid-involute/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("cycloid and involute: what is promised is reported", "[cycloid-involute]") {
  const CheckedExercise result = both().checked({});
  CHECK(result.passed());
  for (const char* name : {"cycloid.x_M", "cycloid.arch_length", "cycloid.rho_M_at_s4", "involute.P0M_t1"})
    CHECK(find(result, name).spec.unit == "m");
  for (const char* name : {"cycloid.time_at_phi", "cycloid.t_at_s4"}) CHECK(find(result, name).spec.unit == "s");
  for (const char* name : {"cycloid.phi_at_s4", "involute.phi_t2"}) CHECK(find(result, name).spec.unit == "rad");
  for (const char* name : {"cycloid.v_M", "involute.v_M_y_t2"}) CHECK(find(result, name).spec.unit == "m/s");
  for (const char* name : {"cycloid.a_t_at_s4_before_cusp", "involute.a_n_t1"})
    CHECK(find(result, name).spec.unit == "m/s^2");
}

TEST_CASE("cycloid and involute: values are the corpus', to the last bit of a double, by every route",
          "[cycloid-involute]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/cycloid_involute.txt");
  CHECK(corpus.size() == 20);
  holds_against(both(), corpus);
}

TEST_CASE("cycloid: the cusp is decided, not felt", "[cycloid-involute]") {
  const CheckedExercise at = both().checked({});
  for (const char* zero : {"v_M", "v_M_x", "v_M_y", "rho_M", "a_n", "P0M", "y_M", "curvature_centre_y"})
    for (const RouteValue& route : find(at, std::string("cycloid.") + zero + "_at_s4").routes) {
      CAPTURE(zero, route.route);
      CHECK(route.settled.kind == geometry::Settled::Kind::certain);
      CHECK(route.settled.enclosure.upper == 0);
      CHECK(route.settled.enclosure.lower == 0);
    }
  CHECK(value(at, "cycloid.a_t_at_s4_before_cusp") == -450);
  CHECK(value(at, "cycloid.a_t_at_s4_after_cusp") == 450);
  // The same to a double, and no cusp: one tangential part, a speed, a radius.
  for (const auto& [s, along] : {std::pair{"s=4.000000000000000000000000000001", 450.0},
                                 std::pair{"s=3.999999999999999999999999999999", -450.0}}) {
    const CheckedExercise beside = both().checked({s});
    CAPTURE(s);
    CHECK(value(beside, "cycloid.a_t_at_s4_before_cusp") == along);
    CHECK(value(beside, "cycloid.a_t_at_s4_after_cusp") == along);
    CHECK(value(beside, "cycloid.v_M_at_s4") > 0);
    CHECK(value(beside, "cycloid.rho_M_at_s4") > 0);
  }
}

TEST_CASE("cycloid: at a cusp of the angle the tangential part has no single value", "[cycloid-involute]") {
  for (const char* phi : {"phi=0", "phi=360", "phi=3600", "phi=5turn"}) {
    const CheckedExercise result = both().checked({phi});
    CAPTURE(phi, find(result, "cycloid.a_t").settled.reason.english);
    CHECK(result.passed());
    CHECK(find(result, "cycloid.a_t").settled.kind == geometry::Settled::Kind::absent);
    CHECK(find(result, "cycloid.a_t").settled.reason.english.find("before_cusp") != std::string::npos);
    CHECK(value(result, "cycloid.a_t_before_cusp") == -450);
    CHECK(value(result, "cycloid.a_t_after_cusp") == 450);
  }
}

TEST_CASE("cycloid: angle and arc name the same instant", "[cycloid-involute]") {
  // cos φ/2 is ±1/2, so that the arcs 4 r (1 - cos φ/2) are rational.
  for (const auto& [phi, s] :
       {std::pair{"phi=120", "s=1"}, std::pair{"phi=240", "s=3"}, std::pair{"phi=480", "s=5"}}) {
    const CheckedExercise result = both().checked({phi, s});
    CAPTURE(phi, s);
    CHECK(result.passed());
    for (const char* name : {"x_M", "y_M", "P0M", "v_M", "v_M_x", "v_M_y", "a_M_x", "a_M_y", "a_n", "rho_M",
                             "curvature_centre_x", "curvature_centre_y"})
      CHECK(value(result, std::string("cycloid.") + name) ==
            value(result, std::string("cycloid.") + name + "_at_s4"));
  }
}

TEST_CASE("cycloid and involute: what the source prints, and the mistake that gives it", "[cycloid-involute]") {
  const CheckedExercise result = both().checked({});
  const std::set<std::string> of_a_quarter_turn{"cycloid.P0M",      "cycloid.v_M", "cycloid.rho_M",
                                                "cycloid.Mprime_M", "cycloid.a_n", "cycloid.a_t"};
  int judged = 0;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      ++judged;
      const bool is_wrong = of_a_quarter_turn.contains(quantity.spec.name);
      CHECK(verdict.verdict == (is_wrong ? Verdict::disagrees : Verdict::rounding));
      CHECK(verdict.explanation_holds);
      CHECK(verdict.explanation.has_value() == is_wrong);
    }
  CHECK(judged == 17);
  for (const CheckedQuantity& quantity : both().checked({"phi=90"}).quantities) CHECK(quantity.printed.empty());
}

TEST_CASE("involute: the source's equation with the wrong sign does not give the source's speeds",
          "[cycloid-involute]") {
  // The speed of an involute is φ (times r ω). By x = r (cos φ - φ sin φ), y = r (sin φ - φ cos φ) it would be
  // sqrt((2 sin φ + φ cos φ)² + (φ sin φ)²): 2.3772 at φ = 1, 120.6 and 216.1 m/s at the two instants.
  const auto by_printed_equation = [](double phi) {
    return std::hypot(2 * std::sin(phi) + phi * std::cos(phi), phi * std::sin(phi));
  };
  CHECK(by_printed_equation(1) == Approx(2.3771597604590332129).epsilon(1e-15));  // "more than twice", says the sheet
  const CheckedExercise result = both().checked({});
  CHECK(value(result, "involute.v_M_t1") == 105);  // as the source prints it
  CHECK(value(result, "involute.v_M_t2") == 210);
}

TEST_CASE("cycloid and involute: givens that cannot be", "[cycloid-involute]") {
  for (const char* assignment : {"d=0", "d=-1", "omega_1=0", "omega_2=-50", "s=-1", "phi=-1", "t1=-1", "d_0=0"})
    CHECK_THROWS_AS(both().givens({assignment}), BadGivens);
  CHECK(both().checked({"d=1000mm", "phi=3/8turn", "s=400cm"}).givens.as_stated());
}
