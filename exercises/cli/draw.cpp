#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <ostream>
#include <set>
#include <utility>

#include "drawings/output.h"
#include "drawings/page.h"
#include "drawings/stopwatch.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace {

using drawings::File;

// An exercise with its givens. Its sheets are drawn by several threads: the first of them solves it for all.
class Solving {
 public:
  Solving(const Exercise* exercise, Givens givens) : exercise_(exercise), givens_(std::move(givens)) {}

  const Exercise* exercise() const { return exercise_; }
  const Solution& solution() {
    std::call_once(once_, [&] { found_ = exercise_->solution(givens_); });
    return *found_;
  }

 private:
  const Exercise* exercise_;
  Givens givens_;
  std::once_flag once_ = {};
  std::optional<Solution> found_ = {};
};

// A sheet of an exercise, each once, and what became of it. Layout and labels' places serve both formats.
struct DrawnSheetOf {
  const Exercise* exercise;
  std::string name;
  drawings::Page page = {};
  std::optional<Words> undecided = {};  // why there is no page
};

struct DrawnTarget {
  Target target;
  std::vector<const DrawnSheetOf*> sheets;
};

class Drawing {
 public:
  Drawing(const std::vector<Target>& targets, const Options& options) : options_(options) {
    std::vector<const Exercise*> exercises;
    for (const Target& target : targets)
      if (std::find(exercises.begin(), exercises.end(), target.exercise) == exercises.end())
        exercises.push_back(target.exercise);
    const std::vector<Givens> givens = set_givens(exercises, options.assignments);
    for (const Target& target : targets) {
      drawn_.push_back({target, {}});
      for (const std::string& sheet : target.sheets()) drawn_.back().sheets.push_back(add(*target.exercise, sheet));
    }
    std::deque<Solving> solving;
    for (std::size_t i = 0; i < exercises.size(); ++i) solving.emplace_back(exercises[i], givens[i]);
    const SheetRequest request = sheet_request(options);
    abreast(sheets_.size(), [&](std::size_t i) {
      DrawnSheetOf& each = sheets_[i];
      const auto of = std::find_if(solving.begin(), solving.end(),
                                   [&](const Solving& one) { return one.exercise() == each.exercise; });
      try {
        each.page = compose(each, *of, request);
      } catch (const geometry::Undecided& open) {
        each.undecided = open.words();
      } catch (const DoesNotFit& why) {
        if (sheets_.size() == 1) throw;
        throw DoesNotFit(each.exercise->about().id + "/" + each.name + ": " + why.words());
      } catch (const drawings::TooFar& why) {
        throw drawings::TooFar(each.exercise->about().id + "/" + each.name + ": " + why.words());
      }
    });
    leave_out_undecided();
  }

  // Of each sheet left out, why.
  const std::vector<Words>& remarks() const { return remarks_; }

  // ID.pdf and ID-SHEET.svg, or ID-SHEET.pdf and ID-SHEET.svg; a file asked for twice is made once.
  std::vector<File> files_in_folder() const {
    const std::filesystem::path folder = options_.folder.value_or("out");
    std::vector<File> files;
    std::vector<std::function<std::string()>> makers;
    std::set<std::filesystem::path> seen;
    const auto add = [&](const std::filesystem::path& path, std::function<std::string()> maker) {
      if (!seen.insert(path).second) return;
      files.push_back({path, {}});
      makers.push_back(std::move(maker));
    };
    for (const DrawnTarget& each : drawn_)
      for (const Format format : formats_of(options_)) {
        if (format == Format::pdf)
          add(folder / (each.target.file_stem() + ".pdf"), [&] { return pdf({each}); });
        else
          for (const DrawnSheetOf* sheet : each.sheets)
            add(folder / (each.target.exercise->about().id + "-" + sheet->name + ".svg"),
                [sheet] { return write_svg(sheet->page); });
      }
    abreast(files.size(), [&](std::size_t i) { files[i].bytes = makers[i](); });
    return files;
  }

