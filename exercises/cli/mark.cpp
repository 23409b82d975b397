#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "drawings/output.h"
#include "exercises/cli/mark_report.h"
#include "exercises/cli/request.h"
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
  if (!ends_in_csv(options)) refuse_ending_of_others(options, {"text or csv", "text o csv"});
  if (!options.format && !options.csv) return ends_in_csv(options);
  const std::string format = lower_case(options.format.value_or("csv"));
  if (format == "csv") return true;
  if (format != "text")
    throw WrongUsage(format_words("\"{}\" is no format of marks; choose text or csv",
                                  "\"{}\" non è un formato di valutazioni; scegliere text o csv", *options.format));
  if (options.csv)
    throw WrongUsage("--csv says how CSV is written, and --format text is none; leave one of them out",
                     "--csv dice come scrivere il CSV, e --format text non lo è; togliere uno dei due");
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

// --out-of: the mark that all points are.
std::optional<Rational> best_mark(const Options& options) {
  constexpr int most = 1000;
  if (!options.out_of) return {};
  const Rational best = points_typed("--out-of", *options.out_of, most);
  if (best > 0) return best;
  throw WrongUsage(
      format_words("--out-of {}: must be more than 0", "--out-of {}: dev'essere più di 0", *options.out_of));
}

// "v_B=2,omega_3=1", of quantities that are asked.
std::map<std::string, Rational> points_asked(const Options& options, const std::vector<Quantity>& asked) {
  constexpr int most_points = 1000;
  const std::vector<NameAndLetters> known = quantity_names(asked);
  std::vector<std::string> names;
  for (const Quantity& each : asked) names.push_back(each.name);
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

// The first of the key's values that are not true, and how many more there are.
Words other_key(const Marking& marking) {
  const std::size_t more = marking.other_key.size() - 1;
  return marking.other_key.front() +
         (more == 0 ? Words{} : format_words(" ({} more like it)", " (altri {} simili)", more));
}

// A key whose values are others than true for most of its students is none of these exercises, and marks by its
// givens would be wrong; so would no marks at all be for marks.
void demand_use_of_key(const Answers& answers, const Marking& marking) {
  if (2 * marking.contradicted > marking.keyed) throw BadTable(other_key(marking));
  const bool is_of_use = std::any_of(marking.students.begin(), marking.students.end(), [](const auto& student) {
    return std::any_of(student.marks.begin(), student.marks.end(),
                       [](const Mark& mark) { return mark.kind != Mark::not_marked || !mark.remark.empty(); });
  });
  if (is_of_use || !marking.undecided.empty()) return;
  const auto told = std::find_if(answers.students.begin(), answers.students.end(),
                                 [](const Student& each) { return !each.remarks.empty(); });
  throw BadTable(format_words("nothing can be marked by this key; {}: {}",
                              "con questa chiave non si può valutare nulla; {}: {}", told->number,
                              told->remarks.front()));
}

// Who has drawn and measured is right more often than not; a whole class that is not has other givens.
std::optional<Words> doubt_in_givens(const Marking& marking, bool has_key) {
  std::size_t right = 0, answered = 0;
  for (const MarkedStudent& student : marking.students)
    for (const Mark& each : student.marks) {
      right += each.kind == Mark::right ? 1 : 0;
      answered += each.kind == Mark::none || each.kind == Mark::not_marked ? 0 : 1;
    }
  constexpr std::size_t a_class = 20;  // answers; a few may well be wrong
  if (answered < a_class || 2 * right >= answered) return {};
  return has_key ? format_words(
                       "only {} of {} answers are right: is it the key of the sheets that were handed out "
                       "(the same --seed, --vary and --set)?",
                       "solo {} risposte su {} sono giuste: è la chiave delle tavole distribuite (stessi "
                       "--seed, --vary e --set)?",
                       right, answered)
                 : format_words(
                       "only {} of {} answers are right: are the givens those of the sheets that were handed "
                       "out (--key, --set)?",
                       "solo {} risposte su {} sono giuste: i dati sono quelli delle tavole distribuite (--key, "
                       "--set)?",
                       right, answered);
}

// What is to be said beside the marks: of the tables, a key that does not fit, once, and what is undecided, each.
std::vector<Words> remarks_on(const Answers& answers, const Marking& marking, bool has_key) {
  std::vector<Words> remarks = answers.remarks;
  if (const auto doubt = doubt_in_givens(marking, has_key)) remarks.push_back(*doubt);
  if (!marking.other_key.empty()) remarks.push_back(other_key(marking));
  for (const Words& each : marking.undecided)
    remarks.push_back(format_words("cannot be decided: {}", "non si può decidere: {}", each));
  return remarks;
}

}  // namespace

Outcome mark(const Catalogue& exercises, const Options& options) {
  const Exercise& exercise = exercise_to_mark(exercises, options);
  const bool as_csv = wants_csv(options);
  const CsvStyle style = csv_style(options);
  const Reader reader{language(options), options.colours && !options.file};
  const Givens givens = set_givens({&exercise}, options.assignments).front();
  MarkingRules rules{.ruler = ruler_asked({&exercise}, options),
                     .slip_points = points_typed("--slip-points", options.slip_points, 1),
                     .out_of = best_mark(options)};
  if (!options.answers)
    throw WrongUsage("say where the answers are: epure mark ID --answers FILE",
                     "dire dove sono le risposte: epure mark ID --answers FILE");
  const CsvTable table = read_csv_file(*options.answers);
  std::optional<CsvTable> key;
  if (options.key) key = read_csv_file(*options.key);
  Answers answers = read_answers(exercise, table, key ? &*key : nullptr, givens);
  std::vector<Words> on_files;
  if (!table.remark.empty()) on_files.push_back(table.remark);
  if (key && !key->remark.empty()) on_files.push_back(key->remark);
  answers.remarks.insert(answers.remarks.begin(), on_files.begin(), on_files.end());
  rules.points = points_asked(options, answers.asked);
  if (rules.ruler.sheet.empty() && answers.sheets.size() == 1) rules.ruler.sheet = answers.sheets.front();

  const Marking marking = mark_answers(exercise, answers, rules);
  if (key) demand_use_of_key(answers, marking);
  const std::string text = as_csv ? mark_csv(answers, marking, rules, style, reader.language)
                                  : mark_report(exercise, answers, marking, rules, reader);
  const Exit exit = marking.undecided.empty() ? Exit::success : Exit::undecided;
  if (!options.file || is_standard_output(options))
    return {text, exit, remarks_on(answers, marking, key.has_value())};
  drawings::write_whole(*options.file, text);
  return {*options.file + "\n", exit, remarks_on(answers, marking, key.has_value())};
}

}  // namespace epure
