// A second picture, larger, of what lies close together; and pictures that need none, as they are large enough.
#include <algorithm>
#include <cmath>
#include <map>

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Where the letters of one point stand, each once on the sheet; none closer to another than this (mm).
void stand_apart(const drawings::Figure& figure, const std::vector<std::string>& letters, double least) {
  std::map<std::string, drawings::Point> at;
  for (const std::string& each : letters) {
    CAPTURE(each);
    std::vector<drawings::Point> found;
    for (const drawings::Label& label : figure.labels)
      if (label.text == each) found.push_back(label.at);
    REQUIRE(found.size() == 1);
    at.emplace(each, found.front());
  }
  for (const auto& [one, p] : at)
    for (const auto& [other, q] : at)
      if (one < other) {
        CAPTURE(one, other);
        CHECK(drawings::length(p - q) >= least);
      }
}

// Paper over nature of a caption in the title block: "1 : 50".
double ratio(const std::string& caption) {
  const std::size_t colon = caption.find(" : ");
  return std::stod(caption.substr(0, colon)) / std::stod(caption.substr(colon + 3));
}
std::vector<double> ratios(const DrawnSheet& drawn) {
  std::vector<double> all;
  for (const std::string& caption : drawn.sheet.title_block.scales)
    if (caption.find(" : ") != std::string::npos) all.push_back(ratio(caption));
  return all;
}

std::string all_steps(const drawings::Sheet& sheet) {
  std::string all;
  for (const drawings::Block& block : sheet.column)
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) all += line + "\n";
  return all;
}

bool is_round_plate(const drawings::Mark& mark) {
  const auto* area = std::get_if<drawings::Area>(&mark);
  return area && area->meaning == drawings::Meaning::plate && !area->path.pieces.front().straight;
}

}  // namespace

// A crank of 0.15 m before a rocker of 5 m: 3 mm at 1 : 50. (Without close-ups A₀ and A stand so close together.)
TEST_CASE("joints that lie together beside far ones are drawn again, larger, and have their letters there alone") {
  const Tried four_bar("four-bar");
  const Assignments small{"B0B=5", "x_B0=-4.9", "y_B0=-0.3", "phi=200"};
  for (const std::string name : {"poles", "velocity-diagram", "acceleration-diagram", "acceleration-pole"}) {
    const drawings::Figure figure = four_bar.draw(name, small).sheet.figure;
    std::vector<drawings::Point> hinges;
    for (const drawings::Mark& mark : figure.marks)
      if (const auto* hinge = std::get_if<drawings::Hinge>(&mark)) hinges.push_back(hinge->at);
    REQUIRE(hinges.size() >= 2);
    CAPTURE(name);
    for (const drawings::Mark& mark : figure.marks)
      if (const auto* fixed = std::get_if<drawings::FixedHinge>(&mark))
        for (const drawings::Point& hinge : hinges) CHECK(drawings::length(hinge - fixed->at) > 12);
    const auto times = [&](const std::string& letters) {
      return std::count_if(figure.labels.begin(), figure.labels.end(),
                           [&](const drawings::Label& label) { return label.text == letters; });
    };
    for (const char* letters : {"$A_{0}$", "$A$", "$B$", "$B_{0}$"}) CHECK(times(letters) == 1);
    if (name == "poles") CHECK(times("$ω_{2}$") == 1);  // beside its arc, which the whole has no more
  }
}

TEST_CASE("a linkage of which all joints can be told apart has one picture") {
  const drawings::Figure figure = Tried("four-bar").draw("poles", {}).sheet.figure;
  CHECK(std::count_if(figure.marks.begin(), figure.marks.end(), [](const drawings::Mark& mark) {
          return std::holds_alternative<drawings::FixedHinge>(mark);
        }) == 2);
}

