// The verb that makes a mechanism's file of what other programs have.
#include <filesystem>

#include "drawings/output.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/import/drawn_linkage.h"

namespace epure {

Outcome import_text(const Options& options) {
  language(options);
  if (options.names.size() != 1)
    throw WrongUsage("say what to import: an expression of pyslvs or a share link of PMKS+, in quotes, or a file",
                     "dire che cosa importare: un'espressione di pyslvs o un collegamento di PMKS+, tra apici, o un "
                     "file");
  const std::filesystem::path path = options.file.value_or("-");
  const std::string name = path.stem().string();
  scenes::Imported made = scenes::import_scene(options.names.front(), scenes::is_id(name) ? name : "imported");
  Outcome outcome{.text = std::move(made.scene), .notes = std::move(made.notes)};
  if (!options.file || is_standard_output(options)) return outcome;
  drawings::write_whole(path, outcome.text);
  outcome.text = shown_whole(path.string()) + "\n";
  return outcome;
}

}  // namespace epure
