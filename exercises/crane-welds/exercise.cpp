// Exercise 3 of Pisa's machine design: the welds between web and flanges of the boat crane's beam.
#include "exercises/crane-welds/printed.h"
#include "exercises/crane-welds/routes.h"
#include "exercises/crane-welds/sphere_panel.h"
#include "exercises/crane-welds/throat_panel.h"
#include "exercises/kit/crane/section_diagrams.h"
#include "exercises/kit/panels/beam_panel.h"
#include "exercises/kit/panels/mohr_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace crane_welds {
namespace {

constexpr double mega = 1e6;
const std::set<std::string> of_the_crane_alone{"H_0", "s_2", "H_2", "b_2", "sigma_S", "Delta_sigma_L", "Psi", "E"};

std::set<std::string> without(std::set<std::string> others) {
  others.insert(of_the_crane_alone.begin(), of_the_crane_alone.end());
  return others;
}

double metres(const Solution& s, const std::string& given) { return CGAL::to_double(s.givens()[given]) / 1000; }

// The force of the upper flange along the beam: its rise is the shear flow.
BeamPanel flange_along_beam(const Solution& s) {
  const double L = CGAL::to_double(s.givens()["L"]), pull = s["flange_pull"];
  const Place middle{1.5 * L, -1};
  const BeamDiagram beam{.letters = {{"$B$", {0, 0}, middle}, {"$C$", {L, 0}, middle}, {"$D$", {3 * L, 0}, middle}},
                         .loads = {{"$\\it{R}_{B}$", 0, -1}, {"$\\it{Y}_{A}$", L, 1}, {"$\\it{P}$", 3 * L, -1}},
                         .is_beam = true};
  const BeamDiagram flange{
      .of_vectors = true,
      .name = "$\\it{F}$",
      .runs = {{.points = {{0, 0}, {L, pull}, {3 * L, 0}}, .meaning = Meaning::force, .is_area = true}},
      .ordinates = {{"q", "$\\it{F}_{C}$", L, 0, pull, 1 / L}}};
  BeamPanel panel(3 * L, {beam, flange}, {.unit = "N", .longest = pull, .longest_on_paper = 60});
  panel.lines_at({0, L, 3 * L});
  panel.step(1, {L / 2, pull / 2},
             {"The upper flange is pulled with $\\it{F}$ = |$\\it{M}$|$\\it{S}_{f1}$/$\\it{J}_{x1}$, nought at $B$. "
              "What it gains over a unit of length the weld hands on: the shear flow $q$ = $\\it{F}_{C}$/$\\it{L}$ = "
              "|$\\it{T}_{1}$|$\\it{S}_{f1}$/$\\it{J}_{x1}$.",
              "La piattabanda superiore è tesa da $\\it{F}$ = |$\\it{M}$|$\\it{S}_{f1}$/$\\it{J}_{x1}$, nulla in "
              "$B$. Ciò che guadagna per unità di lunghezza lo trasmette la saldatura: il flusso di taglio $q$ = "
              "$\\it{F}_{C}$/$\\it{L}$ = |$\\it{T}_{1}$|$\\it{S}_{f1}$/$\\it{J}_{x1}$."});
  return panel;
}

PanelSheet flow_sheet(const Solution& s, Language language) {
  const double h = half_web(s), sigma = s["sigma_par_M"] / mega, tau = s["tau_par_Jour"] / mega;
  SectionPanel section = section_with_stresses(s, s["sigma_outer"] / mega, s["T_1"] / s["J_x1"] / mega,
                                               {{"sigma_par_M", "$σ_{∥M}$", {sigma, h}}},
                                               {{"tau_par_Jour", "$τ_{∥J}$", {tau, h}}}, language);
  section
      .step(0, {sigma, h},
            {"The bending stress at the joint, by similar triangles from the outer fibre.",
             "La tensione di flessione al giunto, per triangoli simili dalla fibra esterna."})
      .step(1, {tau, h},
            {"Jourawsky's shear of the web at the joint: $q$ over the thickness $s_{1}$.",
             "Il taglio di Jourawsky dell'anima al giunto: $q$ sullo spessore $s_{1}$."});
  const Words means{
      "$τ_{∥T}$ = $\\it{T}_{1}$/$\\it{A}_{v1}$: the mean over the web. $\\it{S}_{f1}$: of a flange.",
      "$τ_{∥T}$ = $\\it{T}_{1}$/$\\it{A}_{v1}$: la media sull'anima. $\\it{S}_{f1}$: della piattabanda."};
  return {.panels = panels(flange_along_beam(s), section),
          .results = {values({"T_1", "M_C"}), workshop_values({"A_1", "A_v1"}), workshop_values({"J_x1", "S_x1"}),
                      values({"flange_pull", "q"}), workshop_values({"sigma_par_M", "tau_par_T"}),
                      workshop_values({"tau_par_Jour"}), remark(means.in(language))},
          .seen = {"The force of the upper flange along the beam, whose rise is the shear flow, and section C with "
                   "bending stress and shear along its depth",
                   "La forza della piattabanda superiore lungo la trave, la cui crescita è il flusso di taglio, e la "
                   "sezione C con la tensione di flessione e il taglio lungo l'altezza"},
          .told = {"sigma_par_M", "tau_par_Jour", "q"},
          .without_part = without({"b", "sigma_amm", "f", "f_1", "f_2"})};
}

// Whether a check holds: `what`, with the letter of its utilisation.
Result verdict(const Solution& s, const Words& what, const std::string& utilisation, Language language) {
  const auto excess = s.value(utilisation + "_excess");
  const std::string u = s.described(utilisation).symbol;
  const Words found = excess && *excess <= 0
                          ? Words{" holds, as " + u + " ≤ 1.", " vale, poiché " + u + " ≤ 1."}
                          : Words{" does not hold, as " + u + " > 1.", " non vale, poiché " + u + " > 1."};
  return remark((what + found).in(language));
}
const Words of_throats{"The check of the throats", "La verifica delle sezioni di gola"};

PanelSheet throat_sheet(const Solution& s, Language language) {
  return {.panels = panels(ThroatPanel(metres(s, "s_1"), metres(s, "b"), s["a"])),
          .results = {values({"q"}), workshop_values({"a", "tau_fillet"}), workshop_values({"fillet_allowable_1"}),
                      values({"fillet_throat_utilisation"}),
                      verdict(s, of_throats, "fillet_throat_utilisation", language)},
          .seen = {"The joint with its two fillets and their throat",
                   "Il giunto con i due cordoni e la loro sezione di gola"},
          .told = {"q", "a", "tau_fillet"},
          .without_part = without({"f", "f_2"})};
}

PanelSheet mohr_sheet(const Solution& s, Language language) {
  const MohrPanel circle({.unit = "MPa",
                          .si = mega,
                          .sigma = s["sigma_par_M"] / mega,
                          .tau = s["tau_par_T"] / mega,
                          .sigma_I = s["sigma_I"] / mega,
                          .sigma_II = s["sigma_II"] / mega,
                          .sigma_letters = "$σ_{∥M}$",
                          .tau_letters = "$τ_{∥T}$",
                          .direction_letters = "$φ_{I}$",
                          .sigma_name = "sigma_par_M",
                          .tau_name = "tau_par_T",
                          .sigma_I_name = "sigma_I",
                          .sigma_II_name = "sigma_II",
                          .radius_name = "Mohr_radius",
                          .centre_name = "Mohr_centre",
                          .equivalent_name = "sigma_eq"});
  const Words check{
      "Full penetration is checked by $σ_{eq}$ against $σ_{ammW}$ = $fσ_{amm}$; $u$ is what it uses of that. "
      "$σ_{eq,J}$: the same with Jourawsky's shear $τ_{∥J}$ for the mean $τ_{∥T}$.",
      "La piena penetrazione si verifica con $σ_{eq}$ contro $σ_{ammW}$ = $fσ_{amm}$; $u$ è quanto ne usa. "
      "$σ_{eq,J}$: la stessa con il taglio di Jourawsky $τ_{∥J}$ invece della media $τ_{∥T}$."};
  return {.panels = panels(circle),
          .results = {workshop_values({"sigma_par_M", "tau_par_T"}), workshop_values({"Mohr_centre", "Mohr_radius"}),
                      workshop_values({"sigma_I", "sigma_II"}), values({"principal_direction"}),
                      workshop_values({"sigma_eq", "sigma_eq_Jour"}),
                      workshop_values({"sigma_amm_W", "full_penetration_utilisation"}), remark(check.in(language)),
                      verdict(s, {"The check", "La verifica"}, "full_penetration_utilisation", language)},
          .seen = {"Mohr's circle of the web at the joint", "Il cerchio di Mohr dell'anima al giunto"},
          .told = {"Mohr_centre", "Mohr_radius", "sigma_I", "sigma_II", "principal_direction", "sigma_eq"},
          .without_part = without({"b", "f_1", "f_2"})};
}

PanelSheet sphere_sheet(const Solution& s, Language language) {
  const auto in_MPa = [&](const std::string& name) { return s[name] / mega; };
  const SpherePanel sphere(in_MPa("fillet_allowable_1"), in_MPa("fillet_allowable_2"),
                           {{"tau_par_T", "1", in_MPa("tau_par_T")},
                            {"mass_600kg.tau_par_T", "2", in_MPa("mass_600kg.tau_par_T")},
                            {"tau_fillet", "3", in_MPa("tau_fillet")}});
  const Words points{
      "1: $τ_{∥}$ as the source takes it, the shear over the web. 2: the same with 600 kg, as the source computes. "
      "3: the shear that the throats have of the shear flow (drawn positive).",
      "1: $τ_{∥}$ come la prende la fonte, il taglio medio sull'anima. 2: la stessa con 600 kg, come calcola la "
      "fonte. 3: il taglio che le sezioni di gola hanno dal flusso di taglio (disegnato positivo)."};
  return {
      .panels = panels(sphere),
      .results = {remark(points.in(language)), workshop_values({"fillet_stress_1", "fillet_allowable_1"}),
                  workshop_values({"fillet_stress_2", "fillet_allowable_2"}), values({"fillet_utilisation"}),
                  verdict(s, {"The check as the source has it", "La verifica della fonte"}, "fillet_utilisation",
                          language),
                  workshop_values({"tau_fillet", "fillet_throat_utilisation"}),
                  verdict(s, of_throats, "fillet_throat_utilisation", language)},
      .seen = {"The truncated sphere of the fillet welds in the plane of τ and σ, with the points of the stresses",
               "La sfera troncata dei cordoni d'angolo nel piano di τ e σ, con i punti delle tensioni"},
      .told = {"fillet_stress_1", "fillet_allowable_1", "fillet_allowable_2", "tau_fillet"},
      .without_part = without({"f"})};
}

}  // namespace
}  // namespace crane_welds

