#include "exercises/kit/panels/problem_sheet.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr std::size_t most_in_one_column = 12;

// In what is awkward, between the sheet and the quantity.
constexpr std::string_view without_value = "/without value: ", off_sheet = "/off sheet: ";

// The point whose coordinate or distance from another it is: P0 of P0_x and of P0A, Cprime of Cprime_C. Else empty.
std::string point_of(const std::string& quantity, const Solution& solution) {
  if (solution.described(quantity).unit != "m") return {};
  for (std::size_t end = 1; end < quantity.size(); ++end) {
    const std::string rest = quantity.substr(end), point = quantity.substr(0, end);
    const bool is_coordinate = rest == "_x" || rest == "_y";
    const std::size_t first = rest.starts_with('_') ? 1 : 0;
    const bool is_distance = first < rest.size() && rest[first] >= 'A' && rest[first] <= 'Z';
    if ((is_coordinate || is_distance) && solution.has(point + "_x") && solution.has(point + "_y")) return point;
  }
  return {};
}

// Counter-clockwise, and said to be so or told from one direction to another.
bool is_turning(const Quantity& quantity) {
  const std::string& meaning = quantity.meaning.english;
  const bool is_angle = quantity.unit == "rad" || quantity.unit == "deg";
  return meaning.find("counter-clockwise") != std::string::npos ||
         (is_angle && meaning.find("from ") != std::string::npos);
}

bool lies_along_axis(const Quantity& quantity) {
  const std::array<std::string_view, 4> units{"m", "m/s", "m/s^2", "N"};
  return (quantity.name.ends_with("_x") || quantity.name.ends_with("_y")) &&
         std::find(units.begin(), units.end(), quantity.unit) != units.end();
}

}  // namespace

Words positive_senses(const std::vector<std::string>& quantities, const Solution& solution) {
  const auto any = [&](bool (*is_so)(const Quantity&)) {
    return std::any_of(quantities.begin(), quantities.end(),
                       [&](const std::string& name) { return is_so(solution.described(name)); });
  };
  const bool some_turn = any(is_turning), some_lie = any(lies_along_axis);
  if (!some_turn && !some_lie) return {};
  return Words{"Positive sense: ", "Verso positivo: "} +
         (some_turn ? Words{"counter-clockwise", "antiorario"} : Words{}) +
         (some_turn && some_lie ? Words{"; ", "; "} : Words{}) +
         (some_lie ? Words{"x to the right, y upwards", "x a destra, y in alto"} : Words{}) + ".";
}

AskedOnSheet asked_on(const Solution& solution, const PanelSheet& shown,
                      const std::function<bool(const std::string& quantity, const Place&)>& is_off_sheet) {
  std::vector<Result::Asked> all;
  const auto add_all = [&](const std::vector<Result>& results) {
    for (const Result& result : results) all.insert(all.end(), result.asked().begin(), result.asked().end());
  };
  add_all(shown.results);
  if (all.empty())
    for (const Section& section : shown.theory) add_all(section.lines);
  if (all.empty())
    for (const std::string& name : shown.told) all.push_back({name});
  AskedOnSheet found;
  std::set<std::string> seen;
  for (const Result::Asked& each : all) {
    if (!solution.is_reported(each.quantity) || !seen.insert(each.quantity).second) continue;
    const std::string point = point_of(each.quantity, solution);
    const std::optional<Place> place = point.empty() ? std::nullopt : solution.point(point);
    if (!solution.value(each.quantity))
      found.without_value.push_back(each.quantity);
    else if (place && is_off_sheet(each.quantity, *place))
      found.off_sheet.push_back(each.quantity);
    else
      found.asked.push_back(each);
  }
  return found;
}

