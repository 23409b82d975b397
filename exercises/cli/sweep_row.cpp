#include "exercises/cli/sweep_row.h"

#include <algorithm>

#include "drawings/text/text.h"
#include "exercises/cli/json_number.h"
#include "exercises/kit/proof/agreement.h"
#include "exercises/kit/proof/asked.h"
#include "exercises/kit/statement/csv_field.h"

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

// What is no plain absence says so.
Words reason_in_full(const SweptQuantity& quantity) {
  const Words reason{drawings::plain(quantity.reason.english), drawings::plain(quantity.reason.italian)};
  if (quantity.state == State::undecided) return Words{"undecided: ", "non decisa: "} + reason;
  if (quantity.state == State::disagreement) return Words{"the routes disagree: ", "le vie discordano: "} + reason;
  return reason;
}

// What may be one says so.
Words fault_in_full(const Flaw& fault) {
  const Words sentence{drawings::plain(fault.sentence.english), drawings::plain(fault.sentence.italian)};
  return fault.undecided ? Words{"undecided: ", "non deciso: "} + sentence : sentence;
}

std::string faults_in_line(const std::vector<Flaw>& faults, Language language) {
  std::string line;
  for (const Flaw& each : faults) line += (line.empty() ? "" : " ") + fault_in_full(each).in(language);
  return line;
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

SweptRow swept_row(const SweepStudy& study, std::uint64_t number) {
  SweptRow row{number, study.places(number), {}};
  const std::vector<std::string> names = study.quantity_names();
  try {
    Givens givens = study.givens;
    for (std::size_t i = 0; i < study.over.size(); ++i) givens.set(study.over[i].assignment(row.places[i]));
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

std::string csv_header(const SweepStudy& study) {
  std::string line;
  for (const Variation& each : study.over)
    line += (line.empty() ? "" : ",") + csv_head(each.given().symbol, each.unit());
  for (const Quantity& each : study.quantities)
    line += "," + csv_head(each.name, each.unit) + "," + csv_head(each.name + "_lower", each.unit) + "," +
            csv_head(each.name + "_upper", each.unit) + "," + csv_field(each.name + "_reason");
  return line + ",faults\r\n";
}

std::string csv_line(const SweepStudy& study, const SweptRow& row, Language language) {
  std::string line;
  for (std::size_t i = 0; i < study.over.size(); ++i)
    line += (i == 0 ? "" : ",") + csv_field(study.over[i].text(row.places[i]));
  for (const SweptQuantity& each : row.quantities) {
    const auto [lower, value, upper] = each.enclosure;
    line +=
        each.state == State::value ? "," + csv_field(value) + "," + csv_field(lower) + "," + csv_field(upper) : ",,,";
    line += "," + (each.reason.empty() ? "" : csv_field(reason_in_full(each).in(language)));
  }
  return line + "," + csv_field(faults_in_line(row.faults, language)) + "\r\n";
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
