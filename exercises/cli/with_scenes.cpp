#include "exercises/cli/with_scenes.h"

#include <algorithm>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/scene_exercise.h"

namespace epure {

bool names_scenes(const Options& options) {
  return std::any_of(options.names.begin(), options.names.end(),
                     [](const std::string& name) { return scenes::scene_name(name).has_value(); });
}

Scenes read_scenes(const Options& options) {
  Scenes read{{}, options};
  std::vector<std::pair<std::string, std::string>> known;  // file, id
  for (std::string& name : read.options.names) {
    const auto scene = scenes::scene_name(name);
    if (!scene)
      throw WrongUsage(format_words("\"{}\" stands beside a file; name files alone, or exercises alone",
                                    "\"{}\" sta accanto a un file; nominare solo file, o solo esercizi", name));
    const std::string& file = scene->file;
    auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == file; });
    if (found == known.end()) {
      std::unique_ptr<Exercise> exercise = scenes::scene_exercise(file);
      const std::string id = exercise->about().id;
      if (std::any_of(known.begin(), known.end(), [&](const auto& k) { return k.second == id; }))
        throw WrongUsage(format_words("two files have the id {}; their drawings would be one file",
                                      "due file hanno l'id {}; i loro disegni sarebbero un solo file", id));
      read.exercises.emplace_back(std::move(exercise));
      found = known.insert(known.end(), {file, id});
    }
    name = found->second + scene->sheet;
  }
  return read;
}

}  // namespace epure
