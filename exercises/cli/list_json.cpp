#include "exercises/cli/list_json.h"

#include "drawings/text/text.h"
#include "exercises/cli/json_given.h"
#include "exercises/cli/symbol.h"
#include "exercises/cli/version.h"

namespace epure {
namespace {

std::string english(const Words& words) { return drawings::plain(words.english); }

const char* name(Range range) {
  switch (range) {
    case Range::positive:
      return "positive";
    case Range::not_negative:
      return "not negative";
    case Range::any:
      break;
  }
  return "any";
}

Json listed_given(const Givens& stated, const GivenSpec& spec) {
  Json json = json_given(stated, spec);
  json["letters"] = unicode_symbol(spec.letters.empty() ? spec.symbol : spec.letters);
  json["meaning"] = english(spec.meaning);
  if (spec.choices.empty()) json["range"] = name(spec.range);
  for (const Choice& choice : spec.choices)
    json["choices"].push_back({{"word", choice.word}, {"meaning", english(choice.meaning)}});
  if (spec.turned) json["or"] = spec.turned->instant;
  return json;
}

Json listed_exercise(const Description& about) {
  Json json = {{"id", about.id},
               {"title", english(about.title)},
               {"source", {{"document", about.document}, {"item", about.item}, {"text", english(about.source)}}},
               {"question", english(about.question)},
               {"sheets", Json::array()},
               {"givens", Json::array()},
               {"quantities", Json::array()}};
  for (const SheetSpec& sheet : about.sheets)
    json["sheets"].push_back({{"name", sheet.name}, {"title", english(sheet.title)}});
  const Givens stated(about.givens);
  for (const GivenSpec& given : about.givens) json["givens"].push_back(listed_given(stated, given));
  for (const Quantity& quantity : about.quantities())
    json["quantities"].push_back({{"name", quantity.name},
                                  {"symbol", unicode_symbol(quantity.symbol)},
                                  {"unit", quantity.unit},
                                  {"meaning", english(quantity.meaning)}});
  return json;
}

}  // namespace

std::string json_list(const std::vector<const Exercise*>& exercises) {
  Json json = {{"schema", "epure.list/1"}, {"epure", version_for_programs()}, {"exercises", Json::array()}};
  for (const Exercise* exercise : exercises) json["exercises"].push_back(listed_exercise(exercise->about()));
  return json.dump(1) + "\n";
}

}  // namespace epure
