// The sheets of the body under a force that depends on time, whatever is given.
#include <map>

#include "exercises/kit/proof/solution.h"
#include "tests/exercises/point-mass/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("point mass: every sheet is drawn, whatever is given", "[point-mass][sheets]") {
  draws_every_sheet(body(), read_corpus(EPURE_CORPUS "/point_mass.txt"));
}

TEST_CASE("point mass: letters find room", "[point-mass][sheets]") {
  letters_find_room(body(), {{}, {"strip=2"}, {"A=-0.5", "B=5", "C=0"}, {"A=0", "B=-3", "C=20", "t_2=10"}});
}

TEST_CASE("point mass: the polygons' ordinates are measured on the sheet", "[point-mass][sheets]") {
  const CheckedExercise result = body().checked({});
  for (const char* name : {"graphical.v_1", "graphical.v_2", "graphical.v_3", "graphical.s_1", "graphical.s_2",
                           "graphical.s_3", "t_centroid_1", "t_centroid_2", "t_centroid_3", "t_v_max", "F_min"}) {
    CAPTURE(name);
    CHECK_FALSE(find(result, name).on_sheets.empty());
  }
}

TEST_CASE("point mass: the table has all its rows, on paper and for a spreadsheet", "[point-mass][sheets]") {
  const Exercise& exercise = find_exercise(catalogue(), "point-mass");
  const Solution solution = exercise.solution(body().givens({"dt=0.25"}));
  const auto table = exercise.long_table("table", solution);
  REQUIRE(table);
  CHECK(table->rows() == 81);
  CHECK(table->columns.size() == 15);
  CHECK(table->columns[0].values.back() == 20);
  CHECK(table->columns[7].name == "v_bezout");
  CHECK(table->columns[7].values[20] == solution["v_bezout_1"]);
  CHECK(table->columns[14].values[56] == solution["s_simpson_2"]);
  CHECK(exercise.draw("table", solution, {}).further.size() == 3);
  CHECK_FALSE(exercise.long_table("curves", solution));
}

TEST_CASE("point mass: each tangent has its slope, each centroid its letters on both charts",
          "[point-mass][sheets]") {
  std::map<std::string, int> count;
  const DrawnSheet drawn = body().draw("tangents", {});
  for (const drawings::Label& each : drawn.sheet.figure.labels) ++count[each.text];
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* writing = std::get_if<drawings::Writing>(&mark)) ++count[writing->text];
  for (const std::string k : {"1", "2", "3"}) {
    CHECK(count["$v_{" + k + "}$"] == 1);
    CHECK(count["$t_{G" + k + "}$"] == 2);
  }
}

// Of s = 34535.8125 exactly, as of some others, the cell is the half of its last digit off.
TEST_CASE("point mass: ties in the cells of the table are rounded as they may be", "[point-mass][sheets]") {
  for (const Assignments& given : {Assignments{"m=2", "t_3=40"}, {"t_3=67.5"}, {"m=16", "t_3=60"}}) {
    const CheckedExercise result = body().checked(given);
    CAPTURE(given, complaints(result));
    CHECK(result.passed());
  }
}
