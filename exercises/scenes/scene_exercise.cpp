#include "exercises/scenes/scene_exercise.h"

#include <algorithm>
#include <utility>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/limits.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/forces/force_sheets.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/acceleration_pole_sheets.h"
#include "exercises/scenes/sheets/centres_sheets.h"
#include "exercises/scenes/sheets/chart_sheets.h"
#include "exercises/scenes/sheets/diagram_sheets.h"
#include "exercises/scenes/sheets/legend.h"
#include "exercises/scenes/sheets/path_sheets.h"
#include "exercises/scenes/sheets/polode_sheets.h"
#include "exercises/scenes/sheets/polygon_sheets.h"
#include "exercises/scenes/sheets/range_sheets.h"
#include "exercises/scenes/shipped.h"

namespace epure::scenes {
namespace {

std::vector<RouteValue> solved(const Scene& scene, const Givens& givens, Rung rung) {
  const auto built = std::make_shared<const Built>(scene.built(givens));
  try {
    if (rung != Rung::names && rung != Rung::fast)
      for (const auto& refusal : {limit_of, no_forces_with_friction})
        if (const auto why = refusal(*built)) throw BadGivens(*why);
    std::vector<RouteValue> all = by_both_routes(built, route_plan(*built), rung);
    for (RouteValue& each : extremes(*built, scene.extremes(), rung)) all.push_back(std::move(each));
    return all;
  } catch (const geometry::NotClosed& open) {
    throw BadGivens(
        format_words("the mechanism does not close: {}", "il meccanismo non si chiude: {}", in_words(open, *built)));
  }
}

std::vector<Quantity> quantities_of(const Scene& scene) {
  std::vector<Quantity> all;
  for (const RouteValue& each : solved(scene, Givens(scene.givens()), Rung::names))
    if (each.described) all.push_back(*each.described);
  return all;
}

// Its letters are explained in full where the scene begins.
void add_legends(std::vector<SheetMaker>& sheets, const std::shared_ptr<const Scene>& scene,
                 const SheetNumbers& numbers) {
  for (std::size_t i = 0; i < sheets.size(); ++i)
    sheets[i].make = [scene, make = std::move(sheets[i].make),
                      first = i == 0 ? Words{} : numbers.of(sheets[0].spec.name)](const Solution& s,
                                                                                  Language language) {
      PanelSheet sheet = make(s, language);
      sheet.legend = legend_of(*scene, first, language);
      return sheet;
    };
}

Words question(const Scene& scene) {
  const Words motion{
      "Find the velocities and accelerations of all points, and the angular velocities and accelerations of all "
      "links.",
      "Trovare velocità e accelerazioni di tutti i punti, e velocità e accelerazioni angolari di tutti i membri."};
  if (!scene.built(Givens(scene.givens())).loads) return motion;
  if (!scene.built(Givens(scene.givens())).loads->masses.empty())
    return motion + Words{
                        " Find the reactions of all joints under loads, weights and inertia forces, and what the "
                        "drives must provide.",
                        " Trovare le reazioni di tutti i vincoli sotto carichi, pesi e forze d'inerzia, e quanto "
                        "devono dare i moventi."};
  return motion + Words{" Find the reactions of all joints under the loads, and what the drives must provide.",
                        " Trovare le reazioni di tutti i vincoli sotto i carichi, e quanto devono dare i moventi."};
}

Description described(const std::shared_ptr<const Scene>& scene) {
  return {.id = scene->id(),
          .title = escaped(scene->title()),
          .document = "scene",
          .item = scene->id(),
          .source = escaped(scene->source()),
          .question = question(*scene),
          .givens = scene->givens(),
          .also_given = [scene](const Givens& givens) { return scene->built(givens).in_place; },
          .printed = [printed = scene->printed()] { return printed; }};
}

}  // namespace

std::optional<SceneName> scene_name(const std::string& name) {
  for (const std::string ending : {".yaml", ".yml"})
    if (const auto place = name.rfind(ending + "/"); place != std::string::npos) {
      const std::size_t slash = place + ending.size();
      return SceneName{name.substr(0, slash), name.substr(slash)};
    }
  if (name.ends_with(".yaml") || name.ends_with(".yml")) return SceneName{name, ""};
  const std::string piped = standard_input;
  if (name == "-" || name == piped) return SceneName{piped, ""};
  if (name.starts_with(piped + "/")) return SceneName{piped, name.substr(piped.size())};
  const std::size_t slash = std::min(name.find('/'), name.size());
  if (shipped_scene(name.substr(0, slash))) return SceneName{name.substr(0, slash), name.substr(slash)};
  return {};
}

std::unique_ptr<Exercise> scene_exercise(const std::shared_ptr<const Scene>& scene) {
  const std::vector<Quantity> known = quantities_of(*scene);
  scene->demand_one_meaning(known);
  const auto solve = [scene](const Givens& givens, Rung rung) { return solved(*scene, givens, rung); };
  const SheetNumbers numbers;
  std::vector<SheetMaker> sheets = diagram_sheets(scene, numbers);
  for (SheetMaker& sheet : polygon_sheets(scene, numbers)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : acceleration_pole_sheets(scene)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : centres_sheets(scene, numbers)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : force_sheets(scene, numbers)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : path_sheets(scene)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : polode_sheets(scene)) sheets.push_back(std::move(sheet));
  for (SheetMaker& sheet : range_sheets(scene)) sheets.push_back(std::move(sheet));
  if (!scene->charts().empty())
    for (SheetMaker& sheet : chart_sheets(scene, known)) sheets.push_back(std::move(sheet));
  std::vector<std::string> names;
  for (const SheetMaker& sheet : sheets) names.push_back(sheet.spec.name);
  std::vector<SheetMaker> chosen;
  for (const std::size_t i : scene->chosen_sheets(names)) chosen.push_back(std::move(sheets[i]));
  names.clear();
  for (const SheetMaker& sheet : chosen) names.push_back(sheet.spec.name);
  numbers.are_of(names);
  add_legends(chosen, scene, numbers);
  auto exercise = exercise_of_panels(described(scene), solve, std::move(chosen));
  scene->demand_printed(exercise->about().quantities());
  return exercise;
}

}  // namespace epure::scenes
