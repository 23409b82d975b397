#include "exercises/scenes/scene_exercise.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "drawings/text/text.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/vectors_panel.h"
#include "exercises/scenes/scene_figure.h"
#include "exercises/scenes/scene_routes.h"

namespace epure::scenes {
namespace {

std::string bytes_of(const std::string& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown))
    throw BadScene(format_words("{}: there is no such file", "{}: non c'è un file così", file));
  if (!std::filesystem::is_regular_file(file, unknown))
    throw BadScene(format_words("{}: this is no file to be read, but a folder or a device",
                                "{}: non è un file da leggere, ma una cartella o un dispositivo", file));
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw BadScene(format_words("{}: the file cannot be read", "{}: il file non si può leggere", file));
  return std::move(bytes).str();
}

std::vector<RouteValue> solved(const Scene& scene, const Givens& givens, Rung rung) {
  try {
    return settle(SceneRoutes{std::make_shared<const Built>(scene.built(givens))}, rung);
  } catch (const geometry::Impossible& open) {
    throw BadGivens(
        format_words("the mechanism does not close: {}", "il meccanismo non si chiude: {}", open.words()));
  }
}

PanelSheet diagram(const Scene& scene, const Solution& s, VectorQuantity (*vector)(const std::string&)) {
  const Built built = scene.built(s.givens());
  PanelSheet sheet;
  std::vector<std::string> moving;
  for (const std::string& name : moving_points(built)) {
    if (s.value(vector(name).name)) moving.push_back(name);
    sheet.results.push_back(components(vector(name)));
  }
  sheet.panels = panels(VectorsPanel(s, figure_of(built, s), vector, moving));
  return sheet;
}

// What a file says is text, not markup.
Words escaped(const Words& words) { return {drawings::escaped(words.english), drawings::escaped(words.italian)}; }

Description described(const Scene& scene) {
  return {
      .id = scene.id(),
      .title = escaped(scene.title()),
      .document = "scene",
      .item = scene.id(),
      .source = escaped(scene.source()),
      .question = {"Find the velocities and accelerations of all points, and the angular velocities and "
                   "accelerations of all links.",
                   "Trovare velocità e accelerazioni di tutti i punti, e velocità e accelerazioni angolari di tutti "
                   "i membri."},
      .givens = scene.givens()};
}

}  // namespace

std::optional<SceneName> scene_name(const std::string& name) {
  for (const std::string ending : {".yaml", ".yml"})
    if (const auto place = name.rfind(ending + "/"); place != std::string::npos) {
      const std::size_t slash = place + ending.size();
      return SceneName{name.substr(0, slash), name.substr(slash)};
    }
  if (name.ends_with(".yaml") || name.ends_with(".yml")) return SceneName{name, ""};
  return {};
}

std::unique_ptr<Exercise> scene_exercise(const std::string& file) {
  return scene_exercise(std::make_shared<const Scene>(file, bytes_of(file)));
}

std::unique_ptr<Exercise> scene_exercise(const std::shared_ptr<const Scene>& scene) {
  const auto solve = [scene](const Givens& givens, Rung rung) { return solved(*scene, givens, rung); };
  return exercise_of_panels(described(*scene), solve,
                            {{{"velocities", {"Velocities", "Velocità"}},
                              [scene](const Solution& s, Language) { return diagram(*scene, s, velocity); }},
                             {{"accelerations", {"Accelerations", "Accelerazioni"}},
                              [scene](const Solution& s, Language) { return diagram(*scene, s, acceleration); }}});
}

}  // namespace epure::scenes
