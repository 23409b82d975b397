#include <cmath>
#include <numbers>

#include "exercises/friction-efficiency/both_motions.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {

PanelSheet double_slider(const Solution& s, Language language) {
  const Case of(s, "double_slider_pins", "double_slider"), ideal(s, "double_slider");
  const double r = CGAL::to_double(s.givens()["double_slider_pins.r"]), rho = of["friction_circle_radius"];
  const Chain chain{"2",
                    "4",
                    force_between(3, 2),
                    force_between(1, 2),
                    force_between(1, 4),
                    3,
                    "⊥ $x$",
                    Words{"by both circles", "per i due cerchi"}.in(language),
                    turned_from("$x$", language),
                    turned_from("⊥ $x$", language),
                    "∥ $x$"};
  // The pin and its friction circle, with the line of the link's force.
  const auto detail = [&](const std::string& X, bool is_reversed) {
    const Place P = of.place(X), other = of.place(X == "A" ? "B" : "A");
    const Arrow2 along = (1 / distance(P, other)) * (other - P);
    Mechanism pin;
    pin.point(X, P, Joint::none, "$" + X + "$")
        .point("rim", {P.x + r, P.y}, Joint::corner, "")
        .point("circle", {P.x, P.y - rho}, Joint::corner, "");
    pin.disc(X, "rim", false).disc(X, "circle", false).axis(P + -1.5 * r * along, P + 1.5 * r * along, "$AB$");
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(pin)));
    PolygonSide R = of.known(moving(chain.contact, direct), "", "");
    R.quantity.clear();
    panel.force(is_reversed ? reversed(R, 3, 4) : R, of.place("on_" + X + direct));
    return panel;
  };
  // The angles at which the forces of the guides leave their normals.
  const auto with_guides = [&](const std::string& suffix) {
    ChainedPolygonsPanel panel = polygons(of, chain, suffix);
    const Arrow2 R_12 = of.vector(chain.on_loaded.name + suffix), R_14 = of.vector(chain.on_driven.name + suffix),
                 b = -R_12;
    constexpr double downwards = -std::numbers::pi / 2;
    panel.angle({0, 0}, 0, std::atan2(b.y, b.x), "$φ$").angle(b, downwards, std::atan2(-R_14.y, -R_14.x), "$φ$");
    return panel;
  };
  FreeBodyPanel whole(double_slider_figure(of));
  whole.load(of.load("Q", "", ""), of.place("A")).effort(of.known(P_of(direct), "", ""), of.place("B"), Arrow::ends);
  FreeBodyPanel A = detail("A", false), B = detail("B", true);
  A.step({"The pins turn in the link: its force touches both friction circles, $ρ$ = $r$ sin $φ$, on the sides on "
          "which it hinders their turning; so it crosses $AB$ at the angle $δ$, sin $δ$ = 2$ρ$/$l$. "
          "Dashed polygons: without friction.",
          "I perni ruotano nell'asta: la sua forza è tangente ai due cerchi d'attrito, $ρ$ = $r$ sen $φ$, dalle "
          "parti che ne ostacolano la rotazione; perciò taglia $AB$ sotto l'angolo $δ$, sen $δ$ = 2$ρ$/$l$. "
          "Poligoni a tratti: senza attrito."},
         of.place("on_A" + direct));
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"friction_circle_radius", "link_line_tilt_angle_deg"}));
  const auto row = [&](const Words& hinges, const Case& each) {
    return Row{hinges.in(language), each.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"})};
  };
  results.push_back(
      table({Words{"hinges", "cerniere"}.in(language), "$\\it{P}$ (N)", "$\\it{P}'$ (N)", "$η_{D}$", "$η_{R}$"},
            {row({"with friction", "con attrito"}, of), row({"ideal", "ideali"}, ideal)}));
  const auto limits = [&](const Words& hinges, const Case& each) {
    return Row{hinges.in(language), each.names({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"})};
  };
  results.push_back(table({Words{"hinges", "cerniere"}.in(language), "$φ_{R}$ (°)", "$φ_{D}$ (°)"},
                          {limits({"with friction", "con attrito"}, of), limits({"ideal", "ideali"}, ideal)}));
  return {
      .panels = panels(whole, A, B, with_guides(direct), with_guides(retrograde)),
      .results = results,
      .seen =
          {"The double slider, its pins with their friction circles, and the polygons of the direct and of the "
           "retrograde motion",
           "Il doppio pattino, i suoi perni con i cerchi d'attrito, e i poligoni del moto diretto e del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({}, {"phi", "double_slider_pins.r"})};
}

}  // namespace epure::friction_efficiency
