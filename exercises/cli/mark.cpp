#include <algorithm>
#include <filesystem>
#include <map>

#include "drawings/output.h"
#include "exercises/cli/mark_report.h"
#include "exercises/cli/request.h"
#include "exercises/cli/symbol.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

const Exercise& exercise_to_mark(const Catalogue& exercises, const Options& options) {
  if (options.names.size() != 1 || options.names.front() == "all")
    throw WrongUsage("one exercise at a time: epure mark ID --answers FILE",
                     "un esercizio alla volta: epure mark ID --answers FILE");
  return *find_exercises(exercises, options.names).front();
}

bool ends_in_csv(const Options& options) {
  return options.file && lower_case(std::filesystem::path(*options.file).extension().string()) == ".csv";
}

bool wants_csv(const Options& options) {
  if (!options.format) return ends_in_csv(options);
  const std::string format = lower_case(*options.format);
  if (format == "csv") return true;
  if (format != "text")
    throw WrongUsage(format_words("\"{}\" is no format of marks; choose text or csv",
                                  "\"{}\" non è un formato di valutazioni; scegliere text o csv", *options.format));
  if (ends_in_csv(options))
    throw WrongUsage(format_words("\"{}\" is not the ending of --format text",
                                  "\"{}\" non finisce come vuole --format text", *options.file));
  return false;
}

// Not negative, and small enough to be added up.
Rational points_typed(const std::string& option, const std::string& text, int most) {
  Rational points = 0;
  try {
    points = geometry::parse_given(text, "1");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage(option + ": " + unreadable.words());
  }
  if (points >= 0 && points <= most) return points;
  throw WrongUsage(
      format_words("{} {}: must lie between 0 and {}", "{} {}: deve stare tra 0 e {}", option, text, most));
}

// "v_B=2,omega_3=1", of quantities that are asked.
std::map<std::string, Rational> points_asked(const Options& options, const std::vector<Quantity>& asked) {
  constexpr int most_points = 1000;
  std::vector<NameAndLetters> known;
  std::vector<std::string> names;
  for (const Quantity& each : asked) {
    known.push_back({each.name, unicode_symbol(each.symbol)});
    names.push_back(each.name);
  }
  std::map<std::string, Rational> points;
  std::string rest = options.points.value_or("");
  while (!rest.empty()) {
    const std::string one = rest.substr(0, rest.find(','));
    rest.erase(0, std::min(one.size() + 1, rest.size()));
    const auto equals = one.find('=');
    if (equals == std::string::npos)
      throw WrongUsage(format_words("--points: \"{}\" gives no points; write v_B=2,omega_3=1.5",
                                    "--points: \"{}\" non assegna punti; scrivere v_B=2,omega_3=1.5", one));
    const std::string name = ascii_name(one.substr(0, equals), known);
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw WrongUsage(format_words("--points: the answers have no column \"{}\"; {}",
                                    "--points: le risposte non hanno la colonna \"{}\"; {}", name,
                                    did_you_mean(name, names)));
    if (!points.emplace(name, points_typed("--points " + name, one.substr(equals + 1), most_points)).second)
      throw WrongUsage(format_words("--points: {} is given twice", "--points: {} è dato due volte", name));
  }
  return points;
}

// What is to be said beside the marks: a key that does not fit, once, and what is undecided, each.
std::vector<Words> remarks_on(const Marking& marking) {
  std::vector<Words> remarks;
  if (!marking.other_key.empty()) {
    const std::size_t more = marking.other_key.size() - 1;
    remarks.push_back(marking.other_key.front() +
                      (more == 0 ? Words{} : format_words(" ({} more like it)", " (altri {} simili)", more)));
  }
  for (const Words& each : marking.undecided)
    remarks.push_back(format_words("cannot be decided: {}", "non si può decidere: {}", each));
  return remarks;
}

}  // namespace

Outcome mark(const Catalogue& exercises, const Options& options) {
  const Exercise& exercise = exercise_to_mark(exercises, options);
  const bool as_csv = wants_csv(options);
  const Reader reader{language(options), options.colours && !options.file};
  const Givens givens = set_givens({&exercise}, options.assignments).front();
  MarkingRules rules{.ruler = ruler_asked({&exercise}, options),
                     .slip_points = points_typed("--slip-points", options.slip_points, 1)};
  if (!options.answers)
    throw WrongUsage("say where the answers are: epure mark ID --answers FILE",
                     "dire dove sono le risposte: epure mark ID --answers FILE");
  const CsvTable table = read_csv_file(*options.answers);
  std::optional<CsvTable> key;
  if (options.key) key = read_csv_file(*options.key);
  Answers answers = read_answers(exercise, table, key ? &*key : nullptr, givens);
  rules.points = points_asked(options, answers.asked);

  const Marking marking = mark_answers(exercise, answers, rules);
  const std::string text =
      as_csv ? mark_csv(answers, marking, rules, reader.language) : mark_report(exercise, answers, marking, reader);
  const Exit exit = marking.undecided.empty() ? Exit::success : Exit::undecided;
  if (!options.file || is_standard_output(options)) return {text, exit, remarks_on(marking)};
  drawings::write_whole(*options.file, text);
  return {*options.file + "\n", exit, remarks_on(marking)};
}

}  // namespace epure
