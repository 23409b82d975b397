#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "drawings/output.h"
#include "drawings/text.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"

namespace epure {
namespace {

struct File {
  std::filesystem::path path;
  std::string bytes;
};

struct DrawnTarget {
  Target target;
  std::vector<drawings::Sheet> sheets;
};

std::vector<DrawnTarget> draw_sheets(const std::vector<Target>& targets, const Options& options) {
  std::vector<const Exercise*> exercises;
  for (const Target& target : targets)
    if (std::find(exercises.begin(), exercises.end(), target.exercise) == exercises.end())
      exercises.push_back(target.exercise);
  const std::vector<Givens> givens = set_givens(exercises, options.assignments);
  const SheetRequest request = sheet_request(options);
  std::vector<DrawnTarget> drawn;
  for (const Target& target : targets) {
    const auto of = std::find(exercises.begin(), exercises.end(), target.exercise) - exercises.begin();
    DrawnTarget& current = drawn.emplace_back(DrawnTarget{target, {}});
    for (const std::string& sheet : target.sheets())
      current.sheets.push_back(target.exercise->draw(sheet, givens[static_cast<std::size_t>(of)], request).sheet);
  }
  return drawn;
}

std::string title(const std::vector<DrawnTarget>& drawn, const Options& options) {
  const bool one_exercise = std::all_of(drawn.begin(), drawn.end(), [&](const DrawnTarget& each) {
    return each.target.exercise == drawn.front().target.exercise;
  });
  return one_exercise ? drawings::plain(drawn.front().target.exercise->about().title.in(language(options))) : "Epure";
}

// ID.pdf and ID-SHEET.svg, or ID-SHEET.pdf and ID-SHEET.svg; a file asked for twice is made once.
std::vector<File> files_in_folder(const std::vector<DrawnTarget>& drawn, const Options& options) {
  const std::filesystem::path folder = options.folder.value_or("out");
  const std::vector<Format> formats = formats_of(options);
  std::vector<File> files;
  std::set<std::filesystem::path> seen;
  for (const DrawnTarget& each : drawn) {
    const std::vector<std::string> names = each.target.sheets();
    for (const Format format : formats) {
      if (format == Format::pdf) {
        files.push_back(
            {folder / (each.target.file_stem() + ".pdf"), drawings::pdf(each.sheets, title({each}, options))});
        continue;
      }
      for (std::size_t i = 0; i < names.size(); ++i) {
        const auto path = folder / (each.target.exercise->about().id + "-" + names[i] + ".svg");
        if (seen.insert(path).second) files.push_back({path, drawings::svg(each.sheets[i])});
      }
    }
  }
  return files;
}

File single_file(const std::vector<DrawnTarget>& drawn, const Options& options) {
  std::vector<drawings::Sheet> sheets;
  for (const DrawnTarget& each : drawn) sheets.insert(sheets.end(), each.sheets.begin(), each.sheets.end());
  if (format_of_file(options) == Format::pdf) return {*options.file, drawings::pdf(sheets, title(drawn, options))};
  if (sheets.size() != 1)
    throw WrongUsage(fmt::format("an SVG file holds one sheet, and {} are asked for; name one, such as {}/{}",
                                 sheets.size(), drawn.front().target.exercise->about().id,
                                 drawn.front().target.sheets().front()));
  return {*options.file, drawings::svg(sheets.front())};
}

}  // namespace

std::string draw(const Catalogue& exercises, const Options& options) {
  const std::vector<Target> targets = find_targets(exercises, options.names);
  demand_sensible_output(options);
  const std::vector<DrawnTarget> drawn = draw_sheets(targets, options);
  const std::vector<File> files =
      options.file ? std::vector{single_file(drawn, options)} : files_in_folder(drawn, options);
  if (is_standard_output(options)) return files.front().bytes;
  std::string written;
  for (const File& file : files) {
    drawings::write_whole(file.path, file.bytes);
    written += file.path.string() + "\n";
  }
  return written;
}

}  // namespace epure
