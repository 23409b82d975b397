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
#include "exercises/cli/pages.h"
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
  std::vector<drawings::Page> pages = {};  // several of a long table
  std::optional<Words> undecided = {};     // why there are none
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
    for (std::size_t i = 0; i < exercises.size(); ++i) solving_.emplace_back(exercises[i], givens[i]);
    if (wants_only_tables()) return;
    const SheetRequest request = sheet_request(options);
    abreast(sheets_.size(), [&](std::size_t i) {
      DrawnSheetOf& each = sheets_[i];
      try {
        each.pages = compose(each, solving_of(*each.exercise), request);
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

  // ID.pdf and ID-SHEET.svg, or ID-SHEET.pdf and ID-SHEET.svg, of a sheet's further pages ID-SHEET-2.svg;
  // ID-SHEET.csv; ID-blank.pdf, ID-SHEET-blank.svg. A file asked for twice is made once.
  std::vector<File> files_in_folder() {
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
          add(folder / (each.target.file_stem() + ending_of_blank() + ".pdf"), [&] { return pdf({each}); });
        else if (format == Format::svg)
          for (const DrawnSheetOf* sheet : each.sheets)
            for (std::size_t i = 0; i < sheet->pages.size(); ++i)
              add(folder / (stem(*sheet) + ending_of_blank() + (i == 0 ? "" : fmt::format("-{}", i + 1)) + ".svg"),
                  [sheet, i] { return write_svg(sheet->pages[i]); });
      }
    if (is_asked_for(Format::csv))
      for (const TableOf& table : tables())
        add(folder / (stem(*table.sheet) + ".csv"), [table] { return csv(table.table); });
    abreast(files.size(), [&](std::size_t i) { files[i].bytes = makers[i](); });
    return files;
  }

  // Of a sheet of several pages an SVG file holds the first, which says so.
  File single_file() {
    const Format format = format_of_file(options_);
    if (format == Format::pdf) return {*options_.file, pdf(drawn_)};
    if (format == Format::csv) return {*options_.file, single_table()};
    const DrawnTarget& first = drawn_.front();
    std::size_t count = 0;
    for (const DrawnTarget& each : drawn_) count += each.sheets.size();
    if (count != 1)
      throw WrongUsage(
          format_words("an SVG file holds one sheet, and {} are asked for; name one, such as {}/{}",
                       "un file SVG contiene una tavola, e ne sono chieste {}; nominarne una, come {}/{}", count,
                       first.target.exercise->about().id, first.target.sheets().front()));
    return {*options_.file, write_svg(first.sheets.front()->pages.front())};
  }

 private:
  struct TableOf {
    const DrawnSheetOf* sheet;
    LongTable table;
  };
  // A sheet to be solved stands beside the solved one.
  std::string ending_of_blank() const { return options_.blank ? "-blank" : ""; }
  bool is_asked_for(Format format) const {
    const std::vector<Format> asked = options_.file ? std::vector{format_of_file(options_)} : formats_of(options_);
    return std::find(asked.begin(), asked.end(), format) != asked.end();
  }
  bool wants_only_tables() const {
    return is_asked_for(Format::csv) && !is_asked_for(Format::pdf) && !is_asked_for(Format::svg);
  }
  Solving& solving_of(const Exercise& exercise) {
    return *std::find_if(solving_.begin(), solving_.end(),
                         [&](const Solving& one) { return one.exercise() == &exercise; });
  }
  static std::string stem(const DrawnSheetOf& sheet) { return sheet.exercise->about().id + "-" + sheet.name; }

  // Those of all sheets that hold one. A sheet that was named must.
  std::vector<TableOf> tables() {
    std::vector<TableOf> all;
    for (const DrawnTarget& each : drawn_)
      for (const DrawnSheetOf* sheet : each.sheets) {
        auto table = each.target.exercise->long_table(sheet->name, solving_of(*each.target.exercise).solution());
        if (!table && !each.target.sheet.empty())
          throw WrongUsage(format_words("{}/{} holds no long table that --format csv could write",
                                        "{}/{} non contiene una tabella lunga che --format csv possa scrivere",
                                        each.target.exercise->about().id, sheet->name));
        if (table) all.push_back({sheet, std::move(*table)});
      }
    if (all.empty())
      throw WrongUsage(format_words("no sheet of {} holds a long table that --format csv could write",
                                    "nessuna tavola di {} contiene una tabella lunga che --format csv possa scrivere",
                                    drawn_.front().target.exercise->about().id));
    return all;
  }
  std::string single_table() {
    const std::vector<TableOf> all = tables();
    if (all.size() != 1)
      throw WrongUsage(
          format_words("a CSV file holds one table, and {} are asked for; name one sheet, such as {}/{}",
                       "un file CSV contiene una tabella, e ne sono chieste {}; nominare una tavola, come "
                       "{}/{}",
                       all.size(), all.front().sheet->exercise->about().id, all.front().sheet->name));
    return csv(all.front().table);
  }

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

  static std::vector<drawings::Page> compose(const DrawnSheetOf& wanted, Solving& solving,
                                             const SheetRequest& request) {
    const auto construct = [&] {
      const drawings::Timed timed(drawings::Work::construction);
      return wanted.exercise->draw(wanted.name, solving.solution(), request);
    };
    return pages_of(construct());
  }

  std::string pdf(const std::vector<DrawnTarget>& targets) const {
    std::vector<drawings::Page> pages;
    for (const DrawnTarget& each : targets)
      for (const DrawnSheetOf* sheet : each.sheets)
        pages.insert(pages.end(), sheet->pages.begin(), sheet->pages.end());
    return drawings::write_pdf(pages, title(targets));
  }

  std::string title(const std::vector<DrawnTarget>& targets) const {
    const Exercise* first = targets.front().target.exercise;
    const bool one_exercise =
        std::all_of(targets.begin(), targets.end(), [&](const auto& each) { return each.target.exercise == first; });
    return one_exercise ? drawings::plain(first->about().title.in(language(options_))) : "Epure";
  }

  const Options& options_;
  std::deque<Solving> solving_;
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
  Drawing drawing(targets, options);
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
