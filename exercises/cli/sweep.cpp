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
    if (options.csv && format_ != RowFormat::csv) refuse_csv_of_json();
    if (!options.chart) return;
    if (!part_.is_whole)
      throw WrongUsage("--chart draws a whole sweep, and --part is one of its parts; leave one of them out",
                       "--chart disegna tutte le posizioni, e --part è una loro parte; togliere uno dei due");
    chart_.emplace(study_, *options.chart, language_);
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
          }
          progress.has_done(block.rows.size());
          return is_read = lines.write(block.lines);
        });
    if (!is_read) return {""};
    if (part_.is_whole && tally_.possible == 0)
      throw WrongUsage(Words{"no position of the sweep is possible: ", "nessuna posizione è possibile: "} +
                       *tally_.why_impossible);
    lines.finish();
    if (chart_) drawings::write_whole({chart_->drawn()});
    Outcome outcome = outcome_of_sweep(tally_);
    std::vector<std::string> swept;
    for (const Variation& each : study_.over) swept.push_back(each.given().symbol);
    for (Words& each : moved_by_speed(study_.givens, swept)) outcome.remarks.push_back(std::move(each));
    return outcome;
  }

  std::uint64_t size() const { return part_.size(); }

 private:
  [[noreturn]] static void refuse_csv_of_json() {
    throw WrongUsage("--csv says how CSV is written, and --format json is none; leave one of them out",
                     "--csv dice come scrivere il CSV, e --format json non lo è; togliere uno dei due");
  }

  BlockOfRows block_of_rows(std::uint64_t block) const {
    BlockOfRows made;
    const std::uint64_t first = part_.first + block * rows_of_a_block,
                        end = std::min(first + rows_of_a_block, part_.end);
    for (std::uint64_t number = first; number < end; ++number) {
      made.rows.push_back(swept_row(study_, number));
      made.lines += format_ == RowFormat::csv ? csv_line(study_, made.rows.back(), style_, language_)
                                              : json_line(study_, made.rows.back());
    }
    return made;
  }

  Language language_;
  SweepStudy study_;
  PartOfRows part_;
  RowFormat format_;
  CsvStyle style_;
  std::optional<SweepChart> chart_;
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
