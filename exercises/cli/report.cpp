// The verb that writes a worked solution as a document.
#include <algorithm>
#include <filesystem>

#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/cases.h"
#include "exercises/cli/check_words.h"
#include "exercises/cli/documents.h"
#include "exercises/cli/figure_size.h"
#include "exercises/cli/givens_file.h"
#include "exercises/cli/pages.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/report_document.h"
#include "exercises/cli/request.h"
#include "exercises/cli/typographic.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/proof/route_names.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/statement/given_number.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

namespace fs = std::filesystem;
using drawings::Paragraph;
using drawings::Table;

constexpr const char* no_break = "\u00a0";  // a blank at which no line ends

enum class ReportFormat { markdown, latex, html };

std::optional<ReportFormat> report_format_named(const std::string& typed) {
  const std::string name = lower_case(typed);
  if (name == "md") return ReportFormat::markdown;
  if (name == "tex") return ReportFormat::latex;
  if (name == "html") return ReportFormat::html;
  return std::nullopt;
}

const char* ending_of(ReportFormat format) {
  return format == ReportFormat::markdown ? ".md" : format == ReportFormat::latex ? ".tex" : ".html";
}

// From --format, or the ending of the file -o names, else Markdown.
ReportFormat report_format(const Options& options) {
  const std::string ending = options.file ? fs::path(*options.file).extension().string() : "";
  const auto by_ending = ending.empty() ? std::nullopt : report_format_named(ending.substr(1));
  if (!options.format) {
    if (by_ending || !options.file) return by_ending.value_or(ReportFormat::markdown);
    if (is_standard_output(options)) return ReportFormat::html;
    throw WrongUsage(format_words("\"{}\" tells no format; end it in .md, .tex or .html, or add --format",
                                  "\"{}\" non dice il formato; farlo finire in .md, .tex o .html, o aggiungere "
                                  "--format",
                                  *options.file));
  }
  const auto asked = report_format_named(*options.format);
  if (!asked)
    throw WrongUsage(format_words("\"{}\" is no format of a report; choose md, tex or html",
                                  "\"{}\" non è un formato di report; scegliere md, tex o html", *options.format));
  if (by_ending && by_ending != asked)
    throw WrongUsage(format_words("\"{}\" is not the ending of --format {}",
                                  "\"{}\" non finisce come vuole --format {}", *options.file, *options.format));
  if (!by_ending) refuse_ending_of_others(options, {"md, tex or html", "md, tex o html"});
  return *asked;
}

// The document's path; that of its figures begins with the same.
fs::path path_of(const Exercise& exercise, ReportFormat format, const Options& options) {
  if (options.file && options.folder)
    throw WrongUsage("-o names one file and --out a folder; choose one of them",
                     "-o nomina un file e --out una cartella; scegliere uno dei due");
  const fs::path path =
      options.file ? fs::path(*options.file)
                   : fs::path(options.folder.value_or("out")) / (exercise.about().id + "-report" + ending_of(format));
  if (format != ReportFormat::html && is_standard_output(options))
    throw WrongUsage(
        "a report in md or tex has its figures in files beside it, and standard output is one; name a "
        "file, or choose --format html, which holds them",
        "una relazione in md o tex ha le figure in file accanto, e lo standard output è uno; nominare un "
        "file, o scegliere --format html, che le contiene");
  if (format == ReportFormat::latex) demand_name_for_tex("-o", path.filename().string());
  return path;
}

std::string words_as_numbers(const std::string& text) {
  const bool is_number = !text.empty() && text.find_first_not_of("+-0123456789.,e") == std::string::npos;
  return is_number ? typographic(text) : drawings::escaped(text);
}

class ReportMaker {
 public:
  ReportMaker(const Exercise& exercise, const Givens& givens, const CheckedExercise& checked, Language language,
              std::string figures, double widest_figure)
      : exercise_(exercise),
        givens_(givens),
        checked_(checked),
        language_(language),
        figures_(std::move(figures)),
        widest_figure_(widest_figure) {}

  ReportDocument document() {
    const Description& about = exercise_.about();
    ReportDocument made{about.title.in(language_), about.source.in(language_), language_, {}};
    if (!givens_.as_stated()) made.source += say({", givens changed", ", dati cambiati"});
    blocks_ = &made.blocks;
    head({"Question", "Quesito"});
    add(Paragraph{about.question.in(language_)});
    add_givens();
    add_sheets();
    add_quantities();
    add_printed();
    add_audits();
    add_complaints({"What failed", "Che cosa fallisce"}, checked_.failures);
    add_complaints({"What is undecided", "Che cosa non è deciso"}, checked_.undecided);
    return made;
  }

