// What a strict reader found on the sheets of the shipped mechanisms, by its causes.
#include <algorithm>
#include <cmath>

#include "drawings/paths/vectors.h"
#include "exercises/scenes/file/file_head.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

DrawnSheet shipped(const std::string& file, const std::string& sheet, const Assignments& set = {}) {
  const auto exercise = exercise_said(scenes::bytes_of(EPURE_SCENES "/" + file + ".yaml"));
  Givens givens(exercise->about().givens);
  for (const std::string& each : set) givens.set(each);
  return exercise->draw(sheet, givens, {});
}

bool has_label(const DrawnSheet& sheet, const std::string& text) {
  const auto& labels = sheet.sheet.figure.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const auto& label) { return label.text == text; });
}

double to_segment(drawings::Point p, drawings::Point from, drawings::Point to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double t = std::max(0.0, std::min(1.0, ((p.x - from.x) * dx + (p.y - from.y) * dy) / (dx * dx + dy * dy)));
  return std::hypot(p.x - from.x - t * dx, p.y - from.y - t * dy);
}

}  // namespace

TEST_CASE("a slot ends before the hinges of its link", "[scenes]") {
  const DrawnSheet sheet = shipped("quick-return", "velocities");
  const auto slots = all_of<drawings::Slot>(sheet);
  REQUIRE(slots.size() == 1);
  for (const drawings::FixedHinge& hinge : all_of<drawings::FixedHinge>(sheet))
    CHECK(to_segment(hinge.at, slots[0].from, slots[0].to) > 3);
}

TEST_CASE("the arc arrow of a rate is clear of slots and links", "[scenes]") {
  const std::string sheet_of[][2] = {{"quick-return", "velocities"},
                                     {"quick-return", "velocity-polygon-A"},
                                     {"cutting-stroke", "velocities"},
                                     {"peaucellier", "velocity-polygon-B"}};
  for (const auto& [file, name] : sheet_of) {
    CAPTURE(file, name);
    const DrawnSheet sheet = shipped(file, name);
    const auto arrows = all_of<drawings::Rotation>(sheet);
    REQUIRE(!arrows.empty());
    for (const drawings::Rotation& arrow : arrows)
      for (int i = 0; i <= 10; ++i) {
        const double at = arrow.from + (arrow.to - arrow.from) * i / 10;
        const drawings::Point p{arrow.centre.x + arrow.radius * std::cos(at),
                                arrow.centre.y + arrow.radius * std::sin(at)};
        for (const drawings::Slot& slot : all_of<drawings::Slot>(sheet))
          CHECK(to_segment(p, slot.from, slot.to) > slot.width / 2);
        for (const drawings::Line& line : all_of<drawings::Line>(sheet))
          if (line.meaning == drawings::Meaning::link && line.path.pieces.size() == 1 && line.path.pieces[0].straight)
            CHECK(to_segment(p, line.path.start, line.path.pieces[0].end) > 0.5);
      }
  }
}

TEST_CASE("a guide's wall stands where no link passes through it, and a point of the frame alone is no hinge",
          "[scenes]") {
  const DrawnSheet sheet = shipped("trammel", "velocities");
  const auto guides = all_of<drawings::Guide>(sheet);
  REQUIRE(guides.size() == 2);
  for (const drawings::Guide& guide : guides) {
    if (std::abs(guide.from.x - guide.to.x) < 1)
      CHECK(guide.from.y > guide.to.y);  // its wall on the left: the ladder is on the right
    else
      CHECK(guide.from.x < guide.to.x);
  }
  CHECK(all_of<drawings::FixedHinge>(sheet).empty());
  CHECK(has_label(sheet, "1"));
}

TEST_CASE("a rod that slides in a link of one hinge is a piston's, in a cylinder", "[scenes]") {
  const DrawnSheet sheet = shipped("oscillating-cylinder", "velocities");
  CHECK(all_of<drawings::Slot>(sheet).empty());
  for (const std::string letters : {"$s$", "3", "4", "$K$"}) CHECK(has_label(sheet, letters));
}

TEST_CASE("the step of a centre off the sheet stands where its lines leave", "[scenes]") {
  const DrawnSheet sheet = shipped("cutting-stroke", "instant-centres");
  for (const drawings::StepNumber& step : sheet.sheet.figure.steps)
    for (const drawings::Slider& block : all_of<drawings::Slider>(sheet))
      CHECK(drawings::distance(step.at, block.at) > 10);
}

