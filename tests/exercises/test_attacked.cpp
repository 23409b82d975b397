// What attacks from outside found, each with the command that found it. Right answers are the checks' own, which hold
// sheets against proved values.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "exercises/cli/csv_reader.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/measured.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/held_against_corpus.h"
#include "tests/exercises/run.h"

using namespace epure;
using namespace epure::tests;

namespace {

Ran run_real(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err);
  return {exit, out.str(), err.str()};
}

// Why it is.
std::string refused(const std::string& id, const Assignments& givens) {
  try {
    Tried(id).checked(givens);
  } catch (const BadGivens& why) {
    return why.words().english;
  }
  return "accepted";
}

bool passes(const std::string& id, const Assignments& assignments) {
  const CheckedExercise checked = Tried(id).checked(assignments);
  for (const auto* all : {&checked.failures, &checked.undecided, &checked.not_drawn})
    for (const Complaint& each : *all) UNSCOPED_INFO(each.sentence.english);
  return checked.passed();
}

}  // namespace

// Neither weight nor inertia: the polygon of the forces on the lever is a point.
TEST_CASE("attacked: a lever on which no force acts") {
  CHECK(passes("pin-in-slot", {"OB=0.2", "M1=0", "omega_dot=0"}));
  CHECK(passes("pin-in-slot", {"omega=0", "omega_dot=0", "g=0"}));
  CHECK(passes("pin-in-slot", {"omega=0", "omega_dot=0", "M1=0"}));
}

// 256 bits cannot tell 7.77 rad/s² from zero there; drawn as zero, the sheet was wrong.
TEST_CASE("attacked: so near to a change point that drawings need more bits") {
  Assignments near{"A0B0=1.1", "AB=0.799", "A0A=0.5", "B0B=0.801", "alpha_2=10"};
  for (const int zeros : {12, 17, 21, 24, 32, 39, 60}) {
    CAPTURE(zeros);
    near.push_back("theta_2=180." + std::string(static_cast<std::size_t>(zeros), '0') + "1");
    CHECK(passes("four-bar-analytic", near));
    near.pop_back();
  }
}

// 360° - 1e-17, drawn at 0°.
TEST_CASE("attacked: an angle at the seam of a turn") {
  CHECK(passes("four-bar-analytic", {"A0B0=0.3", "AB=1.3", "A0A=0.2999999999999999999", "B0B=1.3", "theta_2=0"}));
}

// -11.537° measured on the other side of the turn.
TEST_CASE("attacked: a measured direction may be whole turns away") {
  for (const auto& [text, is_right] :
       {std::pair{"348.46deg", true}, {"-11.54deg", true}, {"708.46deg", true}, {"349.2deg", false}}) {
    CAPTURE(text);
    CheckedExercise checked = Tried("slider-crank-velocity").checked({});
    for (CheckedQuantity& quantity : checked.quantities)
      if (quantity.spec.name == "coupler_angle") add_measured(checked, quantity, text, {});
    CHECK(checked.passed() == is_right);
  }
}

// The coupler curve near its change point took a million pieces, 26 s.
TEST_CASE("attacked: change points of four-bars on oblique frames") {
  CHECK(passes("four-bar", {"A0A=0.1", "x_B0=0.3", "y_B0=0.4", "AB=0.4", "B0B=0.2", "AC=0.3"}));
  CHECK(passes("four-bar", {"A0A=0.68", "x_B0=1.6", "y_B0=3", "AB=4.72", "B0B=2", "AC=2.832", "phi=2.429838rad"}));
  CHECK(passes("four-bar", {"A0A=0.025", "x_B0=-0.15", "y_B0=0.2", "AB=0.25", "B0B=0.0250000000000000000008",
                            "AC=0.125", "phi=236"}));
}

