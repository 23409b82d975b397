#include "exercises/cli/with_scenes.h"

#include <algorithm>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/coincidences.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/truss_file.h"
#include "exercises/scenes/scene_exercise.h"

namespace epure {

namespace {

// In the name of the file, which is what was typed.
void demand_sheet(const Exercise& exercise, const std::string& file, const std::string& sheet) {
  std::vector<std::string> names;
  for (const SheetSpec& spec : exercise.about().sheets) names.push_back(spec.name);
  if (std::find(names.begin(), names.end(), sheet) == names.end())
    throw WrongUsage(format_words("{} has no sheet \"{}\"; {}", "{} non ha la tavola \"{}\"; {}", file, sheet,
                                  did_you_mean(sheet, names)));
}

constexpr const char* all_shipped = "scenes";

// With each that is shipped in its place.
std::vector<std::string> each_named(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names)
    if (name != all_shipped)
      all.push_back(name);
    else
      for (const std::string& id : scenes::shipped_ids()) all.push_back(id);
  return all;
}

}  // namespace

bool names_scenes(const Options& options) {
  return std::any_of(options.names.begin(), options.names.end(),
                     [](const std::string& name) { return name == all_shipped || scenes::scene_name(name); });
}

Scenes read_scenes(const Options& options) {
  Scenes read{.exercises = {}, .options = options};
  read.options.names = each_named(options.names);
  std::vector<std::pair<std::string, std::string>> known;  // file, id
  for (std::string& name : read.options.names) {
    const auto scene = scenes::scene_name(name);
    if (!scene)
      throw WrongUsage(
          format_words("\"{}\" stands beside a mechanism from a file; name such mechanisms alone, or "
                       "exercises alone",
                       "\"{}\" sta accanto a un meccanismo da un file; nominare solo meccanismi da "
                       "file, o solo esercizi",
                       name));
    const std::string& file = scene->file;
    auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == file; });
    if (found == known.end()) {
      const std::string bytes = scenes::bytes_of(file);
      read.options.mechanisms += bytes;
      std::unique_ptr<Exercise> exercise = scenes::truss_of_text(file, bytes);
      read.files.push_back(exercise ? nullptr : std::make_shared<const scenes::Scene>(file, bytes));
      if (!exercise) exercise = scenes::scene_exercise(read.files.back());
      const std::string id = exercise->about().id;
      if (std::any_of(known.begin(), known.end(), [&](const auto& k) { return k.second == id; }))
        throw WrongUsage(format_words("two files have the id {}; give each its own",
                                      "due file hanno l'id {}; darne uno proprio a ciascuno", id));
      read.exercises.emplace_back(std::move(exercise));
      found = known.insert(known.end(), {file, id});
    }
    if (!scene->sheet.empty())
      demand_sheet(*read.exercises[static_cast<std::size_t>(found - known.begin())], file, scene->sheet.substr(1));
    name = found->second + scene->sheet;
  }
  if (options.verb == Options::Verb::list && options.names == std::vector<std::string>{all_shipped})
    read.options.names = {"all"};
  return read;
}

std::vector<Words> remarks(const Scenes& read) {
  std::vector<const Exercise*> exercises;
  for (const Listed& each : read.exercises) exercises.push_back(&*each);
  const std::vector<Givens> givens = set_givens(exercises, read.options.assignments);
  std::vector<Words> all;
  for (std::size_t i = 0; i < givens.size(); ++i) {
    if (!read.files[i]) continue;
    for (const Words& each : scenes::coincidences(read.files[i]->built(givens[i])))
      all.push_back(read.files[i]->id() + ": " + each);
  }
  return all;
}

}  // namespace epure
