// The landing: its numbers are those of a corpus of integrals over the speed, the source's numbers, bad givens,
// sheets.
#include <algorithm>
#include <cmath>

#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& landing() {
  static const Tried tried("aircraft-landing");
  return tried;
}
const std::vector<CorpusCase>& corpus() {
  static const auto read = read_corpus(EPURE_CORPUS "/landing.txt");
  return read;
}

}  // namespace

TEST_CASE("landing: values are the corpus', to the last bit of a double, by every route", "[landing]") {
  CHECK(corpus().size() == 10);
  holds_against(landing(), corpus());
}

TEST_CASE("landing: what the source printed, and why it is wrong where it is", "[landing]") {
  const CheckedExercise result = landing().checked({});
  CHECK(result.passed());
  const Judged prints = judged(result);
  CHECK(prints.rounding == 2);
  CHECK(prints.explained == 2);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("landing: beside uniform braking nothing cancels", "[landing]") {
  // f_r c_y + c_x is zero, or misses it by the last digits.
  const double exact = value(landing().checked({"c_y=-2"}), "wheel_angle_s");
  for (const char* beside : {"c_y=-2.000000001", "c_y=-1.999999999999999999999999999999"}) {
    const CheckedExercise result = landing().checked({beside});
    CAPTURE(beside);
    CHECK(result.passed());
    CHECK(value(result, "wheel_angle_s") == Approx(exact).epsilon(1e-8));
  }
}

TEST_CASE("landing: adherence at its limit is decided exactly", "[landing]") {
  // Without drag F'/N = f_v M/(M + J_r/R²): with these, 1/1000 · 9060/9085 exactly.
  const Assignments at_limit{"c_x=0", "J_r=4", "f_a=9060/9085000"};
  CHECK(value(landing().checked(at_limit), "adheres") == 1);
  for (const auto& [less, adheres] : {std::pair("9060/9085000", 1), {"0.000997248211337369290038525", 0}}) {
    const CheckedExercise result = landing().checked({"c_x=0", "J_r=4", std::string("f_a=") + less});
    CHECK(result.passed());
    CHECK(value(result, "adheres") == adheres);
  }
}

TEST_CASE("landing: a step that ends slip exactly", "[landing]") {
  const Assignments constant{"c_x=0", "c_y=0", "f_v=0", "f_r=1",   "g=1",       "m_a=39",
                             "m_r=1", "R=1",   "J_r=8", "v_0=216", "Delta_t=10"};
  // a = -1, ω' = 5: 60 m/s fall by 6 a second, so at step 100 of 0.1 s.
  const CheckedExercise result = landing().checked(constant);
  CHECK(result.passed());
  CHECK(value(result, "euler_1ms.steps") == 100);
  CHECK(value(result, "euler_1ms.t_s") == 10);
  CHECK(value(result, "t_s") == 10);
}

TEST_CASE("landing: what is not there", "[landing]") {
  is_absent(landing(), {"v_0=30"}, "v_10ms", "slip has ended by then");
  is_absent(landing(), {"v_0=30"}, "euler_1ms.v_20", "slip has ended before");
  is_absent(landing(), {"c_y=20"}, "flap_lift.t_s", "only below 66.6628 m/s");
  is_absent(landing(), {"Delta_t=0.0001"}, "euler_100us.steps", "more than 20000 steps");
}

TEST_CASE("landing: givens that cannot be, each in one sentence", "[landing]") {
  is_refused(landing(), {"f_r=0.001"}, "slip never ends");
  is_refused(landing(), {"c_y=-20"}, "only below 66.6628 m/s");
  is_refused(landing(), {"rim_0=70"}, "spins faster");
  is_refused(landing(), {"v_0=60m/s", "rim_0=60"}, "already rolls");
  is_refused(landing(), {"m_a=-1"}, "must be positive");
  is_refused(landing(), {"v_0=0"}, "must be positive");
  CHECK(landing().checked({"f_r=0.001000001"}).passed());
  CHECK(landing().checked({"rim_0=69.4444444444444444444444444444444"}).passed());
}

namespace {
std::string told(const std::string& sheet, const Assignments& given, Language language = Language::english) {
  return told_on(landing(), sheet, given, language);
}
std::size_t drawn_of(const Assignments& given, const std::string& curve) {
  std::size_t found = 0;
  for (const drawings::Mark& mark : landing().draw("euler", given).sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark)) found += line->name.starts_with(curve);
  return found;
}
}  // namespace

