// N.8 of Sapienza's exercises: the mechanisms of N.4 with friction, their efficiency.
#include "exercises/friction-efficiency/exercise.h"

namespace epure {

std::unique_ptr<Exercise> make_friction_efficiency() {
  using namespace friction_efficiency;
  Description about{.id = "friction-efficiency",
                    .title = {"Efficiency of mechanisms with friction", "Rendimento di meccanismi con attrito"},
                    .document = "sapienza",
                    .item = "N.8",
                    .source = {"Sapienza, exercises in applied mechanics, N.8",
                               "Sapienza, Esercitazioni di Meccanica Applicata, N.8"},
                    .givens = stated_givens(),
                    .printed = printed_by_the_source()};
  return exercise_of_panels(std::move(about), solve, sheets());
}

}  // namespace epure
