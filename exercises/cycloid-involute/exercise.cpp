#include "exercises/cycloid-involute/exercise.h"

#include "exercises/cycloid-involute/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_cycloid_involute() {
  using namespace cycloid_involute;
  Description about{
      .id = "cycloid-involute",
      .title = {"Cycloid and involute", "Cicloide ed evolvente"},
      .document = "sapienza",
      .item = "N.9",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.9",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.9"},
      .question =
          {"Draw cycloid and involute by twelve divisions. At the given instants find velocity, acceleration and "
           "centre of curvature of the point that describes each curve, and the length of arc that it has travelled.",
           "Tracciare la cicloide e l'evolvente con dodici divisioni. Agli istanti dati trovare velocità, "
           "accelerazione e centro di curvatura del punto che descrive ciascuna curva, e la lunghezza dell'arco "
           "percorso."},
      .givens = given_specs(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return solved(Problem(givens), rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"cycloid", {"Cycloid by twelve divisions", "Cicloide per dodici divisioni"}}, cycloid_sheet},
       {{"cycloid-instants", {"Cycloid: two instants", "Cicloide: due istanti"}}, cycloid_instants_sheet},
       {{"cycloid-travel", {"Cycloid: arc travelled", "Cicloide: spazi percorsi"}}, cycloid_travel_sheet},
       {{"involute", {"Involute by twelve divisions", "Evolvente per dodici divisioni"}}, involute_sheet},
       {{"involute-instants", {"Involute: two instants", "Evolvente: due istanti"}}, involute_instants_sheet},
       {{"involute-travel", {"Involute: arc travelled", "Evolvente: spazi percorsi"}}, involute_travel_sheet}});
}

}  // namespace epure
