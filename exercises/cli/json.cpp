#include "drawings/text/text.h"
#include "exercises/cli/check_report.h"
#include "exercises/cli/json_given.h"
#include "exercises/cli/json_number.h"
#include "exercises/cli/symbol.h"
#include "exercises/cli/version.h"

namespace epure {
namespace {

using geometry::Settled;

void add_value(Json& json, const Settled& settled) {
  const bool has_number = has_value(settled);
  json["value"] = has_number ? json_number(settled.enclosure.value) : Json(nullptr);
  json["lower"] = has_number ? json_number(settled.enclosure.lower) : Json(nullptr);
  json["upper"] = has_number ? json_number(settled.enclosure.upper) : Json(nullptr);
  if (settled.kind == Settled::Kind::absent) json["absent"] = settled.reason.english;
  if (settled.kind == Settled::Kind::undecided) json["undecided"] = settled.reason.english;
}

Json printed_number(const PrintedVerdict& verdict) {
  Json json = {{"text", verdict.text},
               {"route", verdict.route},
               {"difference_percent", json_number(verdict.difference_percent)},
               {"verdict", name(verdict.verdict)}};
  if (verdict.explanation) json["explanation"] = drawings::plain(verdict.explanation->in(Language::english));
  return json;
}

Json measured(const Measured& number_read) {
  return {{"text", number_read.text},
          {"value", json_number(number_read.value)},
          {"difference", json_number(number_read.difference)},
          {"difference_percent", json_number(number_read.difference_percent)},
          {"allowed", json_number(number_read.allowed)},
          {"allowed_by", number_read.allowed_by.english},
          {"verdict", verdict(number_read).english}};
}

// Some route could not tell, though another could; or not all digits are certain.
void add_doubt(Json& json, const std::string& name, const CheckedExercise& checked) {
  for (const Complaint& each : checked.undecided)
    if (each.quantity == name && !json.contains("undecided")) json["undecided"] = each.sentence.english;
}

Json sentences(const std::vector<Complaint>& all) {
  Json json = Json::array();
  for (const Complaint& each : all) json.push_back(drawings::plain(each.sentence.english));
  return json;
}

Json quantity(const CheckedQuantity& checked) {
  Json json = {
      {"name", checked.spec.name}, {"symbol", unicode_symbol(checked.spec.symbol)}, {"unit", checked.spec.unit}};
  add_value(json, checked.settled);
  json["routes"] = Json::array();
  for (const RouteValue& value : checked.routes) {
    json["routes"].push_back({{"route", value.route}});
    add_value(json["routes"].back(), value.settled);
  }
  if (const OnSheet* shown = farthest_on_sheet(checked))
    json["on_sheet"] = {{"value", json_number(shown->value)}, {"resolution", json_number(shown->resolution)}};
  for (const PrintedVerdict& each : checked.printed) json["printed"].push_back(printed_number(each));
  for (const Measured& each : checked.measured) json["measured"].push_back(measured(each));
  return json;
}

// A block by its first and last row, as they are printed.
Json audit(const TableAudit& of) {
  Json json = {{"table", of.table.english}, {"rows", of.rows.size()}, {"columns", Json::array()}};
  for (const AuditedColumn& column : of.columns) {
    Json blocks = Json::array();
    for (const AuditedBlock& block : column.blocks) {
      blocks.push_back({{"first", of.rows.at(block.first)},
                        {"last", of.rows.at(block.last)},
                        {"rows", block.last - block.first + 1},
                        {"verdict", name(block.verdict)},
                        {"rounded", block.rounded},
                        {"right", block.right}});
      if (!block.mistake.empty()) blocks.back()["mistake"] = drawings::plain(block.mistake.english);
    }
    json["columns"].push_back({{"name", column.name}, {"blocks", blocks}});
  }
  return json;
}

Json exercise(const CheckedExercise& checked) {
  Json json = {{"id", checked.about.id},
               {"source", {{"document", checked.about.document}, {"item", checked.about.item}}},
               {"givens", Json::array()},
               {"quantities", Json::array()}};
  for (const GivenSpec& spec : checked.givens.specs())
    if (checked.givens.reading(spec.symbol)) json["givens"].push_back(json_given(checked.givens, spec));
  for (const CheckedQuantity& each : checked.quantities) {
    json["quantities"].push_back(quantity(each));
    add_doubt(json["quantities"].back(), each.spec.name, checked);
  }
  for (const TableAudit& each : checked.audits) json["audit"].push_back(audit(each));
  if (!checked.failures.empty()) json["failures"] = sentences(checked.failures);
  if (!checked.undecided.empty()) json["undecided"] = sentences(checked.undecided);
  if (!checked.not_drawn.empty()) json["not_drawn"] = sentences(checked.not_drawn);
  json["passed"] = checked.passed();
  return json;
}

}  // namespace

std::string json_report(const std::vector<CheckedExercise>& all, const std::vector<Candidate>& rows) {
  Json json = {{"schema", "epure.check/1"}, {"epure", version_for_programs()}, {"exercises", Json::array()}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    json["exercises"].push_back(exercise(all[i]));
    if (i >= rows.size()) continue;
    json["exercises"].back()["row"] = {{"number", rows[i].number}};
    if (!rows[i].name.empty()) json["exercises"].back()["row"]["name"] = rows[i].name;
  }
  return json.dump(1) + "\n";
}

}  // namespace epure