// Seven letters within 15 mm at 1 : 50.
TEST_CASE("a crowd of letters is parted by a close-up") {
  const Assignments small{"B0B=5", "x_B0=-4.9", "y_B0=-0.3", "phi=200"};
  stand_apart(Tried("four-bar").draw("dead-centres", small).sheet.figure,
              {"$A_{0}$", "$A_{1}$", "$A_{2}$", "$B_{1}$", "$B_{2}$", "$C_{1}$", "$C_{2}$"}, 6);
  // A stationarity circle of 4 mm at 1 : 10, and an inflection circle of 8 mm.
  stand_apart(Tried("slider-crank-acceleration").draw("circles", {"phi=179.5", "alpha_2=10000"}).sheet.figure,
              {"$P_{0}$", "$S$", "$S'$"}, 6);
  stand_apart(Tried("four-bar-analytic")
                  .draw("curvature", {"A0B0=0.8", "A0A=0.6", "AB=0.5", "B0B=0.7", "phi=-60", "n=-400"})
                  .sheet.figure,
              {"$P_{0}$", "$A'$", "$F$", "$J$", "$G'_{3}$"}, 5);
  // A fixed circle of 4 mm.
  stand_apart(Tried("roulette").draw("instant", {"r=0.45", "R=0.02", "d=0.9"}).sheet.figure,
              {"$P_{0}$", "$J$ ≡ $K$", "$Ω$", "$O$"}, 3);
}

TEST_CASE("the frame of a close-up tells its scale, which the title block has too") {
  const DrawnSheet drawn = Tried("four-bar").draw("parallel-links", {"B0B=5", "x_B0=-4.9", "y_B0=-0.3"});
  const std::vector<std::string>& scales = drawn.sheet.title_block.scales;
  std::size_t told = 0;
  for (const drawings::Label& label : drawn.sheet.figure.labels)
    if (label.text.find(" : ") < 4) {
      CHECK(std::find(scales.begin(), scales.end(), label.text) != scales.end());
      ++told;
    }
  CHECK(told == 1);
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* bar = std::get_if<drawings::ScaleBar>(&mark)) CHECK_THAT(bar->caption, !Contains("centre"));
}

// A retrograde polygon of 8 mm beside a direct one ten times as large.
TEST_CASE("a polygon whose corners crowd is drawn again at a scale that its frame and the title block tell") {
  const DrawnSheet drawn =
      Tried("friction-efficiency").draw("two-forces", {"phi=6", "wedge_collar.Q=1", "wedge_collar.theta=70"});
  const std::vector<std::string>& scales = drawn.sheet.title_block.scales;
  const auto in_frame = std::find_if(drawn.sheet.figure.labels.begin(), drawn.sheet.figure.labels.end(),
                                     [](const drawings::Label& label) { return label.text.starts_with("1 cm"); });
  REQUIRE(in_frame != drawn.sheet.figure.labels.end());
  CHECK(std::count(scales.begin(), scales.end(), in_frame->text) == 1);
  // P' = 1.390 N where 1 cm is 0.5 N, once: the whole leaves it to the close-up.
  std::vector<double> found;
  for (const Measurement& each : drawn.measurements)
    if (each.quantity == "wedge_collar_two_point.P_retrograde")
      found.push_back(drawings::length(each.to - each.from));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Catch::Matchers::WithinAbs(27.8, 0.05));
  stand_apart(Tried("truss").draw("plan", {"shape=pratt", "n=8", "h=0.8", "W=1234.5678", "beta=30"}).sheet.figure,
              {"$p$", "$s$", "$t$"}, 10);
}

TEST_CASE("a long side that begins in the part of a close-up stays in the whole") {
  const DrawnSheet drawn = Tried("pin-in-slot").draw("acceleration", {"OB=2.8"});
  const auto count = std::count_if(drawn.measurements.begin(), drawn.measurements.end(),
                                   [](const Measurement& each) { return each.quantity == "a_cor"; });
  CHECK(count == 1);
}

// Of 4 cm in a slot of 2 m.
TEST_CASE("a disc that would be a dot is drawn again, larger") {
  double widest = 0;
  const DrawnSheet drawn = Tried("pin-in-slot").draw("kinematics", {"OB=2", "R=0.02", "omega=-1"});
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (is_round_plate(mark))
      widest = std::max(widest, drawings::bounds(std::get<drawings::Area>(mark).path).width());
  CHECK(widest > 15);
}

