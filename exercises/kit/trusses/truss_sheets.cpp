#include "exercises/kit/trusses/truss_sheets.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "exercises/kit/panels/force_plan_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/support_polygon_panel.h"
#include "exercises/kit/panels/table_panel.h"
#include "exercises/kit/panels/truss_panel.h"
#include "exercises/kit/trusses/truss_routes.h"

namespace epure::trusses {
namespace {

// "C3" is "C_{3}".
std::string letters_of(const std::string& name) {
  return name.size() == 1 ? name : name.substr(0, 1) + "_{" + name.substr(1) + "}";
}

std::shared_ptr<const TrussFigure> figure_of(const LoadedTruss& of, const Solution& s) {
  TrussFigure figure{.letters = {}, .bow = of.bow};
  for (const std::string& name : of.truss.names) figure.letters.push_back(letters_of(name));
  // From the hinge, wherever the axes of the joints are.
  const auto& A = of.truss.joints[of.hinge()];
  for (const auto& J : of.truss.joints)
    figure.joints.push_back({CGAL::to_double(J.x - A.x), CGAL::to_double(J.y - A.y)});
  for (std::size_t i = 0; i < of.bars(); ++i) {
    const std::string name = bar_force(i).name;
    figure.bars.push_back({of.truss.bars[i].from, of.truss.bars[i].to, s[name], name});
  }
  const VectorQuantity R_A = reaction_of_hinge(of);
  const std::string R_B = reaction_of_roller(of).name;
  figure.outside = {
      {of.hinge(), s.vector(R_A.name), R_A.arrow(), R_A.name},
      {of.roller_at(), s.vector("roller"), "$\\vec{\\it{R}}_{" + of.truss.names[of.roller_at()] + "}$", R_B}};
  for (std::size_t k = 0; k < of.loads.size(); ++k)
    figure.outside.push_back({of.loads[k].joint, s.vector("load_" + std::to_string(k)), of.loads[k].label, ""});
  for (std::size_t r = 0; r < of.bow.regions(); ++r) figure.plan.push_back(s.place("region_" + std::to_string(r)));
  figure.roller_down = to_double(of.roller) + std::numbers::pi;
  return std::make_shared<const TrussFigure>(std::move(figure));
}

// "+2500", "−1200": a number with a power of ten begins with the dollar sign of its letters.
std::string with_sign(double force, Language language) {
  const std::string number = figures(force, 4, language);
  if (force <= 0) return number;
  return number.starts_with('$') ? "$+" + number.substr(1) : "+" + number;
}

std::vector<Result> reactions_of(const LoadedTruss& of, const Solution& s, Language language) {
  const Quantity R_B = reaction_of_roller(of);
  std::vector<Result> all{components(reaction_of_hinge(of)), values({R_B.name})};
  if (s[R_B.name] < 0)
    all.push_back(remark(R_B.symbol + Words{" < 0: the roller is pulled from its plane, and must be held down to it.",
                                            " < 0: il carrello è tirato via dal suo piano, e vi va trattenuto."}
                                          .in(language)));
  return all;
}

std::vector<Result> results_of(const LoadedTruss& of, const Solution& s, Language language) {
  std::vector<Result> all = reactions_of(of, s, language);
  all.push_back(values({"N_max", "N_min"}));
  all.push_back(values({"sum_N_l"}));
  all.push_back(
      remark(Words{"$Σ\\it{N}l$ over the bars is $Σ\\vec{\\it{F}}$·$\\vec{r}$ over loads and reactions, $\\vec{r}$ "
                   "from any one point (Maxwell): a check of the plan.",
                   "$Σ\\it{N}l$ sulle aste è $Σ\\vec{\\it{F}}$·$\\vec{r}$ su carichi e reazioni, $\\vec{r}$ da un "
                   "punto qualsiasi (Maxwell): controlla il diagramma."}
                 .in(language)));
  for (const Load& load : of.loads)
    if (load.is_told) all.push_back(components(load_at(of, load)));
  return all;
}

PanelSheet reactions_sheet(const LoadedTruss& of, const Solution& s, Language language) {
  const auto figure = figure_of(of, s);
  const FunicularOfLoads funicular = funicular_of_loads(*figure);
  TrussPanel on_truss(figure, TrussPanel::Regions::without_letters);
  on_truss.strings(funicular);
  const VectorQuantity R_A = reaction_of_hinge(of);
  return {.panels = panels(SupportPolygonPanel(figure, funicular), on_truss),
          .results = reactions_of(of, s, language),
          .seen = {"The loads end to end with pole and rays, and the truss with the funicular polygon that closes in "
                   "its hinge",
                   "I carichi uno dopo l'altro con polo e raggi, e la travatura con il poligono funicolare che si "
                   "chiude nella cerniera"},
          .told = {R_A.x().name, R_A.y().name, reaction_of_roller(of).name}};
}

PanelSheet plan_sheet(const LoadedTruss& of, const Solution& s, Language language) {
  const auto figure = figure_of(of, s);
  const VectorQuantity R_A = reaction_of_hinge(of);
  const Words senses{
      "Going clockwise round a joint, the plan gives the sense of each force on it: towards the joint is compression "
      "(heavy, −), away from it tension (thin, +); dashed bars bear nothing.",
      "Girando in senso orario attorno a un nodo, il diagramma dà il verso di ogni forza su di esso: verso il nodo è "
      "compressione (linea grossa, −), dal nodo trazione (sottile, +); le aste tratteggiate sono scariche."};
  return {
      .panels = panels(TrussPanel(figure, TrussPanel::Regions::lettered), ForcePlanPanel(figure)),
      .theory = {{{"Senses", "Versi"}, {remark(senses.in(language))}}},
      .results = results_of(of, s, language),
      .seen =
          {"The truss with its loads and reactions and the regions between them lettered, and Cremona's plan",
           "La travatura con carichi e reazioni e le regioni tra di essi distinte da lettere, e il piano di Cremona"},
      .told = {R_A.x().name, R_A.y().name, reaction_of_roller(of).name, "N_max", "N_min"}};
}

PanelSheet forces_sheet(const LoadedTruss& of, const Solution& s, Language language) {
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
      cells[row].insert(cells[row].end(),
                        {std::to_string(i + 1) + " $" + figure->letters[bar.from] + figure->letters[bar.to] + "$",
                         figures(s[bar_length(i).name], 4, language), with_sign(bar.force, language)});
    }
  }
  const Words signs{"Heavy and −: compression. Thin and +: tension. Dashed: the bar carries nothing.",
                    "Linea grossa e −: compressione. Sottile e +: trazione. Tratteggiata: asta scarica."};
  return {.panels = panels(TrussPanel(figure, TrussPanel::Regions::without_letters), TablePanel(heads, cells)),
          .theory = {{{"Senses", "Versi"}, {remark(signs.in(language))}}},
          .results = results_of(of, s, language),
          .seen = {"The truss, its bars drawn by what they bear, and a table of their forces",
                   "La travatura, le aste disegnate secondo lo sforzo, e la tabella degli sforzi"},
          .told = {"N_max", "N_min"}};
}

}  // namespace

