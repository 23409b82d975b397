// What other programs have, as a scene: the examples of pyslvs (pyslvs/example.py of KmolYuan/pyslvs) and the
// templates of PMKS+ (template-linkages.ts of PMKS-Web/PMKSWeb) pass check with every joint where it was drawn; what
// a scene cannot say, or is damaged, is refused with a sentence.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "exercises/cli/run.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/import/drawn_linkage.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

// "R" or a kind with its angle, the place in the source's unit, the links.
struct Joint {
  std::string kind;
  double x, y;
  std::string links;
};

std::string expression(const std::vector<Joint>& joints) {
  std::string text = "M[";
  for (const Joint& joint : joints)
    text += fmt::format("J[{}, color[Green], P[{}, {}], L[{}]], ", joint.kind, joint.x, joint.y, joint.links);
  return text + "]";
}

std::string refusal_of_import(const std::string& text) {
  try {
    scenes::import_scene(text, "f");
  } catch (const scenes::BadScene& bad) {
    return bad.what();
  }
  return {};
}

// The scene passes check, and each joint that moves lies within the last bits of its drawn place.
void is_as_drawn(const std::string& text, const std::vector<Joint>& drawn, double metres) {
  const std::string scene = scenes::import_scene(text, "f").scene;
  const CheckedExercise checked = checked_text(scene);
  CAPTURE(scene, complaints(checked));
  CHECK(checked.passed());
  CHECK(checked.undecided.empty());
  std::size_t moving = 0;
  std::string letter = "A";
  for (const Joint& joint : drawn) {
    if (joint.kind.starts_with("P,")) continue;  // has no letter
    for (const auto& [name, place] : {std::pair(letter + "_x", joint.x), std::pair(letter + "_y", joint.y)}) {
      const auto found = std::find_if(checked.quantities.begin(), checked.quantities.end(),
                                      [&](const CheckedQuantity& each) { return each.spec.name == name; });
      if (found == checked.quantities.end()) continue;
      CAPTURE(name);
      CHECK(std::abs(found->settled.enclosure.value - place * metres) < 1e-15);
      ++moving;
    }
    ++letter[0];
  }
  CHECK(moving >= 2);
}

struct ImportRun {
  int exit;
  std::string out, err;
};
ImportRun run_import(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "import");
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), arguments, out, err, {});
  return {exit, out.str(), err.str()};
}

const std::string pmks = "https://app.pmksplus.com/?";
const std::string four_bar_link =
    pmks +
    "2P.Ay,1E8.K,0.1011.MA,A,0mv,0VU,0.GB,B,0e_,E6,0.GC,C,l1,WW,0.KD,D,qD,0Pk,0..YRAB,AB,Fe,Fe,0ix,08i,c5cae9,A,B,,."
    "YRBC,BC,Fe,Fe,32,NJ,303e9f,B,C,,.YRCD,CD,Fe,Fe,nd,3P,0d125a,C,D,,...N_v";

}  // namespace

TEST_CASE("examples of pyslvs pass check where they were drawn", "[scenes]") {
  const std::vector<std::vector<Joint>> examples{
      {{"R", 0, 0, "ground, L1"},  // Watt I
       {"R", -18.6154, 41.3846, "L1, L2"},
       {"R", 29, 116.5, "L2, L3"},
       {"R", 38, 69, "L2, L5"},
       {"R", 95, 143, "L3, L4"},
       {"R", 122, 76.5, "L4, L5"},
       {"R", 64, 0, "ground, L5"}},
      {{"R", 0, 0, "ground, L1"},  // Jansen's linkage
       {"R", 9.61, 11.52, "L1, L2, L4"},
       {"R", -38, -7.8, "ground, L3, L5"},
       {"R", -35.24, 33.61, "L2, L3"},
       {"R", -77.75, -2.54, "L3, L6"},
       {"R", -20.1, -42.79, "L4, L5, L7"},
       {"R", -56.05, -35.42, "L6, L7"},
       {"R", -22.22, -91.74, "L7"}},
      {{"R", -67.38, 36.13, "ground, L1"},  // Crank lifter: pins in slots of the ground, and of a link that moves
       {"R", -68.925, 55.925, "L1, L2"},
       {"RP, A[0.0]", 11.88, 0, "ground, L2, L3"},
       {"R", 50.775, 24.7908, "L3, L4"},
       {"R", 80.375, 8.625, "ground, L4"},
       {"R", 109.1972, 63.8805, "L3, L5"},
       {"RP, A[0.0]", 0.82, 64.42, "L5, L4"}},
      {{"R", -33.625, -19.625, "ground, L1"},  // Crank slider (P joint): a block in a guide at 30°
       {"R", -48.375, 12.125, "L1, L3"},
       {"R", 17.125, 33.875, "L2, L3"},
       {"P, A[30.0]", 51.38, -12.63, "ground, L2"},
       {"R", 50.35, 53.117, "L2, L5"},
       {"R", 143.455, 65.967, "L4, L5"},
       {"R", 99.244, 20.447, "ground, L4"}},
      {{"R", -30, -10, "ground, L1"},  // Crank slider (Three bar): a slot over a pin of the ground
       {"R", -9.9986, 4.999, "L1, L2"},
       {"RP, A[0.0]", 65, -45, "L2, ground"}},
      {{"R", -15, 0, "ground, L1"},  // Inverted slider
       {"R", 41, 0, "ground, L3"},
       {"R", -8, 25, "L1, L2"},
       {"P, A[0.0]", 44, 41, "L3, L2"}}};
  for (const auto& joints : examples) is_as_drawn(expression(joints), joints, 0.001);
}