 private:
  std::string say(const Words& words) const { return words.in(language_); }
  void add(ReportBlock block) { blocks_->push_back(std::move(block)); }
  void head(const Words& words, int level = 1) { add(ReportHeading{level, say(words)}); }

  // Those that a sheet tells.
  void add_givens() {
    ReportList list;
    for (const GivenSpec& spec : givens_.specs()) {
      if (givens_.follows(spec.symbol) || (spec.beyond_source && !givens_.is_changed(spec.symbol))) continue;
      if (!spec.choices.empty()) {
        list.items.push_back(say(spec.meaning) + ": " + say(givens_.chosen(spec.symbol).meaning));
        continue;
      }
      const auto read = *givens_.reading(spec.symbol);
      list.items.push_back((spec.letters.empty() ? spec.symbol : spec.letters) + " " +
                           equal_to(read.number, language_) + unit_after_number(read.unit.symbol, language_) + ", " +
                           say(spec.meaning));
    }
    for (const Words& each : exercise_.about().also_given(givens_)) list.items.push_back(say(each));
    if (list.items.empty()) return;
    head({"Given", "Dati"});
    add(std::move(list));
  }

  // A figure, and what its column tells; or why there is none.
  struct ReportSheet {
    std::vector<drawings::Page> pages = {};
    std::vector<drawings::Block> column = {};
    Words why_not = {};
  };

  void add_sheets() {
    const std::vector<SheetSpec>& specs = exercise_.about().sheets;
    std::vector<ReportSheet> sheets(specs.size());
    const Solution solution = exercise_.solution(givens_);
    abreast(specs.size(), [&](std::size_t i) { sheets[i] = sheet_of(specs[i].name, solution); });
    for (std::size_t i = 0; i < specs.size(); ++i) {
      head(specs[i].title);
      if (!sheets[i].why_not.empty()) add(Paragraph{say(sheets[i].why_not)});
      for (std::size_t page = 0; page < sheets[i].pages.size(); ++page)
        add(ReportFigure{figures_ + "-" + specs[i].name + (page == 0 ? "" : "-" + std::to_string(page + 1)),
                         specs[i].title.in(language_), std::move(sheets[i].pages[page])});
      for (drawings::Block& block : sheets[i].column) add_block(std::move(block));
    }
  }

  // As wide as the page, at a standard scale; or as it comes where it is wider at each of them.
  ReportSheet sheet_of(const std::string& name, const Solution& solution) const {
    ReportSheet sheet;
    SheetRequest request{.language = language_, .bare = true};
    const DrawnIn draw_in = [&](const FigureSize& room) {
      request.room_width = room.width;
      return exercise_.draw(name, solution, request);
    };
    try {
      DrawnSheet drawn;
      try {
        drawn = FigureWithin({.width = widest_figure_}, draw_in).largest();
      } catch (const DoesNotFit&) {
        drawn = draw_in({});
      }
      sheet.pages = pages_of(drawn);
      sheet.column = std::move(drawn.sheet.column);
    } catch (const BadGivens& why) {
      sheet.why_not = why.words();
    } catch (const drawings::TooFar& why) {
      sheet.why_not = why.words();
    } catch (const geometry::Undecided& why) {
      sheet.why_not = why.words();
    }
    if (sheet.pages.empty()) sheet.column.clear();
    drop_givens(sheet.column);
    return sheet;
  }

  // They stand before the first sheet.
  void drop_givens(std::vector<drawings::Block>& column) const {
    const auto* first = column.size() < 2 ? nullptr : std::get_if<drawings::Heading>(&column.front());
    if (first && first->text == say({"Given", "Dati"})) column.erase(column.begin(), column.begin() + 2);
  }

  void add_block(drawings::Block block) {
    if (auto* heading = std::get_if<drawings::Heading>(&block))
      add(ReportHeading{2, heading->text});
    else if (auto* paragraph = std::get_if<Paragraph>(&block))
      add(std::move(*paragraph));
    else if (auto* steps = std::get_if<drawings::Steps>(&block))
      add(std::move(*steps));
    else if (auto* table = std::get_if<Table>(&block))
      add(std::move(*table));
    else
      add(as_table(std::get<drawings::VectorEquation>(block)));
  }

