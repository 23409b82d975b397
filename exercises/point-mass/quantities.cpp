#include "exercises/point-mass/quantities.h"

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity_kinds.h"

namespace epure::point_mass {
namespace {

const QuantityKind& kind_of(const std::string& name) {
  static const QuantityKinds kinds{
      {"F", {"\\it{F}", "N", {"force", "forza"}}},
      {"a", {"a", "m/s^2", {"acceleration", "accelerazione"}}},
      {"v", {"v", "m/s", {"velocity", "velocità"}}},
      {"q", {"q", "kg*m/s", {"momentum", "quantità di moto"}}},
      {"E", {"\\it{E}", "J", {"kinetic energy", "energia cinetica"}}},
      {"s", {"s", "m", {"space", "spazio"}}},
  };
  return kinds.at(name);
}

std::string initial(const std::string& method) { return method.empty() ? "" : method == "bezout" ? "B" : "S"; }
Words by(const std::string& method) {
  if (method.empty()) return {};
  return method == "bezout" ? Words{" by Bezout's formula", " con la formula di Bezout"}
                            : Words{" by Cavalieri-Simpson's formula", " con la formula di Cavalieri-Simpson"};
}
std::string name_of(const std::string& kind, const std::string& method, const std::string& at) {
  return kind + (method.empty() ? "" : "_" + method) + "_" + at;
}
bool is_row(const std::string& at) { return at.starts_with("at_"); }
Words when(const std::string& at) {
  return is_row(at) ? format_words(" at t = {} s", " per t = {} s", at.substr(3))
                    : format_words(" at t_{}", " all'istante t_{}", at);
}

}  // namespace

Quantity of_motion(const std::string& kind, const std::string& method, const std::string& at) {
  const QuantityKind& of = kind_of(kind);
  const std::string letters = is_row(at) ? "$" + of.symbol + (method.empty() ? "" : "_{" + initial(method) + "}") +
                                               "$(" + at.substr(3) + " s)"
                                         : "$" + of.symbol + "_{" + initial(method) + at + "}$";
  return {name_of(kind, method, at), letters, of.unit, of.meaning + by(method) + when(at)};
}

Quantity error_of(const std::string& kind, const std::string& method, const std::string& at) {
  return {"err_" + name_of(kind, method, at), "$ε_{" + kind + initial(method) + at + "}$", "1",
          Words{"relative error of the ", "errore relativo: "} + kind_of(kind).meaning + by(method) + when(at)};
}

Quantity centroid_at(const std::string& instant) {
  return {"t_centroid_" + instant, "$t_{G" + instant + "}$", "s",
          format_words("centroid of the acceleration diagram from 0 to t_{}",
                       "baricentro del diagramma delle accelerazioni da 0 a t_{}", instant)};
}

Quantity extreme(const std::string& name) {
  static const std::map<std::string, Quantity> all{
      {"t_F_max", {"t_F_max", "$t_{Fmax}$", "s", {"instant of the greatest force", "istante della forza massima"}}},
      {"F_max", {"F_max", "$\\it{F}_{max}$", "N", {"greatest force", "forza massima"}}},
      {"t_F_min", {"t_F_min", "$t_{Fmin}$", "s", {"instant of the least force", "istante della forza minima"}}},
      {"F_min", {"F_min", "$\\it{F}_{min}$", "N", {"least force", "forza minima"}}},
      {"t_v_max",
       {"t_v_max", "$t_{vmax}$", "s", {"instant of the greatest velocity", "istante della velocità massima"}}},
      {"v_max", {"v_max", "$v_{max}$", "m/s", {"greatest velocity", "velocità massima"}}},
      {"q_max", {"q_max", "$q_{max}$", "kg*m/s", {"greatest momentum", "quantità di moto massima"}}},
      {"E_max",
       {"E_max",
        "$\\it{E}_{max}$",
        "J",
        {"kinetic energy at the greatest velocity", "energia cinetica alla velocità massima"}}},
      {"s_at_v_max",
       {"s_at_v_max",
        "$s_{vmax}$",
        "m",
        {"space at the greatest velocity", "spazio percorso alla velocità massima"}}},
      {"impulse_positive",
       {"impulse_positive",
        "$\\it{I}_{+}$",
        "N*s",
        {"area of the force diagram where the force is positive",
         "area del diagramma delle forze dove la forza è positiva"}}},
      {"impulse_negative",
       {"impulse_negative",
        "$\\it{I}_{-}$",
        "N*s",
        {"area of the force diagram where the force is negative",
         "area del diagramma delle forze dove la forza è negativa"}}},
  };
  return all.at(name);
}

Quantity pole_distance(const std::string& kind) {
  return {"pole_distance_" + kind, "$\\it{H}_{" + kind + "}$", "m",
          Words{"distance of the pole on paper, for the diagram of the ",
                "distanza del polo sulla carta, per il diagramma: "} +
              kind_of(kind).meaning};
}

Quantity distance_of_polygon(const std::string& kind) {
  return {"off_" + kind, "$δ_{" + kind + "}$", kind_of(kind).unit,
          Words{"end of the integral polygon above the true curve: ",
                "estremo del poligono integrale sopra la curva esatta: "} +
              kind_of(kind).meaning};
}

Quantity ordinate_of_polygon(const std::string& kind, const std::string& instant) {
  return {name_of(kind, "", instant), "$" + kind + "_{g" + instant + "}$", kind_of(kind).unit,
          kind_of(kind).meaning + Words{" of the integral polygon", " del poligono integrale"} + when(instant)};
}

}  // namespace epure::point_mass
