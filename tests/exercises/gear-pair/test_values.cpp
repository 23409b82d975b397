// Pairs of gears: the exercise's numbers are those of a corpus that knows the generating rack only; the source's
// numbers; what is refused.
#include "tests/exercises/gear-pair/cases.h"

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

TEST_CASE("gear pair: every quantity is the corpus', to the last bit of a double, by both routes", "[gear-pair]") {
  CHECK(gear_cases().size() == 25);
  for (const CorpusCase& c : gear_cases()) {
    const CheckedExercise result = gear_pair().checked(assignments_of(c));
    CAPTURE(c.name, c.why, complaints(result));
    CHECK(numbers_pass(result));
    for (const CheckedQuantity& quantity : result.quantities) {
      const std::string reference = c.reference(quantity.spec.name);
      CAPTURE(quantity.spec.name, reference);
      REQUIRE_FALSE(reference.empty());
      is_the_reference(quantity, reference);
    }
  }
}

TEST_CASE("gear pair: what is promised is reported, in its unit", "[gear-pair]") {
  const CheckedExercise result = gear_pair().checked({});
  CHECK(result.passed());
  for (const char* name : {"r1",
                           "r2",
                           "r_tip_1",
                           "r_root_1",
                           "r_tip_2",
                           "r_root_2",
                           "r_base_1",
                           "r_base_2",
                           "addendum",
                           "dedendum",
                           "clearance",
                           "tooth_height",
                           "circular_pitch",
                           "base_pitch",
                           "path_of_approach",
                           "path_of_recess",
                           "path_of_contact",
                           "arc_of_approach",
                           "arc_of_recess",
                           "arc_of_action",
                           "tooth_thickness_pitch_1",
                           "tooth_thickness_base_1",
                           "tooth_thickness_tip_1",
                           "tooth_thickness_pitch_2",
                           "tooth_thickness_base_2",
                           "tooth_thickness_tip_2",
                           "interference_limit_approach",
                           "interference_limit_recess",
                           "max_tip_radius_2_without_interference",
                           "max_tip_radius_1_without_interference",
                           "undercut_limit_addendum_1",
                           "start_of_active_profile_radius_1",
                           "start_of_active_profile_radius_2"})
    CHECK(find(result, name).spec.unit == "m");
  for (const char* name :
       {"z1", "z2", "contact_ratio", "minimum_teeth_no_undercut_rack", "minimum_teeth_pinion_for_this_ratio"})
    CHECK(find(result, name).spec.unit == "1");
  for (const char* name : {"omega_1", "omega_2", "omega_relative"}) CHECK(find(result, name).spec.unit == "rad/s");
  for (const char* name : {"sliding_velocity_approach", "sliding_velocity_recess"})
    CHECK(find(result, name).spec.unit == "m/s");
  for (const char* name : {"tip_pressure_angle_1_deg", "tip_pressure_angle_2_deg"})
    CHECK(find(result, name).spec.unit == "deg");
}

TEST_CASE("gear pair: the source's numbers round, but for the path of approach and the relative velocity",
          "[gear-pair]") {
  const std::set<std::string> wrong{"path_of_approach", "omega_relative", "sliding_velocity_approach",
                                    "sliding_velocity_recess"};
  int judged = 0;
  for (const CheckedQuantity& quantity : gear_pair().checked({}).quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      const bool is_wrong = wrong.contains(quantity.spec.name);
      CHECK(verdict.verdict == (is_wrong ? Verdict::disagrees : Verdict::rounding));
      CHECK(verdict.explanation.has_value() == is_wrong);
      CHECK(verdict.explanation_holds);
      ++judged;
    }
  CHECK(judged == 24);
  for (const CheckedQuantity& quantity : gear_pair().checked({"z1=21"}).quantities) CHECK(quantity.printed.empty());
}