  // The vectors on a line, under each its direction and its magnitude.
  static Table as_table(const drawings::VectorEquation& equation) {
    Table table{.head = {}, .rows = {{}, {}}};
    for (const auto& term : equation.terms) {
      table.head.push_back((term.before.empty() ? "" : term.before + " ") + term.vector);
      table.rows[0].push_back(term.direction);
      table.rows[1].push_back(term.magnitude);
    }
    return table;
  }

  void add_quantities() {
    head({"All quantities, checked", "Tutte le grandezze, verificate"});
    add(Paragraph{
        say({"Found by: ", "Trovate per queste vie: "}) + routes() + ". " +
        say({"The true value lies between the bounds told. What the sheets of epure draw show is measured on "
             "them as their files hold them, ± what a file can hold.",
             "Il valore vero sta fra i limiti detti. Ciò che mostrano le tavole di epure draw è misurato su di "
             "esse come stanno nei file, ± quanto un file può contenere."})});
    Table table{.head = {say({"quantity", "grandezza"}), say({"value", "valore"}), say({"between", "compresa fra"}),
                         say({"on the sheets", "sulle tavole"})},
                .rows = {}};
    Cases cases;
    for (const CheckedQuantity& quantity : checked_.quantities) {
      cases.within(quantity.spec.name, table.rows);
      const bool is_known = has_value(quantity.settled);
      table.rows.push_back({quantity.spec.symbol + ", " + say(quantity.spec.meaning),
                            words_as_numbers(say(number_in_words(quantity))) +
                                (is_known ? unit_after_number(quantity.spec.unit, language_) : ""),
                            is_known ? bounds(quantity.settled.enclosure) : "", on_sheets(quantity)});
    }
    add(std::move(table));
    Remarks reasons;
    for (const CheckedQuantity& quantity : checked_.quantities)
      if (quantity.settled.kind == geometry::Settled::Kind::absent)
        reasons.add(letters_of(quantity.spec), say(quantity.settled.reason));
    add_remarks(reasons);
  }

  // All digits of both; of one and the same number, once.
  std::string bounds(const geometry::Enclosure& enclosure) const {
    const std::string lower = typographic(say(all_digits(enclosure.lower)));
    return enclosure.lower == enclosure.upper
               ? lower
               : lower + no_break + "… " + typographic(say(all_digits(enclosure.upper)));
  }

  // With the case before it, where there is one: "dead_centre: ω₃".
  static std::string letters_of(const Quantity& quantity) {
    const auto point = quantity.name.find('.');
    return (point == std::string::npos ? "" : quantity.name.substr(0, point) + ": ") + quantity.symbol;
  }

  std::string routes() const {
    std::vector<std::string> names;
    for (const CheckedQuantity& quantity : checked_.quantities)
      for (const RouteValue& each : quantity.routes)
        if (std::find(names.begin(), names.end(), each.route) == names.end()) names.push_back(each.route);
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + say(route_in_words(name));
    return drawings::escaped(text);
  }

  std::string on_sheets(const CheckedQuantity& quantity) const {
    std::string text;
    for (const OnSheet& on : quantity.on_sheets) {
      const std::string shown = say(on_sheet_in_words(on));
      const auto blank = shown.find(" ± ");
      text += (text.empty() ? "" : "; ") + words_as_numbers(shown.substr(0, blank)) + " ±" + no_break +
              words_as_numbers(shown.substr(blank + std::string(" ± ").size())) + " (" +
              say(title_of_sheet(exercise_, on.sheet)) + ")";
    }
    return text;
  }

  void add_printed() {
    Table table{.head = {say({"quantity", "grandezza"}), say({"printed", "stampata"}), say({"by", "per via"}),
                         say({"value", "valore"}), say({"difference", "differenza"}), say({"verdict", "giudizio"})},
                .rows = {}};
    Remarks explanations;
    Cases cases;
    for (const CheckedQuantity& quantity : checked_.quantities)
      for (const PrintedVerdict& each : quantity.printed) {
        cases.within(quantity.spec.name, table.rows);
        const std::string printed = drawings::escaped(say(decimal(each.text)));
        table.rows.push_back({quantity.spec.symbol, printed, drawings::escaped(say(route_in_words(each.route))),
                              words_as_numbers(say(number_in_words(quantity))),
                              with_true_minus(say(percent(each.difference_percent))), say(in_words(each.verdict))});
        if (each.explanation)
          explanations.add(letters_of(quantity.spec) + say({" printed ", ", stampata "}) + printed,
                           say(*each.explanation));
      }
    if (table.rows.empty()) return;
    head({"What the source printed", "Ciò che la fonte stampa"});
    add(std::move(table));
    add_remarks(explanations);
  }