std::unique_ptr<Exercise> exercise_of_truss(Description about, std::size_t most_bars, const TrussOf& truss,
                                            const WithoutPart& without_part) {
  about.question = {
      "Find the reactions of the truss and the forces in its bars by Cremona's plan: which bars are in tension, "
      "which in compression, and which carry nothing?",
      "Trovare le reazioni della travatura e le forze nelle aste con il diagramma di Cremona: quali aste sono tese, "
      "quali compresse e quali scariche?"};
  const auto solve = [=](const Givens& givens, Rung rung) { return settle(Routes{truss(givens), most_bars}, rung); };
  const auto made = [=](PanelSheet (*make)(const LoadedTruss&, const Solution&, Language)) {
    return [=](const Solution& s, Language language) {
      PanelSheet sheet = make(truss(s.givens()), s, language);
      sheet.without_part = without_part(s.givens());
      return sheet;
    };
  };
  return exercise_of_panels(std::move(about), solve,
                            {{{"reactions", {"Reactions", "Reazioni vincolari"}}, made(reactions_sheet)},
                             {{"plan", {"Cremona's plan", "Diagramma cremoniano"}}, made(plan_sheet)},
                             {{"forces", {"Forces of the bars", "Sforzi nelle aste"}}, made(forces_sheet)}});
}

}  // namespace epure::trusses
