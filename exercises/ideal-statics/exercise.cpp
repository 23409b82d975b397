// N.4 of Sapienza's exercises: ideal mechanisms in equilibrium, by force polygons and by virtual work.
#include "exercises/ideal-statics/exercise.h"
#include "exercises/ideal-statics/sheets.h"
#include "exercises/kit/linkages/loaded_mechanisms.h"

namespace epure {

std::unique_ptr<Exercise> make_ideal_statics() {
  using namespace ideal_statics;
  Description about{
      .id = "ideal-statics",
      .title = {"Statics of ideal mechanisms", "Statica di meccanismi ideali"},
      .document = "sapienza",
      .item = "N.4",
      .source = {"Sapienza, exercises in applied mechanics, N.4",
                 "Sapienza, Esercitazioni di Meccanica Applicata, N.4"},
      .question =
          {"The mechanisms have no friction. Find the force (or couple) that balances the load and all reactions by "
           "cutting the bodies free and drawing force polygons; then the same force by virtual work.",
           "I meccanismi sono senza attrito. Trovare la forza (o la coppia) che equilibra il carico e tutte le "
           "reazioni, isolando i corpi e disegnando i poligoni delle forze; poi la stessa forza con i lavori "
           "virtuali."},
      .givens = givens_of_loaded_mechanisms(),
      .printed = printed_by_the_source};
  std::vector<SheetMaker> sheets;
  for (const auto& of_one : {wedge_sheets(), double_slider_sheets(), lever_sheets(), fairbairn_sheets()})
    sheets.insert(sheets.end(), of_one.begin(), of_one.end());
  return exercise_of_panels(std::move(about), solve, std::move(sheets));
}

}  // namespace epure