  // Columns with the same blocks are told together.
  void add_audits() {
    for (const TableAudit& each : checked_.audits) {
      add(Paragraph{say(format_words("Printed {}, row by row:", "Riga per riga, {}:", each.table))});
      Remarks remarks;
      for (const AuditedColumn& column : each.columns) {
        std::string blocks;
        for (const AuditedBlock& block : column.blocks)
          blocks += (blocks.empty() ? "" : "; ") + say(block_in_words(each, block));
        remarks.add(column.name, blocks);
      }
      add_remarks(remarks);
    }
  }

  void add_complaints(const Words& heading, const std::vector<Complaint>& all) {
    if (all.empty()) return;
    head(heading);
    ReportList list;
    for (const Complaint& each : all) list.items.push_back(say(each.sentence));
    add(std::move(list));
  }

  void add_remarks(const Remarks& remarks) {
    ReportList list;
    for (const auto& [subjects, remark] : remarks.all()) list.items.push_back(subjects + ": " + remark);
    if (!list.items.empty()) add(std::move(list));
  }

  const Exercise& exercise_;
  const Givens& givens_;
  const CheckedExercise& checked_;
  Language language_;
  std::string figures_;
  double widest_figure_;
  std::vector<ReportBlock>* blocks_ = nullptr;
};

const Exercise& exercise_reported(const Catalogue& exercises, const Options& options) {
  const std::vector<Target> targets = find_targets(exercises, options.names);
  if (targets.size() != 1 || !targets.front().sheet.empty())
    throw WrongUsage("report takes one exercise: epure report ID (epure list shows them)",
                     "report prende un esercizio: epure report ID (epure list li mostra)");
  return *targets.front().exercise;
}

// Of all its files the document comes last.
std::vector<drawings::File> files_of(const ReportDocument& document, ReportFormat format, const fs::path& path) {
  std::vector<drawings::File> files;
  for (const ReportBlock& block : document.blocks) {
    const auto* figure = std::get_if<ReportFigure>(&block);
    if (!figure || format == ReportFormat::html) continue;
    const bool is_pdf = format == ReportFormat::latex;
    files.push_back({path.parent_path() / (figure->name + (is_pdf ? ".pdf" : ".svg")),
                     is_pdf ? drawings::write_pdf({figure->page}, {.title = figure->page.title})
                            : drawings::write_svg(figure->page)});
  }
  files.push_back({path, format == ReportFormat::markdown ? markdown_of(document)
                         : format == ReportFormat::latex  ? latex_of(document)
                                                          : html_of(document)});
  return files;
}

}  // namespace

Outcome report(const Catalogue& exercises, const Options& options) {
  const Exercise& exercise = exercise_reported(exercises, options);
  const Language in = language(options);
  const ReportFormat format = report_format(options);
  const fs::path path = path_of(exercise, format, options);
  GivensFile rows{{Candidate{}}};
  if (options.givens_file) rows = read_givens_file(*options.givens_file, {&exercise}, options.assignments);
  if (rows.rows.size() > 1)
    throw WrongUsage(format_words("{} has {} rows, and a report has one set of givens",
                                  "{} ha {} righe, e una relazione ha una sola serie di dati", *options.givens_file,
                                  rows.rows.size()));
  const Givens givens = givens_in(rows.rows.front(), {&exercise}, options.assignments).front();
  const std::vector<CheckedExercise> checked{check(exercise, givens, Rung::climb)};
  const ReportDocument document =
      ReportMaker(exercise, givens, checked.front(), in, path.stem().string(),
                  format == ReportFormat::markdown ? widest_markdown_figure : widest_report_figure)
          .document();
  const std::vector<drawings::File> files = files_of(document, format, path);
  Outcome outcome{.text = "", .exit = exit_of(checked), .remarks = sheets_not_drawn(checked)};
  if (is_standard_output(options)) {
    outcome.text = files.back().bytes;
  } else {
    drawings::write_whole(files);
    for (const drawings::File& file : files) outcome.text += shown_whole(file.path.string()) + "\n";
  }
  return outcome;
}

}  // namespace epure
