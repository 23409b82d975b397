// The sheets of the mechanisms in equilibrium, whatever is given.
#include "tests/exercises/ideal-statics/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{{},
                                     {"wedge_collar.theta=20", "double_slider.theta=30"},
                                     {"sliding_levers.direction_P=73", "fairbairn.theta=10"},
                                     {"sliding_levers.y_C=0", "fairbairn.AB=0.5"}};

}  // namespace

TEST_CASE("ideal statics: every sheet is drawn, whatever is given", "[ideal-statics][sheets]") {
  draws_every_sheet(statics(), read_corpus(EPURE_CORPUS "/ideal_statics.txt"));
}

TEST_CASE("ideal statics: letters find room", "[ideal-statics][sheets]") { letters_find_room(statics(), usual); }