// In doubles its gradient was zero from end to end, and a chart without height ended the program.
TEST_CASE("attacked: a film whose walls are all but parallel") {
  CHECK(passes("michell-bearing", {"h_1=1", "h_2=0.99999999999999999"}));
  CHECK(passes("michell-bearing", {"h_1=3.6", "h_2=3.5999999999999999999"}));
}

// 256 bits know four digits of a pressure there, and the sheet printed others.
TEST_CASE("attacked: a film parallel to 35 digits") {
  CHECK(passes("michell-bearing", {"h_1=3", "h_2=2.99999999999999999999999999999999998"}));
}

// v_0 in m/s is a quantity, v_0 in km/h a given: who wrote the key's own numbers got no points.
TEST_CASE("attacked: a key that class wrote is read as it was meant") {
  const Scratch scratch;
  REQUIRE(run_real({"class", "aircraft-landing", "--count", "1", "--vary", "c_y=1.9|2.1", "--out", "o"}).exit == 0);
  const std::string key_file = "o/aircraft-landing-class/key.csv";
  const CsvTable key = read_csv_file(key_file);
  const auto column = key.column("t_s");
  REQUIRE(column);
  std::ofstream("answers.csv") << "number,t_s\n1," << key.rows.front().cells[*column] << "\n";
  const Ran marked = run_real({"mark", "aircraft-landing", "--answers", "answers.csv", "--key", key_file});
  INFO(marked.out << marked.err);
  CHECK(marked.exit == 0);
  CHECK(marked.out.find("1 points of 1") + marked.out.find("1 point of 1") != 2 * std::string::npos);
}

// A reader's find: φ set to the angle that t says at the stated speed was forgotten at another speed, and the answer
// of the wrong φ (5.79 m/s, at t = 1/72 s) explained by a length that has no part in it.
TEST_CASE("attacked: an angle that was set holds at another speed") {
  const Scratch scratch;
  std::ofstream("answers.csv") << "number,v_B\n1,5.79\n";
  const Ran marked = run_real({"mark", "slider-crank-velocity", "--answers", "answers.csv", "--set", "r=0.19m",
                               "--set", "n=400rpm", "--set", "phi=30deg"});
  INFO(marked.out);
  CHECK(marked.out.find("doubled") == std::string::npos);
  REQUIRE(run_real({"class", "slider-crank-velocity", "--count", "1", "--vary", "n=360|400", "--set", "phi=30deg",
                    "--out", "o"})
              .exit == 0);
  CHECK(read_csv_file("o/slider-crank-velocity-class/key.csv").column("phi"));
}

TEST_CASE("attacked: charts of a sweep") {
  const Scratch scratch;
  CHECK(run_real({"sweep", "friction-efficiency", "--over", "phi=1..5/3", "--quantity", "sliding_levers.H_2_direct_x",
                  "--chart", "c.svg"})
            .exit == 0);
  const Ran narrow =
      run_real({"sweep", "boat-crane", "--over", "Psi=1.5..1.5000000015/3", "--quantity", "P", "--chart", "d.svg"});
  CHECK(narrow.exit == 2);
  CHECK(narrow.err == "epure: --chart: from 1.5 to 1.5000000015 is too narrow an axis for its numbers\n");
  CHECK(run_real({"sweep", "slider-crank-acceleration", "--over", "delta=1..1.000000001/3", "--quantity", "a_MA",
                  "--chart", "e.svg"})
            .exit == 2);
}

// Both were told rounded, and seemed to be as they ought to.
TEST_CASE("attacked: a sentence tells by how little a given is wrong") {
  CHECK(refused("michell-bearing", {"h_1=2.9", "h_2=2.9000001"}).find("h_2 = 0.0029000001 m") != std::string::npos);
  CHECK(refused("michell-bearing", {"pads=8.0000001"}).find("pads = 8.0000001:") != std::string::npos);
}

