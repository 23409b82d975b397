// What the exercise reports.
#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/coupler_quantities.h"
#include "exercises/kit/linkages/four_bar_instant.h"

namespace epure::four_bar {
namespace {

Quantity radians(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "rad", meaning};
}
Quantity degrees(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "deg", meaning};
}

const Words coupler_angle{"direction from A to B", "direzione da A a B"};
const Words rocker_angle{"direction from B₀ to B", "direzione da B₀ a B"};

std::vector<Quantity> pins() {
  return joined({coordinates("A", "A", {"A", "A"}), coordinates("B", "B", {"B", "B"})});
}

std::vector<Quantity> position() {
  return joined(
      {{{"omega_2", "$ω_{2}$", "rad/s", {"angular velocity of the crank", "velocità angolare della manovella"}},
        radians("crank_angle_phi", "$φ$", {"angle of the crank", "angolo della manovella"}),
        degrees("crank_angle_phi_deg", "$φ$", {"angle of the crank", "angolo della manovella"}),
        metres("BC", "$BC$", {"side BC of the plate", "lato BC della piastra"}),
        metres("AC", "$AC$", {"side AC of the plate", "lato AC della piastra"})},
       pins(),
       coordinates("C", "C", {"C", "C"}),
       {radians("coupler_angle", "$ϑ_{3}$", coupler_angle), radians("rocker_angle", "$ϑ_{4}$", rocker_angle)}});
}

std::vector<Quantity> velocities() {
  return joined(
      {{speed("v_A", "$v_{A}$", {"velocity of A", "velocità di A"}),
        {"omega_3", "$ω_{3}$", "rad/s", {"angular velocity of the coupler", "velocità angolare della biella"}},
        {"omega_4", "$ω_{4}$", "rad/s", {"angular velocity of the rocker", "velocità angolare del bilanciere"}},
        speed("v_BA", "$v_{BA}$", {"velocity of B relative to A", "velocità di B relativa ad A"})},
       components("v_B", "v", "B", "m/s", {"velocity of B", "velocità di B"}),
       components("v_C", "v", "C", "m/s", {"velocity of C", "velocità di C"})});
}

std::vector<Quantity> accelerations() {
  return joined(
      {{{"alpha_3",
         "$α_{3}$",
         "rad/s^2",
         {"angular acceleration of the coupler", "accelerazione angolare della biella"}},
        {"alpha_4",
         "$α_{4}$",
         "rad/s^2",
         {"angular acceleration of the rocker", "accelerazione angolare del bilanciere"}},
        {"tan_gamma", "$tan γ$", "1", {"α₃/ω₃²", "α₃/ω₃²"}},
        degrees("gamma_deg", "$γ$", {"angle from a_A to the ray AK", "angolo da a_A al raggio AK"}),
        acceleration("a_A", "$a_{A}$", {"acceleration of A", "accelerazione di A"}),
        acceleration("a_B_n", "$a^{n}_{B}$", {"normal part of a_B", "parte normale di a_B"}),
        acceleration("a_B_t", "$a^{t}_{B}$", {"tangential part of a_B", "parte tangenziale di a_B"}),
        acceleration("a_BA_n", "$a^{n}_{BA}$",
                     {"normal part of B's relative to A", "parte normale di B rispetto ad A"}),
        acceleration("a_BA_t", "$a^{t}_{BA}$",
                     {"tangential part of B's relative to A", "parte tangenziale di B rispetto ad A"}),
        acceleration("a_CA_n", "$a^{n}_{CA}$",
                     {"normal part of C's relative to A", "parte normale di C rispetto ad A"}),
        acceleration("a_CA_t", "$a^{t}_{CA}$",
                     {"tangential part of C's relative to A", "parte tangenziale di C rispetto ad A"}),
        acceleration("a_C_n", "$a^{n}_{C}$",
                     {"part of a_C normal to C's path", "parte di a_C normale alla traiettoria"}),
        acceleration("a_C_t", "$a^{t}_{C}$", {"part of a_C along C's path", "parte di a_C lungo la traiettoria"})},
       components("a_B", "a", "B", "m/s^2", {"acceleration of B", "accelerazione di B"}),
       components("a_C", "a", "C", "m/s^2", {"acceleration of C", "accelerazione di C"})});
}

std::vector<Quantity> second_order() {
  return joined({velocities(), pole_quantities("P31", "P_{31}", {"A", "B", "C"}), accelerations(),
                 acceleration_pole_quantities({"A", "B", "C"}), circle_quantities(), curvature_quantities("C", "C")});
}

std::vector<Quantity> mirror_side() {
  return in_case(
      "mirror_side_", {"C on the other side of AB", "C dall'altra parte di AB"},
      joined({coordinates("C", "C", {"C", "C"}),
              {acceleration("a_C", "$a_{C}$", {"acceleration of C", "accelerazione di C"}),
               metres("KC", "$KC$", {"distance of C from K", "distanza di C da K"}),
               metres("rho_C", "$ρ_{C}$",
                      {"radius of curvature of the path of C", "raggio di curvatura della traiettoria di C"}),
               metres("P31C", "$P_{31}C$", {"distance of C from the pole", "distanza di C dal polo"})}}));
}

