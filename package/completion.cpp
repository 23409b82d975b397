#include "package/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "drawings/text/text.h"
#include "exercises/cli/options.h"
#include "exercises/scenes/scene_exercise.h"
#include "exercises/scenes/shipped.h"

namespace epure {
namespace {

std::string harmless(const Words& words) {
  std::string text;
  for (const char letter : drawings::plain(words.english))
    if (letter == '\'')
      text += "’";
    else if (letter == '"' || letter == '\\' || letter == '$' || letter == '`' || letter == '\t' || letter == '\n')
      text += ' ';
    else
      text += letter;
  return text;
}

// An option that takes one of a few words, which its help names in a sentence.
struct OfFewWords {
  std::vector<std::string> verbs;
  std::string option;
  std::vector<std::string> words;
};
const std::vector<OfFewWords> options_of_few_words{
    {{"list", "draw", "check", "report", "booklet", "class", "mark", "sweep", "import", "bench"},
     "--lang",
     {"en", "it"}},
    {{"draw", "booklet", "class", "bench"}, "--paper", {"a4", "a3"}},
    {{"draw"}, "--format", {"pdf", "svg", "html", "png", "eps", "pdf+tex", "csv"}},
    {{"draw"}, "--background", {"white", "none"}},
    {{"draw"}, "--ink", {"dark", "light"}},
    {{"bench"}, "--format", {"pdf", "svg"}},
    {{"report"}, "--format", {"md", "tex", "html"}},
    {{"class"}, "--format", {"pdf", "moodle"}},
    {{"mark"}, "--format", {"text", "csv"}},
    {{"sweep"}, "--format", {"csv", "json", "html"}},
    {{"draw", "class", "mark", "sweep"}, "--csv", {"plain", "excel"}},
    {{"check"}, "--arithmetic", {"fast", "bounded", "exact"}}};

std::string values_of_options() {
  std::string lines;
  for (const OfFewWords& of : options_of_few_words)
    for (const std::string& verb : of.verbs) {
      const auto& options = help_page(verb, Language::english).options;
      if (std::none_of(options.begin(), options.end(), [&](const HelpEntry& each) { return each.name == of.option; }))
        throw std::logic_error("epure " + verb + " has no option " + of.option);
      for (const std::string& word : of.words) lines += fmt::format("value\t{}\t{}\t{}\n", verb, of.option, word);
    }
  return lines;
}

std::string options_of(const std::string& verb) {
  std::string lines;
  for (const HelpEntry& option : help_page(verb, Language::english).options) {
    std::istringstream names(option.name);
    for (std::string name; std::getline(names, name, ',');)
      lines += fmt::format("option\t{}\t{}\t{}\t{}\n", verb.empty() ? "-" : verb, name,
                           option.type.empty() ? "-" : option.type, harmless({option.meaning, {}}));
  }
  return lines;
}

std::string lines_of(const Description& about) {
  std::string lines = fmt::format("exercise\t{}\t{}\n", about.id, harmless(about.title));
  for (const SheetSpec& sheet : about.sheets)
    lines += fmt::format("sheet\t{}\t{}\t{}\n", about.id, sheet.name, harmless(sheet.title));
  for (const GivenSpec& given : about.givens)
    lines += fmt::format("given\t{}\t{}\t{}\n", about.id, given.symbol, harmless(given.meaning));
  for (const Quantity& quantity : about.quantities())
    lines += fmt::format("quantity\t{}\t{}\t{}\n", about.id, quantity.name, harmless(quantity.meaning));
  return lines;
}

}  // namespace

std::string completion_lines(const Catalogue& exercises) {
  std::string lines = options_of("");
  for (const std::string& verb : verbs())
    lines += fmt::format("verb\t{}\t{}\n", verb, harmless(help_page(verb, Language::english).help.purpose)) +
             options_of(verb);
  lines += values_of_options();
  for (const Listed& exercise : exercises) lines += lines_of(exercise->about());
  for (const scenes::Shipped& scene : scenes::shipped_scenes())
    lines += lines_of(
        scenes::scene_exercise(std::make_shared<const scenes::Scene>(std::string(scene.id), scene.text))->about());
  return lines;
}

}  // namespace epure
