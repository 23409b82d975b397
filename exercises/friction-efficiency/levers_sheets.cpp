#include "exercises/friction-efficiency/both_motions.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/linkages/shared_out.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {

PanelSheet levers(const Solution& s, const std::string& name, int loaded_lever, Language language) {
  const LeverFigure at(s, name, loaded_lever);
  const Case& of = at.of;
  const double nu = of.radians("nu");
  const std::string j = std::to_string(at.loaded), i = std::to_string(at.driven);
  const auto H = [](int lever, const std::string& suffix) {
    return "$H" + below_prime(std::to_string(lever), suffix) + "$";
  };
  const auto hinge_line = [&](int lever, const std::string& suffix) {
    if (of.point("H_" + std::to_string(lever) + suffix)) return "∥ " + at.letters(lever) + H(lever, suffix);
    return at.along(lever == at.loaded ? "Q" : "P", language);  // parallel forces
  };
  const std::string other_H = H(2, retrograde), other_H_3 = H(3, retrograde);
  const auto chained = [&](const std::string& suffix) {
    return Chain{j,
                 i,
                 force_between(at.driven, at.loaded),
                 force_between(1, at.loaded),
                 force_between(1, at.driven),
                 at.loaded,
                 at.along("Q", language),
                 turned_from("$n$", language),
                 hinge_line(at.loaded, suffix),
                 hinge_line(at.driven, suffix),
                 at.along("P", language),
                 other_lines(other_H + " and " + other_H_3, other_H + " e " + other_H_3)};
  };
  const Chain chain = chained(direct);
  const PolygonSide contact = of.known(moving(chain.contact, direct), "", "");
  const Sides on = sides(of, chain, direct), back = sides(of, chained(retrograde), retrograde);
  // Where the lines of a body's forces do not meet on the sheet: in the direct motion, or in the retrograde one,
  // unless that needs no effort, or is the same without friction.
  const auto shared_out = [&](int lever, const std::string& suffix, const Sides& by) -> std::optional<SharedOut> {
    const auto H_of = of.point("H_" + std::to_string(lever) + suffix);
    const bool is_same = suffix == retrograde && is_zero(s.givens().angle("phi"));
    if (is_same || magnitude(by.P.v) == 0 || !is_out_of_reach(H_of, at.C, at.hinge(lever), at.attacked(lever)))
      return {};
    SharedOut shared = lever == at.loaded
                           ? SharedOut(by.Q, at.attacked(lever), by.contact, at.C, by.on_loaded, at.hinge(lever))
                           : SharedOut(by.back, at.C, by.P, at.attacked(lever), by.on_driven, at.hinge(lever));
    return suffix == retrograde ? shared.otherwise() : shared;
  };
  const auto shared_j = shared_out(at.loaded, direct, on), shared_i = shared_out(at.driven, direct, on),
             other_j = shared_out(at.loaded, retrograde, back), other_i = shared_out(at.driven, retrograde, back);
  // Where the others' lines meet on the sheet, to which the line of the hinge's force leads.
  const auto meets = [&](int lever) -> std::optional<Place> {
    if (lever == at.loaded ? shared_j : shared_i) return {};
    return of.point("H_" + std::to_string(lever) + direct);
  };
  const auto met = [&](int lever) -> Words {
    const std::string& known = lever == at.loaded ? on.Q.label : on.P.label;
    return Words{known + " at ", known + " in "} + H(lever, direct);
  };
  const Words through_C{"Through $C$ the line $φ$ from $n$ meets ", "Per $C$ la retta $φ$ da $n$ incontra "};
  const auto body = [&](int lever) {
    const bool is_loaded = lever == at.loaded;
    Mechanism drawn;
    at.add(drawn, lever, Joint::hinge);
    drawn.point("C", at.C, Joint::none, "$C$");
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(drawn)));
    const std::string k = std::to_string(lever);
    panel.to_scale();
    if (is_loaded)
      panel.load(of.load("Q", "", ""), at.attacked(lever));
    else
      panel.effort(of.known(P_of(direct), "", ""), at.attacked(lever));
    const Arrow2 v = of.vector("sliding");  // of the loaded lever on the other
    press(panel, of, is_loaded ? contact : reversed(contact, at.loaded, at.driven), at.C, nu, is_loaded ? v : -v,
          is_loaded ? j + i : i + j, "$n$");
    panel.force(of.known(moving(force_between(1, lever), direct), "", ""), at.hinge(lever), Arrow::ends_at_hinge);
    if (const auto& shared = is_loaded ? shared_j : shared_i)
      shared->draw_strings(panel);
    else
      panel.meeting(of.name("H_" + k + direct), H(lever, direct), of.point("H_" + k + direct));
    panel.otherwise(of.name("H_" + k + retrograde), H(lever, retrograde), of.point("H_" + k + retrograde),
                    {{at.attacked(lever), of.vector(is_loaded ? "Q" : "P_ideal")},
                     {at.C, of.vector(chain.contact.name + retrograde)},
                     {at.hinge(lever), of.vector("R_1" + k + retrograde)}});
    if (const auto& other = is_loaded ? other_j : other_i) other->draw_strings(panel);
    return panel;
  };
  FreeBodyPanel first = body(at.loaded);
  first.step(turned_against, at.C);
  FreeBodyPanel second = body(at.driven);
  const auto H_of_loaded = meets(at.loaded), H_of_driven = meets(at.driven);
  if (H_of_loaded)
    first.step(through_C + met(at.loaded) + (H_of_driven ? Words{" and ", " e "} + met(at.driven) : Words{}) + ".",
               *H_of_loaded);
  else if (H_of_driven)
    second.step(through_C + met(at.driven) + ".", *H_of_driven);
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"contact_force_angle_direct_deg", "contact_force_angle_retrograde_deg"}));
  results.push_back(
      remark(Words{"$ν_{D}$, $ν_{R}$: directions of ", "$ν_{D}$, $ν_{R}$: direzioni della "}.in(language) +
             on.contact.label + Words{" in the two motions.", " nei due moti."}.in(language)));
  results.push_back(of.results({"self_locking_friction_angle_deg"}));
  if (of.s.value(of.name("self_locking_friction_angle_deg"))) results.push_back(remark(locks_from.in(language)));
  Panels all = panels(levers_with_givens(at, of.load("Q", "", ""), of.known(P_of(direct), "", "")), first, second);
  const auto add_motion = [&](const std::string& suffix, const Sides& by, const std::optional<SharedOut>& of_loaded,
                              const std::optional<SharedOut>& of_driven) {
    const Chain in_motion = chained(suffix);
    if (!of_loaded && !of_driven) {
      all.push_back(std::make_unique<ChainedPolygonsPanel>(polygons(of, in_motion, suffix)));
      return;
    }
    VectorPolygon first_polygon = by.first(in_motion);
    first_polygon.origin = origin(in_motion.loaded, suffix);
    add_polygons(all, first_polygon, by.second(in_motion), by.Q.v + by.contact.v, {&of_loaded, &of_driven},
                 {"−" + by.Q.label, by.contact.label});
  };
  add_motion(direct, on, shared_j, shared_i);
  add_motion(retrograde, back, other_j, other_i);
  return {
      .panels = std::move(all),
      .results = results,
      .seen = {"The two levers, each cut free with the friction cone of their contact, and the polygons of the "
               "direct and of the retrograde motion",
               "Le due leve, ciascuna isolata con il cono d'attrito del contatto, e i poligoni del moto diretto e "
               "del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({"r_2", "r_3"}, {"phi"})};
}

}  // namespace epure::friction_efficiency