TEST_CASE("centres that are one to the eye are drawn again, larger", "[scenes]") {
  CHECK(all_of<drawings::ScaleBar>(shipped("stephenson", "instant-centres-2")).size() == 2);
}

TEST_CASE("where the drive cannot go all round its positions divide what it can", "[scenes]") {
  for (const std::string file : {"chebyshev", "roberts", "peaucellier"}) {
    CAPTURE(file);
    const DrawnSheet sheet = shipped(file, "path");
    for (int i = 0; i < 12; ++i) CHECK(has_label(sheet, std::to_string(i)));
  }
  const DrawnSheet polodes = shipped("four-bar", "polodes", {"A0A=300mm", "AB=100mm", "B0B=250mm", "theta=20deg"});
  CHECK(tells(polodes, "In 12 positions of the drive"));
}

TEST_CASE("each result of the velocities and accelerations has its way on the sheet", "[scenes]") {
  CHECK(tells(shipped("oscillating-cylinder", "velocities"),
              "$\\vec{v}_{K}$ = $\\vec{v}_{A}$ + $\\vec{v}_{KA}$, $\\vec{v}_{KA}$ ⊥ $AK$, |$ω_{4}$|·$AK$."));
  CHECK(tells(shipped("oscillating-cylinder", "accelerations"),
              "$ω^{2}_{4}$·$AK$ from $K$ to $A$, and |$α_{4}$|·$AK$"));
  CHECK(tells(shipped("scotch-yoke", "accelerations"),
              "$\\vec{a}_{C}$ = $\\vec{a}_{A*}$: link 3 only slides, sheet 4."));
  CHECK(tells(shipped("rack-pinion", "velocities"), "|$ω_{5}$| = $v_{B}$ / $P_{45}C$ ($P_{45}$: sheet 6)."));
  CHECK(tells(shipped("rack-pinion", "accelerations"), "|$α_{5}$| = $a_{B}$ / $P_{45}C$"));
  CHECK(tells(shipped("oldham", "velocities"), "$ω_{4}$ = $ω_{3}$ = $ω_{2}$."));
  CHECK(
      tells(shipped("oldham", "acceleration-polygon"), "$α_{4}$ = $α_{3}$ = $α_{2}$. Positive: counter-clockwise."));
}

TEST_CASE("points in line have the line on which their images lie", "[scenes]") {
  const auto thin_lines = [](const DrawnSheet& sheet) {
    const auto lines = all_of<drawings::Line>(sheet);
    return std::count_if(lines.begin(), lines.end(),
                         [](const drawings::Line& line) { return line.meaning == drawings::Meaning::construction; });
  };
  // The carriers of two unknown vectors, and from a' and b' to p'.
  CHECK(thin_lines(shipped("chebyshev", "acceleration-polygon")) == 4);
}

TEST_CASE("a pole of accelerations is told without turning where nothing is turned", "[scenes]") {
  CHECK(tells(shipped("trammel", "acceleration-poles"), "$a_{A}$ = 0, so $K_{2}$ is $A$."));
  CHECK(tells(shipped("cardan-circles", "acceleration-poles"), "$α_{3}$ = 0, and so $γ$ = 0"));
}

TEST_CASE("which way forces and couples are positive is told", "[scenes]") {
  CHECK(tells(shipped("cutting-stroke", "forces"),
              "Positive: $\\it{N}_{C}$ upwards, $\\it{N}_{A}$ to the left, couples counter-clockwise."));
  CHECK(tells(shipped("plunger-pump", "forces-3-4"), "$\\it{N}_{b}$ upwards, $\\it{T}_{b}$ to the right"));
  CHECK(tells(shipped("cutting-stroke", "forces-5"), "Positive: $\\it{N}_{C}$ upwards."));
}

// Two opposite couples had one name, and the sign against the arrow.
TEST_CASE("a couple of friction is named by the link it acts on, as its force is", "[scenes]") {
  const DrawnSheet rod_and_block = shipped("plunger-pump", "forces-3-4"), crank = shipped("plunger-pump", "forces-2");
  const std::string M_23 = "$\\it{M}_{23}$", M_32 = "$\\it{M}_{32}$", M_34 = "$\\it{M}_{34}$",
                    M_43 = "$\\it{M}_{43}$";
  for (const std::string& M : {M_23, M_43, M_34}) CHECK(has_label(rod_and_block, M));
  CHECK(has_label(crank, M_32));
  CHECK_FALSE(has_label(crank, M_23));
  CHECK(tells(rod_and_block, "|" + M_43 + "| = "));
  CHECK(tells(rod_and_block, "= −" + M_23 + " − " + M_43 + "."));
  CHECK(tells(rod_and_block, M_34 + " = −" + M_43 + " = 1.939 N m"));
  CHECK(tells(crank, M_23 + " = −" + M_32 + " = −2.585 N m"));
}

