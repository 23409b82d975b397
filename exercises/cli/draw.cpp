#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <ostream>
#include <utility>

#include "drawings/files/tex.h"
#include "drawings/output.h"
#include "drawings/page.h"
#include "drawings/stopwatch.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/documents.h"
#include "exercises/cli/file_names.h"
#include "exercises/cli/givens_file.h"
#include "exercises/cli/pages.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/request.h"
#include "exercises/cli/sheet_html.h"
#include "exercises/cli/staged_pages.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace {

using drawings::File;

std::vector<const Exercise*> exercises_of(const std::vector<Target>& targets) {
  std::vector<const Exercise*> exercises;
  for (const Target& target : targets)
    if (std::find(exercises.begin(), exercises.end(), target.exercise) == exercises.end())
      exercises.push_back(target.exercise);
  return exercises;
}

// An exercise with one set of givens. Its sheets are drawn by several threads: the first of them solves it for all.
class Solving {
 public:
  Solving(const Exercise* exercise, Givens givens, const Candidate& row, std::size_t row_number)
      : exercise_(exercise), givens_(std::move(givens)), row_(row), row_number_(row_number) {}

  const Exercise* exercise() const { return exercise_; }
  const Candidate& row() const { return row_; }
  DrawnVariant drawn() const { return {*exercise_, givens_, row_, row_number_}; }
  const Solution& solution() {
    std::call_once(once_, [&] { found_ = exercise_->solution(givens_); });
    return *found_;
  }
  // What tells it apart from the others: its id, and the row of its givens.
  Words name() const {
    const std::string& id = exercise_->about().id;
    return row_.place.empty() ? Words{id, id} : id + (" (" + row_.place + ")");
  }

 private:
  const Exercise* exercise_;
  Givens givens_;
  const Candidate& row_;
  std::size_t row_number_;
  std::once_flag once_ = {};
  std::optional<Solution> found_ = {};
};

// A sheet of an exercise with its givens, each once, and what became of it. Layout and labels' places serve both
// formats.
struct DrawnSheetOf {
  Solving* solving;
  std::string name;
  std::vector<drawings::Page> pages = {};   // several of a long table; none where only staged ones are wanted
  std::vector<drawings::Page> staged = {};  // the same in steps, where they are wanted
  std::optional<Words> undecided = {};      // why there are none
  std::optional<Words> note = {};           // of the size that was asked for

  const Exercise& exercise() const { return *solving->exercise(); }
  std::string path() const { return exercise().about().id + "/" + name; }
};

struct DrawnTarget {
  Target target;
  Solving* solving;
  std::vector<const DrawnSheetOf*> sheets;
};

// Rows of givens, counted from `first`; is_table: students have their names on the sheets.
struct RowsToDraw {
  std::vector<Candidate> rows;
  bool is_table = false;
  std::size_t first = 1;
};

