#include "exercises/cam-dynamics/quantities.h"

#include <algorithm>
#include <cassert>

namespace epure::cam_dynamics {
namespace {

template <class Kind>
const Kind& named(const std::vector<Kind>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Kind& each) { return each.name == name; });
  assert(found != all.end());
  return *found;
}

const std::vector<Quantity> quantities{
    {"omega_2", "$ω_{2}$", "rad/s", {"angular velocity of the cam", "velocità angolare della camma"}},
    {"B_y", "$y_{B}$", "m", {"ordinate of B", "ordinata di B"}},
    {"A0B", "$A_{0}B$", "m", {"distance of B from A0", "distanza di B da A0"}},
    {"pressure_angle_deg", "$δ$", "deg", {"pressure angle", "angolo di pressione"}},
    {"P23_x", "$x_{P23}$", "m", {"abscissa of the relative pole P23", "ascissa del polo relativo P23"}},
    {"d_2", "$d_{2}$", "m", {"arm of P_2 about A0", "braccio di P_2 rispetto ad A0"}},
    {"d_32", "$d_{32}$", "m", {"arm of R_32 about A0", "braccio di R_32 rispetto ad A0"}},
    {"M_m", "$\\it{M}_{m}$", "N*m", {"driving torque", "coppia motrice"}},
    {"M_m_virtual_work",
     "$\\it{M}'_{m}$",
     "N*m",
     {"driving torque by virtual work", "coppia motrice per i lavori virtuali"}},
    {"angle_of_A0A_deg", "$φ_{l}$", "deg", {"angle of A0A", "angolo di A0A"}},
    {"P_min",
     "$\\it{P}_{min}$",
     "N",
     {"closing force that just keeps contact", "forza di chiusura che appena mantiene il contatto"}},
    {"omega_2_contact_loss",
     "$ω_{2,l}$",
     "rad/s",
     {"angular velocity at which contact is lost", "velocità angolare a cui si perde il contatto"}},
    {"omega_2_first_loss",
     "$ω_{2,P}$",
     "rad/s",
     {"angular velocity beyond which contact is lost somewhere",
      "velocità angolare oltre cui in qualche punto si perde il contatto"}},
    {"y_B_max", "$y_{max}$", "m", {"greatest ordinate of B", "ordinata massima di B"}},
    {"y_B_min", "$y_{min}$", "m", {"least ordinate of B", "ordinata minima di B"}},
    {"lift", "$h$", "m", {"lift", "alzata"}},
    {"angle_at_max_lift_deg",
     "$φ_{max}$",
     "deg",
     {"angle of A0A at maximum lift", "angolo di A0A all'alzata massima"}},
    {"angle_at_min_lift_deg",
     "$φ_{min}$",
     "deg",
     {"angle of A0A at minimum lift", "angolo di A0A all'alzata minima"}},
    {"rise_angle_deg",
     "$φ_{r}$",
     "deg",
     {"rotation of the rise, counter-clockwise", "rotazione di salita, antioraria"},
     true},
    {"pressure_angle_max_deg", "$δ_{max}$", "deg", {"greatest pressure angle", "angolo di pressione massimo"}},
    {"pressure_angle_min_deg", "$δ_{min}$", "deg", {"least pressure angle", "angolo di pressione minimo"}},
    {"angle_at_P_min_deg",
     "$φ_{P}$",
     "deg",
     {"angle of A0A at which that force is needed", "angolo di A0A in cui occorre quella forza"}},
    {"a_B3_y_min", "$a_{min}$", "m/s^2", {"least acceleration of the follower", "accelerazione minima del cedente"}}};

const std::vector<VectorQuantity> vectors{
    {"v_A", "v_{{{}}}", "A", "m/s", {"velocity of A", "velocità di A"}, {"speed of A", "velocità di A"}},
    {"v_B3",
     "v_{{{}}}",
     "B3",
     "m/s",
     {"velocity of the follower", "velocità del cedente"},
     {"speed of the follower", "velocità del cedente"}},
    {"v_B2",
     "v_{{{}}}",
     "B2",
     "m/s",
     {"velocity of the cam's point in B", "velocità del punto della camma in B"},
     {"speed of the cam's point in B", "velocità del punto della camma in B"}},
    {"v_B32",
     "v_{{{}}}",
     "B32",
     "m/s",
     {"velocity of B relative to the cam", "velocità di B relativa alla camma"},
     {"speed of B relative to the cam", "velocità di B relativa alla camma"}},
    {"a_B3",
     "a_{{{}}}",
     "B3",
     "m/s^2",
     {"acceleration of the follower", "accelerazione del cedente"},
     {"acceleration of the follower", "accelerazione del cedente"}},
    {"a_B2",
     "a_{{{}}}",
     "B2",
     "m/s^2",
     {"acceleration of the cam's point in B", "accelerazione del punto della camma in B"},
     {"acceleration of the cam's point in B", "accelerazione del punto della camma in B"}},
    {"a_B32_n",
     "a^{{n}}_{{{}}}",
     "B32",
     "m/s^2",
     {"normal relative acceleration", "accelerazione relativa normale"},
     {"normal relative acceleration", "accelerazione relativa normale"}},
    {"a_B32_t",
     "a^{{t}}_{{{}}}",
     "B32",
     "m/s^2",
     {"tangential relative acceleration", "accelerazione relativa tangenziale"},
     {"tangential relative acceleration", "accelerazione relativa tangenziale"}},
    {"a_coriolis",
     "a_{{{}}}",
     "c",
     "m/s^2",
     {"Coriolis acceleration", "accelerazione di Coriolis"},
     {"Coriolis acceleration", "accelerazione di Coriolis"}},
    {"a_G2",
     "a_{{{}}}",
     "G2",
     "m/s^2",
     {"acceleration of the disc's centre of mass", "accelerazione del baricentro del disco"},
     {"acceleration of the disc's centre of mass", "accelerazione del baricentro del disco"}}};

VectorQuantity of_force(const std::string& name, const std::string& letter, const std::string& of,
                        const Words& meaning) {
  return {name, letter, of, "N", meaning, meaning};
}
const std::vector<VectorQuantity> acting{
    of_force("P", "\\it{{P}}{}", "", {"closing force", "forza di chiusura"}),
    of_force("P_2", "\\it{{P}}_{{{}}}", "2", {"weight of the disc", "peso del disco"}),
    of_force("P_3", "\\it{{P}}_{{{}}}", "3", {"weight of the follower", "peso del cedente"}),
    of_force("F_2_in", "\\it{{F}}^{{in}}_{{{}}}", "2", {"force of inertia of the disc", "forza d'inerzia del disco"}),
    of_force("F_3_in", "\\it{{F}}^{{in}}_{{{}}}", "3",
             {"force of inertia of the follower", "forza d'inerzia del cedente"}),
    force_between(1, 3),
    force_between(2, 3),
    force_between(1, 2)};

}  // namespace

const Quantity& quantity(const std::string& name) { return named(quantities, name); }
VectorQuantity moving(const std::string& name) { return named(vectors, name); }
VectorQuantity force(const std::string& name) { return named(acting, name); }

Quantity lift_at(int degrees) {
  const std::string number = std::to_string(degrees);
  return {"lift_at_" + number, "$h_{" + number + "}$", "m",
          Words{"lift with A0A at ", "alzata con A0A a "} + decimal(number + "°")};
}

}  // namespace epure::cam_dynamics
