// Which step drew which mark, where it is known by construction.
#include "drawings/sheet/steps_of_marks.h"

#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

// v_B = v_A + v_BA, as a sheet draws it: a known vector (1), the line of the second (2), that of the sum (3), which
// end each other in b'; then the middle m' of v_BA (4). The mechanism stands beside it.
struct Polygon {
  Point O{100, 100}, a{140, 100}, b{140, 130}, m{140, 115}, hinge{20, 20};
  Figure figure{
      .marks = {Arrow{O, a, Meaning::velocity, "v_A"}, Line{segment({140, 92}, {140, 138})},
                Arrow{a, b, Meaning::velocity, "v_BA"}, Line{segment({93.6, 95.2}, {146.4, 134.8})},
                Arrow{O, b, Meaning::velocity, "v_B"}, Dot{m}, Hinge{hinge},
                Line{segment(hinge, {60, 20}), Meaning::link}, RightAngle{a, 3.141592653589793, 1.5707963267948966},
                Dot{O}, Line{segment(m, hinge)}, Slider{{60, 20}}},
      .labels = {{.text = "$\\vec{v}_{A}$", .at = O, .to = a},
                 {.text = "∥ $x$", .at = {140, 138}},
                 {.text = "$b'$", .at = b},
                 {.text = "$m'$", .at = m},
                 {.text = "$A$", .at = hinge},
                 {.text = "4", .at = {45, 23}},
                 {.text = "$b'$", .at = {65, 23}}},
      .steps = {{1, {112, 100}}, {2, {140, 109}}, {3, {112, 109}}, {4, m}}};
  std::vector<Block> column{Heading{"Construction"},
                            Steps{{"From $O_{v}$ the known $\\vec{v}_{A}$, ∥ $y$.", "Through $a'$ the line ∥ $x$.",
                                   "The line of $\\vec{v}_{B}$. The two meet at $b'$, not in 4."}},
                            Paragraph{"Between them, a thought."}, Steps{{"$m'$ halves $a'b'$, not $A$."}, 4}};
};

}  // namespace

TEST_CASE("a known vector comes with its step, an unknown one with the line that ends it") {
  const Polygon polygon;
  const StepsOfMarks found = steps_of_marks(polygon.figure, polygon.column);
  CHECK(found.marks[0] == 1);
  CHECK(found.marks[1] == 2);
  CHECK(found.marks[2] == 3);
  CHECK(found.marks[3] == 3);
  CHECK(found.marks[4] == 3);
}

TEST_CASE("a point comes with its number or its letters, the mechanism before all steps") {
  const Polygon polygon;
  const StepsOfMarks found = steps_of_marks(polygon.figure, polygon.column);
  CHECK(found.marks[5] == 4);
  CHECK(found.marks[6] == 0);
  CHECK(found.marks[7] == 0);
  CHECK(found.marks[8] == 2);   // between the first vector and the line
  CHECK(found.marks[9] == 1);   // where the first vector begins
  CHECK(found.marks[10] == 4);  // a line, when both its ends were there
  CHECK(found.labels == std::vector<int>{1, 2, 3, 4, 0, 0, 0});
}

TEST_CASE("without steps all was there before the first") {
  Polygon polygon;
  polygon.column.clear();
  const StepsOfMarks found = steps_of_marks(polygon.figure, polygon.column);
  CHECK(found.marks == std::vector<int>(polygon.figure.marks.size(), 0));
  CHECK(found.labels == std::vector<int>(polygon.figure.labels.size(), 0));
}

TEST_CASE("what a figure knows of a step goes before what is found") {
  Polygon polygon;
  polygon.figure.known_of_marks.resize(polygon.figure.marks.size());
  polygon.figure.known_of_marks[0].number = 4;    // found: 1
  polygon.figure.known_of_marks[2].number = 0;    // found: 2
  polygon.figure.known_of_marks[6].earliest = 3;  // of the mechanism
  polygon.figure.known_of_marks[5].earliest = 2;  // found: 4
  polygon.figure.known_of_labels = {{.number = 2}, {.earliest = 3}};
  const StepsOfMarks found = steps_of_marks(polygon.figure, polygon.column);
  CHECK(found.marks[0] == 4);
  CHECK(found.marks[2] == 0);
  CHECK(found.marks[6] == 3);
  CHECK(found.marks[5] == 4);
  CHECK(found.labels[0] == 2);
  CHECK(found.labels[1] == 3);
}

TEST_CASE("of letters that the words of another panel's steps speak of too, one's own count") {
  const Point P{100, 100};
  Figure figure{.marks = {Dot{P}}, .labels = {{.text = "$C$", .at = P}}, .steps = {}};
  const std::vector<Block> column{Steps{{"$C$ turns.", "Nothing.", "$C$ is found."}}};
  CHECK(steps_of_marks(figure, column).marks == std::vector{1});
  figure.known_of_marks = {{.earliest = 2, .first = 2, .last = 3}};
  figure.known_of_labels = figure.known_of_marks;
  CHECK(steps_of_marks(figure, column).marks == std::vector{3});
  CHECK(steps_of_marks(figure, column).labels == std::vector{3});
}

TEST_CASE("a point that is found comes with the second of the lines that cross in it") {
  const Point P{100, 100};
  const Figure figure{.marks = {Line{segment({60, 100}, {110, 100})}, Line{segment({100, 60}, {100, 110})}, Cross{P}},
                      .labels = {{.text = "$P_{31}$", .at = P}},
                      .steps = {{1, {70, 100}}, {2, {100, 70}}}};
  const std::vector<Block> column{Steps{{"$P_{31}$ lies on the first line.", "And on the second."}}};
  const StepsOfMarks found = steps_of_marks(figure, column);
  CHECK(found.marks == std::vector{1, 2, 2});
  CHECK(found.labels == std::vector{2});
}
