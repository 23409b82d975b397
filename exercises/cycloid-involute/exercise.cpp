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
      {{{"cycloid",
         {"Cycloid by twelve divisions", "Cicloide per dodici divisioni"},
         {"A circle rolls without slipping on a line. Draw the cycloid by twelve divisions.",
          "Una circonferenza rotola senza strisciare su una retta. Tracciare la cicloide con dodici divisioni."}},
        cycloid_sheet},
       {{"cycloid-instants",
         {"Cycloid: two instants", "Cicloide: due istanti"},
         {"A circle rolls without slipping on a line. At the given instants find velocity, acceleration and centre "
          "of curvature of the point that describes the cycloid.",
          "Una circonferenza rotola senza strisciare su una retta. Agli istanti dati trovare velocità, accelerazione "
          "e centro di curvatura del punto che descrive la cicloide."}},
        cycloid_instants_sheet},
       {{"cycloid-travel",
         {"Cycloid: arc travelled", "Cicloide: spazi percorsi"},
         {"A circle rolls without slipping on a line. Find the length of arc of the cycloid that its point has "
          "travelled at the given instants.",
          "Una circonferenza rotola senza strisciare su una retta. Trovare la lunghezza dell'arco di cicloide che il "
          "suo punto ha percorso agli istanti dati."}},
        cycloid_travel_sheet},
       {{"involute",
         {"Involute by twelve divisions", "Evolvente per dodici divisioni"},
         {"A line rolls without slipping on a circle. Draw the involute by twelve divisions.",
          "Una retta rotola senza strisciare su una circonferenza. Tracciare l'evolvente con dodici divisioni."}},
        involute_sheet},
       {{"involute-instants",
         {"Involute: two instants", "Evolvente: due istanti"},
         {"A line rolls without slipping on a circle. At the given instants find velocity, acceleration and centre "
          "of curvature of the point that describes the involute.",
          "Una retta rotola senza strisciare su una circonferenza. Agli istanti dati trovare velocità, accelerazione "
          "e centro di curvatura del punto che descrive l'evolvente."}},
        involute_instants_sheet},
       {{"involute-travel",
         {"Involute: arc travelled", "Evolvente: spazi percorsi"},
         {"A line rolls without slipping on a circle. Find the length of arc of the involute that its point has "
          "travelled at the given instants.",
          "Una retta rotola senza strisciare su una circonferenza. Trovare la lunghezza dell'arco di evolvente che "
          "il suo punto ha percorso agli istanti dati."}},
        involute_travel_sheet}});
}

}  // namespace epure
