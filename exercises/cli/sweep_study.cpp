#include "exercises/cli/sweep_study.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "exercises/cli/givens_file.h"
#include "exercises/cli/request.h"
#include "exercises/cli/variations.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

const Exercise& single_exercise(const Catalogue& exercises, const Options& options) {
  if (options.names.size() != 1)
    throw WrongUsage(
        "sweep takes one exercise: epure sweep ID --over phi=0..360/361 --quantity NAME (epure list shows "
        "them)",
        "sweep prende un esercizio: epure sweep ID --over phi=0..360/361 --quantity NOME (epure list li "
        "mostra)");
  const Target target = find_targets(exercises, options.names).front();
  if (options.names.front() == "all" || !target.sheet.empty())
    throw WrongUsage(format_words("\"{}\" is not one exercise, and sweep takes one",
                                  "\"{}\" non è un esercizio, e sweep "
                                  "ne prende uno",
                                  options.names.front()));
  return *target.exercise;
}

std::vector<std::string> at_commas(const std::vector<std::string>& lists) {
  std::vector<std::string> items;
  for (const std::string& list : lists) {
    std::string rest = list + ",";
    for (auto comma = rest.find(','); comma != std::string::npos; comma = rest.find(',')) {
      const std::size_t first = std::min(rest.find_first_not_of(' '), comma);
      items.push_back(rest.substr(first, comma - first));
      rest.erase(0, comma + 1);
    }
  }
  return items;
}

std::vector<Quantity> quantities_asked_for(const Description& about, const Options& options) {
  const std::vector<NameAndLetters> names = quantity_names(about.quantities());
  std::vector<std::string> known;
  for (const Quantity& quantity : about.quantities()) known.push_back(quantity.name);
  if (options.quantities.empty()) {
    const std::size_t few = std::min<std::size_t>(known.size(), 2);
    std::string some;
    for (std::size_t i = 0; i < few; ++i) some += (i == 0 ? "" : ",") + known[i];
    throw WrongUsage(format_words("say which quantities, such as --quantity {} (epure list {} shows all {})",
                                  "dire quali grandezze, come --quantity {} (epure list {} le mostra tutte e {})",
                                  some, about.id, known.size()));
  }
  std::vector<Quantity> asked;
  for (const std::string& typed : at_commas(options.quantities)) {
    const std::string name = ascii_name(typed, names);
    const auto place = std::find(known.begin(), known.end(), name);
    if (place == known.end())
      throw WrongUsage(format_words("--quantity: there is no quantity \"{}\"; {} (epure list {} shows all)",
                                    "--quantity: non c'è alcuna grandezza \"{}\"; {} (epure list {} le mostra)", name,
                                    did_you_mean(name, known), about.id));
    if (std::none_of(asked.begin(), asked.end(), [&](const Quantity& one) { return one.name == name; }))
      asked.push_back(about.quantities()[static_cast<std::size_t>(place - known.begin())]);
  }
  return asked;
}

void demand_feasible(const std::vector<Variation>& over) {
  std::uint64_t rows = 1;
  for (const Variation& each : over) {
    if (rows > most_values / each.size())
      throw WrongUsage(format_words("the values of --over make more than {} positions together",
                                    "i valori di --over fanno insieme più di {} posizioni", most_values));
    rows *= each.size();
  }
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_read = !text.empty() && error == std::errc() && end == text.data() + text.size();
  return is_read && number <= most_values ? std::optional(number) : std::nullopt;
}

std::optional<RowFormat> row_format_named(const std::string& typed) {
  const std::string name = lower_case(typed);
  if (name == "csv") return RowFormat::csv;
  if (name == "json" || name == "jsonl" || name == "ndjson") return RowFormat::json;
  if (name == "html") return RowFormat::html;
  return std::nullopt;
}

