// A point carried by a rolling circle: what the command line reports is the corpus', which knows positions only.
#include "tests/exercises/roulette/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::map<std::string, std::string> names{{"x", "M_x"},
                                               {"y", "M_y"},
                                               {"P0_x", "P0_x"},
                                               {"P0_y", "P0_y"},
                                               {"s", "s"},
                                               {"J_x", "inflection_pole_x"},
                                               {"v_x", "v_M_x"},
                                               {"v_y", "v_M_y"},
                                               {"J_y", "inflection_pole_y"},
                                               {"a_x", "a_M_x"},
                                               {"a_y", "a_M_y"},
                                               {"Omega_x", "curvature_centre_M_x"},
                                               {"v", "v_M"},
                                               {"a", "a_M"},
                                               {"Omega_y", "curvature_centre_M_y"},
                                               {"a_n", "a_M_n"},
                                               {"rho", "rho_M"},
                                               {"a_t_before", "a_M_t_before"},
                                               {"a_t_after", "a_M_t_after"}};

// Empty for a case beyond what a given may be: between 1e-12 and 1e12, or zero.
std::optional<Assignments> assignments_of_roulette(const CorpusCase& c) {
  Assignments all{"how=" + c.choices.at("how")};
  for (const auto& [symbol, value] : c.givens) {
    if (value != 0 && abs(value) < exact_decimal("1e-12")) return {};
    if (symbol == "turns")
      all.push_back("phi=" + geometry::to_text(Rational(360) * value));
    else
      all.push_back((symbol == "radians" ? "phi_rad" : symbol) + "=" + geometry::to_text(value));
  }
  return all;
}

}  // namespace

TEST_CASE("roulette: values are the corpus', to the last bit of a double, by every route", "[roulette]") {
  int held = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/roulettes.txt")) {
    const auto assignments = assignments_of_roulette(c);
    if (!assignments) continue;
    const CheckedExercise result = roulette().checked(*assignments);
    CAPTURE(c.name, c.why, complaints(result));
    CHECK(result.passed());
    for (const Reference& reference : c.references) {
      CAPTURE(reference.name, reference.value);
      is_the_reference(find(result, names.at(reference.name)), reference.value);
    }
    ++held;
  }
  CHECK(held == 77);
}

TEST_CASE("roulette: parts and distances fit together", "[roulette]") {
  for (const Assignments& assignments : {Assignments{},
                                         {"how=circle_on_line", "d=0.4"},
                                         {"how=circle_inside_circle", "d=1/9"},
                                         {"how=line_on_circle", "d=-0.3"}}) {
    CAPTURE(assignments);
    const CheckedExercise result = roulette().checked(assignments);
    CHECK(value(result, "v_M") == Approx(2 * value(result, "P0M")));
    CHECK(value(result, "a_M_n") == Approx(4 * value(result, "Mprime_M")));
    CHECK(std::pow(value(result, "P0M"), 2) == Approx(value(result, "rho_M") * value(result, "Mprime_M")));
    CHECK(value(result, "a_M") == Approx(std::hypot(value(result, "a_M_n"), value(result, "a_M_t_after"))));
  }
}

TEST_CASE("roulette: a circle that cannot roll so is refused with the values", "[roulette]") {
  CHECK_THROWS_WITH(roulette().checked({"how=circle_inside_circle", "r=0.45"}), Contains("r < R"));
  CHECK_THROWS_WITH(roulette().checked({"d=-0.1"}), Contains("d = -1/10 m"));
  CHECK(roulette().checked({"how=line_on_circle", "d=-0.1"}).passed());
}

TEST_CASE("roulette: at a cusp the tangential acceleration has two values, without turning none", "[roulette]") {
  const CheckedExercise cusp = roulette().checked({"phi=480"});
  CHECK(value(cusp, "v_M") == 0);
  CHECK(value(cusp, "rho_M") == 0);
  CHECK(value(cusp, "a_M_t_before") == -0.45);  // ω² r R/(R + r) = 4 · 9/80
  CHECK(value(cusp, "a_M_t_after") == 0.45);
  const CheckedExercise still = roulette().checked({"omega=0"});
  CHECK(still.passed());
  CHECK(find(still, "a_M_t_after").settled.reason.english.find("does not turn") != std::string::npos);
  const CheckedExercise straight = roulette().checked({"how=circle_inside_circle", "R=0.3"});
  CHECK(straight.passed());
  CHECK(find(straight, "rho_M").settled.kind == geometry::Settled::Kind::absent);
}
