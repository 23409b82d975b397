#include "exercises/cam-dynamics/exercise.h"

#include "exercises/cam-dynamics/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_cam_dynamics() {
  using namespace cam_dynamics;
  Description about{
      .id = "cam-dynamics",
      .title = {"Eccentric cam with a roller follower", "Camma eccentrica con cedente a rullo"},
      .document = "sapienza",
      .item = "N.13",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.13",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.13"},
      .question = {"An eccentric cam moves a roller follower. In the given position find velocities and "
                   "accelerations by polar diagrams, the reactions and the driving torque; at maximum lift the least "
                   "closing force that keeps contact at the second speed.",
                   "Una camma eccentrica muove una punteria a rotella. Nella posizione data trovare velocità e "
                   "accelerazioni con i diagrammi polari, le reazioni e la coppia motrice; all'alzata massima la "
                   "minima forza di chiusura che mantiene il contatto alla seconda velocità."},
      .givens = stated_givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes(cam(givens)), rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"velocities",
         {"Velocities", "Velocità"},
         {"An eccentric cam moves a roller follower. In the given position find the velocities by the polar diagram.",
          "Una camma eccentrica muove una punteria a rotella. Nella posizione data trovare le velocità con il "
          "diagramma polare."}},
        velocity_sheet},
       {{"accelerations",
         {"Accelerations", "Accelerazioni"},
         {"An eccentric cam moves a roller follower. In the given position find the accelerations by the polar "
          "diagram.",
          "Una camma eccentrica muove una punteria a rotella. Nella posizione data trovare le accelerazioni con il "
          "diagramma polare."}},
        acceleration_sheet},
       {{"forces",
         {"Forces on the follower", "Forze sul cedente"},
         {"An eccentric cam moves a roller follower. In the given position find the reactions on the follower.",
          "Una camma eccentrica muove una punteria a rotella. Nella posizione data trovare le reazioni sul "
          "cedente."}},
        forces_sheet},
       {{"torque",
         {"Forces on the cam and torque", "Forze sulla camma e coppia"},
         {"An eccentric cam moves a roller follower. In the given position find the reaction of the frame on the cam "
          "and the driving torque.",
          "Una camma eccentrica muove una punteria a rotella. Nella posizione data trovare la reazione del telaio "
          "sulla camma e la coppia motrice."}},
        torque_sheet},
       {{"maximum-lift",
         {"Maximum lift", "Massima alzata"},
         {"An eccentric cam moves a roller follower. At maximum lift find the least closing force that keeps contact "
          "at the second speed.",
          "Una camma eccentrica muove una punteria a rotella. All'alzata massima trovare la minima forza di chiusura "
          "che mantiene il contatto alla seconda velocità."}},
        maximum_lift_sheet},
       {{"inversion",
         {"Lift by inversion", "Alzata per inversione"},
         {"An eccentric cam moves a roller follower. Find the lift over the turn by inversion of the motion.",
          "Una camma eccentrica muove una punteria a rotella. Trovare l'alzata nel giro per inversione del moto."}},
        lift_sheet},
       {{"closing-force",
         {"Closing force over the turn", "Forza di chiusura nel giro"},
         {"An eccentric cam moves a roller follower. Find the closing force that keeps contact over the turn.",
          "Una camma eccentrica muove una punteria a rotella. Trovare la forza di chiusura che mantiene il contatto "
          "nel giro."}},
        closing_force_sheet}});
}

}  // namespace epure
