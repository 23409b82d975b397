// N.8 of Sapienza's exercises: the mechanisms of N.4 with friction, their efficiency.
#include "exercises/friction-efficiency/exercise.h"

namespace epure {

std::unique_ptr<Exercise> make_friction_efficiency() {
  using namespace friction_efficiency;
  Description about{
      .id = "friction-efficiency",
      .title = {"Efficiency of mechanisms with friction", "Rendimento di meccanismi con attrito"},
      .document = "sapienza",
      .item = "N.8",
      .source = {"Sapienza, exercises in applied mechanics, N.8",
                 "Sapienza, Esercitazioni di Meccanica Applicata, N.8"},
      .question = {"All pairs of the mechanisms rub. Find the driving force in direct motion and the force that "
                   "holds back in retrograde motion by force polygons, both efficiencies, and the friction angles at "
                   "which self-locking and jamming begin.",
                   "In tutte le coppie dei meccanismi c'è attrito. Trovare con i poligoni delle forze la forza "
                   "motrice nel moto diretto e la forza che trattiene nel moto retrogrado, i due rendimenti, e gli "
                   "angoli d'attrito a cui iniziano l'arresto spontaneo e l'impuntamento."},
      .givens = stated_givens(),
      .printed = printed_by_the_source};
  return exercise_of_panels(std::move(about), parts(), sheets());
}

}  // namespace epure
