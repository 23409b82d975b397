// N.12 of the Sapienza sheets: a pair of involute gears around its pitch point, whole, and how its flanks slide.
#include <algorithm>
#include <cmath>

#include "exercises/gear-pair/contact_words.h"
#include "exercises/gear-pair/faults.h"
#include "exercises/gear-pair/mesh_panel.h"
#include "exercises/gear-pair/problem.h"
#include "exercises/gear-pair/routes.h"
#include "exercises/gear-pair/sliding_panel.h"
#include "exercises/gear-pair/wheels_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/verdict.h"
#include "exercises/kit/statement/decimal.h"

namespace epure {
namespace gear_pair {
namespace {

using Names = std::vector<std::string>;
const std::string none = "–";

// What every sheet begins with: nothing for a pair without a fault.
std::vector<Section> faults_of(const Pair& pair, Language language) {
  Section section{pair.faults.size() > 1 ? Words{"Faults", "Difetti"} : Words{"Fault", "Difetto"}, {}};
  for (const geometry::Fault& fault : pair.faults)
    section.lines.push_back(remark(sentence(fault, pair.of).in(language)));
  return {section};
}

// Nothing when the givens were changed, or when no number of the source differs.
Section source_prints(const Pair& pair, const Names& quantities, Language language) {
  Section section{{"The source prints", "La fonte riporta"}, {}};
  Words lines, why;
  for (const Printed& printed : printed_by_the_source()) {
    if (!pair.s.givens().as_stated() ||
        std::find(quantities.begin(), quantities.end(), printed.quantity) == quantities.end())
      continue;
    const auto& values = pair.s.values();
    const PrintedVerdict verdict = judge(printed, std::find_if(values.begin(), values.end(), [&](const auto& value) {
                                                    return value.quantity == printed.quantity;
                                                  })->settled);
    const Quantity& quantity = pair.s.described(printed.quantity);
    lines = lines + (lines.empty() ? "" : ", ") +
            format_words("{}\u00a0= {}\u00a0{} for {}", "{}\u00a0= {}\u00a0{} invece di {}", quantity.symbol,
                         decimal(printed.text), quantity.unit, written(pair.s[printed.quantity]));
    why = verdict.explanation.value_or(why);
  }
  if (!lines.empty()) section.lines = {remark((lines + ".").in(language)), remark(why.in(language))};
  return section;
}

std::set<std::string> without_part(const Pair& pair, std::set<std::string> others = {}) {
  if (pair.is_rack()) others.insert("z2");
  return others;
}

// In millimetres, with the limits at which interference begins.
drawings::Table lengths_of_mesh(const Pair& pair, Language language) {
  drawings::Table table{{"mm", "", Words{"limit", "limite"}.in(language)}, {}};
  const auto row = [&](const Words& words, const std::string& name, const std::string& limit = "") {
    const auto value = limit.empty() ? std::nullopt : pair.s.value(limit);
    table.rows.push_back({words.in(language), in_mm(pair.s[name]).in(language),
                          limit.empty() ? ""
                          : value       ? in_mm(*value).in(language)
                                        : "∞"});
  };
  if (pair.has_contact()) {
    row({"path of approach $P_{0}A$", "linea di accesso $P_{0}A$"}, "path_of_approach",
        "interference_limit_approach");
    row({"path of recess $P_{0}E$", "linea di recesso $P_{0}E$"}, "path_of_recess", "interference_limit_recess");
    row({"path of contact $AE$", "linea di ingranamento $AE$"}, "path_of_contact");
    row({"arc of approach", "arco di accesso"}, "arc_of_approach");
    row({"arc of recess", "arco di recesso"}, "arc_of_recess");
    row({"arc of action $e$", "arco di azione $e$"}, "arc_of_action");
  }
  row({"circular pitch $p$", "passo $p$"}, "circular_pitch");
  row({"base pitch $p_{b}$", "passo di base $p_{b}$"}, "base_pitch");
  row({"clearance tip 1, root 2", "gioco testa 1, fondo 2"}, "clearance");
  row({"clearance tip 2, root 1", "gioco testa 2, fondo 1"}, "clearance_2");
  return table;
}

// Of these quantities, told in millimetres.
Result table_of(drawings::Table table, const Names& asked = {}) {
  const auto tell = [table = std::move(table)](const Solution&, Language) -> std::optional<drawings::Block> {
    return table;
  };
  return {tell, asked, true};
}

const Names asked_of_mesh{"path_of_approach",
                          "path_of_recess",
                          "arc_of_approach",
                          "arc_of_recess",
                          "contact_ratio",
                          "interference_limit_approach",
                          "interference_limit_recess"};

PanelSheet mesh_sheet(const Solution& s, Language language) {
  const Pair pair(s);
  Section results{{"Results", "Risultati"}, {table_of(lengths_of_mesh(pair, language), asked_of_mesh)}};
  Names told{"base_pitch"};
  if (pair.has_contact()) {
    results.lines.push_back(remark(about_ratio(pair).in(language)));
    told = {"path_of_approach", "path_of_recess", "contact_ratio", "base_pitch"};
    if (!pair.is_whole()) {
      results.lines.push_back(
          remark(about_path(pair, {"Paths and arcs are of whole flanks", "Linee e archi sono di fianchi interi"})
                     .in(language)));
      if (pair.is_known && pair.touches) told.push_back("true_contact_ratio");
    }
  }
  return {.panels = panels(MeshPanel(pair)),
          .first = faults_of(pair, language),
          .theory = {results, source_prints(pair, {"path_of_approach"}, language)},
          .seen = {"Both wheels around the pitch point with their circles, the line of action, the path of contact "
                   "AE and a pair of teeth in contact",
                   "Le due ruote intorno al punto P0 con le circonferenze, la retta d'azione, la linea di "
                   "ingranamento AE e una coppia di denti a contatto"},
          .told = told,
          .without_part = without_part(pair, {"n1"})};
}

// To a thousandth of a millimetre.
Words to_micrometre(double metres) {
  const double mm = 1000 * std::abs(metres);
  return in_mm(metres, std::clamp(mm == 0 ? 4 : static_cast<int>(std::floor(std::log10(mm))) + 4, 1, 9));
}
Words exactly(const Rational& x) { return decimal(nearest(x), 6); }

// Both wheels column by column; a rack has what a wheel has but circles.
drawings::Table gear_data(const Pair& pair, Language language) {
  drawings::Table table{{"mm", "1", "2"}, {}};
  const auto lengths = [&](const std::string& letters, const std::string& of_1, const std::string& of_2) {
    table.rows.push_back({"$" + letters + "$"});
    for (const std::string& name : {of_1, of_2}) {
      const auto value = pair.s.has(name) ? pair.s.value(name) : std::nullopt;
      table.rows.back().push_back(value ? to_micrometre(*value).in(language) : none);
    }
  };
  const auto of_both = [&](const std::string& letters, const std::string& name) {
    lengths(letters, name + "1", name + "2");
  };
  const auto teeth = [&](int wheel) {
    const auto k = pair.is_rack(wheel) ? std::nullopt : pair.s.value(on("k_", wheel));
    return k ? exactly(Rational(*k)).in(language) : none;
  };
  table.rows = {{"$z$", std::to_string(pair.of.z1), pair.is_rack() ? "∞" : std::to_string(pair.of.z2)},
                {"$x$", exactly(pair.of.x1).in(language), pair.is_rack() ? none : exactly(pair.of.x2).in(language)}};
  of_both("d", "d_");
  if (pair.is_shifted()) of_both("d_{w}", "dw_");
  of_both("d_{b}", "db_");
  of_both("d_{a}", "da_");
  of_both("d_{f}", "df_");
  of_both("s", "tooth_thickness_pitch_");
  of_both("s_{a}", "tooth_thickness_tip_");
  lengths("h", "tooth_height", "tooth_height");
  of_both("𝑊_{k}", "W_");
  table.rows.push_back({"$k$", teeth(1), teeth(2)});
  return table;
}

// From what the source gives to what the exercise starts from.
Words from_source(const Pair& pair) {
  if (!pair.s.givens().as_stated()) return {};
  return format_words(
      "Given in the source: centre distance $i$ = {}\u00a0mm, ratio $τ$ = $r_{{1}}$/$r_{{2}}$ = {}. So $r_{{2}}$ = "
      "$i$/(1 + $τ$) = {}\u00a0mm, $r_{{1}}$ =\u00a0$τ$·$r_{{2}}$ =\u00a0{}\u00a0mm, and $z$ = 2$r$/$m$.",
      "Dati nella fonte: interasse $i$ = {}\u00a0mm, rapporto $τ$ = $r_{{1}}$/$r_{{2}}$ = {}. Quindi $r_{{2}}$ = "
      "$i$/(1 + $τ$) = {}\u00a0mm, $r_{{1}}$ =\u00a0$τ$·$r_{{2}}$ =\u00a0{}\u00a0mm, e $z$ = 2$r$/$m$.",
      in_mm(pair.s["centre_distance"]), written(pair.s["tau"], 3), in_mm(pair("r", 2)), in_mm(pair("r", 1)));
}

// What the letters of the table stand for.
Words legend(const Pair& pair) {
  return format_words(
      "$d$ reference, {}$d_{{b}}$ base, $d_{{a}}$ tip, $d_{{f}}$ root diameter; tooth thickness $s$ on $d$, "
      "$s_{{a}}$ at the tip; height $h$; $𝑊_{{k}}$ base tangent length over $k$ teeth.",
      "Diametri $d$ primitivo, {}$d_{{b}}$ di base, $d_{{a}}$ di testa, $d_{{f}}$ di fondo; spessore $s$ su $d$, "
      "$s_{{a}}$ in testa; altezza $h$; $𝑊_{{k}}$ scartamento su $k$ denti.",
      pair.is_shifted() ? Words{"$d_{w}$ working pitch, ", "$d_{w}$ di funzionamento, "} : Words{});
}

Words of_the_pair(const Pair& pair) {
  Words text = format_words("$m$ = {}\u00a0mm, $α$ = {}°", "$m$ = {}\u00a0mm, $α$ = {}°", exactly(1000 * pair.of.m),
                            decimal(degrees(pair.of.alpha), 6));
  if (!pair.is_rack()) text = text + ", $a$ = " + to_micrometre(pair.s["centre_distance"]) + "\u00a0mm";
  if (pair.is_shifted()) text = text + ", $α_{w}$ = " + written(pair.s["working_pressure_angle_deg"], 6) + "°";
  if (pair.has_contact()) text = text + ", " + both_contact_ratios(pair);
  return text + format_words(", backlash $j$ = {}\u00a0mm.", ", gioco $j$ = {}\u00a0mm.", exactly(1000 * pair.of.j));
}

Words of_the_cutter(const Pair& pair) {
  const geometry::PairData& of = pair.of;
  const Words text = format_words(
      "Basic rack: $h_{{a}}^{{*}}$ = {}, $h_{{f}}^{{*}}$ = {}, $ρ^{{*}}$ = {}: its tip is rounded, and the fillets "
      "are cut, with $ρ$ =\u00a0$ρ^{{*}}$·$m$ =\u00a0{}\u00a0mm",
      "Dentiera di riferimento: $h_{{a}}^{{*}}$ = {}, $h_{{f}}^{{*}}$ = {}, $ρ^{{*}}$ = {}: il raccordo in testa, "
      "che taglia quelli al piede, è $ρ$ =\u00a0$ρ^{{*}}$·$m$ =\u00a0{}\u00a0mm",
      exactly(of.ha), exactly(of.hf), exactly(of.rho), to_micrometre(pair.s["rho"]));
  return of.k == 0 ? text + "." : text + "; $k$ = " + exactly(of.k) + ".";
}

// A rack has no circles, and no centre.
Names asked_of_wheels(const Pair& pair) {
  Names names;
  if (pair.is_shifted()) names.push_back("working_pressure_angle_deg");
  if (!pair.is_rack()) names.push_back("centre_distance");
  for (const char* name : {"r_base_", "r_tip_", "r_root_", "tooth_thickness_pitch_", "tooth_thickness_tip_"})
    for (const int wheel : {1, 2})
      if (!pair.is_rack(wheel)) names.push_back(on(name, wheel));
  return names;
}

PanelSheet wheels_sheet(const Solution& s, Language language) {
  const Pair pair(s);
  Section data{{"Gear data", "Dati delle dentature"}, {remark(from_source(pair).in(language))}};
  data.lines.push_back(table_of(gear_data(pair, language), asked_of_wheels(pair)));
  for (const Words& words : {legend(pair), of_the_pair(pair), of_the_cutter(pair)})
    data.lines.push_back(remark(words.in(language)));
  return {.panels = panels(WheelsPanel(pair)),
          .first = faults_of(pair, language),
          .theory = {data},
          .seen = {"The wheels with their teeth in mesh, their circles and radii, and the gear data",
                   "Le ruote con i denti in presa, le circonferenze coi raggi, e i dati delle dentature"},
          .told = pair.is_rack() ? Names{"z1"} : Names{"z1", "z2", "centre_distance"},
          .without_part = without_part(pair, {"n1"})};
}

Section curves(const Pair& pair, Language language) {
  std::vector<Words> lines{
      format_words(
          "$ξ$ is the position of the contact on the line of action, from $P_{{0}}$; contact travels from ${}$ to "
          "${}$.",
          "$ξ$ è la posizione del contatto sulla retta d'azione, da $P_{{0}}$; il contatto va da ${}$ a ${}$.",
          pair.begins.letters(), pair.ends.letters()),
      pair.is_rack()
          ? Words{"Along the common tangent flank 1 moves with $v_{t1}$ =\u00a0$ω_{1}$·$T_{1}P$, the rack's with the "
                  "constant $v_{t2}$ = $ω_{1}$·$T_{1}P_{0}$; $v_{s}$ = $ω_{1}$·$P_{0}P$, zero at $P_{0}$.",
                  "Lungo la tangente comune il fianco 1 si muove con $v_{t1}$ =\u00a0$ω_{1}$·$T_{1}P$, quello della "
                  "dentiera con $v_{t2}$ = $ω_{1}$·$T_{1}P_{0}$ costante; $v_{s}$ = $ω_{1}$·$P_{0}P$, nulla in "
                  "$P_{0}$."}
          : Words{"Along the common tangent the flanks move with $v_{t1}$ =\u00a0$ω_{1}$·$T_{1}P$ and $v_{t2}$ "
                  "=\u00a0$ω_{2}$·$T_{2}P$, positive towards tip 1; $v_{s}$ =\u00a0$ω_{r}$·$P_{0}P$, zero at "
                  "$P_{0}$.",
                  "Lungo la tangente comune i fianchi si muovono con $v_{t1}$ =\u00a0$ω_{1}$·$T_{1}P$ e $v_{t2}$ "
                  "=\u00a0$ω_{2}$·$T_{2}P$, positive verso la testa 1; $v_{s}$ =\u00a0$ω_{r}$·$P_{0}P$, nulla in "
                  "$P_{0}$."},
      {"Specific sliding: $ζ_{1}$ = $v_{s}$/$v_{t1}$, $ζ_{2}$ = −$v_{s}$/$v_{t2}$; without bound towards $T_{1}$ and "
       "$T_{2}$.",
       "Strisciamento specifico: $ζ_{1}$ = $v_{s}$/$v_{t1}$, $ζ_{2}$ = −$v_{s}$/$v_{t2}$; senza limite verso $T_{1}$ "
       "e $T_{2}$."}};
  if (!pair.is_whole())
    lines.push_back(
        about_path(pair, pair.is_known ? Words{"Dashed grey: what whole flanks would do",
                                               "In grigio, a tratti: quel che farebbero fianchi interi"}
                                       : Words{"The curves are of whole flanks", "Le curve sono di fianchi interi"}));
  if (pair.has_single_contact())
    lines.push_back({"Grey: two pairs of teeth carry; between $B$ and $D$ one alone.",
                     "In grigio: due coppie di denti in presa; fra $B$ e $D$ una sola."});
  Section section{{"The curves", "Le curve"}, {}};
  for (const Words& line : lines) section.lines.push_back(remark(line.in(language)));
  return section;
}

drawings::Table velocities_at_ends(const Pair& pair, Language language) {
  const Names ends{pair.begins.point, pair.ends.point};
  drawings::Table table{{"", "$" + pair.begins.letters() + "$", "$" + pair.ends.letters() + "$"}, {}};
  const auto row = [&](const std::string& letters, const std::string& name, double unit = 1) {
    table.rows.push_back({letters});
    for (const std::string& end : ends) {
      const auto value = pair.s.value(name + "_" + end);
      table.rows.back().push_back(value ? written(*value / unit).in(language) : none);
    }
  };
  row("$ξ$ (mm)", "xi", 1e-3);
  row("$v_{t1}$ (m/s)", "v_t1");
  row("$v_{t2}$ (m/s)", "v_t2");
  row("|$v_{s}$| (m/s)", "v_s");
  row("$ζ_{1}$", "zeta_1");
  row("$ζ_{2}$", "zeta_2");
  return table;
}

Words speeds(const Pair& pair) {
  const auto omega = [&](const std::string& i) { return written(pair.s["omega_" + i]); };
  const Words of_1 = "$ω_{1}$ = " + omega("1") + "\u00a0rad/s";
  if (pair.is_rack()) return of_1 + ", $v$ = $ω_{1}$·$r_{1}$ =\u00a0" + written(pair.s["v"]) + "\u00a0m/s.";
  return of_1 + ", $ω_{2}$ = " + omega("2") + "\u00a0rad/s, $ω_{r}$ = $ω_{1}$ − $ω_{2}$ =\u00a0" + omega("relative") +
         "\u00a0rad/s" + Words{", counter-clockwise positive.", ", positive se antiorarie."};
}

PanelSheet sliding_sheet(const Solution& s, Language language) {
  const Pair pair(s);
  PanelSheet sheet{.first = faults_of(pair, language), .without_part = without_part(pair)};
  if (!pair.has_contact() || !pair.touches) {
    sheet.seen = {"There is no contact, and no sliding to be drawn.",
                  "Non c'è contatto, né strisciamento da disegnare."};
    Section section{{"Sliding", "Strisciamento"}, {remark(sheet.seen.in(language))}};
    if (pair.has_contact())
      section.lines.push_back(
          remark(about_path(pair, {"Whole flanks would touch", "Fianchi interi si toccherebbero"}).in(language)));
    sheet.theory = {section};
    return sheet;
  }
  sheet.panels = panels(SlidingPanel(pair));
  sheet.theory = {
      curves(pair, language),
      {{"Results", "Risultati"}, {remark(speeds(pair).in(language)), table_of(velocities_at_ends(pair, language))}},
      source_prints(pair, {"omega_relative", "sliding_velocity_approach", "sliding_velocity_recess"}, language)};
  sheet.seen = {"Sliding velocity and specific sliding of both flanks along the path of contact",
                "Velocità di strisciamento e strisciamento specifico dei due fianchi lungo la linea di ingranamento"};
  for (const PathEnd& end : {pair.begins, pair.ends})
    sheet.told.push_back(end.point == "A"   ? "sliding_velocity_approach"
                         : end.point == "E" ? "sliding_velocity_recess"
                                            : "v_s_" + end.point);
  return sheet;
}

}  // namespace
}  // namespace gear_pair

std::unique_ptr<Exercise> make_gear_pair() {
  using namespace gear_pair;
  Description about{
      .id = "gear-pair",
      .title = {"A pair of involute gears", "Una coppia di ruote dentate a evolvente"},
      .document = "sapienza",
      .item = "N.12",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.12",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.12"},
      .question = {"Draw the mesh of the two involute gears around the pitch point and the wheels with their "
                   "dimensions. Find the path of contact, arcs of approach and recess, contact ratio, the limits of "
                   "interference, and the sliding along the path of contact.",
                   "Disegnare l'ingranamento delle due ruote a evolvente intorno al punto primitivo e le ruote con "
                   "le loro dimensioni. Trovare la linea di ingranamento, gli archi di accesso e recesso, il fattore "
                   "di ricoprimento, i limiti d'interferenza, e lo strisciamento lungo la linea di ingranamento."},
      .givens = givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(Routes(pair_of(givens), givens.angle("n1"), rung == Rung::drawing), rung);
  };
  const auto flaws = [](const Givens& givens) {
    const geometry::PairData of = pair_of(givens);
    std::vector<Flaw> all;
    for (const geometry::Fault& fault : geometry::faults(of)) all.push_back({sentence(fault, of), fault.undecided});
    return all;
  };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"pitch-point",
         {"Mesh at the pitch point", "Ingranamento intorno al punto P₀"},
         {"Draw the mesh of the two involute gears around the pitch point. Find the path of contact, arcs of "
          "approach and recess, contact ratio and the limits of interference.",
          "Disegnare l'ingranamento delle due ruote a evolvente intorno al punto primitivo. Trovare la linea di "
          "ingranamento, gli archi di accesso e recesso, il fattore di ricoprimento e i limiti d'interferenza."}},
        mesh_sheet},
       {{"wheels",
         {"The wheels", "Le ruote"},
         {"Draw the two involute gears with their dimensions.",
          "Disegnare le due ruote a evolvente con le loro dimensioni."}},
        wheels_sheet},
       {{"sliding",
         {"Sliding along the path of contact", "Strisciamento lungo l'ingranamento"},
         {"Find the sliding of the two involute gears along the path of contact.",
          "Trovare lo strisciamento delle due ruote a evolvente lungo la linea di ingranamento."}},
        sliding_sheet}},
      flaws);
}

}  // namespace epure
