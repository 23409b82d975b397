// The wheel cut free at touch-down and after it has taken hold: what the hub must give closes its polygon.
#include "exercises/aircraft-landing/landing.h"
#include "exercises/aircraft-landing/sheets.h"
#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {
namespace {

// The place of contact is the origin, the wheel goes to the right.
struct Wheel {
  double R, u, turning;  // clockwise, as it rolls: of what sense its angular acceleration is
  PolygonSide weight, N, F, inertia, hub;
};

Wheel wheel_at(const Solution& s, bool at_first) {
  const std::string prime = at_first ? "" : "'", when = at_first ? "0" : "after";
  const std::string N = at_first ? "N_0" : "N_s", F = "F_" + when, inertia = "wheel_inertia_" + when,
                    hub = "hub_force_" + when;
  const bool is_forwards = s[F] < 0;
  const auto side = [](const std::string& quantity, const std::string& label, const std::string& direction,
                       const std::string& size, const Arrow2& v) {
    return PolygonSide{.quantity = quantity,
                       .label = label,
                       .direction = direction,
                       .magnitude = size,
                       .v = v,
                       .length = magnitude(v)};
  };
  return {
      .R = CGAL::to_double(Landing(s.givens()).R),
      .u = s["u"],
      .turning = s[at_first ? "omega_dot_0" : "a_after"],
      .weight = side("wheel_weight", "$\\vec{\\it{P}}_{r}$", "↓", "$m_{r}g$", {0, -s["wheel_weight"]}),
      .N = side(N, "$\\vec{\\it{N}}$", "↑", "$\\it{N}$", {0, s[N]}),
      .F = side(F, "$\\vec{\\it{F}}" + prime + "$", is_forwards ? "→" : "←",
                is_forwards ? "|$\\it{F}" + prime + "$|" : "$\\it{F}" + prime + "$", {-s[F], 0}),
      .inertia = side(inertia, "−$m_{r}\\vec{a}" + prime + "$", "→", "$m_{r}$|$a" + prime + "$|", {s[inertia], 0}),
      .hub = side(hub, "$\\vec{\\it{H}}" + prime + "$", "?", "?", s.vector(hub))};
}

VectorPolygon polygon_of(const Wheel& of, const std::string& letter) {
  return force_polygon(letter, {of.hub}, {of.weight, of.inertia, of.F, of.N});
}

FreeBodyPanel cut_free(const Wheel& of, const std::string& prime) {
  using Joint = Mechanism::Joint;
  const Place hub{0, of.R}, foot{of.u, 0};
  Mechanism drawn;
  drawn.point("C", {0, 0}, Joint::none, "").point("G", hub, Joint::mass, "$G$").disc("G", "C", true);
  FreeBodyPanel body(std::make_shared<const Mechanism>(std::move(drawn)));
  body.force(of.N, foot, FreeBodyPanel::Arrow::ends)
      .force(of.F, just_above_ground(of.R))
      .force(of.weight, hub)
      .force(of.inertia, hub)
      .force(of.hub, hub, prime.empty() ? FreeBodyPanel::Arrow::starts : FreeBodyPanel::Arrow::ends)
      .couple("−$\\it{J}_{r}α" + prime + "$", hub, of.turning)
      .arm(hub, foot, {0, 1}, "$u$", "");
  return body;
}

}  // namespace

Place just_above_ground(double R) { return {0, 0.12 * R}; }

Words sense_after(const Solution& s) {
  if (s["F_after"] >= 0) return {};
  return {"$\\it{F}'$ < 0: counted backwards, it acts forwards, and slows the wheel down with the aircraft.",
          "$\\it{F}'$ < 0: contata all'indietro, agisce in avanti, e rallenta la ruota con l'aereo."};
}

PanelSheet wheel_sheet(const Solution& s, Language language) {
  const Wheel first = wheel_at(s, true), after = wheel_at(s, false);
  FreeBodyPanel before_body = cut_free(first, ""), after_body = cut_free(after, "'");
  before_body.step(
      {"The wheel cut free at touch-down: the ground's $\\vec{\\it{N}}$ stands $u$ = $f_{v}\\it{R}$ ahead of the "
       "hub, the force of inertia −$m_{r}\\vec{a}$ and the couple −$\\it{J}_{r}α$ are d'Alembert's.",
       "La ruota isolata al contatto: la reazione $\\vec{\\it{N}}$ del terreno è avanti di $u$ = $f_{v}\\it{R}$ "
       "rispetto al mozzo; la forza d'inerzia −$m_{r}\\vec{a}$ e la coppia −$\\it{J}_{r}α$ sono quelle di "
       "d'Alembert."},
      {0, first.R});
  after_body.step(
      {"The same once it rolls, with $α'$ = $a'$/$\\it{R}$.", "La stessa quando rotola, con $α'$ = $a'$/$\\it{R}$."},
      {0, after.R});
  ChainedPolygonsPanel rolling(polygon_of(after, "2"));
  rolling.likewise({"Once it rolls, likewise: the hub's force $\\vec{\\it{H}}'$.",
                    "Quando rotola, allo stesso modo: la forza del mozzo $\\vec{\\it{H}}'$."},
                   {0, 0});
  const Words balance{
      "$\\vec{\\it{H}}$ is what the aircraft gives its wheel: it closes the polygon of weight, inertia, friction and "
      "reaction. About the hub $\\it{J}_{r}α$ = $\\it{F}\\it{R}$ − $\\it{N}u$.",
      "$\\vec{\\it{H}}$ è quanto l'aereo dà alla ruota: chiude il poligono di peso, inerzia, attrito e reazione. "
      "Rispetto al mozzo $\\it{J}_{r}α$ = $\\it{F}\\it{R}$ − $\\it{N}u$."};
  return {.panels = panels(before_body, PolygonPanel(s, polygon_of(first, "1")), after_body, rolling),
          .results = {remark(balance.in(language)), values({"N_0", "F_0"}), values({"hub_force_0", "omega_dot_0"}),
                      values({"N_s", "F_after"}), remark(sense_after(s).in(language)),
                      values({"hub_force_after", "a_after"}), values({"u"})},
          .seen = {"The wheel cut free at touch-down and after it has taken hold, and the polygons of its forces",
                   "La ruota isolata al contatto e dopo che ha aderito, e i poligoni delle sue forze"},
          .told = {"hub_force_0", "hub_force_after", "N_0", "F_0", "N_s", "F_after"},
          .without_part = {"Delta_t", "f_a"}};
}

}  // namespace epure::aircraft_landing