// Folded, all hinges lie in line; extended, crank and coupler reach beyond frame and rocker: 0.7 > 0.5.
TEST_CASE("attacked: of two dead centres that there are not, each has its own reason") {
  const CheckedExercise checked =
      Tried("four-bar-analytic").checked({"A0A=0.2", "AB=0.5", "B0B=0.4", "A0B0=0.1", "phi=45"});
  std::string reasons;
  for (const char* number : {"1", "2"})
    reasons += find(checked, "theta_2_at_omega_4_zero_" + std::string(number) + "_deg").settled.reason.english + "; ";
  CAPTURE(reasons);
  CHECK(reasons.find("no such dead centre") != std::string::npos);
  CHECK(reasons.find("all hinges are in line") != std::string::npos);
}

// 0.7 = 0.3 + 0.2 + 0.2, also with the frame along the diagonal of 0.42 and 0.56, and with the crank as the long one.
TEST_CASE("attacked: a four-bar that closes in one position alone cannot move at all") {
  const auto cannot_move = Contains("closes in this position alone, and cannot move");
  CHECK_THAT(refused("four-bar-analytic", {"A0A=0.3", "AB=0.2", "B0B=0.2", "A0B0=0.7", "phi=0"}), cannot_move);
  CHECK_THAT(refused("four-bar-analytic", {"A0A=0.7", "AB=0.2", "B0B=0.2", "A0B0=0.3", "phi=0"}), cannot_move);
  CHECK_THAT(refused("four-bar-analytic", {"A0A=0.3", "AB=0.3", "B0B=0.2", "A0B0=0.2", "phi=0"}), !cannot_move);
}

// Where A comes within the miss of B0 its square is all that tells the sheet's curve from one that ends.
TEST_CASE("attacked: a rhombus missed by less than drawings need else") {
  for (const int places : {36, 38, 45, 58, 60, 80}) {
    CAPTURE(places);
    const std::string frame = "0.746" + std::string(static_cast<std::size_t>(places - 3), '9');
    CHECK(passes("four-bar-analytic", {"phi=315deg", "A0A=0.747", "AB=0.747", "B0B=0.747", "n=60", "A0B0=" + frame}));
  }
}

TEST_CASE("attacked: a linkage that closes in a hair of a turn does not close at one angle only") {
  const Assignments slider{"phi=315", "delta=90", "r=0.1145", "l=0.241"};
  const auto with_offset = [&](const std::string& e) {
    Assignments all = slider;
    all.push_back("e=" + e);
    return refused("slider-crank-acceleration", all);
  };
  // √(2·1e-16/r) of a radian.
  CHECK_THAT(with_offset("0.3554999999999999"), Contains("it closes within 2.4e-06° of 180° only"));
  CHECK_THAT(with_offset("0.35549999999999999999999999999999999999999999"), Contains("it closes within "));
  CHECK_THAT(with_offset("0.3555"), Contains("it closes at 180° only"));
  // The other way round: a hair of a turn is all that lacks, and the crank is in it.
  for (const int nines : {19, 45}) {
    const std::string l = "l=0." + std::string(static_cast<std::size_t>(nines), '9');
    const std::string sentence =
        refused("slider-crank-acceleration", {"r=1", l, "AC=0.7", "BC=0.7", "n=60", "phi=90"});
    CAPTURE(sentence);
    CHECK(sentence.find("; it closes from -90") != std::string::npos);
    CHECK(sentence.find(" 90°") == sentence.rfind(" 90°"));  // the crank's alone
  }
  const auto four_bar = [&](const std::string& frame) {
    return refused("four-bar-analytic", {"A0A=0.3", "AB=0.2", "B0B=0.2", "A0B0=" + frame, "phi=1"});
  };
  const std::string hardly = "0.6999999999999999999999999999999999999999";
  CHECK_THAT(four_bar(hardly), Contains("it closes from -1.1183e-18° to 1.1183e-18°"));
  CHECK_THAT(refused("four-bar", {"A0A=0.3", "AB=0.2", "B0B=0.2", "AC=0.1", "x_B0=-" + hardly, "y_B0=0", "t=0.001"}),
             Contains("it closes within ") && Contains(" of 180° only"));
  CHECK_THAT(four_bar("0.7"), Contains("it closes at 0° only"));
}

