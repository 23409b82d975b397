#include "exercises/bench/bench.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "drawings/output.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

double seconds_of(const Options& options) {
  Rational seconds = 0;
  const Rational longest = 3600;
  try {
    seconds = geometry::parse_given(options.seconds, "s");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage("--seconds: " + unreadable.words());
  }
  if (seconds > 0 && seconds <= longest) return CGAL::to_double(seconds);
  throw WrongUsage(format_words("--seconds {}: must be positive and at most 3600 s",
                                "--seconds {}: dev'essere positivo e al massimo 3600 s", options.seconds));
}

std::vector<drawings::File> files_of(const bench::Report& report, const std::filesystem::path& folder,
                                     const Options& options) {
  const std::vector<drawings::Sheet> sheets =
      bench::sheets_of(report, language(options), sheet_request(options).paper);
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
  demand_sensible_output(options);
  language(options);
  sheet_request(options);
  const double seconds = seconds_of(options);
  const std::filesystem::path folder = options.folder.value_or("out");
  drawings::demand_writable(folder);  // a minute's work is not to be lost for a folder
  const bench::Report report = bench::run_bench(exercises, seconds, [&](const std::string& what) {
    err << "epure: measuring " << what << '\n' << std::flush;
  });
  const std::vector<drawings::File> files = files_of(report, folder, options);
  drawings::write_whole(files);
  if (options.json) return bench::json_of(report);
  std::string text = bench::text_of(report) + "\n";
  for (const drawings::File& file : files) text += file.path.string() + "\n";
  return text;
}

}  // namespace epure