TEST_CASE("templates of PMKS+ pass check where they were drawn, at the speed they have", "[scenes]") {
  is_as_drawn(four_bar_link,
              {{"R", -3.129, -2.014, ""}, {"R", -2.622, 0.902, ""}, {"R", 3.009, 2.08, ""}, {"R", 3.341, -1.646, ""}},
              0.01);
  is_as_drawn(pmks +
                  "2P.Ay,1E8.K,0.1011.MA,A,0mA,0c,0.GB,B,0Yt,bK,0.GC,C,il,H-,0.LD,D,il,H-,0..YRAB,AB,Fe,Fe,0fW,IN,"
                  "c5cae9,A,B,,.YRBC,BC,Fe,Fe,4y,Rf,303e9f,B,C,,.YPCD,CD,Fe,0,0,0,,C,D,,...N_j",
              {{"R", -3.082, -0.038, ""}, {"R", -2.231, 2.388, ""}, {"R", 2.863, 1.151, ""}}, 0.01);
  is_as_drawn(pmks +
                  "2P.Ay,1E8.K,0.1011.MA,A,0,0,0.GB,B,0,ku,0.KC,C,Fe,0,0.GD,D,095,1A7,0.HP,P,0,ku,0,CD,C,D..YRAB,AB,"
                  "Fe,Fe,0,NS,c5cae9,A,B,,.YRCD,CD,Fe,Fe,3H,b4,303e9f,C,D,,.YPBP,BP,Fe,0,0,0,,B,P,,...N_w",
              {{"R", 0, 0, ""}, {"R", 0, 3, ""}, {"R", 1, 0, ""}, {"R", -0.581, 4.743, ""}}, 0.01);
  is_as_drawn(pmks +
                  "2P.Ay,1E8.K,0.1011.MA,A,0,0,0.GB,B,Fe,0,0.OC,C,Fe,0VG,0.GD,D,Fe,S8,0.HE,E,Fe,0,0,CD,C,D.LF,F,Fe,"
                  "0VG,0..YRAB,AB,Fe,Fe,7q,0,c5cae9,A,B,,.YRCD,CD,Fe,Fe,Fe,01a,303e9f,C,D,,.YPBE,BE,Fe,0,0,0,,B,E,,."
                  "YPCF,CF,Fe,0,0,0,,C,F,,...N_Z",
              {{"R", 0, 0, ""}, {"R", 1, 0, ""}, {"R", 1, -2, ""}, {"R", 1, 1.8, ""}}, 0.01);
  const std::string scene = scenes::import_scene(four_bar_link, "f").scene;
  CHECK_THAT(scene, Contains("speed: -20 rpm"));  // clockwise
  CHECK_THAT(scene, Contains("A: [-3.129, -2.014]"));
}

TEST_CASE("numbers of an expression stand in the file as they were written, and what is taken for granted is told",
          "[scenes]") {
  const auto made = scenes::import_scene(
      "M[ # a crank\n J[R, P[.10, -0.20e1], L[ground, L1]],\n J[R, color[(1, 2, 3)], P[+5., 7], L[L1,]],]", "mine");
  CHECK_THAT(made.scene, Contains("id: mine\n") && Contains("A: [.10, -0.20e1]") && Contains("B: [+5., 7]") &&
                             Contains("2: A B  # L1") && Contains("drive: {link: 2, speed: 1 rad/s}"));
  REQUIRE(made.notes.size() == 2);
  CHECK_THAT(made.notes[0].italian, Contains("mm"));
  CHECK_THAT(made.notes[1].english, Contains("link 2 is driven in A"));
}

