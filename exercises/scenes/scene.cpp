#include "exercises/scenes/scene.h"

#include <algorithm>
#include <map>

#include "drawings/text/text.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/file/sections.h"
#include "exercises/scenes/range_of_drive.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Kind = geometry::Kind;
using Tree = TextTree;

// Capitals upright are points, and two of them a length: these are italic.
bool is_of_mass(Kind kind) {
  return kind == Kind::force || kind == Kind::moment || kind == Kind::mass || kind == Kind::moment_of_inertia;
}

Built built_of(FileReading reading) {
  read_numbers(reading);
  read_links(reading);
  demand_names_of_points(reading);
  read_joints(reading);
  read_drives(reading);
  read_questions(reading);
  read_loads(reading);
  read_friction(reading);
  place_links(reading);
  return std::move(reading.built);
}

// charts: [omega_4, [v_B, v_C]].
std::vector<std::vector<std::string>> read_charts(const File& file, const Tree& all) {
  const Words what{
      "charts: [omega_4, [v_B, v_C]], quantities over all places of the drive, a chart each or together",
      "charts: [omega_4, [v_B, v_C]], grandezze in tutte le posizioni del movente, un grafico ciascuna o insieme"};
  file.demand(all, Tree::Kind::list, what);
  std::vector<std::vector<std::string>> charts;
  for (const Tree& item : all.items) {
    std::vector<std::string> names;
    if (item.kind == Tree::Kind::list)
      for (const Tree& each : item.items) names.push_back(spelled_out(file.text(each, what)));
    else
      names.push_back(spelled_out(file.text(item, what)));
    if (names.empty()) file.refuse(item, what);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
          names.begin() + static_cast<std::ptrdiff_t>(i))
        file.refuse(item, format_words("{} stands here twice", "{} sta qui due volte", names[i]));
    if (std::find(charts.begin(), charts.end(), names) != charts.end())
      file.refuse(item, {"this chart stands here twice", "questo grafico sta qui due volte"});
    charts.push_back(std::move(names));
  }
  return charts;
}

// A chart has one axis, and that ends.
void demand_one_way(const File& file, const Tree& at, const Built& built) {
  if (built.linkage.drives.size() != 1)
    file.refuse(
        at, format_words("with {} drives there is no one way to chart over",
                         "con {} moventi non c'è un solo moto su cui fare il grafico", built.linkage.drives.size()));
  try {
    EveryPlace(built.linkage, built.steps);
  } catch (const Impossible& endless) {
    file.refuse(at, endless.words());
  }
}

// Of what no extremes are told.
[[noreturn]] void refuse_extreme(const File& file, const Tree& item, const std::string& name, const Built& built,
                                 const std::vector<std::string>& known) {
  const auto* turned = std::get_if<TurnedLink>(&built.linkage.drives.front());
  std::vector<std::string> sets;
  for (const Quantity& coordinate : driven_coordinates(built)) sets.push_back(coordinate.name);
  const Words range = format_words("how far a drive goes ({})", "fin dove va un movente ({})", enumerated(sets));
  if (built.linkage.drives.size() > 1 || !turned)
    file.refuse(item,
                format_words("of a mechanism that no single turned link drives extremes are told of {}: not of "
                             "\"{}\"; {}",
                             "di un meccanismo che non è mosso da un solo membro girato gli estremi si dicono di "
                             "{}: non di \"{}\"; {}",
                             range, name, did_you_mean(name, known)));
  file.refuse(item, format_words("this mechanism has no sheet \"{}\"; {}",
                                 "questo meccanismo non ha la tavola \"{}\"; {}", name, did_you_mean(name, names)));
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (std::find(chosen.begin(), chosen.end(), place) != chosen.end())
    file.refuse(item, format_words("the sheet \"{}\" stands here twice", "la tavola \"{}\" sta qui due volte", name));
  chosen.push_back(place);
}
return chosen;
}  // namespace

// Where forces are asked for the links stand in the order in which they are placed, so that the first of those at a
// point, which carries its pin, is there before the others.
Built Scene::built(const Givens& givens) const {
  const File file(file_);
  Built built = built_of(FileReading(file, root_, givens));
  if (!built.loads) return built;
  std::vector<int> order{1};
  for (const Step& step : built.steps)
    for (const int link : placed_by(step)) order.push_back(built.letters.links[index(link)]);
  if (order == built.letters.links) return built;
  return built_of(FileReading(file, root_, givens, order));
}

}  // namespace epure::scenes
