#include <cmath>
#include <numbers>

#include "exercises/friction-efficiency/both_motions.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {

PanelSheet double_slider(const Solution& s, Language language) {
  const Case of(s, "double_slider_pins", "double_slider"), ideal(s, "double_slider");
  const Place A = of.place("A"), B = of.place("B");
  // The line of the link's force, of the retrograde motion another.
  const auto t = [](const std::string& suffix) { return "$t" + prime(suffix) + "$"; };
  Chain chain{"2",    "4",     force_between(3, 2), force_between(1, 2),          force_between(1, 4),
              3,      "⊥ $x$", "∥ " + t(direct),    turned_from("$x$", language), turned_from("⊥ $x$", language),
              "∥ $x$"};
  PolygonSide R_32 = of.known(moving(chain.contact, direct), "", "");
  R_32.quantity.clear();
  const PolygonSide R_34 = reversed(R_32, 3, 4);
  // The friction circle of a pin, with the lines of the link's force.
  const auto detail = [&](const std::string& X, const PolygonSide& R) {
    const Place P = of.place(X), other = X == "A" ? B : A, T = of.place("on_" + X + direct);
    const Arrow2 along = (1 / distance(P, other)) * (other - P);
    constexpr double reaches = 0.0016;  // m
    Mechanism pin;
    pin.point(X, P, Joint::none, "$" + X + "$").axis(P + -reaches * along, P + reaches * along);
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(pin)));
    panel.at_most(5000).friction_circle(P, T, "$ρ$").force(R, T);
    panel.line_to(T, T + -reaches / magnitude(R.v) * R.v, t(direct));
    const Place other_T = of.place("on_" + X + retrograde);
    const Arrow2 other_R = of.vector("R_32" + retrograde);
    if (magnitude(other_R) == 0 || is_zero(s.givens().angle("phi"))) return panel;
    panel.line_to(other_T, other_T + reaches / magnitude(other_R) * other_R, t(retrograde));
    return panel;
  };
  // On a slider the link's force meets the known one, or P, a little beside the pin: through there presses the guide.
  const auto meeting = [&](const std::string& X) -> Place {
    const Place P = of.place(X), T = of.place("on_" + X + direct);
    const Arrow2& v = R_32.v;
    if (X == "A") return v.x == 0 ? P : T + (P.x - T.x) / v.x * v;
    return v.y == 0 ? P : T + (P.y - T.y) / v.y * v;
  };
  const PolygonSide R_12_of_2 = of.known(moving(chain.on_loaded, direct), "", ""),
                    R_14_of_4 = of.known(moving(chain.on_driven, direct), "", "");
  FreeBodyPanel on_2 = slider_cut_free(of, "A"), on_4 = slider_cut_free(of, "B");
  on_2.load(of.load("Q", "", ""), A).force(R_32, of.place("on_A" + direct), Arrow::ends);
  on_4.effort(of.known(P_of(direct), "", ""), B, Arrow::ends).force(R_34, of.place("on_B" + direct), Arrow::ends);
  // Each slides against the friction that its guide exerts.
  press(on_2, of, R_12_of_2, meeting("A"), 0, {0, -R_12_of_2.v.y}, "21");
  press(on_4, of, R_14_of_4, meeting("B"), std::numbers::pi / 2, {-R_14_of_4.v.x, 0}, "41");
  on_2.step(turned_against, A);
  // The angles at which the forces of the guides leave their normals.
  const auto with_guides = [&](const std::string& suffix) {
    chain.along_contact = "∥ " + t(suffix);
    ChainedPolygonsPanel panel = polygons(of, chain, suffix);
    const Arrow2 R_12 = of.vector(chain.on_loaded.name + suffix), R_14 = of.vector(chain.on_driven.name + suffix),
                 b = -R_12;
    constexpr double downwards = -std::numbers::pi / 2;
    panel.angle({0, 0}, 0, std::atan2(b.y, b.x), "$φ$").angle(b, downwards, std::atan2(-R_14.y, -R_14.x), "$φ$");
    return panel;
  };
  FreeBodyPanel whole(double_slider_figure(of, Origin::none));
  whole.to_scale().at_most(200).load(of.load("Q", "", ""), A).effort(of.known(P_of(direct), "", ""), B, Arrow::ends);
  FreeBodyPanel on_A = detail("A", R_32), on_B = detail("B", R_34);
  on_A.step({"The link's force, along $t$, touches both friction circles, $ρ$ = $r$ sin $φ$, against the pins' "
             "turning (retrograde: $t'$); sin $δ$ = 2$ρ$/$l$.",
             "La forza dell'asta corre lungo $t$, tangente ai due cerchi d'attrito, $ρ$ = $r$ sen $φ$, in modo da "
             "ostacolare i perni (nel retrogrado $t'$); sen $δ$ = 2$ρ$/$l$."},
            of.place("on_A" + direct));
  std::vector<Result> results = efficiencies(of, "P", language);
  // P and the efficiencies the table tells, beside those with ideal hinges.
  results.erase(results.begin() + 3);
  results.erase(results.begin() + 1);
  results.push_back(of.results({"friction_circle_radius", "link_line_tilt_angle_deg"}));
  const auto row = [&](const std::string& symbol, const std::string& quantity) {
    return Row{symbol, {of.name(quantity), ideal.name(quantity)}};
  };
  results.push_back(
      table({Words{"hinges", "cerniere"}.in(language), Words{"with friction", "con attrito"}.in(language),
             Words{"ideal", "ideali"}.in(language)},
            {row("$\\it{P}$ (N)", "P_direct"), row("$\\it{P}'$ (N)", "P_retrograde"), row("$η_{D}$", "eta_direct"),
             row("$η_{R}$", "eta_retrograde"), row("$φ_{R}$ (°)", "self_locking_friction_angle_deg"),
             row("$φ_{D}$ (°)", "jamming_friction_angle_deg")}));
  return {
      .panels = panels(whole, on_2, on_4, on_A, on_B, with_guides(direct), with_guides(retrograde)),
      .results = results,
      .seen =
          {"The double slider, its sliders cut free with their friction cones, the friction circles of its pins, and "
           "the polygons of the direct and of the retrograde motion",
           "Il doppio pattino, i suoi pattini isolati con i coni d'attrito, i cerchi d'attrito dei suoi perni, e i "
           "poligoni del moto diretto e del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({}, {"phi", "double_slider_pins.r"})};
}

}  // namespace epure::friction_efficiency
