// What sheets tell and show where other givens are far from the stated ones: words hold for these too, and what a
// sheet is for can be seen.
#include <algorithm>
#include <cmath>

#include "tests/exercises/held_against_corpus.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

std::string words(const std::string& exercise, const std::string& sheet, const Assignments& given,
                  Language language = Language::english) {
  return words_of(Tried(exercise).draw(sheet, given, {.language = language}));
}

std::size_t written(const DrawnSheet& drawn, const std::string& text) {
  const auto& labels = drawn.sheet.figure.labels;
  return static_cast<std::size_t>(
      std::count_if(labels.begin(), labels.end(), [&](const drawings::Label& label) { return label.text == text; }));
}

}  // namespace

TEST_CASE("what energy and velocity do where the force changes its sign is told of these givens") {
  const auto told = [](const Assignments& given, Language language = Language::english) {
    return words("point-mass", "curves", given, language);
  };
  CHECK_THAT(told({}), Contains("from positive to negative, $v$ and $q$ have a maximum, $\\it{E}$ too") &&
                           Contains("$\\it{E}_{max}$") && !Contains("from negative to positive"));
  const Assignments backwards{"A=-0.32", "B=10.4", "C=-80"};
  CHECK_THAT(told(backwards),
             Contains("from negative to positive, $v$ and $q$ have a minimum, $\\it{E}$ a maximum") &&
                 !Contains("from positive to negative"));
  CHECK_THAT(
      told(backwards, Language::italian),
      Contains("Dove $\\it{F}$ passa da negativa a positiva, $v$ e $q$ hanno un minimo, $\\it{E}$ un massimo"));
  CHECK_THAT(told({"A=0", "B=0", "C=-80"}), !Contains("passes from"));
  // Both signs change: at 5 s v < 0, at 10 s it is back at zero, or just short of it.
  for (const char* C : {"C=-50", "C=-50.01"})
    CHECK_THAT(told({"A=-1", "B=15", C}), Contains("have a maximum, $\\it{E}$ a minimum") &&
                                              Contains("have a minimum, $\\it{E}$ a maximum") &&
                                              !Contains("$\\it{E}_{max}$"));
  CHECK_THAT(told({"A=-1", "B=15", "C=-49.99"}), Contains("have a maximum, $\\it{E}$ too"));
}

TEST_CASE("polygons below the true curves do not stand above them") {
  CHECK_THAT(words("point-mass", "integration", {}), Contains("stand above the true curves"));
  const Assignments backwards{"A=-0.32", "B=10.4", "C=-80"};
  CHECK_THAT(words("point-mass", "integration", backwards), Contains("above (+) or below (−)"));
  CHECK_THAT(words("point-mass", "integration", backwards, Language::italian), Contains("sopra (+) o sotto (−)"));
}

TEST_CASE("errors that there are not are told to be none") {
  CHECK_THAT(words("point-mass", "errors", {}), Contains("for the cubic $a$"));
  CHECK_THAT(words("point-mass", "errors", {"A=0"}), Contains("for the parabola $a$: $v_{S}$ has no error"));
  CHECK_THAT(words("point-mass", "errors", {"A=0", "B=0"}), Contains("$a$ is a straight line"));
  CHECK_THAT(words("point-mass", "errors", {"A=0", "B=0", "C=0"}), Contains("the body rests"));
}

TEST_CASE("forces of flaps that lift and friction that slows the wheel are told as they act") {
  const Assignments lifting{"c_y=-1.5", "c_x=20", "v_0=200km/h"};
  CHECK_THAT(words("aircraft-landing", "forces", {}), Contains("$\\vec{\\it{F}}_{y}$, ↓") && !Contains("< 0"));
  CHECK_THAT(words("aircraft-landing", "forces", lifting), Contains("$\\vec{\\it{F}}_{y}$, ↑") &&
                                                               Contains("counted downwards, it acts upwards") &&
                                                               Contains("it acts forwards"));
  CHECK_THAT(words("aircraft-landing", "wheel", lifting), Contains("it acts forwards"));
  CHECK_THAT(words("aircraft-landing", "wheel", lifting, Language::italian), Contains("agisce in avanti"));
}

TEST_CASE("where O is not accelerated it is the acceleration centre, and nothing is constructed") {
  const auto drawn = [](const Assignments& given) {
    return Tried("velocity-centre").draw("acceleration-pole", given);
  };
  const DrawnSheet rests = drawn({"a=0", "omega_dot=0"});
  CHECK_THAT(words_of(rests), Contains("$K$ ≡ $O$") && Contains("points along the bar to $K$") && !Contains("Rays"));
  CHECK(written(rests, "$O$ ≡ $K$") == 1);
  CHECK(written(rests, "$K$") == 0);
  CHECK_THAT(words_of(drawn({"a=0"})), Contains("$\\vec{a}_{A}$ stands at $γ$ to $AK$"));
  CHECK_THAT(words_of(drawn({"a=0", "omega_dot=0", "omega=0"})), Contains("no point is accelerated"));
  CHECK_THAT(words_of(drawn({})), Contains("Rays through $O$ and $A$"));
}

TEST_CASE("an iteration that has gone round is told to have, and not all of a wandering one is drawn") {
  const Assignments wandering{"phi=250", "n=-40", "theta_3_start=-2.5", "theta_4_start=3"};
  CHECK_THAT(words("four-bar-constraints", "iterations", wandering),
             Contains("whole turns beyond") && Contains("Only $k$ = 0 to 3 are drawn"));
  CHECK_THAT(words("four-bar-constraints", "iterations", wandering, Language::italian), Contains("giri interi"));
  CHECK_THAT(words("four-bar-constraints", "iterations", {}), !Contains("whole turns") && !Contains("Only"));
  const DrawnSheet drawn = Tried("four-bar-constraints").draw("iterations", wandering);
  CHECK(written(drawn, "$B^{3}_{3}$") == 1);
  CHECK(written(drawn, "$B^{4}_{3}$") == 0);
}

TEST_CASE("of a path whose rounds run together two are drawn, and dots are told where there are any") {
  const Assignments small_wheel{"how=circle_outside_circle", "r=0.6", "R=0.05", "d=0.01"};
  CHECK_THAT(words("roulette", "path", small_wheel), Contains("one before the instant and one after are drawn"));
  CHECK_THAT(words("roulette", "path", small_wheel, Language::italian),
             Contains("uno prima dell'istante e uno dopo"));
  CHECK_THAT(words("roulette", "path", {}), !Contains("one before the instant") && Contains("the dots are 30°"));
  CHECK_THAT(words("roulette", "path", {"R=5.5", "r=0.5", "d=0.3"}), !Contains("the dots"));
}