TEST_CASE("the letters of forces are told, and where known ones were found", "[scenes]") {
  CHECK(tells(shipped("cutting-stroke", "forces"), "$\\it{N}_{A}$: force of $s$ (link\u00a04) on $A$"));
  CHECK(tells(shipped("engine", "forces"), "$\\it{N}_{b}$: force of $c$ (link\u00a01) on link\u00a04"));
  const DrawnSheet crank = shipped("cutting-stroke", "forces-2");
  const auto is_heading = [](const drawings::Block& block) {
    const auto* heading = std::get_if<drawings::Heading>(&block);
    return heading && heading->text == "From sheet 11";
  };
  CHECK(std::any_of(crank.sheet.column.begin(), crank.sheet.column.end(), is_heading));
  CHECK(tells(crank, "$\\it{N}_{A}$\u00a0=\u00a0−2230\u00a0N"));
  CHECK(tells(crank, "Positive: $\\it{N}_{A}$ to the left"));
}

TEST_CASE("a force too small for an arrow tells its sense: by its sign, or an arrow in its letters", "[scenes]") {
  CHECK(has_label(shipped("cutting-stroke", "forces-5"), "$\\it{N}_{C}$ = −87.8 N"));
  CHECK(has_label(shipped("engine", "forces"), "$\\it{W}_{4}$ = 8.83 N\u2009↓"));
}

TEST_CASE("couples are clear of supports", "[scenes]") {
  constexpr double foot = 6.9, half_ground = 5, hatched = 1, pieces = 12;  // mm
  for (const std::string file : {"cutting-stroke", "loaded-four-bar", "engine", "plunger-pump"}) {
    const DrawnSheet sheet = shipped(file, "forces");
    for (const auto& arc : all_of<drawings::Rotation>(sheet)) {
      if (arc.meaning != drawings::Meaning::force) continue;
      for (int i = 0; i <= pieces; ++i) {
        const drawings::Point P =
            arc.centre + arc.radius * drawings::direction(arc.from + (arc.to - arc.from) * i / pieces);
        for (const auto& support : all_of<drawings::FixedHinge>(sheet)) {
          const drawings::Point down = drawings::direction(support.down), base = support.at + foot * down,
                                side = half_ground * drawings::left_of(down);
          CAPTURE(file, i);
          CHECK(to_segment(P, base - side, base + side) > hatched);
        }
      }
    }
  }
}

TEST_CASE("a load that hangs beside a wheel's middle hangs from where it acts", "[scenes]") {
  const DrawnSheet sheet = shipped("winch", "forces");
  const auto arrows = all_of<drawings::Arrow>(sheet);
  const auto force = std::find_if(arrows.begin(), arrows.end(), [](const drawings::Arrow& arrow) {
    return arrow.meaning == drawings::Meaning::force;
  });
  REQUIRE(force != arrows.end());
  const auto& labels = sheet.sheet.figure.labels;
  const auto T = std::find_if(labels.begin(), labels.end(), [](const auto& label) { return label.text == "$T$"; });
  REQUIRE(T != labels.end());
  CHECK(drawings::distance(force->from, T->at) < 1);
}

TEST_CASE("what runs off a chart, and what shrinks to a point, is said", "[scenes]") {
  const DrawnSheet chart = shipped("quick-return", "chart-v_C_x", {"O2A=290mm", "h=690mm", "theta=89deg"});
  CHECK(tells(chart, "Off the chart: $v_{Cx,max}$."));
  CHECK(tells(chart, "goes on beyond its axis"));
  CHECK_FALSE(tells(shipped("quick-return", "chart-v_C_x"), "beyond its axis"));
  CHECK(tells(shipped("oldham", "velocity-polygon", {"phi=0deg"}),
              "|$ω_{4}$|·$BC$ = 0: $\\vec{v}_{C**}$ is no more than"));
}

TEST_CASE("images in one place are named together", "[scenes]") {
  const DrawnSheet sheet = shipped("parallelogram", "velocity-polygon");
  CHECK(has_label(sheet, "$a'$ ≡ $b'$ ≡ $c'$"));
  CHECK_FALSE(has_label(sheet, "$b'$"));
  CHECK_FALSE(has_label(sheet, "$c'$"));
}

