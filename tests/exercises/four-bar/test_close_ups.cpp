// A second picture, larger, of joints that lie close together.
#include <algorithm>

#include "drawings/paths/vectors.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

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
    for (const char* letters : {"$A_{0}$", "$A$", "$B$", "$B_{0}$"})
      CHECK(std::count_if(figure.labels.begin(), figure.labels.end(),
                          [&](const drawings::Label& label) { return label.text == letters; }) == 1);
  }
}

TEST_CASE("a linkage of which all joints can be told apart has one picture") {
  const drawings::Figure figure = Tried("four-bar").draw("poles", {}).sheet.figure;
  CHECK(std::count_if(figure.marks.begin(), figure.marks.end(), [](const drawings::Mark& mark) {
          return std::holds_alternative<drawings::FixedHinge>(mark);
        }) == 2);
}