std::vector<Quantity> stroke() {
  return {radians("rocker_swing", "$Δϑ_{4}$",
                  {"swing of the rocker between its dead centres", "ampiezza del moto del bilanciere"}),
          radians("crank_rotation_extended_to_folded", "$Δφ$",
                  {"crank from the extended to the folded dead centre, counter-clockwise",
                   "manovella dal punto morto esteso al ripiegato, antioraria"}),
          {"time_ratio",
           "$τ$",
           "1",
           {"time of the slower stroke over the quicker", "tempo della corsa lenta su quella rapida"}}};
}

// The directions of the crank, which no given states here.
std::vector<Quantity> crank_found() {
  return {radians("crank_angle", "$φ$", {"angle of the crank, from 0 to 2π", "angolo della manovella, da 0 a 2π"}),
          degrees("crank_angle_deg", "$φ$",
                  {"angle of the crank, from 0° to 360°", "angolo della manovella, da 0° a 360°"})};
}

std::vector<Quantity> dead_centre() {
  return joined(
      {crank_found(),
       {radians("coupler_angle", "$ϑ_{3}$", coupler_angle), radians("rocker_angle", "$ϑ_{4}$", rocker_angle),
        degrees("rocker_angle_deg", "$ϑ_{4}$", rocker_angle)},
       pins(),
       coordinates("C", "C", {"C", "C"}),
       second_order()});
}

std::vector<Quantity> parallel() { return joined({crank_found(), pins(), link_rate_quantities()}); }

std::vector<Quantity> slider_crank() {
  const auto pure = [](const std::string& name, const std::string& symbol, const Words& meaning) {
    return Quantity{"slider_crank_ratio_3." + name, symbol, "1", meaning};
  };
  return {
      pure("B_x_over_r", "$x_{B}/r$", {"abscissa of B", "ascissa di B"}),
      radians("slider_crank_ratio_3.coupler_angle", "$ϑ_{3}$", coupler_angle),
      pure("omega_3_over_omega_2", "$ω_{3}/ω_{2}$",
           {"angular velocity of the coupler", "velocità angolare della biella"}),
      pure("alpha_3_over_omega_2_squared", "$α_{3}/ω^{2}_{2}$",
           {"angular acceleration of the coupler", "accelerazione angolare della biella"}),
      pure("v_B_over_omega_2_r", "$v_{B}/ω_{2}r$", {"velocity of B", "velocità di B"}),
      pure("a_B_over_omega_2_squared_r", "$a_{B}/ω^{2}_{2}r$", {"acceleration of B", "accelerazione di B"}),
      pure("K_x_over_r", "$x_{K}/r$", {"abscissa of the acceleration pole", "ascissa del polo delle accelerazioni"}),
      pure("K_y_over_r", "$y_{K}/r$", {"ordinate of the acceleration pole", "ordinata del polo delle accelerazioni"}),
      pure("inflection_line_x_over_r", "$x_{F}/r$",
           {"abscissa of the line that the inflection circle has become",
            "ascissa della retta in cui degenera la circonferenza dei flessi"}),
      pure("stationarity_line_y_over_r", "$y_{S}/r$",
           {"ordinate of the line that the stationarity circle has become",
            "ordinata della retta in cui degenera la circonferenza di stazionarietà"})};
}

}  // namespace

std::vector<Quantity> quantities() {
  return joined({position(), second_order(), mirror_side(), stroke(),
                 in_case("dead_centre_extended.",
                         {"rocker's dead centre, extended", "punto morto esteso del bilanciere"}, dead_centre()),
                 in_case("dead_centre_folded.",
                         {"rocker's dead centre, folded", "punto morto ripiegato del bilanciere"}, dead_centre()),
                 in_case("parallel_links.same_sense_other_branch_",
                         {"crank and rocker parallel in the same sense, other branch",
                          "manovella e bilanciere paralleli concordi, altro ramo"},
                         parallel()),
                 in_case("parallel_links.same_sense_main_branch_",
                         {"crank and rocker parallel in the same sense, this branch",
                          "manovella e bilanciere paralleli concordi, questo ramo"},
                         parallel()),
                 in_case("parallel_links.opposite_sense_main_branch_",
                         {"crank and rocker parallel in opposite senses, this branch",
                          "manovella e bilanciere paralleli discordi, questo ramo"},
                         parallel()),
                 in_case("parallel_links.opposite_sense_other_branch_",
                         {"crank and rocker parallel in opposite senses, other branch",
                          "manovella e bilanciere paralleli discordi, altro ramo"},
                         parallel()),
                 slider_crank()});
}

}  // namespace epure::four_bar