TEST_CASE("no close-up shows all that the whole does", "[scenes]") {
  const DrawnSheet sheet = shipped("quick-return", "chart-theta_4", {"O2A=290mm", "h=690mm", "theta=89deg"});
  CHECK(all_of<drawings::ScaleBar>(sheet).size() == 1);
}

TEST_CASE("what a shipped mechanism is drawn from is among its givens", "[scenes]") {
  for (const std::string file : {"watt", "excavator", "jansen", "geared-five-bar", "stephenson"}) {
    CAPTURE(file);
    const auto exercise = exercise_said(scenes::bytes_of(EPURE_SCENES "/" + file + ".yaml"));
    CHECK(exercise->about().givens.size() > 6);
  }
}

TEST_CASE("an offset is told with the line and the point that it is of", "[scenes]") {
  CHECK(tells(shipped("chebyshev", "velocities"), "Distance of $P$ from $g$, to the left: $e$"));
}

TEST_CASE("a sheet tells what the letters of its givens mean, and from where its known vectors are", "[scenes]") {
  CHECK(tells(shipped("quick-return", "velocities"), "$h$: height of the guide $g$ above $O_{4}$;"));
  CHECK(tells(shipped("excavator", "acceleration-polygon-R"), "What these letters mean: sheet 1."));
  CHECK(tells(shipped("quick-return", "velocities"), "by the polygon, sheet 3."));
  CHECK(tells(shipped("peaucellier", "instant-centres-2"), "$P_{38}$: sheet 13."));
}

TEST_CASE("a centre at infinity that was found before leads to others: its lines are drawn", "[scenes]") {
  const DrawnSheet sheet = shipped("peaucellier", "instant-centres-2");
  const auto& labels = sheet.sheet.figure.labels;
  CHECK(std::count_if(labels.begin(), labels.end(), [](const drawings::Label& label) {
          return label.text.find("to $P_{67}$") != std::string::npos;
        }) == 3);  // the two on which it lies, and that on which P17 does
}

TEST_CASE("wheels that rest touch in their instant centre all the same", "[scenes]") {
  const CheckedExercise result = checked_text(scenes::bytes_of(EPURE_SCENES "/cardan-gear.yaml"), {"n=0"});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(value(result, "P13_y") == Approx(0.12 * std::sin(35 * 3.14159265358979323846 / 180)));
  CHECK(find(result, "P13_y").routes.size() == 3);
  // Where they move it is about that point.
  const CheckedExercise moving = checked_text(scenes::bytes_of(EPURE_SCENES "/cardan-gear.yaml"));
  const auto of = [&](const std::string& name) { return value(moving, name); };
  CHECK(of("v_C_x") == Approx(of("omega_3") * (of("P13_y") - of("C_y"))));
  CHECK(of("v_C_y") == Approx(-of("omega_3") * (of("P13_x") - of("C_x"))));
}

TEST_CASE("a path's sheet shows the hinges from which its points are found, numbered", "[scenes]") {
  const DrawnSheet five_bar = shipped("geared-five-bar", "path");
  CHECK(tells(five_bar,
              "Wheels 2 and 5 roll on each other, equal arcs of their pitch circles: the positions of $D$. "
              "In each $B$, by arcs about $A$ and $D$."));
  CHECK(has_label(five_bar, "5, 11"));  // D turns twice for each turn of A
  const auto lines = all_of<drawings::Line>(five_bar);
  const auto long_as = [&](double mm) {
    return std::count_if(lines.begin(), lines.end(), [&](const drawings::Line& line) {
      return line.meaning == drawings::Meaning::construction && line.path.pieces.size() == 1 &&
             std::abs(drawings::distance(line.path.start, line.path.pieces[0].end) - mm) < 0.01;
    });
  };
  CHECK(long_as(70) == 12);  // AB and DB, at 1 : 2
  CHECK(long_as(60) == 12);
  // Of a plate one side: 100 mm left of the middle of AB, at 1 : 5.
  const DrawnSheet four_bar = shipped("four-bar", "path");
  CHECK(has_label(four_bar, "7, 8"));
  // Points of two series in one place have each its number.
  CHECK_FALSE(has_label(shipped("trammel", "path"), "0, 4, 8"));
  CHECK(has_label(shipped("trammel", "path"), "0, 8"));
  CHECK(tells(shipped("cardan-gear", "path"),
              "Wheels 1 and 3 roll on each other, equal arcs of their pitch circles; on tracing paper $P$ goes with "
              "link 3 and marks a point."));
}

