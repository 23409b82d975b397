#include "exercises/cli/kept_inputs.h"

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/scene_exercise.h"

namespace epure {

void demand_not_read(const std::filesystem::path& written, const Options& options) {
  std::vector<std::string> read;
  for (const std::string& name : options.names) {
    const auto scene = scenes::scene_name(name);
    read.push_back(scene ? scene->file : name);
  }
  for (const auto& file : {options.answers, options.key, options.givens_file, options.class_set.students})
    if (file) read.push_back(*file);
  for (const std::string& each : read) {
    std::error_code is_none;  // of a path that leads to no file
    if (!std::filesystem::is_regular_file(each, is_none) || !std::filesystem::equivalent(each, written, is_none))
      continue;
    throw WrongUsage(format_words("{} is read by this command, which would write over it; choose another name",
                                  "{} è letto da questo comando, che ci scriverebbe sopra; scegliere un altro nome",
                                  written.string()));
  }
}

}  // namespace epure
