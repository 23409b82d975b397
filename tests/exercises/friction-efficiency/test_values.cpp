// Mechanisms with friction: their numbers are those of a corpus of closed formulas; self-locking at its limit and
// beside it; jamming; the source's numbers.

#include "tests/exercises/friction-efficiency/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("friction: values are the corpus', to the last bit of a double, by every route", "[friction-efficiency]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/friction_efficiency.txt");
  CHECK(corpus.size() == 16);
  holds_against(friction(), corpus);
}

TEST_CASE("friction: the limit of self-locking, hit and missed", "[friction-efficiency]") {
  const auto locking = [](const Assignments& assignments, const std::string& mechanism) {
    const CheckedExercise result = friction().checked(assignments);
    CAPTURE(assignments, complaints(result));
    CHECK(result.passed());
    return std::pair{value(result, mechanism + ".self_locking"), value(result, mechanism + ".P_retrograde")};
  };
  for (const char* mechanism : {"wedge_collar", "wedge_collar_two_point"}) {
    CHECK(locking({"wedge_collar.theta=10"}, mechanism) == std::pair(1.0, 0.0));  // θ = 2φ
    CHECK(locking({"wedge_collar.theta=10", "phi=5.000000001"}, mechanism).second < 0);
    const auto missed = locking({"wedge_collar.theta=10", "phi=4.999999999999999999999999999999"}, mechanism);
    CHECK(missed.first == 0);
    CHECK(missed.second > 0);
    CHECK(missed.second < 1e-28);
  }
  CHECK(locking({"double_slider.theta=85"}, "double_slider") == std::pair(1.0, 0.0));  // θ + φ = 90°
  CHECK(locking({"double_slider.theta=84.999999999"}, "double_slider").first == 0);
}

TEST_CASE("friction: without friction nothing is lost", "[friction-efficiency]") {
  const CheckedExercise result = friction().checked({"phi=0"});
  CHECK(result.passed());
  for (const char* name : {"wedge_collar", "wedge_collar_two_point", "double_slider", "double_slider_pins",
                           "sliding_levers", "sliding_levers_Q_on_2", "fairbairn", "fairbairn_short_lever"})
    for (const char* eta : {".eta_direct", ".eta_retrograde"})
      CHECK(value(result, std::string(name) + eta) == Approx(1).epsilon(1e-14));
  CHECK(find(result, "wedge_collar_two_point.K_direct_x").settled.kind == geometry::Settled::Kind::absent);
}

TEST_CASE("friction: what jams is said with the angle at which it does", "[friction-efficiency]") {
  is_refused(friction(), {"phi=24.5"},
             "phi = 24.5°: must be less than 24.5°, at which the wedge jams in the direct motion: the force P is "
             "infinite there");
  is_refused(friction(), {"phi=18.72"},
             "phi = 18.72°: must be less than 18.7149°, at which the rod in its collar of two forces jams");
  CHECK(friction().checked({"phi=18.71"}).passed());
  is_refused(friction(), {"phi=8", "double_slider.theta=8"}, "must be less than 8°, at which the double slider jams");
  is_refused(friction(), {"double_slider_pins.r=2"}, "wider than the link is long");
  // The link's force falls into the friction cone of slider 4: sin δ = 2 sin 5°, δ + 5° = 15.0386°; in the middle of
  // the row δ = φ and the limit is hit.
  is_refused(friction(), {"double_slider_pins.r=0.3", "double_slider.theta=15.038"},
             "at which the double slider with friction in its pins jams");
  is_refused(friction(), {"double_slider_pins.r=0.15", "double_slider.theta=10"},
             "must be less than 5°, at which the double slider with friction in its pins jams");
  is_refused(friction(), {"double_slider_pins.r=0.3", "double_slider.theta=10"}, "must be less than 3.32956°");
  CHECK(friction().checked({"double_slider_pins.r=0.3", "double_slider.theta=15.039"}).passed());
  // From C the hinge of the loaded lever lies at 165.2°, or 14.8° below +x.
  is_refused(friction(), {"phi=10", "sliding_levers.nu=160"},
             "the contact's force, at 170° then, does not pass its hinge");
  is_refused(friction(), {"phi=10", "sliding_levers.nu=156"}, "at 166° then");
  CHECK(friction().checked({"phi=10", "sliding_levers.nu=155"}).passed());
  is_refused(friction(), {"sliding_levers.y_C=0"}, "friction has no sense");
}