void note_not_asked(const std::string& sheet, const AskedOnSheet& asked, std::vector<Awkwardness>& awkward) {
  for (const std::string& each : asked.without_value)
    awkward.push_back({sheet + std::string(without_value) + each,
                       {"something asked that does not exist, or lies at infinity",
                        "qualcosa di richiesto che non esiste, o sta all'infinito"}});
  for (const std::string& each : asked.off_sheet)
    awkward.push_back({sheet + std::string(off_sheet) + each, {"a step off the sheet", "un passo fuori del foglio"}});
}

std::optional<std::string> quantity_not_asked(const Awkwardness& noted) {
  for (const std::string_view between : {without_value, off_sheet})
    if (const auto at = noted.what.find(between); at != std::string::npos)
      return noted.what.substr(at + between.size());
  return std::nullopt;
}

std::vector<Words> sentences_of_not_asked(const std::vector<std::string>& nowhere,
                                          const std::vector<std::string>& elsewhere) {
  const auto listed = [](const std::vector<std::string>& symbols) {
    std::string list;
    for (std::size_t i = 0; i < symbols.size(); ++i) list += (i == 0 ? "" : ", ") + symbols[i];
    return list;
  };
  std::vector<Words> all;
  if (!nowhere.empty())
    all.push_back(format_words("Not asked, as it lies at infinity or does not exist: {}.",
                               "Non si chiede, perché sta all'infinito o non esiste: {}.", listed(nowhere)));
  if (!elsewhere.empty())
    all.push_back(format_words("Not asked, as it lies off the sheet: {}.",
                               "Non si chiede, perché sta fuori del foglio: {}.", listed(elsewhere)));
  return all;
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

Words question_of(const Description& about, const std::string& sheet) {
  const auto spec = std::find_if(about.sheets.begin(), about.sheets.end(),
                                 [&](const SheetSpec& each) { return each.name == sheet; });
  if (!spec->question.empty()) return spec->question;
  if (about.sheets.size() == 1 || about.question.empty()) return about.question;
  return format_words("On this sheet: {}. The whole exercise: {}", "In questa tavola: {}. L'esercizio intero: {}",
                      spec->title, about.question);
}

std::vector<drawings::Block> problem_column(const Words& question, const Solution& solution,
                                            const AskedOnSheet& asked, const SheetRequest& request) {
  const Language language = request.language;
  const auto heading = [&](const Words& words) { return drawings::Heading{words.in(language)}; };
  std::vector<drawings::Block> column;
  if (!question.empty()) {
    column.emplace_back(heading({"Question", "Quesito"}));
    column.emplace_back(drawings::Paragraph{question.in(language)});
  }
  if (const auto cells = written(asked.asked, solution, language); !cells.empty()) {
    column.emplace_back(heading({"Asked on this sheet", "Richiesto in questa tavola"}));
    column.emplace_back(answers(cells));
  }
  std::vector<std::string> names;
  for (const Result::Asked& each : asked.asked) names.push_back(each.quantity);
  if (const Words senses = positive_senses(names, solution); !senses.empty())
    column.emplace_back(drawings::Paragraph{senses.in(language)});
  const auto symbols = [&](const std::vector<std::string>& quantities) {
    std::vector<std::string> all;
    for (const std::string& each : quantities) all.push_back(solution.described(each).symbol);
    return all;
  };
  for (const Words& each : sentences_of_not_asked(symbols(asked.without_value), symbols(asked.off_sheet)))
    column.emplace_back(drawings::Paragraph{each.in(language)});
  column.emplace_back(heading({"Solved by", "Svolto da"}));
  drawings::Table who{.head = {}, .rows = {}, .to_fill_in = true};
  for (const auto& [field, known] : {std::pair{Words{"name", "nome"}, request.solver.name},
                                     {Words{"number", "matricola"}, request.solver.number},
                                     {Words{"date", "data"}, std::string()}})
    who.rows.push_back({field.in(language), drawings::escaped(known)});
  column.emplace_back(who);
  return column;
}

void mark_start(Plot& plot, const Place& at, const std::string& letter) {
  plot.cross(at, Meaning::construction);
  if (!letter.empty()) plot.label(letter, at);
}

}  // namespace epure