TEST_CASE("landing: what is told of Euler's steps holds for these givens", "[landing][sheets]") {
  CHECK_THAT(told("euler", {}), Contains("already runs") && Contains("had ended within the step"));
  CHECK_THAT(told("euler", {"Delta_t=0.01"}), Contains("of the aircraft's speed; slip ends later"));
  CHECK_THAT(told("euler", {"Delta_t=0.01"}, Language::italian), Contains("lo strisciamento finisce dopo"));
  CHECK_THAT(told("euler", {"Delta_t=10"}), Contains("no longer go ahead"));
  // 431 and 4308 steps, of which one corner in 11 is drawn; and more than are carried out.
  CHECK_THAT(told("euler", {"Delta_t=0.005"}), Contains("one corner in 11"));
  CHECK(drawn_of({"Delta_t=0.005"}, "euler_1000") > 0);
  CHECK_THAT(told("euler", {"Delta_t=0.0001"}), Contains("more than 20000 steps, not carried out"));
  CHECK(drawn_of({"Delta_t=0.0001"}, "euler_1000") == 0);
}

TEST_CASE("landing: what a wheel that turned before has taken is less than what it has", "[landing][sheets]") {
  CHECK_THAT(told("slip", {}), Contains("as much, if"));
  CHECK_THAT(told("slip", {"rim_0=60"}), Contains("which had") && !Contains("as much"));
}

TEST_CASE("landing: a ruler reads the hub's force off the wheel's polygon", "[landing][sheets]") {
  for (const Assignments& given : {Assignments{}, {"m_r=3000", "rim_0=20"}, {"J_r=250", "c_y=-18"}}) {
    ruler_reads(landing(), {"wheel", {"N_0", "F_0", "hub_force_0", "N_s", "hub_force_after"}}, given);
    const CheckedExercise result = landing().checked(given);
    CHECK(value(result, "hub_force_0") > value(result, "F_0"));
  }
}

TEST_CASE("landing: every sheet is drawn, whatever is given", "[landing][sheets]") {
  draws_every_sheet(landing(), corpus());
}

TEST_CASE("landing: letters find room", "[landing][sheets]") {
  letters_find_room(landing(), {{}, {"c_y=-2"}, {"J_r=400", "Delta_t=0.7"}});
}

TEST_CASE("landing: the wheel's polygon is that of the solution, side by side", "[landing][sheets]") {
  // The stated wheel is so light that its weight is a dot.
  ruler_reads(landing(), {"wheel", {"wheel_weight", "wheel_inertia_0"}}, {"m_r=3000", "rim_0=20"});
  const CheckedExercise result = landing().checked({});
  for (const std::string name : {"wheel_weight", "wheel_inertia_0", "wheel_inertia_after"})
    CHECK_FALSE(find(result, name).on_sheets.empty());
  for (const std::string hub : {"hub_force_0", "hub_force_after"})
    CHECK(std::hypot(value(result, hub + "_x"), value(result, hub + "_y")) == Approx(value(result, hub)));
}

// dt = -dv/(A + B v²), in doubles.
TEST_CASE("landing: the polygon of times is off by no more than is told, and not by much less", "[landing]") {
  const CheckedExercise result = landing().checked({});
  const double v_0 = value(result, "v_0"), v_s = value(result, "v_s"), t_s = value(result, "t_s"),
               a_0 = value(result, "a_0"), a_s = value(result, "a_s");
  const double B = (a_s - a_0) / (v_0 * v_0 - v_s * v_s), A = -a_0 - B * v_0 * v_0;
  const auto time_down_to = [&](double v) {
    return (std::atan(v_0 * std::sqrt(B / A)) - std::atan(v * std::sqrt(B / A))) / std::sqrt(A * B);
  };
  const auto speed_after = [&](double t) {
    return std::sqrt(A / B) * std::tan(std::atan(v_0 * std::sqrt(B / A)) - t * std::sqrt(A * B));
  };
  double most = 0;
  for (int i = 0; i < 6; ++i) {
    const double fast = speed_after(t_s * i / 6), slow = speed_after(t_s * (i + 1) / 6);
    for (int k = 0; k <= 100; ++k) {
      const double v = fast + (slow - fast) * k / 100;
      most = std::max(most, std::abs(t_s * (i + k / 100.0) / 6 - time_down_to(v)));
    }
  }
  const double told = value(result, "polygon_off_at_most");
  CHECK(most <= told);
  CHECK(most > 0.9 * told);
  CHECK_THAT(told_on(landing(), "integration", {}), Contains("$δ_{t}$ = "));
}
