// Stresses of section C, Soderberg's diagram, Euler's hyperbola, and all checks of both masses.
#include <cmath>
#include <numbers>

#include "exercises/boat-crane/sheets.h"
#include "exercises/kit/crane/section_diagrams.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/mechanism_with_blocks.h"
#include "exercises/kit/panels/mohr_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/table_panel.h"

namespace epure::boat_crane {
namespace {

constexpr double mega = 1e6;
const std::string with_600 = "mass_600kg.";

Words stated_mass(const Solution& s) { return decimal(CGAL::to_double(s.givens()["W_b"]), 6) + Words{" kg", " kg"}; }

// The stresses of the beam for both masses, which the sheet to be solved does not ask for.
Result both_masses(const Solution& s, Language language) {
  const auto row = [](const std::string& head, const std::string& of) {
    return Row{head, {of + "sigma_z_max", of + "tau_zy", of + "sigma_eq", of + "beam_static_utilisation"}, "–", true};
  };
  const Result rows = table({"", "$σ_{z}$ (MPa)", "$τ_{zy}$ (MPa)", "$σ_{eq}$ (MPa)", "$u$"},
                            {row(stated_mass(s).in(language), ""), row("600 kg", with_600)});
  return [rows](const Solution& solution, Language told_in) { return rows(solution, told_in); };
}

// The column cut free, and the diagram of its normal force, compression to the left.
class ColumnPanel : public Panel {
 public:
  explicit ColumnPanel(const Solution& s) : height_(CGAL::to_double(s.givens()["H_0"])), N_(s["N_2"]) {}