// What --set and --givens say.
std::vector<std::string> all_assignments(const Exercise& exercise, const Options& options) {
  std::vector<std::string> all = options.assignments;
  if (!options.givens_file) return all;
  const GivensFile file = read_givens_file(*options.givens_file, {&exercise}, options.assignments);
  if (file.rows.size() > 1)
    throw WrongUsage(format_words("{} has {} rows, and a sweep has one set of givens; vary them by --over",
                                  "{} ha {} righe, e sweep prende una sola serie di dati; farli variare con --over",
                                  *options.givens_file, file.rows.size()));
  all.insert(all.end(), file.rows.front().assignments.begin(), file.rows.front().assignments.end());
  return all;
}

}  // namespace

std::uint64_t SweepStudy::size() const {
  std::uint64_t rows = 1;
  for (const Variation& each : over) rows *= each.size();
  return rows;
}

std::vector<std::uint64_t> SweepStudy::places(std::uint64_t row) const {
  std::vector<std::uint64_t> found(over.size());
  for (std::size_t i = over.size(); i-- > 0;) {
    found[i] = row % over[i].size();
    row /= over[i].size();
  }
  return found;
}

Givens SweepStudy::givens_at(std::uint64_t row) const {
  Givens set = givens;
  const std::vector<std::uint64_t> at = places(row);
  for (std::size_t i = 0; i < over.size(); ++i) set.set(over[i].assignment(at[i]));
  return set;
}

std::vector<std::string> SweepStudy::quantity_names() const {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  return names;
}

SweepStudy sweep_study(const Catalogue& exercises, const Options& options) {
  const Exercise& exercise = single_exercise(exercises, options);
  const Description& about = exercise.about();
  if (about.givens.empty())
    throw WrongUsage(format_words("{} has no givens to sweep over", "{} non ha dati da far variare", about.id));
  if (options.variations.empty())
    throw WrongUsage(
        format_words("say what to sweep over, such as --over {}=FROM..TO/COUNT (epure help sweep explains)",
                     "dire che cosa far variare, come --over {}=DA..A/QUANTI (epure help sweep spiega)",
                     about.givens.front().symbol));
  const std::vector<std::string> assignments = all_assignments(exercise, options);
  SweepStudy study{&exercise, set_givens({&exercise}, assignments).front(),
                   read_variations(exercise, "--over", options.variations, assignments),
                   quantities_asked_for(about, options)};
  demand_feasible(study.over);
  return study;
}

PartOfRows part_of_rows(const Options& options, std::uint64_t rows) {
  if (!options.part) return {0, rows, true, true};
  const auto slash = options.part->find('/');
  const auto part = whole_number(options.part->substr(0, slash)),
             parts = slash == std::string::npos ? std::nullopt : whole_number(options.part->substr(slash + 1));
  if (!part || !parts || *part < 1 || *part > *parts)
    throw WrongUsage(format_words("\"{}\" is no part; write 3/40 for the third of forty",
                                  "\"{}\" non è una parte; scrivere 3/40 per la terza di quaranta", *options.part));
  return {rows * (*part - 1) / *parts, rows * *part / *parts, *part == 1, false};
}

RowFormat row_format(const Options& options) {
  const std::string ending = options.file ? std::filesystem::path(*options.file).extension().string() : "";
  const auto by_ending = ending.empty() ? std::nullopt : row_format_named(ending.substr(1));
  if (!by_ending) refuse_ending_of_others(options, {"csv, json or html", "csv, json o html"});
  if (!options.format) return by_ending.value_or(RowFormat::csv);
  const auto asked = row_format_named(*options.format);
  if (!asked)
    throw WrongUsage(format_words("\"{}\" is no format of a sweep; choose csv, json or html",
                                  "\"{}\" non è un formato di sweep; scegliere csv, json o html", *options.format));
  if (by_ending && by_ending != asked)
    throw WrongUsage(format_words("\"{}\" is not the ending of --format {}",
                                  "\"{}\" non finisce come vuole --format {}", *options.file, *options.format));
  return *asked;
}

}  // namespace epure
