#include "exercises/aircraft-landing/quantities.h"

#include <algorithm>
#include <cassert>

#include "exercises/kit/statement/format_words.h"

namespace epure::aircraft_landing {
namespace {

const Words at_touch_down{" at touch-down", " al contatto"},
    just_before{" just before slip ends", " appena prima della fine dello strisciamento"},
    just_after{" just after slip has ended", " appena finito lo strisciamento"},
    when_slip_ends{" when slip ends", " alla fine dello strisciamento"},
    while_slipping{" while it slips", " durante lo strisciamento"}, at_10ms{" after 10 ms", " dopo 10 ms"};
const Words speed{"speed of the aircraft", "velocità dell'aereo"},
    turning{"angular velocity of the wheel", "velocità angolare della ruota"},
    normal{"reaction of the ground, upwards", "reazione verticale del terreno"},
    acceleration{"acceleration of the aircraft", "accelerazione dell'aereo"},
    angular{"angular acceleration of the wheel", "accelerazione angolare della ruota"},
    by_hub{"force of the hub on the wheel", "forza del mozzo sulla ruota"}, forwards{", forwards", ", in avanti"},
    upwards{", upwards", ", verso l'alto"},
    of_inertia{"force of inertia of the wheel, forwards", "forza d'inerzia della ruota, in avanti"},
    friction{"friction, backwards", "forza d'attrito, all'indietro"};

const std::vector<Quantity> quantities{
    {"v_0", "$v_{0}$", "m/s", speed + at_touch_down},
    {"omega_rolling_0",
     "$v_{0}$/$\\it{R}$",
     "rad/s",
     {"angular velocity that would roll at touch-down", "velocità angolare di rotolamento al contatto"}},
    {"u", "$u$", "m", {"offset of the reaction, f_v R", "scostamento della reazione, f_v R"}},
    {"F_x_0", "$\\it{F}_{x0}$", "N", Words{"drag of the flaps", "resistenza dei flap"} + at_touch_down},
    {"F_y_0", "$\\it{F}_{y0}$", "N",
     Words{"downward force of the flaps", "forza dei flap verso il basso"} + at_touch_down},
    {"N_0", "$\\it{N}_{0}$", "N", normal + at_touch_down},
    {"F_0", "$\\it{F}_{0}$", "N", friction + at_touch_down},
    {"a_0", "$a_{0}$", "m/s^2", acceleration + at_touch_down},
    {"omega_dot_0", "$α_{0}$", "rad/s^2", angular + at_touch_down},
    {"t_s", "$t_{s}$", "s", {"time after which slip ends", "durata dello strisciamento"}},
    {"v_s", "$v_{s}$", "m/s", speed + when_slip_ends},
    {"omega_s", "$ω_{s}$", "rad/s", turning + when_slip_ends},
    {"N_s", "$\\it{N}_{s}$", "N", normal + when_slip_ends},
    {"a_s", "$a_{s}$", "m/s^2", acceleration + just_before},
    {"omega_dot_s", "$α_{s}$", "rad/s^2", angular + just_before},
    {"ground_path_s", "$s_{v}$", "m", Words{"way of the aircraft", "spazio percorso dall'aereo"} + while_slipping},
    {"rolled_path_s", "$s_{ω}$", "m", Words{"way of the rim", "spazio percorso dalla periferia"} + while_slipping},
    {"slip_path_s", "$s_{v}$ − $s_{ω}$", "m", {"way slipped", "spazio strisciato"}},
    {"wheel_angle_s", "$θ_{s}$", "rad", Words{"angle of the wheel", "angolo della ruota"} + while_slipping, true},
    {"friction_work_s", "$\\it{L}_{F}$", "J", {"work lost by sliding friction", "lavoro perso per attrito radente"}},
    {"wheel_energy_s", "$\\it{E}_{s}$", "J",
     Words{"kinetic energy of rotation of the wheel", "energia cinetica di rotazione della ruota"} + when_slip_ends},
    {"drag_work_s", "$\\it{L}_{x}$", "J", Words{"work of the drag", "lavoro della resistenza"} + while_slipping},
    {"rolling_work_s",
     "$\\it{L}_{u}$",
     "J",
     {"work lost by rolling friction while it slips", "lavoro perso per attrito volvente"}},
    {"v_10ms", "$v$(10 ms)", "m/s", speed + at_10ms},
    {"omega_10ms", "$ω$(10 ms)", "rad/s", turning + at_10ms},
    {"a_after", "$a'$", "m/s^2", acceleration + just_after},
    {"F_after", "$\\it{F}'$", "N", friction + just_after},
    {"F_after_over_N",
     "$\\it{F}'$/$\\it{N}$",
     "1",
     {"friction over reaction after slip has ended", "attrito su reazione a strisciamento finito"}},
    {"adheres", "adheres", "1", {"1 when |F'| is at most f_a N", "1 se |F'| non supera f_a N"}},
    {"hub_force_0", "$\\it{H}_{0}$", "N", by_hub + at_touch_down},
    {"hub_force_after", "$\\it{H}'$", "N", by_hub + just_after},
    {"hub_force_0_x", "$\\it{H}_{0x}$", "N", by_hub + at_touch_down + forwards},
    {"hub_force_0_y", "$\\it{H}_{0y}$", "N", by_hub + at_touch_down + upwards},
    {"hub_force_after_x", "$\\it{H}'_{x}$", "N", by_hub + just_after + forwards},
    {"hub_force_after_y", "$\\it{H}'_{y}$", "N", by_hub + just_after + upwards},
    {"wheel_weight", "$\\it{P}_{r}$", "N", {"weight of the wheel", "peso della ruota"}},
    {"wheel_inertia_0", "−$m_{r}a_{0}$", "N", of_inertia + at_touch_down},
    {"wheel_inertia_after", "−$m_{r}a'$", "N", of_inertia + just_after},
    {"t_s_tangents",
     "$t^{*}_{s}$",
     "s",
     {"time where the tangents at touch-down cross", "istante in cui si incontrano le tangenti iniziali"}},
    {"v_s_tangents",
     "$v^{*}_{s}$",
     "m/s",
     {"speed where the tangents at touch-down cross", "velocità in cui si incontrano le tangenti iniziali"}},
    {"polygon_off_at_most",
     "$δ_{t}$",
     "s",
     {"what the integral polygon is off the true time at most",
      "scarto massimo possibile del poligono integrale dal tempo esatto"}},
    {"rim_speed_over_speed_1",
     "$ω_{1}\\it{R}$/$v_{1}$",
     "1",
     {"speed of the rim over that of the aircraft after the first step",
      "velocità periferica su velocità dell'aereo dopo il primo passo"}},
    {"steps", "$n$", "1", {"number of the step that ends slip", "numero del passo che conclude lo strisciamento"}}};

}  // namespace

Quantity quantity(const std::string& name) {
  const auto found =
      std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& each) { return each.name == name; });
  if (found != quantities.end()) return *found;
  const auto underscore = name.find('_');
  assert(underscore != std::string::npos);
  const std::string k = name.substr(underscore + 1);
  const Words steps = k == "1" ? Words{" after the first step", " dopo il primo passo"}
                               : format_words(" after {} steps", " dopo {} passi", k);
  return name.starts_with("v_") ? Quantity{name, "$v_{" + k + "}$", "m/s", speed + steps}
                                : Quantity{name, "$ω_{" + k + "}$", "rad/s", turning + steps};
}

}  // namespace epure::aircraft_landing