// Pins of a radius of half the link have δ = φ: the double slider jams at φ = 10°/2. The wedge jams at
// (90° - 41°)/2; below that the rod in its collar of two forces still does.
TEST_CASE("friction: the limit of jamming, hit and missed", "[friction-efficiency]") {
  const auto pins = [](const std::string& phi) {
    return Assignments{"phi=" + phi, "double_slider_pins.r=0.15", "double_slider.theta=10"};
  };
  const std::string jams = "the double slider with friction in its pins jams";
  for (const char* phi : {"5", "5.000000001", "5.000000000000000000000000000001"}) {
    CAPTURE(phi);
    CHECK_THROWS_WITH(friction().checked(pins(phi)), Contains(jams));
  }
  // Read with the digits it has, the angle is at the limit or beyond it; where they would be too many, that is said.
  CHECK_THROWS_WITH(friction().checked(pins("5")), Contains("phi = 5°: must be less than 5°, at which"));
  CHECK_THROWS_WITH(friction().checked(pins("5.000000001")),
                    Contains("phi = 5.000000001°: must be less than 5°, at which"));
  CHECK_THROWS_WITH(friction().checked({"phi=24.500000000000000000000000000001"}),
                    Contains("phi = 24.5°: must be less than 24.5° (it is beyond by less than 10^-12°), at which"));
  CHECK_THROWS_WITH(friction().checked(pins("5.000000000000000000000000000001")),
                    Contains("phi = 5°: must be less than 5° (it is beyond by less than 10^-12°), at which"));
  // The rod's limit is 18.7148901°: with six figures both would be 18.7149°.
  CHECK_THROWS_WITH(friction().checked({"phi=18.714891"}),
                    Contains("phi = 18.714891°: must be less than 18.71489°, at which"));
  for (const char* phi : {"4.999999999", "4.999999999999999999999999999999"}) {
    CAPTURE(phi);
    CHECK(friction().checked(pins(phi)).passed());
  }
  for (const char* phi : {"24.5", "24.500000001", "24.500000000000000000000000000001"}) {
    CAPTURE(phi);
    CHECK_THROWS_WITH(friction().checked({std::string("phi=") + phi}), Contains("the wedge jams"));
  }
  for (const char* phi : {"24.499999999", "24.499999999999999999999999999999"}) {
    CAPTURE(phi);
    CHECK_THROWS_WITH(friction().checked({std::string("phi=") + phi}), Contains("the rod in its collar"));
  }
}

// cot(θ) of the pins' link: φ + δ = 90° - θ and φ + δ = θ, sin δ = 2 r sin φ/l. Beyond the first the pins lock where
// ideal hinges do not.
TEST_CASE("friction: pins lock and jam before ideal hinges do", "[friction-efficiency]") {
  const auto sign_of_P = [](const std::string& phi) {
    const CheckedExercise result =
        friction().checked({"phi=" + phi, "wedge_collar.y_upper=10", "wedge_collar.theta=10"});
    CAPTURE(phi, complaints(result));
    CHECK(result.passed());
    CHECK(value(result, "double_slider.P_retrograde") > 0);
    return value(result, "double_slider_pins.P_retrograde");
  };
  CHECK(sign_of_P("19.711557023388043") > 0);
  CHECK(sign_of_P("19.711557023388044") < 0);
}

TEST_CASE("friction: the source drew the double slider's friction angles too small", "[friction-efficiency]") {
  const CheckedExercise result = friction().checked({});
  const auto explained = [&](const char* name) {
    return find(result, name).printed.front().explanation.value().english;
  };
  CHECK_THAT(explained("double_slider.eta_direct"), Contains("150 cot 67.2° = 63.1 N and 150 cot 70.8° = 52.2 N"));
  CHECK_THAT(explained("double_slider.eta_retrograde"), Contains("follows from the printed forces: 53/60"));
}