  double reach() const override { return height_; }
  Vectors vectors() const override { return {"N", std::abs(N_), 25}; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override {
    constexpr double air = 10;  // mm
    const double wide = vectors.mm_per_unit * std::abs(N_);
    return {{-wide - air, -wide - air}, {air, lengths.mm_per_unit * height_ + wide + air}};
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override {
    plot.segment(foot(), head(), Meaning::link);
    plot.hinge(foot());
    plot.hinge(head());
    plot.label("$A$", foot(), head());
    plot.label("$C$", head(), foot());
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    const double wide = in_lengths(plot, N_);
    const std::vector<Place> border{foot(), {wide, 0}, {wide, height_}, head()};
    plot.area(border, Meaning::plate);
    plot.polygon(border, Meaning::force);
    draw_given(plot, room, language);
    plot.vector_on("", head() + Arrow2{0, -wide}, {0, N_}, Meaning::force, "$\\it{Y}_{A}$");
    plot.vector_on("", foot() + Arrow2{0, wide}, {0, -N_}, Meaning::force, "$\\it{Y}_{A}$");
    plot.label("$\\it{N}_{2}$", {wide, 0.7 * height_}, Place{0, 0.7 * height_}, Meaning::force);
    plot.label("−", {wide / 2, 0.3 * height_}, {}, Meaning::force);
    plot.onto().measurements.push_back({"N_2", plot.at({0, height_ / 2}), plot.at({wide, height_ / 2}),
                                        1 / plot.vector_scale().mm_per_unit, Measurement::along_x});
    return {};
  }
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override {
    return {{{"The column, hinged at both ends, is pressed by $\\it{Y}_{A}$ along its axis: $\\it{N}_{2}$ = "
              "−$\\it{Y}_{A}$ all along it, $\\it{T}$ and $\\it{M}$ are zero.",
              "La colonna, incernierata agli estremi, è premuta da $\\it{Y}_{A}$ lungo l'asse: ovunque $\\it{N}_{2}$ "
              "= −$\\it{Y}_{A}$, $\\it{T}$ e $\\it{M}$ sono nulli."},
             Place{in_lengths(plot, N_) / 2, height_ / 2}}};
  }

 private:
  static Place foot() { return {0, 0}; }
  Place head() const { return {0, height_}; }
  static double in_lengths(const Plot& plot, double force) {
    return force * plot.vector_scale().mm_per_unit / plot.scale().mm_per_unit;
  }

  double height_, N_;
};

}  // namespace

FreeBodyPanel loaded_crane(const Solution& s) {
  using Joint = Mechanism::Joint;
  const double L = CGAL::to_double(s.givens()["L"]), H = CGAL::to_double(s.givens()["H_0"]);
  Mechanism drawn;
  drawn.point("B", {0, 0}, Joint::fixed, "$B$")
      .point("C", {L, 0}, Joint::corner, "$C$")
      .point("D", {3 * L, 0}, Joint::none, "$D$")
      .point("A", {L, -H}, Joint::fixed, "$A$")
      .body({"B", "C", "D"})
      .body({"C", "A"});
  constexpr double upwards = std::numbers::pi / 2;
  drawn.offset("C", {0, 0}, upwards, 0, "$\\it{L}$")
      .offset("D", {0, 0}, upwards, L / 3, "3$\\it{L}$")
      .offset("A", {L, 0}, 0, 0, "$\\it{H}_{0}$");
  MechanismWithBlocks crane(std::move(drawn));
  crane.hinge_under({L, 0}, {L, -H});
  FreeBodyPanel loaded(std::make_shared<const MechanismWithBlocks>(std::move(crane)));
  loaded.load({.label = "$\\it{P}$", .v = {0, -s["P"]}}, {3 * L, 0});
  return loaded;
}

PanelSheet section_sheet(const Solution& s, Language language) {
  const double H = half_depth(s), sigma = s["sigma_z_max"] / mega, tau = s["tau_max_Jourawsky"] / mega;
  SectionPanel section =
      section_with_stresses(s, sigma, s["T_1_BC"] / s["J_x1"] / mega, {{"sigma_z_max", "$σ_{z}$", {sigma, H}}},
                            {{"tau_max_Jourawsky", "$τ_{max}$", {tau, 0}}}, language);
  section.level(0, "$G$")
      .step(0, {sigma, H},
            {"Navier: $σ_{z}$ = −$\\it{M}_{C}$/$\\it{W}_{x1}$ in the upper fibre, nought on the axis through $G$.",
             "Navier: $σ_{z}$ = −$\\it{M}_{C}$/$\\it{W}_{x1}$ nella fibra superiore, nulla sull'asse per $G$."})
      .step(
          1, {tau, 0},
          {"Jourawsky: $τ$ = $\\it{TS}$/($\\it{J}t$), greatest on the axis; it jumps where the flange becomes the "
           "web.",
           "Jourawsky: $τ$ = $\\it{TS}$/($\\it{J}t$), massima sull'asse; salta dove la piattabanda diventa anima."});
  const MohrPanel circle({.unit = "MPa",
                          .si = mega,
                          .sigma = sigma,
                          .tau = s["tau_zy"] / mega,
                          .sigma_I = s["sigma_I"] / mega,
                          .sigma_II = s["sigma_II"] / mega,
                          .sigma_letters = "$σ_{z}$",
                          .tau_letters = "$τ_{zy}$",
                          .sigma_name = "sigma_z_max",
                          .tau_name = "tau_zy",
                          .equivalent_name = "sigma_eq"});
  const Words mean{
      "As the source does, the mean shear $τ_{zy}$ = $\\it{T}$/$\\it{A}_{1}$ is taken with the greatest $σ_{z}$.",
      "Come fa la fonte, il taglio medio $τ_{zy}$ = $\\it{T}$/$\\it{A}_{1}$ è preso insieme alla massima $σ_{z}$."};
  const Words proportional{
      "The source computes with 600 kg: both figures hold for it when a millimetre is taken for 600 kg/$\\it{W}_{b}$ "
      "times the stress.",
      "La fonte calcola con 600 kg: le due figure valgono anche così, se un millimetro si conta per 600 "
      "kg/$\\it{W}_{b}$ volte la tensione."};
  return {
      .panels = panels(section, circle),
      .results = {workshop_values({"A_1", "J_x1"}), workshop_values({"W_x1", "S_x1_max"}),
                  workshop_values({"sigma_z_max", "tau_zy"}), workshop_values({"tau_web_mean", "tau_max_Jourawsky"}),
                  workshop_values({"sigma_I", "sigma_II"}), workshop_values({"sigma_eq", "sigma_eq_web_shear"}),
                  workshop_values({"sigma_amm", "beam_static_utilisation"}), remark(mean.in(language)),
                  both_masses(s, language), remark(proportional.in(language))},
      .seen = {"Section C of the beam with the diagrams of bending stress and of Jourawsky's shear along its depth, "
               "and Mohr's circle",
               "La sezione C della trave con i diagrammi della tensione di flessione e del taglio di Jourawsky lungo "
               "l'altezza, e il cerchio di Mohr"},
      .told = {"sigma_z_max", "tau_zy", "tau_max_Jourawsky", "sigma_eq"},
      .without_part = {"H_0", "s_2", "H_2", "b_2", "Delta_sigma_L", "E"}};
}

PanelSheet fatigue_sheet(const Solution& s, Language language) {
  const double yield = CGAL::to_double(s.givens()["sigma_S"]), limit = CGAL::to_double(s.givens()["Delta_sigma_L"]);
  const double allowed = s["Delta_sigma_Lamm"] / mega;
  const auto in_MPa = [&](const std::string& name) { return s.value(name).value_or(0) / mega; };
  // High enough for the states, unless they lie far beyond what the material bears.
  double high = 1.1 * limit;
  for (const std::string& name :
       {std::string("Delta_sigma"), std::string("Delta_sigma_eff"), with_600 + "Delta_sigma_eff"})
    if (const double reached = 1.05 * in_MPa(name); reached < 4 * limit) high = std::max(high, reached);
  drawings::Chart chart{.x = {.quantity = "$σ_{m}$", .unit = "MPa", .low = 0, .high = yield},
                        .y = {.quantity = "$Δσ$", .unit = "MPa", .low = 0, .high = high}};
  chart.curves.push_back(
      {.name = "soderberg", .runs = {{{0, limit}, {yield, 0}}}, .meaning = Meaning::locus, .label = "$Δσ_{L}$"});
  chart.curves.push_back({.name = "soderberg_allowed",
                          .runs = {{{0, allowed}, {yield, 0}}},
                          .meaning = Meaning::locus,
                          .line = drawings::LineType::dashed,
                          .label = "$Δσ_{L}$/$Ψ$"});
  chart.curves.push_back({.name = "from_zero",
                          .runs = {{{0, 0}, {high / 2, high}}},
                          .meaning = Meaning::construction,
                          .label = "$Δσ$ = 2$σ_{m}$"});
  std::vector<ChartPanel::Read> reads;
  const auto state = [&](const std::string& of, const std::string& label) {
    const double mean = in_MPa(of + "sigma_m"), range = in_MPa(of + "Delta_sigma");
    chart.markers.push_back({.at = {mean, range}, .label = label, .meaning = Meaning::force});
    reads.push_back({{mean, range}, of + "sigma_m", of + "Delta_sigma", mega, mega});
    if (!s.value(of + "Delta_sigma_eff")) return;
    const double effective = in_MPa(of + "Delta_sigma_eff");
    chart.curves.push_back({.name = of == with_600 ? "line_600" : "line",
                            .runs = {{{0, effective}, {yield, 0}}},
                            .meaning = Meaning::force,
                            .line = of == with_600 ? drawings::LineType::dotted : drawings::LineType::continuous});
    chart.markers.push_back({.at = {0, effective},
                             .label = of == with_600 ? "$Δσ_{eff}$ (600 kg)" : "$Δσ_{eff}$",
                             .meaning = Meaning::force});
    reads.push_back({{0, effective}, "", of + "Delta_sigma_eff", 1, mega});
  };
  chart.markers.push_back({.at = {yield, 0}, .label = "$σ_{S}$", .meaning = Meaning::locus});
  state("", "1");
  state(with_600, "1 (600 kg)");
  chart.markers.push_back(
      {.at = {-in_MPa("sigma_m2"), -in_MPa("sigma_zN")}, .label = "2", .meaning = Meaning::force});
  const Words no_range{
      "The mean stress of the state 1 reaches the yield stress: no range of stress is left, there is no line and no "
      "$Δσ_{eff}$, and the check does not hold. ",
      "La tensione media dello stato 1 raggiunge lo snervamento: non resta ampiezza alcuna, non ci sono la retta né "
      "la $Δσ_{eff}$, e la verifica non vale. "};
  const Words by_line{
      "The line from the yield stress through the state 1 of the beam meets the axis of $Δσ$ in $Δσ_{eff}$, the "
      "equivalent range with a mean stress of zero. The check holds when that is not above $Δσ_{L}$/$Ψ$: when "
      "the state lies below the dashed line. ",
      "La retta dallo snervamento per lo stato 1 della trave incontra l'asse delle $Δσ$ in $Δσ_{eff}$, l'ampiezza "
      "equivalente a tensione media nulla. La verifica vale se non supera $Δσ_{L}$/$Ψ$: se lo stato sta sotto la "
      "linea tratteggiata. "};
  const Words column{
      "2: the column, with magnitudes; its signed $Δσ_{eff2}$ takes the compression for a help, so that its check "
      "may hold with the point above the dashed line.",
      "2: la colonna, con i moduli; la sua $Δσ_{eff2}$ con segno conta la compressione come un aiuto, sicché la "
      "verifica può valere con il punto sopra la linea tratteggiata."};
  const Words how = (s.value("Delta_sigma_eff") ? by_line : no_range) + column;
  return {.panels = panels(ChartPanel(std::move(chart), std::move(reads))),
          .theory = {{{"Construction", "Costruzione"}, {remark(how.in(language))}}},
          .results = {workshop_values({"Delta_sigma", "sigma_m"}),
                      workshop_values({"Delta_sigma_eff", "Delta_sigma_Lamm"}), values({"beam_fatigue_utilisation"}),
                      workshop_values({"sigma_zN", "sigma_m2"}),
                      workshop_values({"Delta_sigma_eff2", "Delta_sigma_eff2_conservative"}),
                      values({"column_fatigue_utilisation"})},
          .seen = {"Soderberg's diagram with the states of beam and column",
                   "Il diagramma di Soderberg con gli stati di trave e colonna"},
          .told = {"Delta_sigma", "sigma_m", "Delta_sigma_eff", "Delta_sigma_Lamm"},
          .without_part = {"H_0", "E"}};
}

namespace {

Words verdict_on_buckling(const Solution& s) {
  const auto excess = s.value("buckling_utilisation_excess");
  return excess && *excess <= 0
             ? Words{"|$\\it{N}_{2}$| ≤ $\\it{P}_{cr}$/$Ψ$, $u_{cr}$ ≤ 1: the check holds.",
                     "|$\\it{N}_{2}$| ≤ $\\it{P}_{cr}$/$Ψ$, $u_{cr}$ ≤ 1: la verifica vale."}
             : Words{"|$\\it{N}_{2}$| > $\\it{P}_{cr}$/$Ψ$, $u_{cr}$ > 1: the check does not hold.",
                     "|$\\it{N}_{2}$| > $\\it{P}_{cr}$/$Ψ$, $u_{cr}$ > 1: la verifica non vale."};
}

}  // namespace

PanelSheet buckling_sheet(const Solution& s, Language language) {
  const double yield = CGAL::to_double(s.givens()["sigma_S"]), E = CGAL::to_double(s.givens()["E"]), A = s["A_2"];
  const double safety = CGAL::to_double(s.givens()["Psi"]), slenderness = s["slenderness"],
               limit = s["slenderness_limit"];
  const double far = 1.25 * std::max(slenderness, limit);
  const auto hyperbola = [&](double lambda) { return std::numbers::pi * std::numbers::pi * E / (lambda * lambda); };
  const auto curve = [&](const std::string& name, double share, drawings::LineType line, const std::string& label) {
    drawings::Curve found{.name = name, .runs = {{}}, .meaning = Meaning::locus, .line = line, .label = label};
    constexpr int pieces = 300;
    for (int i = 0; i <= pieces; ++i) {
      const double lambda = limit + (far - limit) * i / pieces;
      found.runs.back().push_back({lambda, hyperbola(lambda) / share});
    }
    return found;
  };
  const double critical = s["P_cr"] / A / mega;
  const auto load = [&](const std::string& of) { return -s[of + "sigma_zN"] / mega; };
  drawings::Chart chart{.x = {.quantity = "$λ$", .low = 0, .high = far},
                        .y = {.quantity = "$σ$", .unit = "MPa", .low = 0, .high = 1.1 * yield}};
  chart.curves = {curve("euler", 1, drawings::LineType::continuous, "$π^{2}\\it{E}$/$λ^{2}$"),
                  curve("euler_allowed", safety, drawings::LineType::dashed, "$π^{2}\\it{E}$/($Ψλ^{2}$)"),
                  {.name = "yield_allowed",
                   .runs = {{{0, yield / safety}, {limit, yield / safety}}},
                   .meaning = Meaning::second_locus,
                   .line = drawings::LineType::dashed,
                   .label = "$σ_{S}$/$Ψ$"},
                  {.name = "yield",
                   .runs = {{{0, yield}, {limit, yield}}},
                   .meaning = Meaning::second_locus,
                   .line = drawings::LineType::continuous,
                   .label = "$σ_{S}$"}};
  chart.markers = {{.at = {slenderness, load("")}, .label = "|$σ_{zN}$|", .meaning = Meaning::force},
                   {.at = {slenderness, load(with_600)}, .label = "|$σ_{zN}$| (600 kg)", .meaning = Meaning::force},
                   {.at = {limit, yield}, .label = "$λ_{lim}$", .meaning = Meaning::locus}};
  std::vector<ChartPanel::Read> reads{{{limit, yield}, "slenderness_limit", ""}};
  const bool is_slender = slenderness >= limit;
  if (is_slender) {
    chart.markers.push_back(
        {.at = {slenderness, critical}, .label = "$\\it{P}_{cr}$/$\\it{A}_{2}$", .meaning = Meaning::locus});
    reads.push_back({{slenderness, critical}, "slenderness", "P_cr", 1, A * mega});
  }
  chart.verticals = {{slenderness, "$λ$ = " + figures(slenderness, 4, language)}};
  const Words axis = s["J_y2"] <= s["J_x2"]
                         ? Words{"The column is weaker about the axis $y$, in the plane of its flanges: ",
                                 "La colonna è più debole attorno all'asse $y$, nel piano delle piattabande: "}
                         : Words{"The column is weaker about the axis $x$, in the plane of its web: ",
                                 "La colonna è più debole attorno all'asse $x$, nel piano dell'anima: "};
  const Words ratio = axis + Words{"$i_{min}$ = √($\\it{J}_{min}$/$\\it{A}_{2}$), $λ$ = $\\it{H}_{0}$/$i_{min}$.",
                                   "$i_{min}$ = √($\\it{J}_{min}$/$\\it{A}_{2}$), $λ$ = $\\it{H}_{0}$/$i_{min}$."};
  const Words above{" Above it the hyperbola has Euler's stress; times $\\it{A}_{2}$ it is the critical load.",
                    " Sopra, l'iperbole dà la tensione di Eulero; per $\\it{A}_{2}$ è il carico critico."};
  const Words how = is_slender ? ratio + above : ratio;
  const Words valid =
      is_slender
          ? Words{"$λ$ is beyond $λ_{lim}$: the column buckles before it yields.",
                  "$λ$ supera $λ_{lim}$: la colonna s'inflette prima di snervarsi."}
          : Words{"$λ$ is below $λ_{lim}$: the column yields before Euler's load, which does not hold there.",
                  "$λ$ è minore di $λ_{lim}$: la colonna si snerva prima del carico di Eulero, che lì non vale."};
  const Words strong{"$\\it{P}'_{cr}$: about the stronger axis.", "$\\it{P}'_{cr}$: attorno all'asse più forte."};
  return {
      .panels = panels(ColumnPanel(s), ChartPanel(std::move(chart), std::move(reads))),
      .theory = {{{"Slenderness", "Snellezza"}, {remark(how.in(language)), remark(valid.in(language))}}},
      .results = {workshop_values({"A_2"}), workshop_values({"J_x2", "J_y2"}), workshop_values({"J_min", "i_min"}),
                  values({"slenderness", "slenderness_limit"}), values({"P_cr", "P_cr_over_Psi"}),
                  values({"P_cr_strong_axis"}), workshop_values({"N_2", "sigma_zN"}),
                  values(is_slender ? std::vector<std::string>{"buckling_utilisation", "buckling_safety_factor"}
                                    : std::vector<std::string>{}),
                  remark(is_slender ? verdict_on_buckling(s).in(language) : ""), remark(strong.in(language))},
      .seen = {"The column with the diagram of its normal force, and Euler's hyperbola with its points",
               "La colonna con il diagramma della sua forza normale, e l'iperbole di Eulero con i suoi punti"},
      .told = {"slenderness", "slenderness_limit", "P_cr", "N_2", "buckling_safety_factor"},
      .without_part = {"L", "s_1", "H_1", "b_1", "Delta_sigma_L"}};
}

namespace {

// The checks that fail with the mass that is given; empty when none does.
Words does_not_hold(const Solution& s) {
  Words all;
  for (const auto& [name, words] : std::vector<std::pair<std::string, Words>>{
           {"beam_static_utilisation", {"yield of the beam", "snervamento della trave"}},
           {"beam_fatigue_utilisation", {"fatigue of the beam", "fatica della trave"}},
           {"column_static_utilisation", {"yield of the column", "snervamento della colonna"}},
           {"column_fatigue_utilisation", {"fatigue of the column", "fatica della colonna"}},
           {"buckling_utilisation", {"buckling of the column", "instabilità della colonna"}}})
    if (const auto excess = s.value(name + "_excess"); !excess || *excess > 0)
      all = all + (all.empty() ? Words{} : Words{", ", ", "}) + words;
  return all;
}

}  // namespace

PanelSheet checks_sheet(const Solution& s, Language language) {
  // The picture's table tells them; the sheet to be solved asks for them.
  std::vector<std::string> utilisations;
  for (const char* const check : {"beam_static", "beam_fatigue", "column_static", "column_fatigue", "buckling"})
    for (const std::string& of : {std::string(), with_600}) utilisations.push_back(of + check + "_utilisation");
  const Result asked_for([](const Solution&, Language) { return std::optional<drawings::Block>(); }, utilisations);
  std::vector<std::vector<std::string>> rows;
  const auto cell = [&](const std::string& name, double unit) {
    const auto value = s.value(name);
    return value ? figures(*value / unit, 3, language) : std::string("–");
  };
  const auto row = [&](const Words& check, const std::string& demand, const std::string& allowable,
                       const std::string& utilisation, double unit) {
    rows.push_back({check.in(language), cell(demand, unit), cell(with_600 + demand, unit), cell(allowable, unit),
                    cell(utilisation, 1), cell(with_600 + utilisation, 1)});
  };
  row({"Beam, yield: $σ_{eq}$ (MPa)", "Trave, snervamento: $σ_{eq}$ (MPa)"}, "sigma_eq", "sigma_amm",
      "beam_static_utilisation", mega);
  row({"Beam, fatigue: $Δσ_{eff}$ (MPa)", "Trave, fatica: $Δσ_{eff}$ (MPa)"}, "Delta_sigma_eff", "Delta_sigma_Lamm",
      "beam_fatigue_utilisation", mega);
  row({"Column, yield: $σ_{zN}$ (MPa)", "Colonna, snervamento: $σ_{zN}$ (MPa)"}, "sigma_zN", "sigma_amm",
      "column_static_utilisation", mega);
  row({"Column, fatigue: $Δσ_{eff2}$ (MPa)", "Colonna, fatica: $Δσ_{eff2}$ (MPa)"}, "Delta_sigma_eff2",
      "Delta_sigma_Lamm", "column_fatigue_utilisation", mega);
  row({"Column, buckling: $\\it{N}_{2}$ (kN)", "Colonna, instabilità: $\\it{N}_{2}$ (kN)"}, "N_2", "P_cr_over_Psi",
      "buckling_utilisation", 1000);
  const Words kg = stated_mass(s);
  const Words of = decimal("$u$, ");
  TablePanel table({Words{"check", "verifica"}.in(language), kg.in(language), "600 kg",
                    Words{"allowable", "ammissibile"}.in(language), (of + kg).in(language),
                    (of + Words{"600 kg", "600 kg"}).in(language)},
                   rows);
  const Words kept = does_not_hold(s).empty()
                         ? Words{"With ", "Con "} + kg + Words{" all checks hold.", " valgono tutte le verifiche."}
                         : Words{"With ", "Con "} + kg +
                               Words{" these checks do not hold: ", " non valgono le verifiche: "} +
                               does_not_hold(s) + Words{".", "."};
  const Words why{
      "The source states 300 kg, and everything it prints of the load is that of 600 kg: $\\it{P}$ = 5884 N is "
      "600·9.80665 N. It is twice what it states; recomputed so, each of its formulas agrees. A check holds when its "
      "utilisation $u$ is not above 1.",
      "La fonte dichiara 300 kg, e tutto ciò che stampa del carico è quello di 600 kg: $\\it{P}$ = 5884 N è "
      "600·9,80665 N. È il doppio di quanto dichiara; ricalcolata così, ognuna delle sue formule torna. Una verifica "
      "vale "
      "se il grado di utilizzo $u$ non supera 1."};
  return {.panels = panels(loaded_crane(s), std::move(table)),
          .theory = {{{"Both masses", "Le due masse"}, {remark(why.in(language))}}},
          .results = {remark(kept.in(language)), values({"P"}), value_as("$\\it{P}$ (600 kg)", with_600 + "P"),
                      asked_for},
          .seen = {"All checks of the crane, with the mass that is stated and with 600 kg",
                   "Tutte le verifiche della gru, con la massa dichiarata e con 600 kg"},
          .told = {"beam_static_utilisation", "beam_fatigue_utilisation", "column_static_utilisation",
                   "column_fatigue_utilisation", "buckling_utilisation"}};
}

}  // namespace epure::boat_crane
