// A spool drawn over a plane by a counterweight: does it stay, roll or slip?
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/spool-slip/routes.h"

namespace epure {
namespace spool_slip {
namespace {

using Joint = Mechanism::Joint;

double given(const Solution& s, const std::string& symbol) { return CGAL::to_double(s.givens()[symbol]); }

// The spool on its plane; C is where it touches, A where the rope leaves the core.
Mechanism spool_of(const Solution& s, const std::string& letters_of_C = "$C$") {
  const Place C = s.place("C"), G = s.place("G"), A = s.place("A");
  Mechanism drawn;
  drawn.point("C", C, Joint::none, letters_of_C)
      .point("G", G, Joint::mass, "$G$")
      .point("A", A, Joint::none, "$A$")
      .disc("G", "C", true)
      .profile(G, given(s, "r"), -M_PI, M_PI);
  return drawn;
}

// With rope, pulley and counterweight.
Mechanism whole(const Solution& s, const std::string& letters_of_C) {
  const double R = given(s, "R"), h = s.place("A").y, pulley = R / 4, far = 1.7 * R, side = 0.2 * R;
  const Place centre{far, h - pulley}, hook{far + pulley, centre.y - 0.6 * R};
  Mechanism drawn = spool_of(s, letters_of_C);
  drawn.point("top", {far, h}, Joint::corner, "")
      .point("Q", centre, Joint::hinge, "")
      .point("right", {far + pulley, centre.y}, Joint::corner, "")
      .point("hook", hook, Joint::corner, "")
      .point("b1", hook + Arrow2{-side, 0}, Joint::corner, "")
      .point("b2", hook + Arrow2{-side, -2 * side}, Joint::corner, "")
      .point("b3", hook + Arrow2{side, -2 * side}, Joint::corner, "")
      .point("b4", hook + Arrow2{side, 0}, Joint::corner, "")
      .point("b", hook + Arrow2{0, -side}, Joint::mass, "$m_{b}$")
      .disc("Q", "right", false)
      .body({"A", "top"})
      .body({"right", "hook"})
      .body({"b1", "b2", "b3", "b4"});
  return drawn;
}

PanelSheet velocity_sheet(const Solution& s, Language language) {
  using Where = PolesStep::Where;
  PolesPanel::Kind about = PolesPanel::of_velocity("C");
  about.letters = "$C$";
  Mechanism spool = whole(s, "");
  const double R = given(s, "R");
  const Place G = s.place("G");
  spool.offset("A", G, std::numbers::pi, R, "$r$").offset("C", G, std::numbers::pi, 1.3 * R, "$\\it{R}$");
  PolesPanel poles(
      s, std::make_shared<const Mechanism>(std::move(spool)), about, {"G", "A"},  // C is the pole's
      {{{"It rolls: $C$ rests, and is the instantaneous centre. $\\vec{v}_{G}$ is laid off for $ω$ = 1 rad/s.",
         "Rotola: $C$ è fermo, ed è il centro d'istantanea rotazione. Si riporta $\\vec{v}_{G}$ per $ω$ = 1 rad/s."},
        Where::tip,
        "G"},
       {{"The line from $C$ to its tip cuts off $\\vec{v}_{A}$, the velocity of the rope: $v_{A}$ : $v_{G}$ = $CA$ : "
         "$CG$.",
         "La retta da $C$ al suo estremo stacca $\\vec{v}_{A}$, la velocità della fune: $v_{A}$ : $v_{G}$ = $CA$ : "
         "$CG$."},
        Where::tip,
        "A"}});
  poles.by_the_tips();
  const auto drawn = [&](const std::string& of, const std::string& direction, const std::string& magnitude,
                         const std::string& tip = {}) {
    PolygonSide side = epure::side(s, velocity(of), direction, magnitude, tip);
    side.quantity.clear();
    return side;
  };
  const VectorPolygon polygon =
      velocity_polygon({drawn("A", "?", "?")},
                       {drawn("G", "⊥ $CG$", "$ω$·$\\it{R}$", "$g$"), drawn("AG", "⊥ $GA$", "$ω$·$r$", "$a$")});
  const Words goes_down{
      "Counterweight and rope: $a$ = $k$·$a'$, $a'$ = $α$·$\\it{R}$, $k$ = ($\\it{R}$ − $r$)/$\\it{R}$.",
      "Contrappeso e fune: $a$ = $k$·$a'$, $a'$ = $α$·$\\it{R}$, $k$ = ($\\it{R}$ − $r$)/$\\it{R}$."};
  return {.panels = panels(poles, PolygonPanel(s, polygon)),
          .results = {values({"rope_to_centre_velocity_ratio"}), remark(goes_down.in(language)), values({"J", "u"})},
          .seen = {"The spool rolling about its contact, with the velocities of its centre and of the rope",
                   "La bobina che rotola attorno al contatto, con le velocità del centro e della fune"},
          .told = {"rope_to_centre_velocity_ratio"},
          .without_part = {"m_b", "m_b_heavy", "m_b_light", "f_a", "f_r", "g"}};
}

// The forces on the spool in one case.
struct Forces {
  PolygonSide W, T, inertia, S;
};
Forces forces(const Solution& s, const std::string& prefix, Language language) {
  const std::string level = Words{"horizontal", "orizzontale"}.in(language),
                    upright = Words{"vertical", "verticale"}.in(language);
  const auto side = [&](const std::string& drawn, const std::string& quantity, const std::string& label,
                        const std::string& direction, const std::string& magnitude, const std::string& tip) {
    const Arrow2 v = s.vector(prefix + drawn);
    const bool is_there = v.x != 0 || v.y != 0;
    return PolygonSide{.quantity = s.is_reported(prefix + quantity) ? prefix + quantity : "",
                       .label = "$\\vec{" + label + "}$",
                       .direction = direction,
                       .magnitude = is_there ? magnitude : "0",
                       .v = v,
                       .tip = tip};
  };
  return {side("side_weight", "", "\\it{W}_{a}", upright, "$m_{a}g$", ""),
          side("side_pull", "T", "\\it{T}", level, "$\\it{T}$", ""),
          side("side_inertia", "inertia_force", "\\it{F}_{i}", level, "$m_{a}a'$", ""),
          side("side_reaction", "ground_reaction", "\\it{S}", "?", "?", "")};
}

const std::array<Words, 3> regime_names{Words{"it stays at rest", "resta in quiete"}, Words{"it rolls", "rotola"},
                                        Words{"it slips", "striscia"}};
const Words& name_of(Regime regime) { return regime_names[static_cast<int>(regime)]; }

// What the rope pulls with.
Words rope_pull(const Solution& s) {
  const bool rests = spool(s.givens()).regime(s.givens()["m_b"]) == Regime::at_rest;
  const std::string pull = rests ? "$\\it{T}$ = $m_{b}g$" : "$\\it{T}$ = $m_{b}$($g$ − $a$)";
  return {pull, pull};
}

const Words meets{
    "Pull and inertia together act in a level line that crosses the vertical of $G$ in $\\it{H}$, $h_{r}$ above "
    "the plane: the reaction's line passes there.",
    "Tiro e inerzia insieme agiscono su una retta orizzontale che taglia la verticale di $G$ in $\\it{H}$, a "
    "$h_{r}$ dal piano: vi passa la retta della reazione."};

// The equations of the spool that give the acceleration with the rope's, and what comes out of them.
std::vector<Result> how_it_moves(const Solution& s, Regime regime, Language language) {
  const auto told = [&](const Words& words) { return remark(words.in(language)); };
  const Result reaction = remark("$\\it{N}$ = $m_{a}g$, $u$ = $f_{v}\\it{R}$, $\\it{J}$ = $m_{a}\\it{R}^{2}$/4.");
  if (regime == Regime::at_rest)
    return {told(
        {"Nothing moves: $\\it{F}$ = $\\it{T}$ = $m_{b}g$, and $\\it{N}$ = $m_{a}g$ stands where the moments "
         "about $C$ balance.",
         "Nulla si muove: $\\it{F}$ = $\\it{T}$ = $m_{b}g$, e $\\it{N}$ = $m_{a}g$ sta dove i momenti intorno a $C$ "
         "si equilibrano."})};
  if (regime == Regime::rolling)
    return {
        reaction,
        told({"About $C$: $\\it{T}$($\\it{R}$ − $r$) = $m_{a}a'\\it{R}$ + $\\it{J}α$ + $\\it{N}u$.",
              "Intorno a $C$: $\\it{T}$($\\it{R}$ − $r$) = $m_{a}a'\\it{R}$ + $\\it{J}α$ + $\\it{N}u$."}),
        told({"It rolls: $α$ = $a'$/$\\it{R}$, $a$ = $ka'$, $k$ = ($\\it{R}$ − $r$)/$\\it{R}$. With $\\it{T}$ of the "
              "counterweight:",
              "Rotola: $α$ = $a'$/$\\it{R}$, $a$ = $ka'$, $k$ = ($\\it{R}$ − $r$)/$\\it{R}$. Con il $\\it{T}$ del "
              "contrappeso:"}),
        remark("$a'$ = $g$($km_{b}$ − $f_{v}m_{a}$)/(5$m_{a}$/4 + $k^{2}m_{b}$).")};
  const Spool of = spool(s.givens());
  const Rational offset = of.offset_while_slipping(s.givens()["m_b"]), most = of.f_v * of.R;
  const Words along{"It slips, $\\it{F}$ = $f_{r}\\it{N}$. Level: $m_{a}a'$ = $\\it{T}$ − $\\it{F}$.",
                    "Striscia, $\\it{F}$ = $f_{r}\\it{N}$. In orizzontale: $m_{a}a'$ = $\\it{T}$ − $\\it{F}$."};
  if (CGAL::abs(offset) != most)
    return {reaction, told(along),
            told({"The rolling friction keeps it from turning: $α$ = 0, $a$ = $a'$.",
                  "L'attrito volvente le impedisce di girare: $α$ = 0, $a$ = $a'$."})};
  const std::string sign = offset == most ? " − " : " + ";
  const std::string turning = "$\\it{J}α$ = $\\it{FR}$ − $\\it{T}r$" + sign + "$\\it{N}u$";
  return {reaction, told(along),
          told(Words{"About $G$: ", "Intorno a $G$: "} + Words{turning, turning} +
               Words{". The rope: $a$ = $a'$ − $rα$.", ". La fune: $a$ = $a'$ − $rα$."}),
          told({"With $\\it{T}$ of the counterweight these give $a'$, $α$ and $a$.",
                "Con il $\\it{T}$ del contrappeso danno $a'$, $α$ e $a$."})};
}

// The counterweight cut free: its weight, the rope and, against its acceleration, its inertia, all in one line.
FreeBodyPanel counterweight(const Solution& s) {
  constexpr double one_to_ten = 100;  // mm a metre
  const double side = 0.35 * given(s, "R");
  Mechanism drawn;
  const std::array<Place, 4> corners{{{-side, 0}, {-side, -2 * side}, {side, -2 * side}, {side, 0}}};
  for (std::size_t i = 0; i < corners.size(); ++i)
    drawn.point("b" + std::to_string(i + 1), corners[i], Joint::corner, "");
  drawn.point("rope", {0, 0}, Joint::none, "").point("b", {0, -side}, Joint::mass, "$m_{b}$");
  drawn.body({"b1", "b2", "b3", "b4"});
  FreeBodyPanel body(std::make_shared<const Mechanism>(std::move(drawn)));
  body.at_most(one_to_ten)
      .force({.label = "$m_{b}\\vec{g}$", .v = {0, -s["weight_b"]}}, {0, -side})
      .force({.label = "−$m_{b}\\vec{a}$", .v = {0, s["a"]}}, {0, -side})
      .force({.label = "$\\vec{\\it{T}}$", .v = {0, s["T"]}}, {0, 0});
  body.step(Words{"The counterweight cut free: ", "Il contrappeso isolato: "} + rope_pull(s) + Words{".", "."},
            {0, -side});
  return body;
}

// The three forces on the spool that meet in H, where that is too near the plane for the spool's own scale.
std::optional<FreeBodyPanel> contact_enlarged(const Solution& s, const Forces& on) {
  constexpr double near = 0.1;  // of R
  const Place foot = s.place("foot");
  const auto height = s.value("resultant_height");
  const double most = near * given(s, "R");
  if (!height || foot.x == 0 || std::abs(*height) > most || std::abs(foot.x) > most) return {};
  const Place H{0, *height};
  const double half = 2 * std::max(std::abs(foot.x), std::abs(*height));
  Mechanism drawn;
  drawn.point("C", {0, 0}, Joint::none, "$C$")
      .point("left", {-half, 0}, Joint::corner, "")
      .point("right", {half, 0}, Joint::corner, "")
      .body({"left", "right"});
  FreeBodyPanel detail(std::make_shared<const Mechanism>(std::move(drawn)));
  detail.force({.label = "$\\vec{\\it{T}}$ + $\\vec{\\it{F}}_{i}$", .v = on.T.v + on.inertia.v}, H)
      .force(on.W, H, FreeBodyPanel::Arrow::ends)
      .force(on.S, foot, FreeBodyPanel::Arrow::ends)
      .arm({0, 0}, foot, {0, 1}, "$u$", "", foot.x > 0 ? -6 : 6)
      .arm({-half, 0}, H, {1, 0}, "$h_{r}$", "")
      .meeting("", "$\\it{H}$", H)
      .step(meets, H);
  return detail;
}

PanelSheet forces_sheet(const Solution& s, Language language) {
  const Forces on = forces(s, "", language);
  const Regime regime = spool(s.givens()).regime(s.givens()["m_b"]);
  const Place G = s.place("G"), A = s.place("A"), foot = s.place("foot");
  const bool rolls = regime == Regime::rolling;
  const Place line{0, rolls ? s["inertia_force_height"] : G.y};
  FreeBodyPanel body(std::make_shared<const Mechanism>(spool_of(s)));
  body.force(on.W, G).force(on.T, A);
  if (on.inertia.is_drawn()) body.force(on.inertia, line);
  body.force(on.S, foot, FreeBodyPanel::Arrow::ends);
  if (regime == Regime::slipping) body.couple("−$\\it{J}α$", G, -s["alpha"]);
  const auto height = s.value("resultant_height");
  const std::optional<FreeBodyPanel> contact = contact_enlarged(s, on);
  const double beside = 1.25 * G.y;  // clear of the spool
  if (rolls && on.inertia.is_drawn()) body.arm({-beside, 0}, line, {1, 0}, "$h_{i}$", "");
  const Words pressed{
      "The spool. The reaction $\\it{S}$ of the plane, whose upright part is $\\it{N}$, starts $u$ ahead of the "
      "foot of $G$.",
      "La bobina. La reazione $\\it{S}$ del piano, di cui $\\it{N}$ è la parte verticale, è spostata di $u$ oltre "
      "il piede di $G$."};
  const Words single{
      "The force of inertia and its couple are one force, in the line at $h_{i}$ above the plane.",
      "La forza d'inerzia e la sua coppia sono una sola forza, sulla retta ad altezza $h_{i}$ dal piano."};
  body.step(pressed, foot);
  if (rolls) body.step(single, line);
  if (height && !contact)
    body.meeting("", "$\\it{H}$", Place{0, *height})
        .arm({beside, 0}, {0, *height}, {1, 0}, "$h_{r}$", "")
        .step(meets, Place{0, *height});
  const Words verdict =
      Words{"With this counterweight ", "Con questo contrappeso "} + name_of(regime) + Words{".", "."};
  const Words not_to_scale{"On the bodies the arrows show directions, in the polygon sizes too.",
                           "Sui corpi le frecce danno le direzioni, nel poligono anche le intensità."};
  Panels all = panels(counterweight(s), body);
  if (contact) all.push_back(std::make_unique<FreeBodyPanel>(*contact));
  all.push_back(std::make_unique<PolygonPanel>(s, force_polygon("a", {on.S}, {on.W, on.T, on.inertia})));
  return {.panels = std::move(all),
          .theory = {{{"How $a$ follows", "Come segue $a$"}, how_it_moves(s, regime, language)}},
          .results = {remark(verdict.in(language)), values({"J", "u"}), values({"a", "a_G", "alpha"}),
                      values({"T", "inertia_force", "inertia_couple"}), values({"N", "F"}),
                      values({"ground_reaction", "ground_reaction_inclination"}),
                      values({"inertia_force_height", "resultant_height"}), remark(not_to_scale.in(language))},
          .seen = {"Counterweight and spool cut free, and the polygon of the spool's forces",
                   "Il contrappeso e la bobina isolati, e il poligono delle forze della bobina"},
          .told = {"a", "a_G", "T", "F", "N"},
          .without_part = {"m_b_heavy", "m_b_light"}};
}

// The polygon of one counterweight, with the cone of friction about the vertical where the reaction starts.
ChainedPolygonsPanel with_cone(const Solution& s, const std::string& prefix, const std::string& letter,
                               const Words& caption, const Words& told, bool is_first, Language language) {
  const Forces on = forces(s, prefix, language);
  const Arrow2 apex = on.W.v + on.T.v + on.inertia.v;
  const double N = s["N"], wide = std::min(s["F_max"], 0.7 * N);
  ChainedPolygonsPanel panel(force_polygon(letter, {on.S}, {on.W, on.T, on.inertia}));
  panel.over({apex + Arrow2{-wide, wide == 0 ? N : wide * N / s["F_max"]}, apex,
              apex + Arrow2{wide, wide == 0 ? N : wide * N / s["F_max"]}});
  panel.captioned(caption);
  panel.angle(apex, std::numbers::pi / 2, std::numbers::pi / 2 + s["friction_cone_half_angle"], "$φ_{a}$");
  if (is_first)
    panel.step(told, apex);
  else
    panel.likewise(told, apex);
  return panel;
}

PanelSheet cones_sheet(const Solution& s, Language language) {
  const Spool of = spool(s.givens());
  // "$m_{b,l}$: it stays at rest"
  const auto so = [&](const std::string& symbol, const std::string& letters) {
    return Words{letters, letters} + Words{": ", ": "} + name_of(of.regime(s.givens()[symbol]));
  };
  const Words light = so("m_b_light", "$m_{b,l}$"), middle = so("m_b", "$m_{b}$"),
              heavy = so("m_b_heavy", "$m_{b,h}$"),
              if_rolling{"$m_{b,h}$, as if it rolled", "$m_{b,h}$, come se rotolasse"}, stop{".", "."};
  const Words cone{
      "Dashed, the cone of friction about the vertical, with the half angle $φ_{a}$ = arctan $f_{a}$. ",
      "Tratteggiato, il cono d'attrito attorno alla verticale, di semiapertura $φ_{a}$ = arctan $f_{a}$. "};
  const Words main_slips{
      "$m_{b}$: it slips with $\\it{F}$ = $f_{r}\\it{N}$; not to slip it would take $\\it{F}^{*}$, outside of the "
      "cone.",
      "$m_{b}$: striscia con $\\it{F}$ = $f_{r}\\it{N}$; per non strisciare occorrerebbe $\\it{F}^{*}$, fuori dal "
      "cono."};
  const Words main = cone + (of.regime(s.givens()["m_b"]) == Regime::slipping ? main_slips : middle + stop);
  const bool slips = of.regime(s.givens()["m_b_heavy"]) == Regime::slipping;
  const Words tried =
      if_rolling + (slips ? Words{": the reaction leaves the cone, and this polygon cannot be.",
                                  ": la reazione esce dal cono, e questo poligono non può essere."}
                          : Words{": the reaction stays in the cone.", ": la reazione resta nel cono."});
  const Words instead =
      slips ? Words{"It slips: $\\it{F}$ = $f_{r}\\it{N}$, and another pull and inertia close the polygon.",
                    "Striscia: $\\it{F}$ = $f_{r}\\it{N}$, e altro tiro e altra inerzia chiudono il poligono."}
            : heavy + stop;
  const std::string tried_head = Words{"$m_{b,h}$, rolling", "$m_{b,h}$, se rotola"}.in(language);
  const Words margin{
      "$\\it{F}^{*}$ is the friction that must hold if it is not to slip; $Δ\\it{F}$ = $\\it{F}_{max}$ − "
      "$\\it{F}^{*}$ "
      "is negative where it slips. $a'$, $α$ and $a_{C}$ are those of $m_{b,h}$, $u'$ is that of $m_{b,l}$.",
      "$\\it{F}^{*}$ è l'attrito che occorre perché non strisci; $Δ\\it{F}$ = $\\it{F}_{max}$ − $\\it{F}^{*}$ è "
      "negativo dove striscia. $a'$, $α$ e $a_{C}$ sono di $m_{b,h}$, $u'$ di $m_{b,l}$."};
  return {.panels = panels(MechanismPanel(std::make_shared<const Mechanism>(whole(s, "$C$"))),
                           with_cone(s, "", "m", middle, main, true, language),
                           with_cone(s, "light.", "l", light, light + stop, false, language),
                           with_cone(s, "heavy_if_rolling.", "t", if_rolling, tried, false, language),
                           with_cone(s, "heavy.", "h", heavy, instead, false, language)),
          .results = {values({"F_max", "friction_cone_half_angle"}),
                      table({"", "$\\it{T}$ (N)", "$\\it{F}$ (N)"},
                            {{"$m_{b,l}$", {"light.T", "light.F"}},
                             {"$m_{b}$", {"T", "F"}},
                             {tried_head, {"heavy_if_rolling.T", "heavy_if_rolling.F"}},
                             {"$m_{b,h}$", {"heavy.T", "heavy.F"}}}),
                      table({"", "$\\it{F}^{*}$ (N)", "$Δ\\it{F}$ (N)"},
                            {{"$m_{b}$", {"F_required", "slip_margin"}},
                             {"$m_{b,h}$", {"heavy_if_rolling.F", "heavy_if_rolling.slip_margin"}}}),
                      values({"heavy.a_G", "heavy.alpha"}), values({"heavy.slip_acceleration", "light.u_required"}),
                      remark(margin.in(language))},
          .seen = {"The spool with its counterweight, and its force polygons with the friction cone for a light, a "
                   "middle and a heavy counterweight",
                   "La bobina con il contrappeso, e i suoi poligoni delle forze con il cono d'attrito per un "
                   "contrappeso leggero, uno medio e uno pesante"},
          .told = {"light.F", "F", "F_required", "heavy_if_rolling.F", "heavy.F", "F_max"}};
}

// F/N over m_b/m_a: what must hold, and what holds; or as a detail the start of it, where it lies near the axis.
struct Shown {
  double far;
  bool is_detail, marks_light;
};
drawings::Chart chart(const Solution& s, const Shown& shown, Language language) {
  const double k = s["rope_to_centre_velocity_ratio"], f_a = given(s, "f_a"), f_r = given(s, "f_r"),
               f_v = given(s, "f_v"), m_a = given(s, "m_a"), start = s["mass_ratio_start"];
  const auto slip = s.value("mass_ratio_slip");
  const auto needed = [&](double mu) {
    return mu <= start ? mu : (mu * (1.25 - k + f_v * k) + f_v) / (1.25 + k * k * mu);
  };
  const double heavy = given(s, "m_b_heavy") / m_a, middle = given(s, "m_b") / m_a,
               light = given(s, "m_b_light") / m_a, far = shown.far;
  const std::string of_detail = shown.is_detail ? "detail-" : "";
  const double edge = slip ? *slip : needed(far) > f_a ? f_a : far;
  const auto run = [&](double from, double to, const auto& y) {
    constexpr int pieces = 200;
    std::vector<drawings::Datum> points;
    for (int i = 0; i <= pieces; ++i) {
      const double x = from + (to - from) * i / pieces;
      points.push_back({x, y(x)});
    }
    return points;
  };
  const double rest_end = std::min(start, edge);
  std::vector<drawings::Curve> curves{
      {.name = of_detail + "rest",
       .runs = {run(0, rest_end, needed)},
       .meaning = Meaning::locus,
       .label = shown.is_detail ? Words{"at rest", "in quiete"}.in(language) : std::string()}};
  if (edge > rest_end)
    curves.push_back({.name = of_detail + "rolling",
                      .runs = {run(rest_end, edge, needed)},
                      .meaning = Meaning::force,
                      .line = drawings::LineType::continuous,
                      .label = Words{"rolling", "rotolamento"}.in(language)});
  if (edge < far) {
    curves.push_back({.name = "trial",
                      .runs = {run(edge, far, needed)},
                      .meaning = Meaning::force,
                      .line = drawings::LineType::dashed,
                      .label = Words{"if it rolled", "se rotolasse"}.in(language)});
    curves.push_back({.name = "slipping",
                      .runs = {{{edge, f_r}, {far, f_r}}},
                      .meaning = Meaning::force,
                      .label = Words{"slipping, $f_{r}$", "strisciamento, $f_{r}$"}.in(language)});
  }
  const double high =
      1.2 * (shown.is_detail ? needed(far)
                             : std::max({needed(far), std::min(f_a, 2 * needed(far)), edge < far ? f_r : 0.0}));
  drawings::Chart of{.x = {.quantity = "$m_{b}$/$m_{a}$", .low = 0, .high = far},
                     .y = {.quantity = "$\\it{F}$/$\\it{N}$", .low = 0, .high = high > 0 ? high : 1},
                     .curves = curves,
                     .horizontals = {{.at = f_a, .label = "$f_{a}$"}}};
  if (slip) of.verticals.push_back({.at = *slip, .label = "$μ_{s}$"});
  if (start > 0) of.verticals.push_back({.at = start, .label = "$μ_{p}$"});
  const auto mark = [&](double at, double must_hold, const std::string& letters) {
    if (at > far) return;
    of.markers.push_back({.at = {at, must_hold}, .label = letters, .meaning = Meaning::force});
    if (must_hold > f_a) of.markers.push_back({.at = {at, f_r}, .label = letters, .meaning = Meaning::force});
  };
  if (shown.marks_light) mark(light, needed(light), "$m_{b,l}$");
  mark(middle, s["F_over_N"], "$m_{b}$");
  mark(heavy, s["heavy_if_rolling.F_over_N"], "$m_{b,h}$");
  return of;
}

// Where the start of rolling is too near the axis to be seen, a detail shows it: as far as this.
std::optional<double> end_of_detail(const Solution& s, double far) {
  constexpr double too_near = 0.1;  // of the chart's width
  const double near = 3 * s["mass_ratio_start"];
  if (near == 0 || near > too_near * far || spool(s.givens()).slips_from_rest()) return {};
  return near;
}
double end_of_chart(const Solution& s) {
  const double m_a = given(s, "m_a"),
               of_masses = std::max({given(s, "m_b_heavy"), given(s, "m_b"), given(s, "m_b_light")}),
               far = 1.15 *
                     std::max({of_masses / m_a, s.value("mass_ratio_slip").value_or(0), 2 * s["mass_ratio_start"]});
  return far == 0 ? 1 : far;
}

Panels charts(const Solution& s, const std::vector<ChartPanel::Read>& read, Language language) {
  const double far = end_of_chart(s), light = given(s, "m_b_light") / given(s, "m_a");
  const auto near = end_of_detail(s, far);
  if (!near) return panels(ChartPanel(chart(s, {far, false, true}, language), read));
  return panels(ChartPanel(chart(s, {far, false, light > *near}, language), read),
                ChartPanel(chart(s, {*near, true, light <= *near}, language)));
}

PanelSheet limits_sheet(const Solution& s, Language language) {
  std::vector<ChartPanel::Read> read{
      {{given(s, "m_b") / given(s, "m_a"), s["F_over_N"]}, {}, "F_over_N"},
      {{given(s, "m_b_heavy") / given(s, "m_a"), s["heavy_if_rolling.F_over_N"]}, {}, "heavy_if_rolling.F_over_N"},
      {{s["mass_ratio_start"], 0}, "mass_ratio_start", {}}};
  if (const auto slip = s.value("mass_ratio_slip")) read.push_back({{*slip, 0}, "mass_ratio_slip", {}});
  const Words rest{
      "At rest $\\it{F}$ = $\\it{T}$ = $m_{b}g$, until the offset of $\\it{N}$ has come to $u$: at $μ_{p}$ = "
      "$f_{v}\\it{R}$/($\\it{R}$ − $r$) it begins to roll.",
      "In quiete $\\it{F}$ = $\\it{T}$ = $m_{b}g$, finché lo spostamento di $\\it{N}$ arriva a $u$: a $μ_{p}$ = "
      "$f_{v}\\it{R}$/($\\it{R}$ − $r$) comincia a rotolare."};
  const Words rolls{
      "Rolling, with $μ$ = $m_{b}$/$m_{a}$ and 5/4 = 1 + $\\it{J}$/$m_{a}\\it{R}^{2}$: $\\it{F}$/$\\it{N}$ = "
      "($μ$(5/4 − $k$ + $f_{v}k$) + $f_{v}$)/(5/4 + "
      "$k^{2}μ$), which comes to $f_{a}$ at $μ_{s}$.",
      "Nel rotolamento, con $μ$ = $m_{b}$/$m_{a}$ e 5/4 = 1 + $\\it{J}$/$m_{a}\\it{R}^{2}$: $\\it{F}$/$\\it{N}$ = "
      "($μ$(5/4 − $k$ + $f_{v}k$) + $f_{v}$)/(5/4 "
      "+ $k^{2}μ$), che arriva a $f_{a}$ per $μ_{s}$."};
  const Words never{"It rolls however heavy the counterweight.", "Rotola per quanto pesi il contrappeso."};
  const Words before{"$\\it{F}$/$\\it{N}$ comes to $f_{a}$ at rest: it slips before it can roll.",
                     "$\\it{F}$/$\\it{N}$ arriva a $f_{a}$ in quiete: striscia prima di poter rotolare."};
  const Words below{"Below, enlarged: how it begins to roll.", "Sotto, ingrandito: come comincia a rotolare."};
  const Words required{"$\\it{F}^{*}$: the friction that must hold if it is not to slip.",
                       "$\\it{F}^{*}$: l'attrito che occorre perché non strisci."};
  const Spool of = spool(s.givens());
  const std::string exception = of.slips_from_rest() ? before.in(language)
                                : of.always_rolls()  ? never.in(language)
                                                     : "";
  return {.panels = charts(s, read, language),
          .theory = {{{"What must hold", "Condizione di aderenza"},
                      {remark(rest.in(language)), remark(rolls.in(language)), remark(exception),
                       remark(end_of_detail(s, end_of_chart(s)) ? below.in(language) : "")}}},
          .results = {values({"mass_ratio_start", "m_b_start"}), values({"mass_ratio_slip", "m_b_slip"}),
                      remark(required.in(language)),
                      table({"", "$\\it{F}^{*}$/$\\it{N}$"},
                            {{"$m_{b}$", {"F_over_N"}}, {"$m_{b,h}$", {"heavy_if_rolling.F_over_N"}}})},
          .seen = {"The friction that must hold over the normal reaction, against the ratio of the masses",
                   "L'attrito che occorre, diviso per la reazione normale, in funzione del rapporto delle masse"},
          .told = {"mass_ratio_start", "mass_ratio_slip", "F_over_N", "heavy_if_rolling.F_over_N"}};
}

}  // namespace
}  // namespace spool_slip

std::unique_ptr<Exercise> make_spool_slip() {
  using namespace spool_slip;
  Description about{
      .id = "spool-slip",
      .title = {"A spool drawn by a counterweight", "Una bobina trascinata da un contrappeso"},
      .document = "macchine",
      .item = "Verifica allo slittamento",
      .source = {"Machines, check against slipping", "Macchine, verifica allo slittamento"},
      .question = {"A counterweight pulls a spool by a rope wound on its core. Find the acceleration with which the "
                   "counterweight falls, and whether the spool stays, rolls or slips.",
                   "Un contrappeso tira una bobina con una fune avvolta sul nucleo. Trovare l'accelerazione con cui "
                   "il contrappeso scende, e se la bobina sta ferma, rotola o striscia."},
      .givens = stated_givens(),
      .printed = {}};
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(Routes{spool(givens), givens["m_b"], givens["m_b_heavy"], givens["m_b_light"]}, rung);
  };
  return exercise_of_panels(std::move(about), solve,
                            {{{"velocities",
                               {"Velocities about the contact", "Velocità attorno al contatto"},
                               {"A counterweight pulls a spool by a rope wound on its core. Find the velocities of "
                                "the spool when it rolls, about its contact with the ground.",
                                "Un contrappeso tira una bobina con una fune avvolta sul nucleo. Trovare le velocità "
                                "della bobina quando rotola, attorno al contatto con il suolo."}},
                              velocity_sheet},
                             {{"forces",
                               {"Forces on the spool", "Forze sulla bobina"},
                               {"A counterweight pulls a spool by a rope wound on its core. Find the forces on the "
                                "spool and the acceleration with which the counterweight falls.",
                                "Un contrappeso tira una bobina con una fune avvolta sul nucleo. Trovare le forze "
                                "sulla bobina e l'accelerazione con cui il contrappeso scende."}},
                              forces_sheet},
                             {{"friction-cone",
                               {"Friction cones", "Coni d'attrito"},
                               {"A counterweight pulls a spool by a rope wound on its core. By the friction cones "
                                "find whether the spool stays, rolls or slips.",
                                "Un contrappeso tira una bobina con una fune avvolta sul nucleo. Trovare con i coni "
                                "d'attrito se la bobina sta ferma, rotola o striscia."}},
                              cones_sheet},
                             {{"limits",
                               {"At rest, rolling, slipping", "Quiete, rotolamento, strisciamento"},
                               {"A counterweight pulls a spool by a rope wound on its core. Find between which "
                                "limits the spool stays, rolls or slips.",
                                "Un contrappeso tira una bobina con una fune avvolta sul nucleo. Trovare entro quali "
                                "limiti la bobina sta ferma, rotola o striscia."}},
                              limits_sheet}});
}

}  // namespace epure