TEST_CASE("beside rays to a large circle the whole mechanism is drawn with its centres of curvature") {
  const auto joints = [](const drawings::Figure& figure) {
    std::size_t shown = 0;
    for (std::size_t i = 0; i < figure.marks.size(); ++i) {
      const auto* hinge = std::get_if<drawings::Hinge>(&figure.marks[i]);
      const auto* fixed = std::get_if<drawings::FixedHinge>(&figure.marks[i]);
      if (!hinge && !fixed) continue;
      const auto window = static_cast<std::size_t>(figure.window_of.at(i));
      shown += drawings::contains(figure.windows.at(window), hinge ? hinge->at : fixed->at);
    }
    return shown;
  };
  // A, B and both hinges of the frame; of the slider-crank A, B and A₀.
  CHECK(joints(Tried("four-bar").draw("curvature", {"phi=127.2", "alpha_2=3"}).sheet.figure) >= 4);
  CHECK(joints(Tried("four-bar").draw("curvature", {"B0B=5", "x_B0=-4.9", "y_B0=-0.3", "phi=200"}).sheet.figure) >=
        4);
  CHECK(joints(Tried("slider-crank-acceleration")
                   .draw("curvature", {"n=0.01", "delta=135", "e=-0.08", "alpha_2=-1e-6"})
                   .sheet.figure) >= 3);
}

TEST_CASE("beside a detail the whole inflection circle is on the sheet") {
  const DrawnSheet drawn = Tried("four-bar").draw("circles", {"B0B=5", "x_B0=-4.9", "y_B0=-0.3", "phi=200"});
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block))
      CHECK_THAT(paragraph->text, !Contains("Off the sheet"));
}

// Of 2 mm, beside links of half a metre.
TEST_CASE("the picture of a small path is as large as the path asks") {
  const Assignments tiny{"A0B0=0.8", "A0A=0.001", "AB=0.5", "B0B=0.7", "branch=right", "n=1"};
  const std::vector<double> all = ratios(Tried("four-bar-analytic").draw("coupler-curve", tiny));
  CHECK(all.size() >= 2);
  for (const double each : all) CHECK((each <= 0.2 || each >= 10));  // all of the linkage, or the path and the crank
}

// A polygon in five or six stages counts as one: the linkage beside it is not 8 mm small.
TEST_CASE("the stages of a polygon do not make the linkage beside them small") {
  const Tried rivals("rivals-polygons");
  CHECK(ratios(rivals.draw("acceleration-of-G", {"phi=180"})).front() >= 0.05);
  CHECK(ratios(rivals.draw("acceleration-of-G", {"alpha_2=-5000", "phi=300", "n=-30"})).front() >= 0.05);
}

TEST_CASE("of a path that goes round a small circle again and again a round to either side is drawn") {
  double longest = 0;
  for (const drawings::Mark& mark :
       Tried("roulette").draw("instant", {"r=0.45", "R=0.02", "d=0.9"}).sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->meaning == drawings::Meaning::locus)
      longest = std::max(longest, static_cast<double>(line->path.pieces.size()));
  CHECK(longest > 0);
  CHECK(longest < 60);
}

TEST_CASE("two paths of which one dwarfs the other have each its own scale") {
  const std::vector<double> all = ratios(Tried("cycloid-involute").draw("involute-instants", {"t2=2"}));
  CHECK(all.size() == 3);
}

// B ahead of A and behind it: A bears its number once, and B none, for each of its C has one.
TEST_CASE("of two series of positions each number stands once on the picture, and the text says whose it is") {
  const Assignments two{"phi=200", "e=0.1", "delta=90", "l=0.25", "BC=0.1", "AC=0.2"};
  const DrawnSheet drawn = Tried("slider-crank-velocity").draw("coupler-curve", two);
  std::map<std::string, int> times;
  for (const drawings::Label& label : drawn.sheet.figure.labels) ++times[label.text];
  CHECK(times["7′"] == 1);
  CHECK(times["7"] == 2);  // of A, and of C
  CHECK_THAT(all_steps(drawn.sheet), Contains("Its number is that of the $C$"));
  const DrawnSheet polodes = Tried("slider-crank-velocity").draw("polodes", two);
  CHECK(ratios(polodes).front() == 0.2);
}