std::unique_ptr<Exercise> make_crane_welds() {
  using namespace crane_welds;
  Description about{
      .id = "crane-welds",
      .title = {"The welds of the crane's beam", "Le saldature della trave della gru"},
      .document = "pisa",
      .item = "Esercizio 3",
      .source = {"Pisa, mid-term test of 14 June 2006, exercise 3",
                 "Pisa, verifica intermedia del 14/6/2006, esercizio 3"},
      .question = {"Web and flanges of the crane's beam are welded, once with full penetration and once with two "
                   "fillets. Find the shear flow and the stresses at the joint in section C and check both welds.",
                   "L'anima e le ali della trave della gru sono saldate, una volta a piena penetrazione e una con "
                   "due cordoni d'angolo. Trovare il flusso di taglio e le tensioni nel giunto alla sezione C e "
                   "verificare entrambe le saldature."},
      .givens = Welds::givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes(Welds(givens)), rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"shear-flow",
         {"Shear flow at the joint", "Flusso di taglio al giunto"},
         {"Web and flanges of the crane's beam are welded. Find the shear flow at the joint in section C.",
          "L'anima e le ali della trave della gru sono saldate. Trovare il flusso di taglio nel giunto alla sezione "
          "C."}},
        flow_sheet},
       {{"throat",
         {"Throat of the fillets", "Sezione di gola dei cordoni"},
         {"Web and flanges of the crane's beam are welded with two fillets. Find the stresses of their throats in "
          "section C and check the weld.",
          "L'anima e le ali della trave della gru sono saldate con due cordoni d'angolo. Trovare le tensioni nelle "
          "loro sezioni di gola alla sezione C e verificare la saldatura."}},
        throat_sheet},
       {{"mohr",
         {"Mohr's circle at the joint", "Cerchio di Mohr al giunto"},
         {"Web and flanges of the crane's beam are welded with full penetration. Find the principal stresses at the "
          "joint in section C by Mohr's circle and check the weld.",
          "L'anima e le ali della trave della gru sono saldate a piena penetrazione. Trovare le tensioni principali "
          "nel giunto alla sezione C con il cerchio di Mohr e verificare la saldatura."}},
        mohr_sheet},
       {{"sphere",
         {"Fillets: the truncated sphere", "Cordoni: la sfera troncata"},
         {"Web and flanges of the crane's beam are welded with two fillets. Check the weld in section C by the "
          "truncated sphere.",
          "L'anima e le ali della trave della gru sono saldate con due cordoni d'angolo. Verificare la saldatura "
          "alla sezione C con la sfera troncata."}},
        sphere_sheet}});
}

}  // namespace epure
