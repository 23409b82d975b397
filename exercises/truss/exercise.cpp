// Trusses with pin joints by Cremona's reciprocal figure: the shape, the loads and the supports are the user's.
#include <algorithm>
#include <numbers>

#include "exercises/kit/panels/force_plan_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/table_panel.h"
#include "exercises/kit/panels/truss_panel.h"
#include "exercises/truss/routes.h"

namespace epure {
namespace truss {
namespace {

std::shared_ptr<const TrussFigure> figure_of(const LoadedTruss& of, const Solution& s) {
  TrussFigure figure{.bow = of.bow};
  for (const auto& J : of.truss.joints) figure.joints.push_back({CGAL::to_double(J.x), CGAL::to_double(J.y)});
  for (std::size_t i = 0; i < of.bars(); ++i) {
    const std::string name = bar_force(i).name;
    figure.bars.push_back({of.truss.bars[i].from, of.truss.bars[i].to, s[name], name});
  }
  figure.outside = {{0, s.vector("R_A"), reaction_of_hinge().arrow(), "R_A"},
                    {1, s.vector("roller"), "$\\vec{\\it{R}}_{B}$", "R_B"}};
  for (std::size_t k = 0; k < of.loads(); ++k) {
    const std::string label = !of.has_W[k]   ? "$\\it{P}$"
                              : !of.has_P[k] ? "$\\it{W}$"
                                             : "$\\vec{\\it{P}}$+$\\vec{\\it{W}}$";
    figure.outside.push_back({of.truss.outside[k + 2], s.vector("load_" + std::to_string(k)), label, ""});
  }
  for (std::size_t r = 0; r < of.bow.regions(); ++r) figure.plan.push_back(s.place("region_" + std::to_string(r)));
  constexpr double quarter = std::numbers::pi / 2;
  figure.hinge_down = stands_on_wall(of.shape) ? 2 * quarter : -quarter;
  figure.roller_down = to_double(of.roller) + 2 * quarter;
  return std::make_shared<const TrussFigure>(std::move(figure));
}

std::set<std::string> without_part(const LoadedTruss& of) {
  std::set<std::string> all;
  if (!has_panels(of.shape)) all.insert("n");
  if (of.W == 0) all.merge(std::set<std::string>{"W", "beta"});
  return all;
}

// "+2500", "−1200": a number with a power of ten begins with the dollar sign of its letters.
std::string with_sign(double force, Language language) {
  const std::string number = figures(force, 4, language);
  if (force <= 0) return number;
  return number.starts_with('$') ? "$+" + number.substr(1) : "+" + number;
}

PanelSheet plan_sheet(const Solution& s, Language language) {
  const LoadedTruss of(s.givens());
  const auto figure = figure_of(of, s);
  const Words senses{
      "Going clockwise round a joint, the plan gives the sense of each force on it: towards the joint is compression "
      "(heavy, −), away from it tension (thin, +); dashed bars bear nothing.",
      "Girando in senso orario attorno a un nodo, il piano dà il verso di ogni forza su di esso: verso il nodo è "
      "compressione (linea grossa, −), dal nodo trazione (sottile, +); le aste tratteggiate sono scariche."};
  return {
      .panels = panels(TrussPanel(figure, TrussPanel::Regions::lettered), ForcePlanPanel(figure)),
      .theory = {{{"Senses", "Versi"}, {remark(senses.in(language))}}},
      .results = {components(reaction_of_hinge()), values({"R_B"}), values({"N_max", "N_min"}), values({"sum_N_l"})},
      .seen = {"The truss with its loads and reactions and the regions between them lettered, and Cremona's plan",
               "La travatura con carichi e reazioni e le regioni tra di essi distinte da lettere, e il piano di "
               "Cremona"},
      .told = {"R_A_x", "R_A_y", "R_B", "N_max", "N_min"},
      .without_part = without_part(of)};
}

PanelSheet forces_sheet(const Solution& s, Language language) {
  const LoadedTruss of(s.givens());
  const auto figure = figure_of(of, s);
  // Side by side, so that the truss keeps the greater part of the sheet; no more than it is wide.
  constexpr std::size_t most_rows = 10, most_blocks = 3;
  const std::size_t blocks = std::min(most_blocks, (of.bars() + most_rows - 1) / most_rows),
                    rows = (of.bars() + blocks - 1) / blocks;
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> cells(rows);
  for (std::size_t b = 0; b < blocks; ++b) {
    for (const std::string& head :
         {Words{"bar", "asta"}.in(language), std::string("$l$ (m)"), std::string("$\\it{N}$ (N)")})
      heads.push_back(head);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t i = b * rows + row;
      if (i >= of.bars()) {
        cells[row].insert(cells[row].end(), 3, "");
        continue;
      }
      const TrussFigure::Bar& bar = figure->bars[i];
      cells[row].insert(
          cells[row].end(),
          {std::to_string(i + 1) + " " + TrussFigure::joint_letter(bar.from) + TrussFigure::joint_letter(bar.to),
           figures(s[bar_length(i).name], 4, language), with_sign(bar.force, language)});
    }
  }
  const Words signs{"Heavy and −: compression. Thin and +: tension. Dashed: the bar carries nothing.",
                    "Linea grossa e −: compressione. Sottile e +: trazione. Tratteggiata: asta scarica."};
  return {
      .panels = panels(TrussPanel(figure, TrussPanel::Regions::without_letters), TablePanel(heads, cells)),
      .theory = {{{"Senses", "Versi"}, {remark(signs.in(language))}}},
      .results = {components(reaction_of_hinge()), values({"R_B"}), values({"N_max", "N_min"}), values({"sum_N_l"})},
      .seen = {"The truss, its bars drawn by what they bear, and a table of their forces",
               "La travatura, le aste disegnate secondo lo sforzo, e la tabella degli sforzi"},
      .told = {"N_max", "N_min"},
      .without_part = without_part(of)};
}

}  // namespace
}  // namespace truss

std::unique_ptr<Exercise> make_truss() {
  using namespace truss;
  Description about{.id = "truss",
                    .title = {"A truss by Cremona's plan", "Travatura reticolare con il piano di Cremona"},
                    .document = "epure",
                    .item = "trusses",
                    .source = {"epure, trusses", "epure, travature reticolari"},
                    .question = {"Find the reactions of the truss and the forces in its bars by Cremona's plan: "
                                 "which bars are in tension, which in compression, and which carry nothing?",
                                 "Trovare le reazioni della travatura e le forze nelle aste con il piano di Cremona: "
                                 "quali aste sono tese, quali compresse e quali scariche?"},
                    .givens = given_specs()};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{LoadedTruss(givens)}, rung); };
  return exercise_of_panels(std::move(about), solve,
                            {{{"plan", {"Cremona's plan", "Piano di Cremona"}}, plan_sheet},
                             {{"forces", {"Forces of the bars", "Sforzi nelle aste"}}, forces_sheet}});
}

}  // namespace epure
