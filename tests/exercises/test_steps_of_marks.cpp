// Which step drew which mark, where it is known by construction.
#include <cmath>

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
  // Of the sheet to be solved: the mechanism and its letters.
  Figure given{.marks = {Hinge{hinge}, Line{segment(hinge, {60, 20}), Meaning::link}, Slider{{60, 20}}},
               .labels = {figure.labels[4], figure.labels[5], figure.labels[6]},
               .steps = {}};
  StepsOfMarks found() const { return steps_of_marks(figure, column, given); }
};

}  // namespace

TEST_CASE("a known vector comes with its step, an unknown one with the line that ends it") {
  const Polygon polygon;
  const StepsOfMarks found = polygon.found();
  CHECK(found.marks[0] == 1);
  CHECK(found.marks[1] == 2);
  CHECK(found.marks[2] == 3);
  CHECK(found.marks[3] == 3);
  CHECK(found.marks[4] == 3);
}

TEST_CASE("a point comes with its number or its letters, the mechanism before all steps") {
  const Polygon polygon;
  const StepsOfMarks found = polygon.found();
  CHECK(found.marks[5] == 4);
  CHECK(found.marks[6] == 0);
  CHECK(found.marks[7] == 0);
  CHECK(found.marks[8] == 2);   // between the first vector and the line
  CHECK(found.marks[9] == 1);   // where the first vector begins
  CHECK(found.marks[10] == 4);  // a line, when both its ends were there
  CHECK(found.labels == std::vector<int>{1, 2, 3, 4, 0, 0, 0});
}

TEST_CASE("what is not given comes late rather than early where nothing tells") {
  Polygon polygon;
  const std::size_t before = polygon.figure.marks.size();
  const auto triangle = [](double x) {
    return Line{polyline({{x, 10}, {x + 5, 10}, {x, 15}}, true), Meaning::alternative};
  };
  // The first has the number 2; of the cross and of its letters nothing is said.
  for (const double x : {200.0, 220.0}) polygon.figure.marks.emplace_back(triangle(x));
  polygon.figure.steps.push_back({2, {200, 10}});
  polygon.figure.marks.emplace_back(Cross{{250, 150}});
  polygon.figure.labels.push_back({.text = "$Q$", .at = {250, 150}});
  const StepsOfMarks found = polygon.found();
  CHECK(found.marks[before] == 2);
  CHECK(found.marks[before + 1] == 2);
  CHECK(found.marks[before + 2] == 4);
  CHECK(found.labels.back() == 4);
}

TEST_CASE("what is given is what the sheet to be solved draws, to the last digit") {
  Polygon polygon;
  const std::size_t link = 7;
  std::get<Line>(polygon.given.marks[1]).path.start.x = std::nextafter(polygon.hinge.x, 0);
  CHECK(polygon.found().marks[link] > 0);
  std::get<Line>(polygon.given.marks[1]) = std::get<Line>(polygon.figure.marks[link]);
  CHECK(polygon.found().marks[link] == 0);
  std::get<Line>(polygon.given.marks[1]).meaning = Meaning::construction;
  CHECK(polygon.found().marks[link] > 0);
}

TEST_CASE("without steps all was there before the first") {
  Polygon polygon;
  polygon.column.clear();
  const StepsOfMarks found = polygon.found();
  CHECK(found.marks == std::vector<int>(polygon.figure.marks.size(), 0));
  CHECK(found.labels == std::vector<int>(polygon.figure.labels.size(), 0));
}
