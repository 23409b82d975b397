#include "exercises/cli/sweep_row.h"

#include <algorithm>

#include "drawings/text/text.h"
#include "exercises/cli/json_number.h"
#include "exercises/kit/proof/agreement.h"
#include "exercises/kit/proof/asked.h"

namespace epure {
namespace {

using State = SweptQuantity::State;

SweptQuantity swept_quantity(const std::vector<RouteValue>& values, const std::string& name) {
  std::vector<RouteValue> routes;
  std::copy_if(values.begin(), values.end(), std::back_inserter(routes),
               [&](const RouteValue& value) { return value.quantity == name; });
  if (routes.empty()) return {State::disagreement, {}, {"no route gives it", "nessuna via la dà"}};
  if (const std::vector<Words> why = contradictions(routes); !why.empty())
    return {State::disagreement, {}, why.front()};
  const geometry::Settled& known = best_known(routes);
  if (known.kind == geometry::Settled::Kind::absent) return {State::absent, {}, known.reason};
  if (known.kind == geometry::Settled::Kind::undecided) return {State::undecided, {}, known.reason};
  return {State::value, known.enclosure, want_of_certainty(known)};
}

SweptRow row_of_one_state(SweptRow row, std::size_t quantities, State state, const Words& why) {
  row.quantities.assign(quantities, {state, {}, why});
  return row;
}

// What may be one says so.
Words fault_in_full(const Flaw& fault) {
  const Words sentence{drawings::plain(fault.sentence.english), drawings::plain(fault.sentence.italian)};
  return fault.undecided ? Words{"undecided: ", "non deciso: "} + sentence : sentence;
}

Json json_faults(const std::vector<Flaw>& faults) {
  Json json = Json::array();
  for (const Flaw& each : faults) json.push_back(fault_in_full(each).english);
  return json;
}

const char* json_key(State state) {
  if (state == State::undecided) return "undecided";
  if (state == State::disagreement) return "disagreement";
  return state == State::impossible ? "impossible" : "absent";
}

Json json_given(const Variation& of, std::uint64_t place) {
  Json json = {{"value", of.text(place)}, {"unit", of.unit()}};
  if (!of.is_of_words()) json["number"] = json_number(of.number(place));
  return json;
}

Json json_quantity(const Quantity& about, const SweptQuantity& quantity) {
  const bool has_number = quantity.state == State::value;
  const auto number = [&](double value) { return has_number ? json_number(value) : Json(nullptr); };
  Json json = {{"unit", about.unit},
               {"value", number(quantity.enclosure.value)},
               {"lower", number(quantity.enclosure.lower)},
               {"upper", number(quantity.enclosure.upper)}};
  if (!quantity.reason.empty())
    json[has_number ? "undecided" : json_key(quantity.state)] = drawings::plain(quantity.reason.english);
  return json;
}

}  // namespace

bool SweptRow::is_possible() const {
  return std::any_of(quantities.begin(), quantities.end(),
                     [](const SweptQuantity& each) { return each.state != State::impossible; });
}

bool SweptRow::is_undecided() const {
  return std::any_of(quantities.begin(), quantities.end(),
                     [](const SweptQuantity& each) {
                       return each.state == State::undecided || (each.state == State::value && !each.reason.empty());
                     }) ||
         std::any_of(faults.begin(), faults.end(), [](const Flaw& each) { return each.undecided; });
}

bool SweptRow::has_disagreement() const {
  return std::any_of(quantities.begin(), quantities.end(),
                     [](const SweptQuantity& each) { return each.state == State::disagreement; });
}

Words reason_in_full(const SweptQuantity& quantity) {
  const Words reason{drawings::plain(quantity.reason.english), drawings::plain(quantity.reason.italian)};
  if (quantity.state == State::undecided) return Words{"undecided: ", "non decisa: "} + reason;
  if (quantity.state == State::disagreement) return Words{"the routes disagree: ", "le vie discordano: "} + reason;
  return reason;
}

std::string faults_in_line(const std::vector<Flaw>& faults, Language language) {
  std::string line;
  for (const Flaw& each : faults) line += (line.empty() ? "" : " ") + fault_in_full(each).in(language);
  return line;
}

SweptRow swept_row(const SweepStudy& study, std::uint64_t number) {
  SweptRow row{number, study.places(number), {}};
  const std::vector<std::string> names = study.quantity_names();
  try {
    const Givens givens = study.givens_at(number);
    const Asked asked(names);
    const std::vector<RouteValue> values = study.exercise->solve(givens, Rung::climb);
    for (const std::string& name : names) row.quantities.push_back(swept_quantity(values, name));
    row.faults = study.exercise->flaws(givens);
    return row;
  } catch (const geometry::Undecided& open) {
    return row_of_one_state(row, names.size(), State::undecided, open.words());
  } catch (const BadGivens& why) {
    return row_of_one_state(row, names.size(), State::impossible, why.words());
  } catch (const geometry::Impossible& why) {
    return row_of_one_state(row, names.size(), State::impossible, why.words());
  }
}

std::string csv_header(const SweepStudy& study, const CsvStyle& style) {
  std::vector<std::string> fields;
  const std::vector<std::string> names = study.quantity_names();
  for (const Variation& each : study.over) {
    const std::string& symbol = each.given().symbol;
    const bool is_also_found = std::find(names.begin(), names.end(), symbol) != names.end();
    fields.push_back(style.head(is_also_found ? symbol + "_given" : symbol, each.unit()));
  }
  for (const Quantity& each : study.quantities) {
    for (const char* const which : {"", "_lower", "_upper"})
      fields.push_back(style.head(each.name + which, each.unit));
    fields.push_back(style.field(each.name + "_reason"));
  }
  fields.emplace_back("faults");
  return std::string(style.begin()) + style.record(fields);
}

std::string csv_line(const SweepStudy& study, const SweptRow& row, const CsvStyle& style, Language asked) {
  const Language language = style.language(asked);
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < study.over.size(); ++i) {
    const Variation& over = study.over[i];
    fields.push_back(style.is_for_spreadsheet && !over.is_of_words() ? style.number(over.number(row.places[i]))
                                                                     : style.field(over.text(row.places[i])));
  }
  for (const SweptQuantity& each : row.quantities) {
    for (const double number : {each.enclosure.value, each.enclosure.lower, each.enclosure.upper})
      fields.push_back(each.state == State::value ? style.number(number) : "");
    fields.push_back(each.reason.empty() ? "" : style.field(reason_in_full(each).in(language)));
  }
  fields.push_back(style.field(faults_in_line(row.faults, language)));
  return style.record(fields);
}

std::string json_line(const SweepStudy& study, const SweptRow& row) {
  Json json = {{"schema", "epure.sweep/1"}, {"id", study.exercise->about().id}, {"row", row.number}};
  for (std::size_t i = 0; i < study.over.size(); ++i)
    json["givens"][study.over[i].given().symbol] = json_given(study.over[i], row.places[i]);
  for (std::size_t i = 0; i < study.quantities.size(); ++i)
    json["quantities"][study.quantities[i].name] = json_quantity(study.quantities[i], row.quantities[i]);
  if (!row.faults.empty()) json["faults"] = json_faults(row.faults);
  return json.dump() + "\n";
}

}  // namespace epure