TEST_CASE("attacked: a roller nearly at right angles to what it may bear is drawn by its force") {
  for (const std::string delta : {"89.99999999999", "89.999999999999999", "-89.99999999999"}) {
    CAPTURE(delta);
    CHECK(passes("truss", {"delta=" + delta}));
  }
}

TEST_CASE("attacked: what has no givens cannot be swept") {
  const std::string file = (std::filesystem::temp_directory_path() / "epure-test-attacked.yaml").string();
  std::ofstream(file)
      << "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O A: 1 m}\ndrive: {link: 2, angle: 1 deg}\n";
  const Ran swept = run_catalogue(catalogue(), {"sweep", file, "--quantity", "A_x"}, {});
  CHECK(swept.exit == 2);
  CHECK_THAT(swept.err, Contains("f has no givens to sweep over"));
  std::filesystem::remove(file);
}

TEST_CASE("attacked: an angle at a hinge has an arc however small the sheet") {
  const std::string file = (std::filesystem::temp_directory_path() / "epure-test-attacked.svg").string();
  for (const char* scale : {"1:20", "1:50", "1:100"}) {
    const Ran drawn = run_catalogue(catalogue(), {"draw", "four-bar/dead-centres", "--scale", scale, "-o", file}, {});
    CAPTURE(scale, drawn.err);
    CHECK(drawn.exit == 0);
  }
  std::filesystem::remove(file);
}

// Of what is false at special givens.
TEST_CASE("attacked: what a sheet says of one dead centre, of a pole at infinity and of a rack") {
  const Assignments one{"A0A=0.4", "AB=0.3", "B0B=0.35", "x_B0=-0.5", "y_B0=0.1", "phi=100deg", "AC=0.1"};
  const DrawnSheet both = Tried("four-bar").draw("dead-centres", one);
  CHECK(tells(both, "one dead centre only, with crank and coupler extended"));
  CHECK_FALSE(tells(Tried("four-bar").draw("dead-centre-extended", one), "has not this dead centre"));
  CHECK(tells(Tried("four-bar").draw("dead-centre-folded", one), "has not this dead centre"));

  const Assignments parallelogram{"A0A=0.2", "B0B=0.2", "AB=0.5", "x_B0=-0.3", "y_B0=-0.4", "AC=0.3"};
  CHECK(tells(Tried("four-bar").draw("parallel-links", parallelogram), "parallel in the same sense throughout"));

  CHECK(tells(Tried("slider-crank-velocity").draw("polodes", {"phi=90deg"}), "an asymptote in common"));
  CHECK(tells(Tried("slider-crank-velocity").draw("polodes", {"phi=80deg"}), "They touch in the $P_{0}$"));

  const DrawnSheet rack = Tried("gear-pair").draw("pitch-point", {"kind=rack", "z1=9", "x1=0.5"});
  CHECK(tells(rack, "The rack's tip line cuts it at $A$"));
  CHECK(tells(rack, "straight on the rack"));
  CHECK_FALSE(tells(rack, "Tip circle 2"));
}