TEST_CASE("gear pair: the least teeth change at 30 degrees exactly, and a hair beside it", "[gear-pair]") {
  const auto least = [](const Assignments& all) {
    return value(gear_pair().checked(all), "minimum_teeth_no_undercut_rack");
  };
  CHECK(least({"alpha=30"}) == 8);
  CHECK(least({"alpha=29.999999999999999999999999999999"}) == 9);
  CHECK(least({"alpha=30.000000000000000000000000000001"}) == 8);
  CHECK(least({"alpha=45"}) == 4);
  CHECK(least({"alpha=30", "ha=1.000000000000000000000000000001"}) == 9);
}

TEST_CASE("gear pair: what a rack, a ring, or a tip inside the base circle has not", "[gear-pair]") {
  const auto absent = [](const Assignments& all, const char* name, const char* because) {
    const CheckedExercise result = gear_pair().checked(all);
    CAPTURE(all, name, find(result, name).settled.reason.english);
    CHECK(numbers_pass(result));
    CHECK(find(result, name).settled.kind == Settled::Kind::absent);
    CHECK(find(result, name).settled.reason.english.find(because) != std::string::npos);
  };
  for (const char* name : {"r2", "z2", "r_base_2", "max_tip_radius_2_without_interference"})
    absent({"kind=rack"}, name, "no centre");
  for (const char* kind : {"kind=rack", "kind=internal"}) absent({kind}, "interference_limit_recess", "external");
  absent({"x1=0.1"}, "interference_limit_teeth", "changes with the number of teeth");
  for (const char* name : {"path_of_approach", "contact_ratio", "tip_pressure_angle_2_deg", "tooth_thickness_tip_2"})
    absent({"kind=internal", "z2=21"}, name, "inside the base circle");
}

TEST_CASE("gear pair: gears with faults fail their check, each with its sentence", "[gear-pair]") {
  const auto says = [](const Assignments& all, const std::string& sentence) {
    const CheckedExercise result = gear_pair().checked(all);
    CAPTURE(all, complaints(result));
    CHECK(numbers_pass(result));
    CHECK_FALSE(result.passed());
    CHECK(std::any_of(result.failures.begin(), result.failures.end(), [&](const Complaint& each) {
      return each.sentence.english.find(sentence) != std::string::npos;
    }));
  };
  says({"z1=5", "x1=1", "z2=30"}, "The teeth of wheel 1 are pointed");
  says({"z1=10"}, "undercuts the teeth of wheel 1");
  says({"kind=internal", "z2=21"}, "lies inside its base circle");
  CHECK(gear_pair().checked({}).failures.empty());
}

TEST_CASE("gear pair: what is no pair of gears is refused in one sentence", "[gear-pair]") {
  const auto refused = [](const Assignments& all, const std::string& because) {
    CAPTURE(all, because);
    try {
      gear_pair().checked(all);
      FAIL("accepted");
    } catch (const BadGivens& refusal) {
      CAPTURE(refusal.what());
      CHECK(std::string(refusal.what()).find(because) != std::string::npos);
    }
  };
  refused({"z1=2"}, "from 3 to 1000000");
  refused({"z1=20.5"}, "z1 = 41/2: teeth are counted");
  refused({"z2=1000001"}, "from 3 to 1000000");
  refused({"kind=internal", "z2=20"}, "a ring has more teeth");
  refused({"kind=rack", "x2=0.1"}, "a rack is not shifted");
  refused({"alpha=0.5"}, "between 1 and 75");
  refused({"alpha=76"}, "between 1 and 75");
  refused({"alpha=90"}, "between 1 and 75");
  refused({"m=0"}, "must be positive");
  refused({"m=1e300"}, "must lie between");
  refused({"x1=1e6"}, "no more than 10 times the module");
  refused({"k=3"}, "the teeth vanish");
  refused({"j=31"}, "leaves no tooth");
  refused({"z1=3", "hf=1.5"}, "cut down beyond its centre");
  refused({"kind=internal", "z1=3", "z2=4", "ha=2"}, "reach beyond its centre");
  refused({"x1=-1", "x2=-1"}, "no working pressure angle");
  refused({"kind=internal", "z2=45", "x1=1"}, "no working pressure angle");
}
