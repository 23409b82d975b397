// The sheets of the Michell bearing, whatever is given.
#include "tests/exercises/michell-bearing/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("michell bearing: every sheet is drawn, whatever is given", "[michell-bearing][sheets]") {
  draws_every_sheet(bearing(), read_corpus(EPURE_CORPUS "/michell_bearing.txt"));
}

TEST_CASE("michell bearing: letters find room", "[michell-bearing][sheets]") {
  letters_find_room(bearing(), {{}, {"h_1=1.6"}, {"x_N=0.038"}, {"pads=6", "r_m=0.12"}});
  letters_find_room(bearing(), {{"h_1=0.32"}}, {"integration"});  // forty strips leave a step's number no room
}
