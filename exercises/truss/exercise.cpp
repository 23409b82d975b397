// Trusses with pin joints by Cremona's reciprocal figure: the shape, the loads and the supports are the user's. One
// of other joints and bars comes from a file (docs/scenes.md).
#include "exercises/kit/trusses/truss_sheets.h"
#include "exercises/truss/given_truss.h"

namespace epure {
namespace truss {
namespace {

std::set<std::string> without_part(const Givens& givens) {
  std::set<std::string> all;
  if (!has_panels(shape_of(givens))) all.insert("n");
  if (givens.angle("delta").turns == 0 && givens.angle("delta").radians == 0) all.insert("delta");
  if (givens["W"] == 0) all.merge(std::set<std::string>{"W", "beta"});
  return all;
}

}  // namespace
}  // namespace truss

std::unique_ptr<Exercise> make_truss() {
  Description about{.id = "truss",
                    .title = {"A truss by Cremona's plan", "Travatura reticolare con il diagramma di Cremona"},
                    .document = "epure",
                    .item = "trusses",
                    .source = {"epure, trusses", "epure, travature reticolari"},
                    .question = {},  // that of all trusses
                    .givens = truss::given_specs()};
  return trusses::exercise_of_truss(std::move(about), truss::most_bars, truss::given_truss, truss::without_part);
}

}  // namespace epure
