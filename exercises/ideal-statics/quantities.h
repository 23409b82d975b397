// What is reported of mechanisms in equilibrium, beside the forces of kit/statement/forces.h.
#pragma once

#include "exercises/kit/statement/forces.h"

namespace epure::ideal_statics {

inline VectorQuantity P() {
  return applied_force("P", {"driving force, along its direction", "forza motrice, lungo la sua direzione"});
}
inline Quantity M() {
  return applied_couple("M", {"couple on the crank, counter-clockwise", "coppia sulla manovella, antioraria"});
}
inline Quantity P_virtual_work() {
  return {"P_virtual_work",
          "$\\it{P}_{vir}$",
          "N",
          {"driving force by virtual work", "forza motrice con i lavori virtuali"}};
}
inline Quantity M_virtual_work() {
  return {"M_virtual_work",
          "$\\it{M}_{vir}$",
          "N*m",
          {"couple on the crank by virtual work", "coppia sulla manovella con i lavori virtuali"}};
}
inline Quantity v_Q_over_v_P() {
  return {"v_Q_over_v_P",
          "$v_{Q}$/$v_{P}$",
          "1",
          {"virtual displacement along Q over that along P", "spostamento virtuale lungo Q su quello lungo P"}};
}
inline VectorQuantity R_13_upper() {
  return force_between(1, 3, "upper", "^{{u}}", {", at the upper end", ", all'estremo superiore"});
}
inline VectorQuantity R_13_lower() {
  return force_between(1, 3, "lower", "^{{l}}", {", at the lower end", ", all'estremo inferiore"});
}
inline Quantity R_13_resultant_x() {
  return {"R_13_resultant_x",
          "$\\it{R}_{13x}$",
          "N",
          {"sum of the two forces of the collar, along x", "somma delle due forze del collare, lungo x"}};
}
inline PointQuantity meeting(const std::string& name, int body) {
  return {name,
          Words{" of the meeting point of the forces on body ", " del punto d'incontro delle forze sul corpo "} +
              std::to_string(body),
          point_letters(name)};
}
inline PointQuantity contact_pole() {
  return {"P23", {" of the relative pole of the levers", " del polo relativo delle leve"}, "P23"};
}
inline Quantity arm_of_normal(const std::string& hinge) {
  return {"arm_normal_" + hinge, "$b_{" + hinge + "}$", "m",
          Words{"distance of the contact's normal from ", "distanza della normale di contatto da "} + hinge};
}
inline Quantity arm_of_Q() {
  return {"arm_Q",
          "$b_{Q}$",
          "m",
          {"arm of Q about the hinge of its lever", "braccio di Q dalla cerniera della sua leva"}};
}
inline Quantity ratio_of_speeds(int i, int j) {
  const std::string a = std::to_string(i), b = std::to_string(j);
  return {"omega_" + a + "_over_omega_" + b, "$ω_{" + a + "}$/$ω_{" + b + "}$", "1",
          format_words("angular velocity of body {} over that of body {}",
                       "velocità angolare del corpo {} su quella del corpo {}", a, b)};
}
inline Quantity F_23() {
  return {"F_23",
          "$\\it{R}_{32}$",
          "N",
          {"force between crank and lever, through block 3", "forza tra manovella e leva, attraverso il corsoio 3"}};
}
inline Quantity arm_of_F_23() { return {"d", "$d$", "m", {"arm of R32 about A", "braccio della R32 rispetto ad A"}}; }
inline Quantity crank_angle() {
  return {"crank_angle_deg", "$φ$", "deg", {"direction of AB from +x", "direzione di AB da +x"}};
}
inline Quantity v_D6_over_omega_2() {
  return {"v_D6_over_omega_2",
          "$v_{D6}$/$ω_{2}$",
          "m",
          {"speed of the ram over that of the crank", "velocità della slitta su quella angolare della manovella"}};
}

}  // namespace epure::ideal_statics
