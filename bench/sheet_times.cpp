#include "bench/sheet_times.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "bench/recording.h"
#include "drawings/files/signals_later.h"
#include "drawings/output.h"
#include "drawings/page.h"
#include "drawings/stopwatch.h"
#include "drawings/text/font_folder.h"

namespace epure::bench {
namespace {

namespace fs = std::filesystem;

// A folder that goes when this goes, on Ctrl-C too.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "epure-bench-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw drawings::CannotWrite("cannot write to " + fs::temp_directory_path().string());
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

  // Throws where the user wants an end: the folder goes, and then the signal does what it always does.
  void demand_no_interrupt() const {
    if (signals_.is_interrupted()) throw std::runtime_error("interrupted");
  }

 private:
  drawings::SignalsLater signals_;  // let through once the folder is gone
  fs::path path_;
};

// Milliseconds of processor time that a program uses from its start to its end. What it says on standard error goes
// to the file `said`. Throws when it cannot be started, fails or is interrupted.
double run(std::vector<std::string> words, const Scratch& scratch) {
  const fs::path said = scratch / "said";
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed = posix_spawn(&child, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw std::runtime_error("cannot start " + words[0]);
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0)
    if (errno != EINTR) throw std::runtime_error("cannot wait for " + words[0]);
  scratch.demand_no_interrupt();
  if (status != 0) {
    std::ifstream reason(said);
    throw std::runtime_error(words[0] + " fails: " + std::string(std::istreambuf_iterator<char>(reason), {}));
  }
  const auto ms = [](const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
  };
  return ms(used.ru_utime) + ms(used.ru_stime);
}

// The numbers before "ms" in the line of --times.
std::vector<double> parts_in(const Scratch& scratch) {
  std::ifstream in(scratch / "said");
  std::vector<double> parts;
  std::string word, before;
  while (in >> word) {
    if (word.starts_with("ms")) parts.push_back(std::strtod(before.c_str(), nullptr));
    before = word;
  }
  return parts;
}

SheetResult measure(const Exercise& exercise, const fs::path& program, const fs::path& floor, int runs,
                    const Scratch& scratch) {
  const std::string sheet = exercise.about().sheets.front().name;
  SheetResult result{.sheet = exercise.about().id + "/" + sheet};
  const drawings::Page page = drawings::compose(exercise.draw(sheet, Givens(exercise.about().givens), {}).sheet);
  const fs::path recording = scratch / "recording";
  drawings::write_whole(recording, drawings::record({page}));
  const std::string out = (scratch / "out").string();
  const std::vector<std::string> draw{program.string(), "draw", result.sheet, "--out", out};
  std::vector<std::string> draw_with_times = draw;
  draw_with_times.emplace_back("--times");
  const std::vector<std::string> bare{floor.string(), recording.string(), drawings::font_folder().string(),
                                      out + "/floor.pdf", out + "/floor.svg"};
  run(draw, scratch);  // which makes the folder, and warms up
  run(bare, scratch);
  double fastest = std::numeric_limits<double>::infinity();
  result.epure_ms = result.floor_ms = fastest;
  for (int i = 0; i < runs; ++i) {
    result.epure_ms = std::min(result.epure_ms, run(draw, scratch));
    result.floor_ms = std::min(result.floor_ms, run(bare, scratch));
    if (const double all = run(draw_with_times, scratch); all < fastest) {
      fastest = all;
      result.parts_ms = parts_in(scratch);
    }
  }
  return result;
}

}  // namespace

std::vector<SheetResult> measure_sheets(const Catalogue& exercises, int runs) {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  const fs::path program = folder / "epure", floor = folder / "epure-floor";
  if (unknown || !fs::exists(program, unknown) || !fs::exists(floor, unknown)) return {};
  const Scratch scratch;
  std::vector<SheetResult> results;
  for (const auto& exercise : exercises)
    if (!exercise->about().sheets.empty()) results.push_back(measure(*exercise, program, floor, runs, scratch));
  return results;
}

}  // namespace epure::bench