class Drawing {
 public:
  Drawing(const std::vector<Target>& targets, const Options& options, const RowsToDraw& rows)
      : options_(options), looks_(looks_asked(options)) {
    const std::vector<const Exercise*> exercises = exercises_of(targets);
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      const Candidate& each = rows.rows[row];
      const std::vector<Givens> givens = givens_in(each, exercises, options.assignments);
      const std::size_t before = solving_.size();
      for (std::size_t i = 0; i < exercises.size(); ++i)
        solving_.emplace_back(exercises[i], givens[i], each, rows.first + row);
      for (const Target& target : targets) {
        Solving& solving = *std::find_if(solving_.begin() + static_cast<std::ptrdiff_t>(before), solving_.end(),
                                         [&](const Solving& one) { return one.exercise() == target.exercise; });
        drawn_.push_back({target, &solving, {}});
        for (const std::string& sheet : target.sheets()) drawn_.back().sheets.push_back(add(solving, sheet));
      }
    }
    if (wants_only_tables()) return;
    SheetRequest request = sheet_request(options);
    request.bare = is_bare(options);
    abreast(sheets_.size(), [&](std::size_t i) {
      DrawnSheetOf& each = sheets_[i];
      SheetRequest own = request;
      if (rows.is_table) own.solver = {each.solving->row().name, each.solving->row().number};
      compose_or_tell(each, own);
    });
    leave_out_undecided();
    demand_paintable_pages();
  }

  // Of each sheet left out, why.
  const std::vector<Words>& remarks() const { return remarks_; }
  // Of what is drawn, what a reader will find hard.
  std::vector<Words> notes() const {
    std::vector<Words> all;
    for (const DrawnSheetOf& each : sheets_)
      if (each.note) all.push_back(in_place(each.solving->row(), in_sheet(each, *each.note)));
    return all;
  }

  // Named by `names`: a PDF for each target, or sheet where the names tell it; of a sheet's further pages -2.svg;
  // SHEET.csv. Of a sheet to be solved -blank. png, eps and tex as svg. A file asked for twice is made once.
  std::vector<File> files_in_folder(FileNames& names) {
    const std::filesystem::path folder = options_.folder.value_or("out");
    std::vector<File> files;
    std::vector<std::function<std::string()>> makers;
    const auto add = [&](const std::filesystem::path& path, const Words& content,
                         std::function<std::string()> maker) {
      if (!names.claim(path, content.in(language(options_)))) return;
      files.push_back({path, {}});
      makers.push_back(std::move(maker));
    };
    const auto stem = [&](const Solving& solving, const std::string& sheet) {
      return names.stem(solving.drawn(), sheet);
    };
    const auto add_pdf = [&](const DrawnTarget& each) {
      const std::string& sheet = each.target.sheet;
      add(folder / (stem(*each.solving, sheet) + ending_of_blank() + ".pdf"),
          sheet.empty() ? each.solving->name() : name_of(*each.sheets.front()), [this, each] { return pdf({each}); });
    };
    for (const DrawnTarget& each : drawn_)
      for (const Format format : formats_of(options_)) {
        if (format == Format::pdf && !names.tells_sheet())
          add_pdf(each);
        else if (format != Format::csv)
          for (const DrawnSheetOf* sheet : each.sheets) {
            if (format == Format::pdf) {
              add_pdf({{each.target.exercise, sheet->name}, each.solving, {sheet}});
              continue;
            }
            if (format == Format::html) {
              add(folder / (stem(*sheet->solving, sheet->name) + ending_of_blank() + ".html"), name_of(*sheet),
                  [this, sheet] { return html(*sheet); });
              continue;
            }
            const std::vector<drawings::Page>& pages = pages_of_file(*sheet);
            for (std::size_t i = 0; i < pages.size(); ++i) {
              const std::string further = i == 0 ? "" : fmt::format("-{}", i + 1),
                                name = stem(*sheet->solving, sheet->name) + ending_of_blank() + further +
                                       ending_of(format);
              for (FileToMake& file : files_of(format, pages[i], folder / name))
                add(file.path, name_of(*sheet) + further + file.part, std::move(file.maker));
            }
          }
      }
    if (is_asked_for(Format::csv))
      for (const TableOf& table : tables())
        add(folder / (stem(*table.sheet->solving, table.sheet->name) + ".csv"), name_of(*table.sheet),
            [table, style = csv_style(options_)] { return csv(table.table, style); });
    abreast(files.size(), [&](std::size_t i) { files[i].bytes = makers[i](); });
    return files;
  }

  // That of -o, and what belongs to it. Of a sheet of several pages a file of one page holds the first, which says
  // so.
  std::vector<File> files_of_one() {
    const Format format = format_of_file(options_);
    if (format == Format::pdf) return {{*options_.file, pdf(drawn_)}};
    if (format == Format::csv) return {{*options_.file, single_table()}};
    const DrawnTarget& first = drawn_.front();
    std::size_t count = 0;
    for (const DrawnTarget& each : drawn_) count += each.sheets.size();
    if (count != 1)
      throw WrongUsage(format_words(
          "a file in {} holds one sheet, and {} are asked for; name one, such as {}/{}",
          "un file in {} contiene una tavola, e ne sono chieste {}; nominarne una, come {}/{}",
          ending_of(format).substr(1), count, first.target.exercise->about().id, first.target.sheets().front()));
    std::vector<File> files;
    if (format == Format::html) return {{*options_.file, html(*first.sheets.front())}};
    for (const FileToMake& file : files_of(format, pages_of_file(*first.sheets.front()).front(), *options_.file))
      files.push_back({file.path, file.maker()});
    return files;
  }

 private:
  struct TableOf {
    const DrawnSheetOf* sheet;
    LongTable table;
  };
  // A sheet to be solved stands beside the solved one.
  std::string ending_of_blank() const { return options_.blank ? "-blank" : ""; }
  bool is_asked_for(Format format) const { return epure::is_asked_for(format, options_); }
  bool wants_only_tables() const {
    return is_asked_for(Format::csv) && (options_.file || formats_of(options_).size() == 1);
  }

  // Of the formats whose files hold a page.
  static std::string ending_of(Format format) {
    return format == Format::svg    ? ".svg"
           : format == Format::html ? ".html"
           : format == Format::png  ? ".png"
           : format == Format::eps  ? ".eps"
                                    : ".tex";
  }

  struct FileToMake {
    std::filesystem::path path;
    std::function<std::string()> maker;
    std::string part = {};  // where a page is more than one file, which of them it is
  };
  // The page in such a format, in the file of this path and what belongs to it.
  std::vector<FileToMake> files_of(Format format, const drawings::Page& page,
                                   const std::filesystem::path& path) const {
    if (format == Format::svg)
      return {{path, [this, &page] { return options_.steps ? write_svg(silent(page)) : write_svg(page); }}};
    if (format == Format::eps) return {{path, [&page] { return write_eps(page); }}};
    if (format == Format::png)
      return {{path, [&page, dots = looks_.dots_per_inch] { return write_png(page, dots); }}};
    const std::filesystem::path picture = path.parent_path() / (path.stem().string() + "-art.pdf");
    return {
        {path, [&page, picture] { return write_tex(page, picture.filename().string()); }},
        {picture, [&page] { return drawings::write_pdf({without_letters(page)}, {.title = page.title}); }, "-art"}};
  }
  // Those of a PDF, an SVG or a picture.
  const std::vector<drawings::Page>& pages_of_file(const DrawnSheetOf& sheet) const {
    return options_.steps ? sheet.staged : sheet.pages;
  }
  std::string html(const DrawnSheetOf& sheet) const {
    return sheet_html(sheet.staged, {.is_bare = is_bare(options_), .follows_reader = !looks_.background});
  }
  bool wants_staged_pages() const { return options_.steps || is_asked_for(Format::html); }
  bool wants_plain_pages() const {
    const bool is_only_html = is_asked_for(Format::html) && (options_.file || formats_of(options_).size() == 1);
    return !options_.steps && !is_only_html;
  }
  void demand_paintable_pages() const {
    if (!is_asked_for(Format::png)) return;
    for (const DrawnSheetOf& sheet : sheets_)
      for (const drawings::Page& page : sheet.pages) demand_paintable(page, looks_.dots_per_inch);
  }
  static Words name_of(const DrawnSheetOf& sheet) {
    const Candidate& row = sheet.solving->row();
    const std::string path = sheet.path();
    return row.place.empty() ? Words{path, path} : path + (" (" + row.place + ")");
  }

  // Those of all sheets that hold one. A sheet that was named must.
  std::vector<TableOf> tables() {
    std::vector<TableOf> all;
    for (const DrawnTarget& each : drawn_)
      for (const DrawnSheetOf* sheet : each.sheets) {
        auto table = each.target.exercise->long_table(sheet->name, each.solving->solution());
        if (!table && !each.target.sheet.empty())
          throw WrongUsage(format_words("{} holds no long table that --format csv could write",
                                        "{} non contiene una tabella lunga che --format csv possa scrivere",
                                        sheet->path()));
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
          format_words("a CSV file holds one table, and {} are asked for; name one sheet, such as {}",
                       "un file CSV contiene una tabella, e ne sono chieste {}; nominare una tavola, come {}",
                       all.size(), all.front().sheet->path()));
    return csv(all.front().table, csv_style(options_));
  }

  // A target none of whose sheets is left has no files; when nothing is left at all, that is the answer.
  void leave_out_undecided() {
    for (const DrawnSheetOf& each : sheets_)
      if (each.undecided)
        remarks_.push_back(format_words("{} cannot be drawn, as it cannot be decided: {}",
                                        "{} non si può disegnare, perché non si può decidere: {}", name_of(each),
                                        *each.undecided));
    for (DrawnTarget& each : drawn_)
      std::erase_if(each.sheets, [](const DrawnSheetOf* sheet) { return sheet->undecided.has_value(); });
    std::erase_if(drawn_, [](const DrawnTarget& each) { return each.sheets.empty(); });
    if (drawn_.empty()) throw geometry::Undecided(*sheets_.front().undecided);
  }

  const DrawnSheetOf* add(Solving& solving, const std::string& name) {
    for (const DrawnSheetOf& each : sheets_)
      if (each.solving == &solving && each.name == name) return &each;
    return &sheets_.emplace_back(DrawnSheetOf{&solving, name});
  }

  // Where there are others.
  Words in_sheet(const DrawnSheetOf& sheet, const Words& words) const {
    return sheets_.size() == 1 ? words : sheet.path() + ": " + words;
  }

  // What cannot be drawn is told with the row of its givens, and with its name where there are others.
  void compose_or_tell(DrawnSheetOf& each, const SheetRequest& request) const {
    const Candidate& row = each.solving->row();
    try {
      if (wants_plain_pages()) each.pages = compose(each, request, pages_of);
      if (wants_staged_pages())
        each.staged = compose(each, request, [&](DrawnSheet drawn) {
          return staged_pages(std::move(drawn), each.solving->solution(), request.language);
        });
    } catch (const geometry::Undecided& open) {
      each.undecided = open.words();
    } catch (const DoesNotFit& why) {
      throw DoesNotFit(in_place(row, in_sheet(each, why.words())));
    } catch (const drawings::TooFar& why) {
      throw drawings::TooFar(in_place(row, each.path() + ": " + why.words()));
    } catch (const BadGivens& why) {
      throw BadGivens(in_place(row, why.words()));
    } catch (const geometry::Impossible& why) {
      throw BadGivens(in_place(row, why.words()));
    }
  }

  std::vector<drawings::Page> compose(
      DrawnSheetOf& wanted, const SheetRequest& request,
      const std::function<std::vector<drawings::Page>(DrawnSheet)>& pages_of_drawn) const {
    std::vector<drawings::Page> pages = pages_of_drawn(drawn_in_size(wanted, request));
    if (looks_.background)
      for (drawings::Page& page : pages) page = on_background(std::move(page), *looks_.background);
    return pages;
  }

  DrawnSheet drawn_in_size(DrawnSheetOf& wanted, const SheetRequest& request) const {
    const DrawnIn draw_in = [&](const FigureSize& room) {
      const drawings::Timed timed(drawings::Work::construction);
      SheetRequest within = request;
      within.room_width = room.width;
      within.room_height = room.height;
      return wanted.exercise().draw(wanted.name, wanted.solving->solution(), within);
    };
    if (!looks_.size.is_asked()) return draw_in({});
    FigureWithin figure(looks_.size, draw_in);
    DrawnSheet drawn = figure.largest();
    wanted.note = figure.hard_to_read();
    return drawn;
  }

  std::string pdf(const std::vector<DrawnTarget>& targets) const {
    drawings::Document document{.title = title(targets), .author = options_.titles.author};
    if (is_of_one_exercise(targets))
      document.subject = drawings::plain(in_language(targets.front().target.exercise->about().source));
    std::vector<drawings::Page> pages;
    const Solving* above = nullptr;
    const bool is_within = !is_of_one_solving(targets);
    for (const DrawnTarget& each : targets)
      for (const DrawnSheetOf* sheet : each.sheets) {
        if (is_within && std::exchange(above, sheet->solving) != sheet->solving)
          document.bookmarks.push_back({title(*sheet->solving), pages.size()});
        document.bookmarks.push_back({title(*sheet), pages.size(), is_within});
        for (const drawings::Page& page : pages_of_file(*sheet)) {
          for (std::size_t i = 0; !is_within && i < page.steps.size(); ++i)
            document.bookmarks.push_back(
                {fmt::format("{}. {}", i + 1, drawings::plain(page.steps[i])), pages.size() + i, true});
          if (options_.steps)
            for (drawings::Page& each_step : page_of_each_step(page)) pages.push_back(std::move(each_step));
          else
            pages.push_back(page);
        }
      }
    if (pages.size() == 1) document.bookmarks.clear();
    return drawings::write_pdf(pages, document);
  }

  static bool is_of_one_exercise(const std::vector<DrawnTarget>& targets) {
    return std::all_of(targets.begin(), targets.end(),
                       [&](const auto& each) { return each.target.exercise == targets.front().target.exercise; });
  }
  static bool is_of_one_solving(const std::vector<DrawnTarget>& targets) {
    return std::all_of(targets.begin(), targets.end(),
                       [&](const auto& each) { return each.solving == targets.front().solving; });
  }

  std::string title(const std::vector<DrawnTarget>& targets) const {
    return is_of_one_exercise(targets) ? title(*targets.front().target.exercise) : "Epure";
  }
  // With whose it is, where it is somebody's.
  std::string title(const Solving& solving) const {
    const Candidate& row = solving.row();
    if (row.number.empty()) return title(*solving.exercise());
    return title(*solving.exercise()) + " (" + row.number + (row.name.empty() ? "" : " " + row.name) + ")";
  }
  std::string title(const Exercise& exercise) const { return drawings::plain(in_language(exercise.about().title)); }
  std::string title(const DrawnSheetOf& sheet) const {
    return drawings::plain(in_language(title_of_sheet(sheet.exercise(), sheet.name)));
  }
  const std::string& in_language(const Words& words) const { return words.in(language(options_)); }

  const Options& options_;
  Looks looks_;
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