TEST_CASE("what a close-up shows leaves joints that stand alone, and their letters, in the whole", "[scenes]") {
  const auto count = [](const DrawnSheet& sheet, const std::string& text) {
    const auto& labels = sheet.sheet.figure.labels;
    return std::count_if(labels.begin(), labels.end(), [&](const auto& label) { return label.text == text; });
  };
  CHECK(count(shipped("watt", "instant-centres-2"), "$A$") == 2);
  // Beside the arc of a rate that is left to the close-up, and as far from its centre.
  CHECK(count(shipped("peaucellier", "instant-centres"), "$A$") == 1);
  CHECK(count(shipped("peaucellier", "instant-centres"), "$ω_{2}$") == 1);
}

TEST_CASE("numbers of links keep away from where the links cross", "[scenes]") {
  const DrawnSheet sheet = shipped("peaucellier", "velocities");
  drawings::Point two{}, four{};
  for (const drawings::Label& label : sheet.sheet.figure.labels) {
    if (label.text == "2") two = label.at;
    if (label.text == "4") four = label.at;
  }
  CHECK(drawings::distance(two, four) > 15);
}

TEST_CASE("vectors set aside from one link stand beside each other, and sums close their triangles", "[scenes]") {
  const auto arrow = [](const DrawnSheet& sheet, const std::string& name) {
    for (const drawings::Arrow& each : all_of<drawings::Arrow>(sheet))
      if (each.name == name) return each;
    FAIL("no vector " << name);
    return drawings::Arrow{};
  };
  const DrawnSheet engine = shipped("engine", "accelerations");
  const drawings::Arrow a_A = arrow(engine, "a_A"), a_S = arrow(engine, "a_S");
  CHECK(to_segment(a_S.to, a_A.from, a_A.to) > 2);
  // v_A and v_KA lead from K to the tip of v_K.
  const DrawnSheet cylinder = shipped("oscillating-cylinder", "velocities");
  const drawings::Arrow v_K = arrow(cylinder, "v_K");
  int leads = 0;
  for (const drawings::Line& line : all_of<drawings::Line>(cylinder)) {
    if (line.meaning != drawings::Meaning::construction || line.path.pieces.size() != 1) continue;
    leads += drawings::distance(line.path.start, v_K.from) < 0.01;
    leads += drawings::distance(line.path.pieces[0].end, v_K.to) < 0.01;
  }
  CHECK(leads == 2);
  // The terms of another sum, through the tip of a_C, do not keep that on its link.
  const DrawnSheet gear = shipped("cardan-gear", "accelerations");
  const auto hinges = all_of<drawings::Hinge>(gear);
  REQUIRE(hinges.size() == 1);
  CHECK(drawings::distance(arrow(gear, "a_C").from, hinges[0].at) > 1);
}

TEST_CASE("coordinates of centres tell from where they count", "[scenes]") {
  const auto head_of = [](const DrawnSheet& sheet) {
    for (const drawings::Block& block : sheet.sheet.column)
      if (const auto* table = std::get_if<drawings::Table>(&block)) return table->head.front();
    return std::string("no table");
  };
  CHECK(head_of(shipped("geneva", "instant-centres")) == "from $O_{2}$");
  CHECK(head_of(shipped("trammel", "polodes")) == "from $O$");
}

TEST_CASE("a centre on the line at infinity is told by the line that leads to it", "[scenes]") {
  CHECK(tells(shipped("oldham", "instant-centres"),
              "$P_{24}$ at infinity along $P_{12}$$P_{14}$: $P_{23}$ and $P_{34}$ are at infinity too."));
}

TEST_CASE("the ends of a drive's range are constructed", "[scenes]") {
  CHECK(tells(shipped("chebyshev", "range-theta_2"),
              "$A_{max}$ where the arc about $A_{0}$ with $A_{0}A$ and that about $B_{0}$ with $B_{0}B$ + $AB$ "
              "meet"));
  CHECK(tells(shipped("excavator", "range-l_PQ"), "on the line $PA$, at the distance $AQ$ from $A$, away from $P$."));
  CHECK(tells(shipped("excavator", "range-l_PQ"), "on the line $PA$, at the distance $AQ$ from $A$, towards $P$."));
}
