// The givens, and what is reported.
#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/linkages/coupler_quantities.h"

namespace epure::cycloid_involute {
namespace {

// The instant in a symbol's subscript and in words.
struct NamedInstant {
  InstantNames names;
  std::string subscript;
  Words when;
};

// "#" in the symbol stands for the instant.
Quantity at(const NamedInstant& instant, const std::string& name, std::string symbol, const std::string& unit,
            const Words& meaning) {
  symbol.replace(symbol.find('#'), 1, instant.subscript);
  return {instant.names(name),
          symbol,
          unit,
          {meaning.english + instant.when.english, meaning.italian + instant.when.italian}};
}

std::vector<Quantity> place(const NamedInstant& of) {
  return {at(of, "x_M", "$x_{M#}$", "m", {"abscissa of M", "ascissa di M"}),
          at(of, "y_M", "$y_{M#}$", "m", {"ordinate of M", "ordinata di M"}),
          at(of, "P0M", "$P_{0}M_{#}$", "m", {"distance of M from the contact P₀", "distanza di M dal contatto P₀"})};
}

std::vector<Quantity> velocity(const NamedInstant& of) {
  return {at(of, "v_M", "$v_{M#}$", "m/s", {"speed of M", "velocità di M"}),
          at(of, "v_M_x", "$v_{M#x}$", "m/s", {"velocity of M, along x", "velocità di M, lungo x"}),
          at(of, "v_M_y", "$v_{M#y}$", "m/s", {"velocity of M, along y", "velocità di M, lungo y"})};
}

std::vector<Quantity> acceleration_of_M(const NamedInstant& of) {
  return {at(of, "a_M", "$a_{M#}$", "m/s^2", {"acceleration of M", "accelerazione di M"}),
          at(of, "a_M_x", "$a_{M#x}$", "m/s^2", {"acceleration of M, along x", "accelerazione di M, lungo x"}),
          at(of, "a_M_y", "$a_{M#y}$", "m/s^2", {"acceleration of M, along y", "accelerazione di M, lungo y"}),
          at(of, "a_n", "$a^{n}_{M#}$", "m/s^2", {"normal part of a_M", "parte normale di a_M"})};
}

Quantity along(const NamedInstant& of) {
  return at(
      of, "a_t", "$a^{t}_{M#}$", "m/s^2",
      {"tangential part of a_M, positive along the motion", "parte tangenziale di a_M, positiva nel senso del moto"});
}
// Two numbers at a cusp, else twice the same.
std::vector<Quantity> along_on_both_sides(const NamedInstant& of) {
  return {at(of, "a_t", "$a^{t−}_{M#}$", "m/s^2",
             {"tangential part of a_M just before the instant, which is a cusp if the sides differ",
              "parte tangenziale di a_M subito prima dell'istante, una cuspide se i due lati differiscono"}),
          at(of, "a_t", "$a^{t+}_{M#}$", "m/s^2",
             {"tangential part of a_M just after the instant", "parte tangenziale di a_M subito dopo l'istante"})};
}

std::vector<Quantity> curvature(const NamedInstant& of) {
  return {
      at(of, "rho_M", "$ρ_{M#}$", "m", {"radius of curvature of the path", "raggio di curvatura della traiettoria"}),
      at(of, "curvature_centre_x", "$x_{Ω#}$", "m",
         {"abscissa of the centre of curvature", "ascissa del centro di curvatura"}),
      at(of, "curvature_centre_y", "$y_{Ω#}$", "m",
         {"ordinate of the centre of curvature", "ordinata del centro di curvatura"})};
}

std::vector<Quantity> sides(const NamedInstant& of) {
  std::vector<Quantity> both = along_on_both_sides(of);
  both[0].name += "_before_cusp";
  both[1].name += "_after_cusp";
  return both;
}

std::vector<Quantity> cycloid_at_phi() {
  const NamedInstant phi{at_phi, "φ", {", at φ", ", a φ"}};
  return joined(
      {{at(phi, "time_at_phi", "$t_{#}$", "s", {"time", "tempo"})},
       place(phi),
       {at(phi, "arc_length_at_phi", "$s_{#}$", "m", {"arc travelled", "arco percorso"})},
       velocity(phi),
       acceleration_of_M(phi),
       {along(phi)},
       sides(phi),
       curvature(phi),
       {at(phi, "Mprime_M", "$M'M_{#}$", "m",
           {"distance of M from M' on the inflection circle", "distanza di M da M' sulla circonferenza dei flessi"}),
        at(phi, "K_x", "$x_{K#}$", "m",
           {"abscissa of the acceleration pole, and inflection pole",
            "ascissa del polo delle accelerazioni, e dei flessi"}),
        at(phi, "K_y", "$y_{K#}$", "m", {"ordinate of K", "ordinata di K"}),
        at(phi, "KM", "$KM_{#}$", "m", {"distance of M from K", "distanza di M da K"}),
        metres("cycloid.inflection_diameter", "$δ$",
               {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}),
        metres("cycloid.arch_base", "$πd$", {"base of an arch", "base di un arco di cicloide"}),
        metres("cycloid.arch_length", "$s_{0}$", {"length of an arch", "lunghezza di un arco di cicloide"})}});
}

std::vector<Quantity> cycloid_at_s() {
  const NamedInstant s{at_s, "s", {", when s has been travelled", ", percorso lo spazio s"}};
  return joined({{at(s, "phi", "$φ_{#}$", "rad", {"angle of the wheel", "angolo della ruota"}),
                  at(s, "t", "$t_{#}$", "s", {"time", "tempo"})},
                 place(s),
                 velocity(s),
                 acceleration_of_M(s),
                 {along(s)},
                 sides(s),
                 curvature(s)});
}

std::vector<Quantity> involute_at(const NamedInstant& t) {
  return joined({{at(t, "phi", "$φ_{#}$", "rad", {"angle of the line", "angolo della retta"})},
                 place(t),
                 {at(t, "arc_length", "$s_{#}$", "m", {"arc travelled", "arco percorso"})},
                 velocity(t),
                 acceleration_of_M(t),
                 {along(t)},
                 curvature(t)});
}

GivenSpec angle_of_line(const std::string& symbol, const std::string& instant, const std::string& letters) {
  return {.symbol = symbol,
          .meaning = {"angle the line has turned through, in place of " + instant,
                      "angolo di cui è ruotata la retta, in luogo di " + instant},
          .unit = "rad",
          .stated = "",
          .range = Range::not_negative,
          .letters = letters,
          .turned = TurnedThrough{.instant = instant, .speed = "omega_2"}};
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  return {{"d", {"diameter of the wheel", "diametro della ruota"}, "m", "1", Range::positive, "$d$"},
          {"omega_1",
           {"angular velocity of the wheel", "velocità angolare della ruota"},
           "rad/s",
           "30",
           Range::positive,
           "$ω_{1}$"},
          {"phi",
           {"angle of the wheel at the first instant", "rotazione della ruota al primo istante"},
           "deg",
           "135",
           Range::not_negative,
           "$φ$"},
          {"s",
           {"arc travelled at the second instant", "spazio percorso al secondo istante"},
           "m",
           "4",
           Range::not_negative,
           "$s$"},
          {"d_0",
           {"diameter of the base circle", "diametro del cerchio di base"},
           "m",
           "0.6",
           Range::positive,
           "$d_{0}$"},
          {"omega_2",
           {"angular velocity of the line", "velocità angolare della retta"},
           "rad/s",
           "50",
           Range::positive,
           "$ω_{2}$"},
          {"t1",
           {"first instant of the involute", "primo istante dell'evolvente"},
           "s",
           "0.14",
           Range::not_negative,
           "$t_{1}$"},
          angle_of_line("phi_1", "t1", "$φ_{1}$"),
          {"t2",
           {"second instant of the involute", "secondo istante dell'evolvente"},
           "s",
           "0.28",
           Range::not_negative,
           "$t_{2}$"},
          angle_of_line("phi_2", "t2", "$φ_{2}$")};
}

std::vector<Quantity> quantity_specs() {
  return joined({cycloid_at_phi(), cycloid_at_s(), involute_at({at_t1, "1", {", at t₁", ", a t₁"}}),
                 involute_at({at_t2, "2", {", at t₂", ", a t₂"}})});
}

}  // namespace epure::cycloid_involute