  File single_file() const {
    if (format_of_file(options_) == Format::pdf) return {*options_.file, pdf(drawn_)};
    const DrawnTarget& first = drawn_.front();
    std::size_t count = 0;
    for (const DrawnTarget& each : drawn_) count += each.sheets.size();
    if (count != 1)
      throw WrongUsage(
          format_words("an SVG file holds one sheet, and {} are asked for; name one, such as {}/{}",
                       "un file SVG contiene una tavola, e ne sono chieste {}; nominarne una, come {}/{}", count,
                       first.target.exercise->about().id, first.target.sheets().front()));
    return {*options_.file, write_svg(first.sheets.front()->page)};
  }

 private:
  // A target none of whose sheets is left has no files; when nothing is left at all, that is the answer.
  void leave_out_undecided() {
    for (const DrawnSheetOf& each : sheets_)
      if (each.undecided)
        remarks_.push_back(format_words("{}/{} cannot be drawn, as it cannot be decided: {}",
                                        "{}/{} non si può disegnare, perché non si può decidere: {}",
                                        each.exercise->about().id, each.name, *each.undecided));
    for (DrawnTarget& each : drawn_)
      std::erase_if(each.sheets, [](const DrawnSheetOf* sheet) { return sheet->undecided.has_value(); });
    std::erase_if(drawn_, [](const DrawnTarget& each) { return each.sheets.empty(); });
    if (drawn_.empty()) throw geometry::Undecided(*sheets_.front().undecided);
  }

  const DrawnSheetOf* add(const Exercise& exercise, const std::string& name) {
    for (const DrawnSheetOf& each : sheets_)
      if (each.exercise == &exercise && each.name == name) return &each;
    return &sheets_.emplace_back(DrawnSheetOf{&exercise, name});
  }

  static drawings::Page compose(const DrawnSheetOf& wanted, Solving& solving, const SheetRequest& request) {
    const auto construct = [&] {
      const drawings::Timed timed(drawings::Work::construction);
      return wanted.exercise->draw(wanted.name, solving.solution(), request).sheet;
    };
    return drawings::compose(construct());
  }

  std::string pdf(const std::vector<DrawnTarget>& targets) const {
    std::vector<drawings::Page> pages;
    for (const DrawnTarget& each : targets)
      for (const DrawnSheetOf* sheet : each.sheets) pages.push_back(sheet->page);
    return drawings::write_pdf(pages, title(targets));
  }

  std::string title(const std::vector<DrawnTarget>& targets) const {
    const Exercise* first = targets.front().target.exercise;
    const bool one_exercise =
        std::all_of(targets.begin(), targets.end(), [&](const auto& each) { return each.target.exercise == first; });
    return one_exercise ? drawings::plain(first->about().title.in(language(options_))) : "Epure";
  }

  const Options& options_;
  std::deque<DrawnSheetOf> sheets_;  // which stay where they are
  std::vector<DrawnTarget> drawn_;
  std::vector<Words> remarks_;
};

// "start 5.1 ms, construction 3.2 ms, ..."
std::string in_words(const drawings::WorkTimes& times) {
  constexpr std::array<const char*, drawings::kinds_of_work> names{
      "start", "other", "construction", "layout", "fonts", "text", "pdf", "svg", "files"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {:.2f} ms", i == 0 ? "" : ", ", names[i], 1000 * times[i]);
  return text;
}

}  // namespace

Outcome draw(const Catalogue& exercises, const Options& options, std::ostream& err) {
  if (options.times) drawings::Stopwatch::begin();
  const std::vector<Target> targets = find_targets(exercises, options.names);
  demand_sensible_output(options);
  const Drawing drawing(targets, options);
  const std::vector<File> files = options.file ? std::vector{drawing.single_file()} : drawing.files_in_folder();
  std::string written;
  if (is_standard_output(options)) {
    written = files.front().bytes;
  } else {
    drawings::write_whole(files);
    for (const File& file : files) written += file.path.string() + "\n";
  }
  if (options.times) err << "epure: processor time: " << in_words(drawings::Stopwatch::times()) << '\n';
  const Exit exit = drawing.remarks().empty() ? Exit::success : Exit::undecided;
  return {written, exit, drawing.remarks()};
}

}  // namespace epure
