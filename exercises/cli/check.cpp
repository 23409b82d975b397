#include <fmt/format.h>

#include <algorithm>

#include "exercises/cli/check_report.h"
#include "exercises/cli/givens_file.h"
#include "exercises/cli/request.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

Rung rung(const Options& options) {
  if (options.arithmetic == "fast") return Rung::fast;
  if (options.arithmetic == "bounded") return Rung::bounded;
  if (options.arithmetic == "exact") return Rung::climb;
  throw WrongUsage(format_words("\"{}\" is no arithmetic of epure; choose fast, bounded or exact",
                                "\"{}\" non è un'aritmetica di epure; scegliere fast, bounded o exact",
                                options.arithmetic));
}

// "v_B=5.25m/s", taken apart.
struct MeasuredText {
  std::string name, value;
};
std::vector<MeasuredText> measured_texts(const std::vector<const Exercise*>& exercises, const Options& options) {
  std::vector<NameAndLetters> known;
  for (const Exercise* exercise : exercises)
    for (NameAndLetters& each : quantity_names(exercise->about().quantities())) known.push_back(std::move(each));
  std::vector<MeasuredText> texts;
  for (const std::string& typed : options.measured) {
    const auto equals = typed.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw WrongUsage(format_words("\"{}\" is no measured number; write name=value, such as omega_3=13",
                                    "\"{}\" non è un numero misurato; scrivere nome=valore, come omega_3=13", typed));
    texts.push_back({ascii_name(typed.substr(0, equals), known), typed.substr(equals + 1)});
  }
  return texts;
}

void demand_known(const std::vector<const Exercise*>& exercises, const std::vector<MeasuredText>& texts) {
  std::vector<std::string> known;
  for (const Exercise* exercise : exercises)
    for (const Quantity& spec : exercise->about().quantities())
      if (std::find(known.begin(), known.end(), spec.name) == known.end()) known.push_back(spec.name);
  for (const MeasuredText& text : texts)
    if (std::find(known.begin(), known.end(), text.name) == known.end())
      throw WrongUsage(format_words("--measured: there is no quantity \"{}\"; {}",
                                    "--measured: non c'è alcuna grandezza \"{}\"; {}", text.name,
                                    did_you_mean(text.name, known)));
}

void add_all_measured(CheckedExercise& checked, const std::vector<MeasuredText>& texts, const Ruler& ruler) {
  for (const MeasuredText& text : texts)
    for (CheckedQuantity& quantity : checked.quantities) {
      if (quantity.spec.name != text.name) continue;
      try {
        add_measured(checked, quantity, text.value, ruler);
      } catch (const geometry::BadGiven& unreadable) {
        throw WrongUsage("--measured " + text.name + ": " + unreadable.words());
      }
    }
}

}  // namespace

Exit exit_of(const std::vector<CheckedExercise>& all) {
  Exit exit = Exit::success;
  for (const CheckedExercise& checked : all) {
    if (!checked.failures.empty()) return Exit::failed_check;
    if (!checked.not_drawn.empty()) exit = Exit::wrong_usage;
    if (!checked.undecided.empty() && exit == Exit::success) exit = Exit::undecided;
  }
  return exit;
}

std::vector<Words> sheets_not_drawn(const std::vector<CheckedExercise>& all) {
  std::vector<Words> remarks;
  for (const CheckedExercise& checked : all)
    if (!checked.not_drawn.empty()) remarks.push_back(checked.about.id + ": " + checked.not_drawn.front().sentence);
  return remarks;
}

namespace {

// One that says nothing, where there is no file.
GivensFile rows_asked(const std::vector<const Exercise*>& exercises, const Options& options) {
  if (!options.givens_file) return {{Candidate{}}};
  GivensFile file = read_givens_file(*options.givens_file, exercises, options.assignments);
  if (file.rows.size() > 1 && !options.measured.empty())
    throw WrongUsage(format_words("--measured is of one drawing, and {} has {} rows",
                                  "--measured è di un solo disegno, e {} ha {} righe", *options.givens_file,
                                  file.rows.size()));
  return file;
}

CheckedExercise check_at(const Candidate& row, const Exercise& exercise, const Givens& givens, Rung number) {
  try {
    return check(exercise, givens, number);
  } catch (const BadGivens& why) {
    throw BadGivens(in_place(row, why.words()));
  } catch (const geometry::Impossible& why) {
    throw BadGivens(in_place(row, why.words()));
  }
}

// "variants.csv, line 3: 12345 Rossi"
std::string heading_of(const Candidate& row, Language language) {
  return row.place.in(language) + ": " + row.number + (row.name.empty() ? "" : " " + row.name) + "\n";
}

}  // namespace

Outcome check(const Catalogue& exercises, const Options& options) {
  const std::vector<const Exercise*> chosen = find_exercises(exercises, options.names);
  const Rung number = rung(options);
  const Ruler ruler = ruler_asked(chosen, options);
  const std::vector<MeasuredText> texts = measured_texts(chosen, options);
  demand_known(chosen, texts);
  const GivensFile rows = rows_asked(chosen, options);

  const Reader reader{language(options), options.colours};

  std::vector<CheckedExercise> checked;
  std::vector<Candidate> row_of_each;
  std::string report;
  for (const Candidate& row : rows.rows) {
    const std::vector<Givens> givens = givens_in(row, chosen, options.assignments);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      checked.push_back(check_at(row, *chosen[i], givens[i], number));
      if (rows.is_table) row_of_each.push_back(row);
      add_all_measured(checked.back(), texts, ruler);
      if (options.json) continue;
      if (rows.is_table && !options.quiet) report += heading_of(row, reader.language);
      if (options.quiet) {
        report += measured_report(checked.back(), reader);
        continue;
      }
      report += text_report(checked.back(), reader) + "\n";
      if (chosen.size() * rows.rows.size() > 1) report += closing_line(checked.back(), reader) + "\n";
    }
  }
  return {options.json ? json_report(checked, row_of_each) : report + totals(checked, reader), exit_of(checked),
          sheets_not_drawn(checked)};
}

}  // namespace epure
