// The sheets of the mechanisms with friction, whatever is given.
#include "tests/exercises/friction-efficiency/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("friction: every sheet is drawn, whatever is given", "[friction-efficiency][sheets]") {
  draws_every_sheet(friction(), read_corpus(EPURE_CORPUS "/friction_efficiency.txt"));
}

TEST_CASE("friction: letters find room", "[friction-efficiency][sheets]") {
  letters_find_room(friction(), {{}, {"phi=12"}, {"wedge_collar.theta=25", "fairbairn.theta=10"}});
}
