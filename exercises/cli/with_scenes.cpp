#include "exercises/cli/with_scenes.h"

#include <algorithm>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/scene_exercise.h"

namespace epure {
namespace {

// "path/ID.yaml/SHEET": the file, and what follows it, "/SHEET".
std::pair<std::string, std::string> file_and_sheet(const std::string& name) {
  for (const char* ending : {".yaml/", ".yml/"})
    if (const auto place = name.rfind(ending); place != std::string::npos) {
      const auto slash = name.find('/', place);
      return {name.substr(0, slash), name.substr(slash)};
    }
  return {name, ""};
}

}  // namespace

bool names_scenes(const Options& options) {
  return std::any_of(options.names.begin(), options.names.end(), scenes::is_scene_file);
}

Scenes read_scenes(const Options& options) {
  Scenes read{{}, options};
  std::vector<std::pair<std::string, std::string>> known;  // file, id
  for (std::string& name : read.options.names) {
    if (!scenes::is_scene_file(name))
      throw WrongUsage(format_words("\"{}\" stands beside a file; name files alone, or exercises alone",
                                    "\"{}\" sta accanto a un file; nominare solo file, o solo esercizi", name));
    const auto parts = file_and_sheet(name);
    const std::string &file = parts.first, &sheet = parts.second;
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
    name = found->second + sheet;
  }
  return read;
}

}  // namespace epure
