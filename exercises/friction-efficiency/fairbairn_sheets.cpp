#include "exercises/friction-efficiency/both_motions.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/linkages/shared_out.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {

PanelSheet fairbairn(const Solution& s, const std::string& name, Language language) {
  const Case of(s, name);
  const Place A = of.place("A"), B = of.place("B"), C = of.place("C"), D = of.place("D");
  const auto shared_out = [&](const std::string& suffix) -> std::optional<SharedOut> {
    const bool is_same = suffix == retrograde && is_zero(s.givens().angle("phi"));
    if (is_same || !is_out_of_reach(of.point("H" + suffix), B, C, D)) return {};
    const auto known = [&](int i, int j) { return of.known(moving(force_between(i, j), suffix), "", ""); };
    SharedOut shared(passed_on(known(5, 6), force_between(5, 6), 5, 4, suffix), D, known(3, 4), B, known(1, 4), C);
    return suffix == retrograde ? shared.otherwise() : shared;
  };
  const auto shared = shared_out(direct), other = shared_out(retrograde);
  const auto polygon = [&](const std::string& suffix) {
    const std::string H = of.point("H" + suffix) ? "∥ $CH" + prime(suffix) + "$" : turned_from("$x$", language);
    const PolygonSide F = of.load("F", "∥ $x$", "$a$"),
                      R_56 = of.sought(moving(force_between(5, 6), suffix), turned_from("$x$", language), "$b$"),
                      R_16 = of.sought(moving(force_between(1, 6), suffix), turned_from("⊥ $x$", language)),
                      R_54 = passed_on(R_56, force_between(5, 6), 5, 4, suffix, "$a$"),
                      R_34 = of.sought(moving(force_between(3, 4), suffix), turned_from("⊥ $CD$", language), "$c$"),
                      R_14 = of.sought(moving(force_between(1, 4), suffix), H);
    VectorPolygon of_ram = force_polygon("6", {R_16}, {F, R_56});
    of_ram.origin = origin("6", suffix);
    ChainedPolygonsPanel panel(std::move(of_ram));
    panel.captioned(name_of(motion_of(suffix)));
    VectorPolygon second = force_polygon("4", {R_14}, {R_54, R_34});
    second.origin = "$b$";
    if (!(suffix == direct ? shared : other)) panel.then(second, F.v + R_56.v);
    const Arrow2 ideal = of.vector("R_34_ideal"), b = F.v + of.vector("R_56_ideal");
    panel.over({b, b + F.v, b + F.v + ideal, b});
    if (suffix == retrograde) panel.likewise(other_lines("$H'$ and $d'$", "$H'$ e $d'$"), F.v);
    return panel;
  };
  FreeBodyPanel on_6 = ram_cut_free(of), on_4 = lever_cut_free(of), on_2 = crank_cut_free(of);
  const PolygonSide R_34 = of.known(moving(force_between(3, 4), direct), "", ""),
                    R_56 = of.known(moving(force_between(5, 6), direct), "", ""), R_54 = reversed(R_56, 5, 4),
                    R_32 = reversed(R_34, 3, 2);
  on_6.to_scale().at_most(50).load(of.load("F", "", ""), end_of_ram(of));
  press(on_6, of, R_56, D, 0, -of.vector("v_56"), "65");
  press(on_6, of, of.known(moving(force_between(1, 6), direct), "", ""), D, std::numbers::pi / 2, of.vector("v_61"),
        "61", "⊥ $x$");
  on_6.step(turned_against, D);
  on_4.to_scale().at_most(50).force(of.known(moving(force_between(1, 4), direct), "", ""), C, Arrow::ends);
  press(on_4, of, R_34, B, -of.radians("theta"), of.vector("v_43"), "43");
  on_4.force(R_54, D, Arrow::ends);  // its friction is on the ram
  if (shared)
    shared->draw_strings(on_4);
  else
    on_4.meeting(of.name("H_direct"), "$H$", of.point("H_direct")).step(meet_in_H, *of.point("H_direct"));
  const Arrow2 other_R_34 = of.vector("R_34" + retrograde);
  on_4.otherwise(of.name("H" + retrograde), "$H'$", of.point("H" + retrograde),
                 {{B, other_R_34}, {D, of.vector("R_56" + retrograde)}, {C, of.vector("R_14" + retrograde)}});
  if (other) other->draw_strings(on_4);
  on_2.to_scale().larger().at_most(200).force(R_32, B).force(reaction(R_32, "$\\vec{\\it{R}}_{12}$", ""), A);
  on_2.couple("$\\it{M}$", A, of["M_direct"]).arm(A, B, R_32.v, "$d$", of.name("d_direct"));
  on_2.otherwise("", "", {}, {{B, other_R_34}}).arm(A, B, other_R_34, "$d'$", of.name("d_retrograde"));
  on_2.moments({"$\\it{M}$ = $\\it{R}_{32}$·$d$.", "$\\it{M}$ = $\\it{R}_{32}$·$d$."}, A);
  FreeBodyPanel all(fairbairn_figure(of));
  all.at_most(100);
  std::vector<Result> results = efficiencies(of, "M", language);
  results.push_back(of.results({"F_23_direct", "d_direct"}));
  results.push_back(of.results({"F_23_retrograde", "d_retrograde"}));
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  if (of.s.value(of.name("self_locking_friction_angle_deg")))
    results.push_back(remark(locks_from_and_jams.in(language)));
  Panels shown = panels(all, on_6, on_4, polygon(direct));
  if (shared)
    shown.push_back(std::make_unique<SharedLoadPanel>(shared->polygon(moving(force_between(5, 6), direct).arrow())));
  shown.push_back(std::make_unique<FreeBodyPanel>(on_2));
  shown.push_back(std::make_unique<ChainedPolygonsPanel>(polygon(retrograde)));
  if (other)
    shown.push_back(
        std::make_unique<SharedLoadPanel>(other->polygon(moving(force_between(5, 6), retrograde).arrow())));
  return {
      .panels = std::move(shown),
      .results = results,
      .seen =
          {"Fairbairn's mechanism, its ram, lever and crank cut free, and the polygons of ram and lever in the "
           "direct and in the retrograde motion",
           "La guida di Fairbairn, slitta, leva e manovella isolate, e i poligoni di slitta e leva nel moto diretto "
           "e nel retrogrado"},
      .told = of.names({"M_direct", "M_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({}, {"phi"})};
}

}  // namespace epure::friction_efficiency