TEST_CASE("the mechanism is whole beside its polodes, also where the curves lead elsewhere") {
  const drawings::Figure figure =
      Tried("slider-crank-velocity").draw("polodes", {"e=0.15", "delta=60", "phi=250"}).sheet.figure;
  int hinges = 0;
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    if (const auto* hinge = std::get_if<drawings::Hinge>(&figure.marks[i])) {
      ++hinges;
      CHECK(drawings::contains(figure.windows.at(static_cast<std::size_t>(figure.window_of.at(i))), hinge->at));
    }
  CHECK(hinges == 2);  // in one picture, as points of both curves that all but touch are no crowd
  // As many of them as have room at 1 : 5, where the curves' points stand closest.
  CHECK(ratios(Tried("slider-crank-velocity").draw("polodes", {"l=0.22", "phi=95"})) == std::vector<double>{0.2});
}

TEST_CASE("beside a far larger inflection circle the slider-crank has a picture of its own") {
  const Tried slider_crank("slider-crank-acceleration");
  CHECK(ratios(slider_crank.draw("circles", {})).size() == 1);
  const DrawnSheet drawn = slider_crank.draw("circles", {"e=-0.15", "delta=-120", "phi=300", "alpha_2=-900"});
  CHECK(ratios(drawn) == std::vector<double>{0.01, 0.1});
  stand_apart(drawn.sheet.figure, {"$A_{0}$", "$M$", "$C$", "$K$", "$S$", "$S'$", "$A''$"}, 6);
}

TEST_CASE(
    "loads that are small beside the reactions of a truss are parted by a close-up, and its plan is as large as "
    "it may be") {
  const Assignments slender{"shape=bracket", "n=8", "h=1", "W=500", "beta=180"};
  const auto forces = [](const DrawnSheet& drawn) {
    std::vector<std::string> scales = drawn.sheet.title_block.scales;
    std::erase_if(scales, [](const std::string& scale) { return !scale.starts_with("1 cm"); });
    return scales;
  };
  CHECK(forces(Tried("truss").draw("reactions", slender)).size() == 2);
  const DrawnSheet plan = Tried("truss").draw("plan", slender);
  CHECK_THAT(forces(plan).at(0), Contains("5000 N"));
  CHECK(forces(plan).size() == 2);
  stand_apart(plan.sheet.figure, {"$l$", "$m$", "$n$"}, 5);
}

TEST_CASE("asymptotes that are on the sheet have their step there") {
  const DrawnSheet drawn =
      Tried("slider-crank-velocity").draw("polodes", {"phi=1", "e=0.05", "delta=-30", "l=2", "BC=1.9"});
  CHECK_THAT(all_steps(drawn.sheet), !Contains("(Off the sheet.)"));
  CHECK(drawn.sheet.figure.steps.size() == 4);
}

TEST_CASE("letters of close-ups, and beside them, find room") {
  const Assignments small{"B0B=5", "x_B0=-4.9", "y_B0=-0.3", "phi=200"};
  letters_find_room(Tried("four-bar"), {small}, {"slider-crank", "velocity-diagram"});
  letters_find_room(Tried("pin-in-slot"), {{"OB=2", "R=0.02", "omega=-1"}}, {"forces", "power-balance"});
  letters_find_room(Tried("roulette"), {{"r=0.45", "R=0.02", "d=0.9"}}, {"path"});
  letters_find_room(Tried("slider-crank-acceleration"), {{"phi=179.5", "alpha_2=10000"}}, {"polar-diagram", "poles"});
  letters_find_room(Tried("four-bar-analytic"), {{"A0B0=0.8", "A0A=0.6", "AB=0.5", "B0B=0.7", "phi=-60", "n=-400"}},
                    {"accelerations"});
}