Outcome draw_one_file(const std::vector<Target>& targets, const Options& options, const RowsToDraw& rows) {
  Drawing drawing(targets, options, rows);
  const std::vector<File> files = drawing.files_of_one();
  Outcome outcome{.text = "", .remarks = drawing.remarks(), .notes = drawing.notes()};
  if (is_standard_output(options)) {
    outcome.text = files.front().bytes;
  } else {
    drawings::write_whole(files);
    for (const File& file : files) outcome.text += shown_whole(file.path.string()) + "\n";
  }
  return outcome;
}

// All is drawn before any of it is written, and each row's pages are let go before the next one's.
Outcome draw_in_folder(const std::vector<Target>& targets, const Options& options, const RowsToDraw& rows,
                       FileNames& names) {
  Outcome outcome;
  std::vector<std::vector<File>> of_rows;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const RowsToDraw row{{rows.rows[i]}, rows.is_table, i + 1};
    Drawing drawing(targets, options, row);
    of_rows.push_back(drawing.files_in_folder(names));
    outcome.remarks.insert(outcome.remarks.end(), drawing.remarks().begin(), drawing.remarks().end());
    const std::vector<Words> notes = drawing.notes();
    outcome.notes.insert(outcome.notes.end(), notes.begin(), notes.end());
  }
  for (const std::vector<File>& files : of_rows) {
    drawings::write_whole(files);
    for (const File& file : files) outcome.text += shown_whole(file.path.string()) + "\n";
  }
  return outcome;
}

}  // namespace

Outcome draw(const Catalogue& exercises, const Options& options, std::ostream& err) {
  if (options.times) drawings::Stopwatch::begin();
  const std::vector<Target> targets = find_targets(exercises, options.names);
  demand_sensible_output(options);
  const std::vector<const Exercise*> drawn = exercises_of(targets);
  RowsToDraw rows{{Candidate{}}};
  if (options.givens_file) {
    GivensFile file = read_givens_file(*options.givens_file, drawn, options.assignments);
    rows = {std::move(file.rows), file.is_table};
  }
  FileNames names(options, drawn, rows.is_table);
  Outcome outcome =
      options.file ? draw_one_file(targets, options, rows) : draw_in_folder(targets, options, rows, names);
  if (options.times) err << "epure: processor time: " << in_words(drawings::Stopwatch::times()) << '\n';
  if (!outcome.remarks.empty()) outcome.exit = Exit::undecided;
  return outcome;
}

}  // namespace epure
