#include <fmt/format.h>

#include "drawings/text/text.h"
#include "exercises/cli/cases.h"
#include "exercises/cli/columns.h"
#include "exercises/cli/list_json.h"
#include "exercises/cli/symbol.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/shipped.h"

namespace epure {
namespace {

std::string one_line_each(const Catalogue& exercises, Language language) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& exercise : exercises) {
    const Description& about = exercise->about();
    rows.push_back({about.id, fmt::format("{} ({}, {})", drawings::plain(about.title.in(language)), about.document,
                                          about.item)});
  }
  return table(rows, 0);
}

// They are read whole only where one is asked for.
std::string shipped(Language language) {
  std::vector<std::vector<std::string>> rows;
  for (const scenes::Shipped& scene : scenes::shipped_scenes())
    rows.push_back({std::string(scene.id), drawings::plain(scenes::head_of(scene).title.in(language))});
  return wrapped(Words{"\nMechanisms from files (docs/scenes; \"scenes\" stands for all of them)",
                       "\nMeccanismi da file (docs/scenes; \"scenes\" vale per tutti)"}
                     .in(language)) +
         table(rows, 0);
}

std::string heading(const Words& words, Language language) { return "\n" + words.in(language) + "\n"; }

std::string sheets(const Description& about, Language language) {
  std::vector<std::vector<std::string>> rows;
  for (const SheetSpec& sheet : about.sheets)
    rows.push_back({about.id + "/" + sheet.name, unicode_symbol(sheet.title.in(language))});
  return heading({"Sheets", "Tavole"}, language) + table(rows, 2, {38});
}

std::string words_of(const GivenSpec& given) {
  std::string words;
  for (const Choice& choice : given.choices) words += (words.empty() ? "" : " | ") + choice.word;
  return words;
}

std::string other_names(const GivenSpec& given, Language language) {
  if (given.also.empty()) return "";
  return fmt::format(" ({} {})", Words{"also", "anche"}.in(language), fmt::join(given.also, ", "));
}

std::string givens(const Description& about, Language language) {
  if (about.givens.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  const Givens stated(about.givens);
  for (const GivenSpec& given : about.givens)
    rows.push_back({given.symbol,
                    stated.follows(given.symbol) ? stated.text(given.symbol) : decimal(given.stated).in(language),
                    given.choices.empty() ? stated.reading(given.symbol)->unit.symbol : words_of(given),
                    drawings::plain(given.meaning.in(language)) + other_names(given, language)});
  return heading({"Givens (--set SYMBOL=VALUE[UNIT])", "Dati (--set SIMBOLO=VALORE[UNITÀ])"}, language) +
         table(rows, 2, {14, 14, 14});
}

std::string quantities(const Description& about, Language language) {
  std::vector<std::vector<std::string>> rows;
  Cases cases;
  for (const Quantity& quantity : about.quantities()) {
    const std::string name = cases.within(quantity.name, rows);
    rows.push_back(
        {name, unicode_symbol(quantity.symbol), quantity.unit, drawings::plain(quantity.meaning.in(language))});
  }
  return heading({"Quantities", "Grandezze"}, language) + table(rows, 2, {22, 8, 7});
}

std::vector<const Exercise*> exercises_listed(const Catalogue& exercises, std::vector<std::string> names) {
  if (names.empty()) names = {"all"};
  std::vector<const Exercise*> found;
  for (const Target& target : find_targets(exercises, names)) {
    const std::string& id = target.exercise->about().id;
    if (!target.sheet.empty())
      throw WrongUsage(format_words("\"{0}/{1}\" is a sheet; epure list {0} shows its exercise",
                                    "\"{0}/{1}\" è una tavola; epure list {0} mostra il suo esercizio", id,
                                    target.sheet));
    found.push_back(target.exercise);
  }
  return found;
}

}  // namespace

std::string list(const Catalogue& exercises, const Options& options) {
  const Language chosen = language(options);
  if (options.json) return json_list(exercises_listed(exercises, options.names));
  if (options.names.empty()) return one_line_each(exercises, chosen) + shipped(chosen);
  if (options.names.size() > 1)
    throw WrongUsage("list shows one exercise at a time; name one, or none for all",
                     "list mostra un esercizio alla volta; nominarne uno, o nessuno per tutti");
  if (options.names.front() == "all") return one_line_each(exercises, chosen);
  const Description& about = exercises_listed(exercises, options.names).front()->about();
  return wrapped(about.id + ": " + drawings::plain(about.title.in(chosen)), 0, 2) +
         wrapped(drawings::plain(about.source.in(chosen)), 0, 2) +
         wrapped("\n" + drawings::plain(about.question.in(chosen))) + sheets(about, chosen) + givens(about, chosen) +
         quantities(about, chosen);
}

Language language(const Options& options) {
  const std::string name = lower_case(options.language);
  if (name == "en") return Language::english;
  if (name == "it") return Language::italian;
  throw WrongUsage(format_words("\"{}\" is no language of epure; choose en or it",
                                "\"{}\" non è una lingua di epure; scegliere en o it", options.language));
}

}  // namespace epure