// Sheets print them with raised digits and blanks, people with prefixes; V is 0.0096980965 m³ by mpmath.
TEST_CASE("attacked: units of quantities that no given has are read as sheets print them") {
  const Scratch scratch;
  const auto marked = [](const std::string& id, const std::string& head, const std::string& answer) {
    std::ofstream("answers.csv") << head << '\n' << answer << '\n';
    return run_real({"mark", id, "--answers", "answers.csv", "--format", "csv"});
  };
  const auto verdict = [&](const std::string& id, const std::string& head, const std::string& answer) {
    const Ran ran = marked(id, head, answer);
    CAPTURE(head, answer, ran.err);
    REQUIRE(ran.exit == 0);
    return read_csv(ran.out, "marks").rows.at(0).cells.at(3);
  };
  CHECK(verdict("pump-flywheel", "V (m³)", "0.0096981") == "right");
  CHECK(verdict("pump-flywheel", "V [cm^3]", "9698.1") == "right");
  CHECK(verdict("pump-flywheel", "V", "9.6981 l") == "right");
  CHECK(verdict("pump-flywheel", "V (m³)", "0.0097981") == "wrong");
  CHECK(verdict("pump-flywheel", "V (m³)", "9698.1 cm3") == "right");
  CHECK(verdict("boat-crane", "W_x1 (mm³)", "357858") == "right");
  CHECK(verdict("boat-crane", "W_x1 (mm³)", "357.858e3") == "right");
  for (const auto& [head, answer, why] :
       {std::tuple{"V (cl)", "969.8", "\"1 cl\" ends in \"cl\", which is no unit of this program"},
        {"V (m)", "969.8", "\"1 m\" ends in \"m\", which is no unit of what is asked; write a number in m^3"}}) {
    const Ran ran = marked("pump-flywheel", head, answer);
    CHECK(ran.exit == 2);
    CAPTURE(ran.err);
    CHECK(ran.err.find(why) != std::string::npos);
  }
  // And letters as they are copied from a sheet; how sure an answer is has the unit behind it.
  CHECK(verdict("slider-crank-velocity", "ω_3 (rad/s)", "1000") == "wrong");
  CHECK(verdict("slider-crank-velocity", "P_0B", "1000") == "wrong");
  // ζ ω_n = 1.5 · 0.2 rad/s: a decay is in 1/s, and no angular velocity.
  CHECK(verdict("oscillator-pendulum", "oscillator.alpha", "0.300 ± 0.1 1/s") == "right");
  CHECK(verdict("oscillator-pendulum", "oscillator.alpha (1/s)", "0.300") == "right");
  CHECK(verdict("oscillator-pendulum", "oscillator.alpha", "0.300 s⁻¹") == "right");
  CHECK(verdict("oscillator-pendulum", "oscillator.alpha", "300 1/ks") == "wrong");
  const Ran measured = run_real({"check", "crane-welds", "--measured", "q=5 furlongs"});
  CHECK(measured.exit == 2);
  CHECK(measured.err.find("\"furlongs\"") != std::string::npos);
}

// Numbers that a mechanism's file says in place stood on its sheets, and neither in questions nor in a report.
TEST_CASE("attacked: what a file says in place is told wherever its givens are") {
  const Scratch scratch;
  std::ofstream("mine.yaml")
      << "epure: 1\nid: mine\ntitle: Mine\ngivens: {r: 100 mm}\nlinks:\n"
         "  1: {O: [0, 0], g: {through: [0, 20 mm], along: [1, 0]}}\n  2: {O A: r}\n  3: {A B: 330 mm}\nslides: {B: "
         "g}\n"
         "drive: {link: 2, angle: 50 deg, speed: 93 rpm}\nassembly: {B: ahead on g}\nloads: [{at: B, force: 237 N, "
         "direction: 171 deg}]\n";
  const auto bytes_of = [](const std::string& name) {
    std::ostringstream all;
    all << std::ifstream(name).rdbuf();
    return all.str();
  };
  REQUIRE(
      run_real({"class", "mine.yaml", "--count", "1", "--vary", "r=90..110/3", "--format", "moodle", "--out", "mo"})
          .exit == 0);
  REQUIRE(run_real({"report", "mine.yaml", "-o", "r.md"}).exit == 0);
  for (const std::string& text : {bytes_of("mo/mine-class/questions.xml"), bytes_of("r.md")})
    for (const std::string told : {"93\u00a0rpm", "237\u00a0N"}) {
      CAPTURE(told);
      CHECK(text.find(told) != std::string::npos);
    }
}