TEST_CASE("what a scene cannot say, or is no such text, is refused with a sentence", "[scenes]") {
  const auto says = [](const std::string& text, const std::string& sentence) {
    CAPTURE(text.substr(0, 200), sentence);
    CHECK_THAT(refusal_of_import(text), Contains(sentence));
  };
  // Stephenson II: a triad.
  says(expression({{"R", -45, -15.5, "ground, L1"},
                   {"R", -52, 25.5, "L1, L2"},
                   {"R", -36, 76.25, "L2, L5"},
                   {"R", -4, 3, "L2, L4"},
                   {"R", 29, 27.5, "L3, L4"},
                   {"R", 85.25, -27.25, "ground, L3"},
                   {"R", 57.5, 77, "L3, L5"}}),
       "move only together");
  says("M[]", "none to drive");
  says("M[", "character 3: J[ is missing");
  says("M[J[R, P[0, 0], L[ground, L1]]", "a comma or ] is missing");
  says("M[J[X, P[0, 0], L[ground]]]", "of kind R, RP or P");
  says("M[J[RP, P[0, 0], L[ground, L1]]]", "A[ is missing");
  says("M[J[RP, A[0], P[0, 0], L[ground]]]", "too few links");
  says("M[J[R, P[0, 0], L[L1, L1]]]", "twice");
  says("M[J[R, P[0, 0.0.0], L[ground, L1]], J[R, P[1, 1], L[L1]]]", "\"0.0.0\"");
  says("M[J[R, P[0, 0], L[ground, L1]]]M", "behind the mechanism");
  says("M[J[R, color[Green", "] is missing");
  says(std::string("M[J[R, P[0, \0], L[ground]]]", 28), "a number is asked");
  says("M[" + std::string(1'000'000, '['), "65536 at most");
  std::string many = "M[";
  for (int i = 0; i < 261; ++i) many += fmt::format("J[R, P[{}, 0], L[L1]],", i);
  says(many + "]", "261 joints are too many");

  says("no/such/file", "there is no such file");
  says(pmks, "damaged");
  says(pmks + "j=A,0,0&l=AB", "damaged");
  says("https://app.pmksplus.com", "question mark");
  for (std::size_t cut = pmks.size(); cut < four_bar_link.size(); ++cut) {
    std::string link = four_bar_link.substr(0, cut);
    says(link, "damaged");  // its last letter counts the others
  }
  // The first joint, and the first link, begin with nothing; the last letter is right.
  says(pmks + "2P.Ay,1E8.K,0.1011.,A,0mA,0c,0..W", "damaged");
  says(pmks + "2P.Ay,1E8.K,0.1011.MA,A,0mA,0c,0..,AB..d", "damaged");
  // Cylinder_Boom, and Pedaling_Leg, whose input turns two links that move.
  says(pmks +
           "2P.Ay,Fe.K,0.1011.KO,O,0,0,0.GC,C,0,_W,0.KG,G,ku,0,0.GN,N,Ju,Z-,0.OP,P,R0,QX,0.pS,S,R0,QX,0,GN,G,N..YROC,"
           "OC,Fe,Fe,0,VG,c5cae9,O,C,,.YRGN,GN,Fe,Fe,XO,I0,303e9f,G,N,,.YRPC,PC,Fe,Fe,DW,iW,0d125a,P,C,,.YPPS,PS,Fe,"
           "0,0,0,,P,S,,...N_e",
       "cylinders");
  says(pmks +
           "2P.Ay,1E8.K,0.1011.KB,B,0,0,0.GP,P,Qa,0,0.KH,H,0NS,1Qe,0.IK,K,c5,13o,0..YRHK,HK,Fe,Fe,7L,1FD,c5cae9,H,K,,"
           ".YRKP,KP,Fe,Fe,WL,Xv,303e9f,K,P,,.YRBP,BP,Fe,Fe,DI,0,0d125a,B,P,,...N_p",
       "turns on the ground");
}

TEST_CASE("epure import writes the file, or nothing", "[scenes]") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("epure-import-{}", ::getpid());
  std::filesystem::create_directory(folder);
  const std::string file = folder / "mine.yaml", text = folder / "link.txt";
  std::ofstream(text) << "\n" << four_bar_link << "\r\n";
  const ImportRun refused = run_import({"M[J[", "-o", file, "--lang", "it"});
  CHECK(refused.exit == 2);
  CHECK_THAT(refused.err, Contains("l'espressione, carattere 5"));
  CHECK_FALSE(std::filesystem::exists(file));
  CHECK(run_import({}).exit == 2);
  CHECK(run_import({text, "-o", text}).exit == 2);
  const ImportRun made = run_import({text, "-o", file});
  CHECK(made.exit == 0);
  CHECK(made.out == file + "\n");
  CHECK_THAT(scenes::bytes_of(file), Contains("id: mine\n"));
  CHECK_THAT(run_import({four_bar_link}).out, Contains("id: imported\n"));
  std::filesystem::remove_all(folder);
}
