#include "exercises/kit/panels/problem_sheet.h"

#include <algorithm>
#include <set>
#include <utility>

#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr std::size_t most_in_one_column = 12;

}  // namespace

std::vector<Result::Asked> asked_on(const Solution& solution, const PanelSheet& shown) {
  std::vector<Result::Asked> all, asked;
  const auto add_all = [&](const std::vector<Result>& results) {
    for (const Result& result : results) all.insert(all.end(), result.asked().begin(), result.asked().end());
  };
  add_all(shown.results);
  if (all.empty())
    for (const Section& section : shown.theory) add_all(section.lines);
  if (all.empty())
    for (const std::string& name : shown.told) all.push_back({name});
  std::set<std::string> seen;
  for (const Result::Asked& each : all)
    if (solution.is_reported(each.quantity) && seen.insert(each.quantity).second) asked.push_back(each);
  return asked;
}

namespace {

std::vector<std::string> written(const std::vector<Result::Asked>& asked, const Solution& solution,
                                 Language language) {
  std::vector<std::string> all;
  for (const Result::Asked& each : asked) {
    const Quantity& quantity = solution.described(each.quantity);
    const std::string unit = unit_told(quantity, each.is_in_workshop_unit, language);
    all.push_back(quantity.symbol + (unit.empty() ? "" : " (" + unit + ")"));
  }
  return all;
}

drawings::Table answers(const std::vector<std::string>& asked) {
  drawings::Table table{.head = {}, .rows = {}, .to_fill_in = true};
  // Two in a row where they are many, and short enough to leave room for an answer.
  const auto is_short = [](const std::string& text) { return drawings::measure(text, 3).width < 30; };
  const bool is_long = asked.size() > most_in_one_column && std::all_of(asked.begin(), asked.end(), is_short);
  const std::size_t rows = is_long ? (asked.size() + 1) / 2 : asked.size();
  for (std::size_t i = 0; i < rows; ++i) {
    table.rows.push_back({asked[i], ""});
    if (!is_long) continue;
    table.rows.back().push_back(rows + i < asked.size() ? asked[rows + i] : "");
    table.rows.back().emplace_back();
  }
  return table;
}

}  // namespace

std::vector<drawings::Block> problem_column(const Description& about, const Solution& solution,
                                            const PanelSheet& shown, const SheetRequest& request) {
  const Language language = request.language;
  const auto heading = [&](const Words& words) { return drawings::Heading{words.in(language)}; };
  std::vector<drawings::Block> column;
  if (!about.question.empty()) {
    column.emplace_back(heading({"Question", "Quesito"}));
    column.emplace_back(drawings::Paragraph{about.question.in(language)});
  }
  if (const auto asked = written(asked_on(solution, shown), solution, language); !asked.empty()) {
    column.emplace_back(heading({"Asked on this sheet", "Richiesto in questa tavola"}));
    column.emplace_back(answers(asked));
  }
  column.emplace_back(heading({"Solved by", "Svolto da"}));
  drawings::Table who{.head = {}, .rows = {}, .to_fill_in = true};
  for (const auto& [field, known] : {std::pair{Words{"name", "nome"}, request.solver.name},
                                     {Words{"number", "matricola"}, request.solver.number},
                                     {Words{"date", "data"}, std::string()}})
    who.rows.push_back({field.in(language), drawings::escaped(known)});
  column.emplace_back(who);
  return column;
}

void mark_start(Plot& plot, const Place& at) {
  plot.cross(at, Meaning::construction);
  plot.label("$O$", at);
}

}  // namespace epure
