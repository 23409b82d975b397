// The quantities the exercise reports.
#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/linkages/four_bar_on_x.h"

namespace epure::four_bar_analytic {
namespace {

std::vector<Quantity> on_the_other_branch(std::vector<Quantity> specs) {
  for (Quantity& spec : specs) {
    spec.name += "_other_branch";
    spec.symbol = spec.symbol.substr(0, spec.symbol.size() - 1) + "'$";
    spec.meaning = {spec.meaning.english + ", other configuration", spec.meaning.italian + ", altra configurazione"};
  }
  return specs;
}

std::vector<Quantity> positions() {
  return joined({coordinates("A", "A", {"A", "A"}), coordinates("B", "B", {"B", "B"}),
                 coordinates("G2", "G2", {"the midpoint of A₀A", "G2, mezzeria di A₀A"}),
                 coordinates("G3", "G3", {"the midpoint of AB", "G3, mezzeria di AB"}),
                 coordinates("G4", "G4", {"the midpoint of B₀B", "G4, mezzeria di B₀B"})});
}

std::vector<Quantity> pins() {
  return joined({{speed("v_A", "$v_{A}$", {"speed of A", "velocità di A"}),
                  speed("v_BA", "$v_{BA}$", {"speed of B relative to A", "velocità di B relativa ad A"})},
                 components("v_B", "v", "B", "m/s", {"velocity of B", "velocità di B"}),
                 {acceleration("a_A", "$a_{A}$", {"acceleration of A", "accelerazione di A"}),
                  acceleration("a_BA_n", "$a^{n}_{BA}$",
                               {"normal part of B's relative to A", "parte normale di B rispetto ad A"}),
                  acceleration("a_BA_t", "$a^{t}_{BA}$",
                               {"tangential part of B's relative to A", "parte tangenziale di B rispetto ad A"}),
                  acceleration("a_B_n", "$a^{n}_{B}$", {"normal part of B's", "parte normale di B"}),
                  acceleration("a_B_t", "$a^{t}_{B}$", {"tangential part of B's", "parte tangenziale di B"})},
                 components("a_B", "a", "B", "m/s^2", {"acceleration of B", "accelerazione di B"})});
}

std::vector<Quantity> parts_of_G3() {
  return {
      acceleration("a_G3_component_along_AB", "$a_{G3}·u_{AB}$",
                   {"component of G₃'s acceleration along A → B", "componente dell'accelerazione di G₃ lungo A → B"}),
      acceleration("a_G3_component_normal_to_AB", "$a_{G3}·k×u_{AB}$",
                   {"component of G₃'s acceleration square to A → B, on its left",
                    "componente dell'accelerazione di G₃ normale ad A → B, a sinistra"}),
      acceleration("a_G3_path_normal", "$a^{n}_{G3}$",
                   {"part of G₃'s acceleration normal to its path", "parte normale alla traiettoria di G₃"}),
      acceleration("a_G3_path_tangential", "$a^{t}_{G3}$",
                   {"part of G₃'s acceleration along its path", "parte tangente alla traiettoria di G₃"}),
      acceleration("a_G3A_n", "$a^{n}_{G3A}$",
                   {"normal part of G₃'s relative to A", "parte normale di G₃ rispetto ad A"}),
      acceleration("a_G3A_t", "$a^{t}_{G3A}$",
                   {"tangential part of G₃'s relative to A", "parte tangenziale di G₃ rispetto ad A"})};
}

std::vector<Quantity> of_a_turn() {
  const auto of_crank = [](const std::string& name, const std::string& index, const Words& meaning) {
    return Quantity{name, "$θ_{2," + index + "}$", "deg", meaning};
  };
  return {{"omega_4_max",
           "$ω_{4,max}$",
           "rad/s",
           {"greatest ω₄ over a turn of the crank at constant speed",
            "massima ω₄ in un giro della manovella a velocità costante"}},
          of_crank("theta_2_at_omega_4_max_deg", "max", {"crank angle there", "anomalia della manovella"}),
          {"omega_4_min",
           "$ω_{4,min}$",
           "rad/s",
           {"least ω₄ over a turn of the crank at constant speed",
            "minima ω₄ in un giro della manovella a velocità costante"}},
          of_crank("theta_2_at_omega_4_min_deg", "min", {"crank angle there", "anomalia della manovella"}),
          of_crank("theta_2_at_omega_4_zero_1_deg", "1",
                   {"crank angle of the first dead centre of the rocker",
                    "anomalia della manovella al primo punto morto del bilanciere"}),
          of_crank("theta_2_at_omega_4_zero_2_deg", "2",
                   {"crank angle of the second dead centre of the rocker",
                    "anomalia della manovella al secondo punto morto del bilanciere"})};
}

std::vector<Quantity> of_P() {
  return joined({coordinates("P", "P", {"the coupler point P", "P, punto di biella"}),
                 components("v_P", "v", "P", "m/s", {"velocity of P", "velocità di P"}),
                 components("a_P", "a", "P", "m/s^2", {"acceleration of P", "accelerazione di P"}),
                 curvature_quantities("P", "P")});
}

}  // namespace

std::vector<Quantity> quantities() {
  const Quantity omega_2{
      "omega_2", "$ω_{2}$", "rad/s", {"angular velocity of the crank", "velocità angolare della manovella"}};
  return joined({{omega_2},
                 link_angle_quantities(),
                 link_rate_quantities(),
                 on_the_other_branch(link_angle_quantities()),
                 on_the_other_branch(link_rate_quantities()),
                 positions(),
                 pins(),
                 midpoint_quantities(),
                 parts_of_G3(),
                 pole_quantities("P0", "P_{0}", {"A", "B", "G3"}),
                 acceleration_pole_quantities({"A", "B", "G3"}),
                 circle_quantities(),
                 curvature_quantities("G3", "G3"),
                 of_P(),
                 of_a_turn()});
}

}  // namespace epure::four_bar_analytic
