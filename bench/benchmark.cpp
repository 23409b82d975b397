#include "bench/benchmark.h"

#include <filesystem>
#include <ostream>

#include "bench/bench.h"
#include "drawings/output.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"

namespace epure::bench {
namespace {

std::vector<drawings::File> files_of(const Report& report, const std::filesystem::path& folder,
                                     const Options& options) {
  const std::vector<drawings::Sheet> sheets = sheets_of(report, language(options), sheet_request(options).paper);
  std::vector<drawings::File> files;
  for (const Format format : formats_of(options)) {
    if (format == Format::pdf) {
      files.push_back({folder / "bench.pdf", drawings::pdf(sheets, sheets.front().title_block.exercise)});
      continue;
    }
    for (const drawings::Sheet& sheet : sheets) files.push_back({folder / (sheet.id + ".svg"), drawings::svg(sheet)});
  }
  return files;
}

}  // namespace

std::string benchmark(const Catalogue& exercises, const Options& options, std::ostream& err) {
  for (const Format format : formats_of(options))
    if (format != Format::pdf && format != Format::svg)
      throw WrongUsage("bench writes pdf, svg or both, and nothing else",
                       "bench scrive pdf, svg o entrambi, e nient'altro");
  const std::filesystem::path folder = options.folder.value_or("out");
  drawings::demand_writable(folder);  // a minute's work is not to be lost for a folder
  const Report report = run_bench(exercises, seconds_of(options), [&](const std::string& what) {
    err << "epure: measuring " << what << '\n' << std::flush;
  });
  const std::vector<drawings::File> files = files_of(report, folder, options);
  drawings::write_whole(files);
  if (options.json) return json_of(report);
  std::string text = text_of(report) + "\n";
  for (const drawings::File& file : files) text += file.path.string() + "\n";
  return text;
}

}  // namespace epure::bench