// The least positive zero of μ³ + (t - 2m/w) μ² - 2 y_u t/w μ + a/w, t = tan θ, 2m = y_u + y_l, a = y_u - y_l, by
// mpmath.
TEST_CASE("friction: where the rod jams in its collar, however near the next place where it moves again",
          "[friction-efficiency]") {
  const char* name = "wedge_collar_two_point.jamming_friction_angle_deg";
  const auto checked = [](const char* w, const char* upper, const char* lower, const char* theta, const char* phi) {
    const std::string of = "wedge_collar.";
    CheckedExercise result = friction().checked({of + "w=" + w, of + "y_upper=" + upper, of + "y_lower=" + lower,
                                                 of + "theta=" + theta, std::string("phi=") + phi});
    CAPTURE(w, upper, lower, theta, complaints(result));
    CHECK(result.passed());
    return result;
  };
  const auto rod = [&](const char* w, const char* upper, const char* lower, const char* theta, const char* phi) {
    return value(checked(w, upper, lower, theta, phi), name);
  };
  CHECK(rod("1", "0.152", "0.148", "0.1", "10") == 10.67634344695067548);       // and again free from 11.888°
  CHECK(rod("1e-7", "1", "-0.9998", "0.01", "0.001") == 89.43677059416023850);  // μ = 101.7
  CHECK(rod("1", "177/736", "127/736", "45", "1") == 14.03624346792647858);     // μ = 1/4 alone
  // The same with the upper end 1e-30 lower, and higher.
  const char* lower = "5531249999999999999999999999977/23000000000000000000000000000000";
  const char* higher = "5531250000000000000000000000023/23000000000000000000000000000000";
  CHECK(rod("1", lower, "127/736", "45", "1") == 14.03624346792644774);
  CHECK(find(checked("1", higher, "127/736", "45", "1"), name).settled.kind == geometry::Settled::Kind::absent);
}

TEST_CASE("friction: the source's numbers", "[friction-efficiency]") {
  const CheckedExercise result = friction().checked({});
  const Judged prints = judged(result);
  CHECK(prints.rounding == 4);
  CHECK(prints.reading == 5);
  CHECK(prints.explained == 11);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("friction: what does not slide has no friction, and no sheet", "[friction-efficiency]") {
  const auto rests = [](const Assignments& assignments, const std::string& mechanism, const std::string& where,
                        double without_friction) {
    const CheckedExercise result = friction().checked(assignments);
    CAPTURE(assignments, complaints(result));
    CHECK(result.failures.empty());
    CHECK(result.undecided.empty());
    REQUIRE(result.not_drawn.size() == 1);
    CHECK_THAT(result.not_drawn.front().sentence.english, Contains("the bodies do not slide on each other"));
    CHECK_THAT(result.not_drawn.front().sentence.english, Contains(where));
    CHECK(find(result, mechanism + ".M_direct").settled.kind == geometry::Settled::Kind::absent);
    CHECK(value(result, mechanism + ".M_i") == Approx(without_friction).epsilon(1e-14));
  };
  // F CD AB/(AC + AB), lever and crank upright.
  rests({"fairbairn.theta=0"}, "fairbairn", "fairbairn.theta = 0°: the lever stands upright",
        50 * 0.95 * 0.2 / 0.649);
  rests({"fairbairn_short_lever.theta=0"}, "fairbairn_short_lever", "fairbairn_short_lever.theta = 0°",
        50 * 0.714 * 0.2 / 0.623);
  // The crank across the lever, which rests.
  rests({"fairbairn_short_lever.theta=30", "fairbairn_short_lever.AC=0.4"}, "fairbairn_short_lever",
        "theta = 30°: the crank stands square to the lever", 0);
  // Without friction nothing need slide; of no couple no efficiency is known.
  const CheckedExercise smooth =
      friction().checked({"phi=0", "fairbairn_short_lever.theta=30", "fairbairn_short_lever.AC=0.4"});
  CAPTURE(complaints(smooth));
  CHECK(smooth.failures.empty());
  CHECK(smooth.undecided.empty());
  CHECK(value(smooth, "fairbairn_short_lever.M_direct") == 0);
  CHECK(find(smooth, "fairbairn_short_lever.eta_direct").settled.kind == geometry::Settled::Kind::absent);
}
