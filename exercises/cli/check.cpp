#include <fmt/format.h>

#include <algorithm>

#include "exercises/cli/check_report.h"
#include "exercises/cli/request.h"
#include "exercises/cli/symbol.h"
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
    for (const Quantity& spec : exercise->about().quantities)
      known.push_back({spec.name, unicode_symbol(spec.symbol)});
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
    for (const Quantity& spec : exercise->about().quantities)
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

Exit exit_of(const std::vector<CheckedExercise>& all) {
  Exit exit = Exit::success;
  for (const CheckedExercise& checked : all) {
    if (!checked.failures.empty()) return Exit::failed_check;
    if (!checked.not_drawn.empty()) exit = Exit::wrong_usage;
    if (!checked.undecided.empty() && exit == Exit::success) exit = Exit::undecided;
  }
  return exit;
}

// Why, once for an exercise: its other sheets mostly fail for the same reason.
std::vector<Words> sheets_not_drawn(const std::vector<CheckedExercise>& all) {
  std::vector<Words> remarks;
  for (const CheckedExercise& checked : all)
    if (!checked.not_drawn.empty()) remarks.push_back(checked.about.id + ": " + checked.not_drawn.front().sentence);
  return remarks;
}

}  // namespace

Outcome check(const Catalogue& exercises, const Options& options) {
  const std::vector<const Exercise*> chosen = find_exercises(exercises, options.names);
  const Rung number = rung(options);
  const Ruler ruler = ruler_asked(chosen, options);
  const std::vector<MeasuredText> texts = measured_texts(chosen, options);
  demand_known(chosen, texts);
  const std::vector<Givens> givens = set_givens(chosen, options.assignments);

  const Reader reader{language(options), options.colours};

  std::vector<CheckedExercise> checked;
  std::string report;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    checked.push_back(check(*chosen[i], givens[i], number));
    add_all_measured(checked.back(), texts, ruler);
    if (options.json) continue;
    if (options.quiet) {
      report += measured_report(checked.back(), reader);
      continue;
    }
    report += text_report(checked.back(), reader) + "\n";
    if (chosen.size() > 1) report += closing_line(checked.back(), reader) + "\n";
  }
  return {options.json ? json_report(checked) : report + totals(checked, reader), exit_of(checked),
          sheets_not_drawn(checked)};
}

}  // namespace epure
