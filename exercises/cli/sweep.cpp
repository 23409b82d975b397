// The verb that runs an exercise over all values of some of its givens.
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <ostream>

#include "exercises/cli/in_order.h"
#include "exercises/cli/moved_by_speed.h"
#include "exercises/cli/print.h"
#include "exercises/cli/progress.h"
#include "exercises/cli/request.h"
#include "exercises/cli/sweep_chart.h"
#include "exercises/cli/sweep_html.h"
#include "exercises/cli/verbs.h"

namespace epure {
namespace {

// So many rows are found in one go: worth handing over, and soon seen.
constexpr std::uint64_t rows_of_a_block = 8;

struct BlockOfRows {
  std::vector<SweptRow> rows;
  std::string lines;
};

// Standard output, or a file.
class LinesOut {
 public:
  LinesOut(const Options& options, std::ostream& out) : out_(out) {
    if (options.file && !is_standard_output(options)) file_.emplace(*options.file);
  }

  // False when nobody reads any more.
  bool write(const std::string& lines) {
    try {
      if (file_)
        file_->write(lines);
      else
        print(out_, lines);
      return true;
    } catch (const NobodyReads&) {
      return false;
    }
  }
  void finish() {
    if (file_) file_->finish();
  }

 private:
  std::ostream& out_;
  std::optional<drawings::GrowingFile> file_;
};

struct SweepTally {
  std::uint64_t possible = 0, undecided = 0, disagreeing = 0;
  std::optional<Words> why_impossible = {};  // of the first that is

  void add(const SweptRow& row) {
    possible += row.is_possible() ? 1 : 0;
    undecided += row.is_undecided() ? 1 : 0;
    disagreeing += row.has_disagreement() ? 1 : 0;
    if (!row.is_possible() && !why_impossible) why_impossible = row.quantities.front().reason;
  }
};

Outcome outcome_of_sweep(const SweepTally& tally) {
  if (tally.disagreeing > 0)
    return {"",
            Exit::failed_check,
            {format_words("in {} positions the routes disagree; their reasons say how",
                          "in {} posizioni le vie discordano; i loro motivi dicono come", tally.disagreeing)}};
  if (tally.undecided > 0)
    return {"",
            Exit::undecided,
            {format_words("in {} positions something could not be decided; their reasons say what",
                          "in {} posizioni qualcosa non si è potuto decidere; i loro motivi dicono che cosa",
                          tally.undecided)}};
  return {""};
}

class Sweeping {
 public:
  Sweeping(const Catalogue& exercises, const Options& options)
      : language_(language(options)),
        study_(sweep_study(exercises, options)),
        part_(part_of_rows(options, study_.size())),
        format_(row_format(options)),
        style_(csv_style(options)) {
    if (options.csv && format_ != RowFormat::csv) refuse_csv();
    if (format_ == RowFormat::html) begin_page();
    if (!options.chart) return;
    if (!part_.is_whole)
      throw WrongUsage("--chart draws a whole sweep, and --part is one of its parts; leave one of them out",
                       "--chart disegna tutte le posizioni, e --part è una loro parte; togliere uno dei due");
    demand_chart_file(*options.chart);
    chart_.emplace(study_, "--chart", language_);
    chart_file_ = *options.chart;
    const std::filesystem::path folder = std::filesystem::path(*options.chart).parent_path();
    drawings::demand_writable(folder.empty() ? "." : folder);
  }

  Outcome run(LinesOut& lines, Progress& progress) {
    if (part_.is_first && format_ == RowFormat::csv && !lines.write(csv_header(study_, style_))) return {""};
    const std::uint64_t blocks = (part_.size() + rows_of_a_block - 1) / rows_of_a_block;
    bool is_read = true;
    in_order(
        blocks, [&](std::uint64_t block) { return block_of_rows(block); },
        [&](const BlockOfRows& block) {
          for (const SweptRow& row : block.rows) {
            tally_.add(row);
            if (chart_) chart_->add(row);
            if (page_chart_) page_chart_->add(row);
          }
          if (page_chart_) rows_.insert(rows_.end(), block.rows.begin(), block.rows.end());
          progress.has_done(block.rows.size());
          return is_read = lines.write(block.lines);
        });
    if (!is_read) return {""};
    if (part_.is_whole && tally_.possible == 0)
      throw WrongUsage(Words{"no position of the sweep is possible: ", "nessuna posizione è possibile: "} +
                       *tally_.why_impossible);
    if (page_chart_ && !lines.write(sweep_html(study_, rows_, *page_chart_, language_))) return {""};
    lines.finish();
    if (chart_) drawings::write_whole({chart_->drawn(chart_file_)});
    Outcome outcome = outcome_of_sweep(tally_);
    std::vector<std::string> swept;
    for (const Variation& each : study_.over) swept.push_back(each.given().symbol);
    for (Words& each : moved_by_speed(study_.givens, swept)) outcome.remarks.push_back(std::move(each));
    return outcome;
  }

  std::uint64_t size() const { return part_.size(); }

 private:
  [[noreturn]] void refuse_csv() const {
    const char* const other = format_ == RowFormat::json ? "json" : "html";
    throw WrongUsage(format_words("--csv says how CSV is written, and --format {} is none; leave one of them out",
                                  "--csv dice come scrivere il CSV, e --format {} non lo è; togliere uno dei due",
                                  other));
  }

  // A page needs all rows, and has charts of its own.
  void begin_page() {
    if (!part_.is_whole)
      throw WrongUsage(
          "--format html is a page of a whole sweep, and --part is one of its parts; leave one of them out",
          "--format html è la pagina di tutte le posizioni, e --part è una loro parte; togliere uno dei due");
    if (study_.size() > most_positions_of_page)
      throw WrongUsage(format_words("a page bears {} positions, and the values of --over make {}",
                                    "una pagina porta {} posizioni, e i valori di --over ne fanno {}",
                                    most_positions_of_page, study_.size()));
    page_chart_.emplace(study_, "--format html", language_);
  }

  BlockOfRows block_of_rows(std::uint64_t block) const {
    BlockOfRows made;
    const std::uint64_t first = part_.first + block * rows_of_a_block,
                        end = std::min(first + rows_of_a_block, part_.end);
    for (std::uint64_t number = first; number < end; ++number) {
      made.rows.push_back(swept_row(study_, number));
      if (format_ == RowFormat::csv) made.lines += csv_line(study_, made.rows.back(), style_, language_);
      if (format_ == RowFormat::json) made.lines += json_line(study_, made.rows.back());
    }
    return made;
  }

  Language language_;
  SweepStudy study_;
  PartOfRows part_;
  RowFormat format_;
  CsvStyle style_;
  std::optional<SweepChart> chart_, page_chart_;
  std::string chart_file_;
  std::vector<SweptRow> rows_;  // of a page
  SweepTally tally_;
};

}  // namespace

Outcome sweep(const Catalogue& exercises, const Options& options, std::ostream& out, std::ostream& err,
              const Surroundings& surroundings) {
  Sweeping sweeping(exercises, options);
  LinesOut lines(options, out);
  const bool is_seen = (!options.file || is_standard_output(options)) && surroundings.out_is_terminal;
  Progress progress(sweeping.size(), surroundings.err_is_terminal && !is_seen, err, language(options));
  return sweeping.run(lines, progress);
}

}  // namespace epure
