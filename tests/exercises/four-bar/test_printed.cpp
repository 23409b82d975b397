// What exercise N.3 printed: each number's verdict, and mistakes that evaluate to the printed digits.
#include "tests/exercises/four-bar/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Printed& printed(const std::string& quantity, const std::string& text) {
  for (const Printed& each : four_bar().about().printed())
    if (each.quantity == quantity && each.text == text) return each;
  throw std::logic_error("nothing like it is printed");
}

PrintedVerdict verdict_on(const Printed& number) {
  static const CheckedExercise result = four_bar().checked({});
  return judge(number, find(result, number.quantity).settled);
}

struct Expected {
  std::string quantity, text;
  Verdict verdict;
  bool explained = false;
};
const std::vector<Expected>& expected() {
  using enum Verdict;
  static const std::vector<Expected> all{{"omega_2", "5.24", rounding},
                                         {"crank_angle_phi", "0.524", rounding},
                                         {"crank_angle_phi_deg", "30", rounding},
                                         {"v_A", "0.79", rounding},
                                         {"P31A", "0.36", rounding},
                                         {"P31B", "0.40", reading},
                                         {"omega_3", "2.2", rounding},
                                         {"v_B", "0.88", reading},
                                         {"omega_4", "1.95", reading},
                                         {"v_BA", "0.81", rounding},
                                         {"v_B", "0.84", reading},
                                         {"omega_4", "1.87", reading},
                                         {"gamma_deg", "42", reading},
                                         {"tan_gamma", "0.9", reading},
                                         {"alpha_3", "4.36", reading},
                                         {"alpha_4", "3.24", disagrees, true},
                                         {"KB", "0.36", disagrees, true},
                                         {"KC", "0.55", disagrees, true},
                                         {"a_B", "2.34", disagrees, true},
                                         {"a_C", "3.58", disagrees, true},
                                         {"a_A", "4.12", disagrees, true},
                                         {"a_B_n", "1.72", reading},
                                         {"a_BA_n", "1.77", reading},
                                         {"a_B_t", "1.24", reading},
                                         {"a_B", "2.16", reading},
                                         {"a_BA_t", "1.55", reading},
                                         {"alpha_3", "4.19", reading},
                                         {"alpha_4", "2.97", disagrees},
                                         {"AC", "0.33", rounding},
                                         {"a_CA_n", "1.59", reading},
                                         {"a_C_n", "1.79", disagrees, true},
                                         {"a_C_t", "0.93", disagrees},
                                         {"a_C", "3.32", reading},
                                         {"rho_C", "0.37", reading}};
  return all;
}

}  // namespace

TEST_CASE("four-bar: every printed number has the verdict it deserves", "[four-bar][printed]") {
  CHECK(expected().size() == four_bar().about().printed().size());
  for (const auto& [quantity, text, verdict, explained] : expected()) {
    CAPTURE(quantity, text);
    const PrintedVerdict judged = verdict_on(printed(quantity, text));
    CHECK(judged.verdict == verdict);
    CHECK(judged.explanation.has_value() == explained);
    CHECK(judged.explanation_holds);
    CHECK(judged.difference_percent);
  }
}

// By hand: 5.24² 0.15 = 4.11864; 2.2² 0.37 = 1.7908; 1.95² 0.9 = 3.42225; with α₃ = 4.356 and ω₃² = 4.84 the factor
// is √(18.974736 + 23.4256) = 6.511554.
TEST_CASE("four-bar: explanations are evaluated", "[four-bar][printed]") {
  const auto evaluated = [](const char* quantity, const char* text) {
    return printed(quantity, text).explanation->evaluate();
  };
  CHECK(evaluated("a_A", "4.12") == Approx(4.11864));
  CHECK(evaluated("a_C_n", "1.79") == Approx(1.7908));
  CHECK(evaluated("alpha_4", "3.24") == 3.24);
  CHECK(evaluated("a_B", "2.34") == Approx(0.36 * 6.511554));
  CHECK(evaluated("a_C", "3.58") == Approx(0.55 * 6.511554));
}

// The corpus' stationarity circle about (-0.1480709370, 0.1998895657), which passes through A = (0.1299038106,
// 0.075), met from A in the direction 210° - 42° at K = (-0.4528107, 0.1988598): by mpmath, and 1.2 times its
// distances.
TEST_CASE("four-bar: the figure's K stands under the printed angle", "[four-bar][printed]") {
  CHECK(printed("KB", "0.36").explanation->evaluate() == Approx(0.355068203607).epsilon(1e-9));
  CHECK(printed("KC", "0.55").explanation->evaluate() == Approx(0.554037933233).epsilon(1e-9));
}

TEST_CASE("four-bar: other digits get another verdict", "[four-bar][printed]") {
  Printed changed = printed("gamma_deg", "42");
  changed.text = "41";
  CHECK(verdict_on(changed).verdict == Verdict::disagrees);
  changed.text = "45";
  CHECK(verdict_on(changed).verdict == Verdict::rounding);
  changed = printed("KB", "0.36");
  changed.text = "0.30";
  CHECK(verdict_on(changed).verdict == Verdict::reading);
  changed.text = "0.37";
  CHECK_FALSE(verdict_on(changed).explanation_holds);
  for (const CheckedQuantity& quantity : four_bar().checked({"t=0.11"}).quantities) CHECK(quantity.printed.empty());
}
