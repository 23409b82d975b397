#include "exercises/cli/catalogue.h"

#include <algorithm>
#include <set>

#include "drawings/text/text.h"
#include "exercises/cli/symbol.h"
#include "exercises/kit/statement/suggest.h"
#include "exercises/scenes/shipped.h"

namespace epure {
namespace {

void demand_sheet(const Exercise& exercise, const std::string& sheet) {
  std::vector<std::string> names;
  for (const SheetSpec& spec : exercise.about().sheets) names.push_back(spec.name);
  if (std::find(names.begin(), names.end(), sheet) == names.end())
    throw WrongUsage(format_words("{} has no sheet \"{}\"; {}", "{} non ha la tavola \"{}\"; {}", exercise.about().id,
                                  sheet, did_you_mean(sheet, names)));
}

// What is like no exercise, and has a folder or an ending as the name of a file has.
void demand_no_file(const Catalogue& exercises, const std::string& name) {
  if (name.find_first_of("/.") == std::string::npos || name.find('=') != std::string::npos) return;
  const std::string id = name.substr(0, name.find('/'));
  std::vector<std::string> ids;
  for (const Listed& exercise : exercises) ids.push_back(exercise.id());
  if (near_names(id, ids).empty())
    throw WrongUsage(
        format_words("\"{}\" is no exercise nor a sheet of one, and the file of a mechanism has a name that "
                     "ends in .yaml or .yml",
                     "\"{}\" non è un esercizio né una sua tavola, e il file di un meccanismo ha un nome che "
                     "finisce in .yaml o .yml",
                     name));
}

Target find_target(const Catalogue& exercises, const std::string& name) {
  demand_no_file(exercises, name);
  const auto slash = name.find('/');
  Target target{&find_exercise(exercises, name.substr(0, slash))};
  if (slash == std::string::npos) return target;
  target.sheet = name.substr(slash + 1);
  demand_sheet(*target.exercise, target.sheet);
  return target;
}

bool has_symbol(const Exercise& exercise, const std::string& symbol) {
  const auto& givens = exercise.about().givens;
  return index_of(givens, symbol) < givens.size();
}

std::string symbol_of(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

void refuse_repetitions(const std::vector<std::string>& assignments) {
  std::set<std::string> seen;
  for (const std::string& assignment : assignments)
    if (!seen.insert(symbol_of(assignment)).second)
      throw WrongUsage(format_words("{} is set twice; which value is meant?",
                                    "{} è dato due volte; quale valore si intende?", symbol_of(assignment)));
}

// "α₂=1" as "alpha_2=1".
std::string in_ascii(const Exercise& exercise, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) return assignment;
  return ascii_name(assignment.substr(0, equals), given_names(exercise)) + assignment.substr(equals);
}

// Among several exercises a symbol may be unknown to some, but not to all.
void demand_an_owner(const std::vector<const Exercise*>& exercises, const std::string& assignment) {
  const std::string symbol = symbol_of(assignment);
  if (given_meant(symbol, exercises)) return;
  throw WrongUsage(format_words("\"{}\" is no given of {}; {}", "\"{}\" non è un dato di {}; {}", symbol,
                                names_of(exercises), did_you_mean(symbol, symbols_of(exercises))));
}

}  // namespace

const Words& title_of_sheet(const Exercise& exercise, const std::string& sheet) {
  const std::vector<SheetSpec>& all = exercise.about().sheets;
  return std::find_if(all.begin(), all.end(), [&](const SheetSpec& each) { return each.name == sheet; })->title;
}

std::vector<NameAndLetters> quantity_names(const std::vector<Quantity>& quantities) {
  std::vector<NameAndLetters> all;
  for (const Quantity& each : quantities) {
    all.push_back({each.name, unicode_symbol(each.symbol)});
    all.push_back({each.name, drawings::plain(each.symbol)});
  }
  return all;
}

std::vector<NameAndLetters> given_names(const Exercise& exercise) {
  std::vector<NameAndLetters> all;
  for (const GivenSpec& given : exercise.about().givens) {
    all.push_back({given.symbol, unicode_symbol(given.letters.empty() ? given.symbol : given.letters)});
    for (const std::string& name : given.also) all.push_back({given.symbol, name});
  }
  return all;
}

std::optional<std::string> given_meant(const std::string& name, const std::vector<const Exercise*>& exercises) {
  for (const Exercise* exercise : exercises) {
    const auto& specs = exercise->about().givens;
    const std::size_t place = index_of(specs, ascii_name(name, given_names(*exercise)));
    if (place < specs.size()) return specs[place].symbol;
  }
  return std::nullopt;
}

std::vector<std::string> symbols_of(const std::vector<const Exercise*>& exercises) {
  std::vector<std::string> known;
  for (const Exercise* exercise : exercises)
    for (const GivenSpec& given : exercise->about().givens)
      if (std::find(known.begin(), known.end(), given.symbol) == known.end()) known.push_back(given.symbol);
  return known;
}

Words names_of(const std::vector<const Exercise*>& exercises) {
  if (exercises.size() > 1) return {"any exercise named", "alcun esercizio nominato"};
  const std::string& id = exercises.front()->about().id;
  return {id, id};
}

const Exercise& find_exercise(const Catalogue& exercises, const std::string& id) {
  std::vector<std::string> ids;
  for (const Listed& exercise : exercises) {
    if (exercise.id() == id) return *exercise;
    ids.push_back(exercise.id());
  }
  if (id.find('=') != std::string::npos)
    throw WrongUsage(format_words("\"{0}\" is no exercise; to set a given write --set {0}",
                                  "\"{0}\" non è un esercizio; per assegnare un dato scrivere --set {0}", id));
  const std::vector<std::string> like_shipped = near_names(id, scenes::shipped_ids());
  ids.insert(ids.end(), like_shipped.begin(), like_shipped.end());
  throw WrongUsage(format_words("there is no exercise \"{}\"; {}", "non c'è alcun esercizio \"{}\"; {}", id,
                                did_you_mean(id, ids)));
}

std::vector<Target> find_targets(const Catalogue& exercises, const std::vector<std::string>& names) {
  std::vector<Target> targets;
  const auto add = [&](const Target& added) {
    if (std::none_of(targets.begin(), targets.end(), [&](const Target& target) {
          return target.exercise == added.exercise && target.sheet == added.sheet;
        }))
      targets.push_back(added);
  };
  for (const std::string& name : names) {
    if (name != "all") {
      add(find_target(exercises, name));
      continue;
    }
    for (const auto& exercise : exercises) add({&*exercise});
  }
  if (targets.empty())
    throw WrongUsage("no exercise named; name one, or say all (epure list shows them)",
                     "nessun esercizio nominato; nominarne uno, o dire all (epure list li mostra)");
  return targets;
}

std::string ascii_name(const std::string& typed, const std::vector<NameAndLetters>& known) {
  std::vector<std::string> meant;
  for (const auto& [name, letters] : known) {
    if (name == typed) return typed;
    if (letters == typed && std::find(meant.begin(), meant.end(), name) == meant.end()) meant.push_back(name);
  }
  if (meant.size() > 1)
    throw WrongUsage(format_words("\"{}\" may mean several; write {}",
                                  "\"{}\" può significarne più d'una; scrivere {}", typed, alternatives(meant)));
  return meant.empty() ? typed : meant.front();
}

std::vector<const Exercise*> find_exercises(const Catalogue& exercises, const std::vector<std::string>& ids) {
  std::vector<const Exercise*> found;
  for (const Target& target : find_targets(exercises, ids)) {
    if (!target.sheet.empty())
      throw WrongUsage(format_words("\"{}/{}\" is a sheet, and whole exercises are wanted here",
                                    "\"{}/{}\" è una tavola, e qui si vogliono esercizi interi",
                                    target.exercise->about().id, target.sheet));
    found.push_back(target.exercise);
  }
  return found;
}

std::vector<std::string> Target::sheets() const {
  if (!sheet.empty()) return {sheet};
  std::vector<std::string> names;
  for (const SheetSpec& spec : exercise->about().sheets) names.push_back(spec.name);
  return names;
}

std::string Target::file_stem() const { return exercise->about().id + (sheet.empty() ? "" : "-" + sheet); }

std::vector<Givens> set_givens(const std::vector<const Exercise*>& exercises,
                               const std::vector<std::string>& assignments) {
  if (exercises.size() > 1)  // of a single exercise Givens knows better what to say
    for (const std::string& assignment : assignments)
      if (assignment.find('=') != std::string::npos) demand_an_owner(exercises, assignment);
  std::vector<Givens> all;
  for (const Exercise* exercise : exercises) {
    all.emplace_back(exercise->about().givens);
    std::vector<std::string> named;
    for (const std::string& assignment : assignments) named.push_back(in_ascii(*exercise, assignment));
    refuse_repetitions(named);
    for (const std::string& assignment : named) {
      const bool well_formed = assignment.find('=') != std::string::npos;
      if (!well_formed || exercises.size() == 1 || has_symbol(*exercise, symbol_of(assignment)))
        all.back().set(assignment);
    }
  }
  return all;
}

}  // namespace epure
