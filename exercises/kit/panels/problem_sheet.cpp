#include "exercises/kit/panels/problem_sheet.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "drawings/sheet/column.h"
#include "drawings/sheet/layout.h"
#include "drawings/sheet/title_block.h"
#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr std::size_t most_in_one_column = 12, most_explained_in_one_column = 8;

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

bool is_abscissa_or_ordinate(const Quantity& quantity) { return lies_along_axis(quantity) && quantity.unit == "m"; }

}  // namespace

std::string letter_of_origin(const std::vector<std::string>& quantities, const Solution& solution,
                             const DrawnSheet& solved) {
  for (const Measurement& each : solved.measurements) {
    const bool is_asked = std::find(quantities.begin(), quantities.end(), each.quantity) != quantities.end();
    if (!is_asked || !is_abscissa_or_ordinate(solution.described(each.quantity))) continue;
    for (const drawings::Label& label : solved.sheet.figure.labels)
      if (!label.to && label.at.x == each.from.x && label.at.y == each.from.y) return label.text;
  }
  return {};
}

Words positive_senses(const std::vector<std::string>& quantities, const Solution& solution,
                      const std::string& origin) {
  const auto any = [&](bool (*is_so)(const Quantity&)) {
    return std::any_of(quantities.begin(), quantities.end(),
                       [&](const std::string& name) { return is_so(solution.described(name)); });
  };
  const bool some_turn = any(is_turning), some_lie = any(lies_along_axis);
  if (!some_turn && !some_lie) return {};
  return Words{"Positive sense: ", "Verso positivo: "} +
         (some_turn ? Words{"counter-clockwise", "antiorario"} : Words{}) +
         (some_turn && some_lie ? Words{"; ", "; "} : Words{}) +
         (some_lie ? Words{"x to the right, y upwards", "x a destra, y in alto"} : Words{}) +
         (any(is_abscissa_or_ordinate) && !origin.empty()
              ? Words{"; coordinates from ", "; coordinate da "} + Words{origin, origin}
              : Words{}) +
         ".";
}

AskedOnSheet asked_on(const Description& about, const Solution& solution, const PanelSheet& shown,
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
  const std::vector<Quantity>& reported = about.quantities();
  const auto is_reported = [&](const std::string& name) {
    return solution.has(name) && std::any_of(reported.begin(), reported.end(),
                                             [&](const Quantity& quantity) { return quantity.name == name; });
  };
  for (const Result::Asked& each : all) {
    if (!is_reported(each.quantity) || !seen.insert(each.quantity).second) continue;
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

std::vector<std::string> names_of(const std::vector<Result::Asked>& asked) {
  std::vector<std::string> names;
  for (const Result::Asked& each : asked) names.push_back(each.quantity);
  return names;
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

std::vector<std::string> meanings(const std::vector<Result::Asked>& asked, const Solution& solution,
                                  Language language) {
  std::vector<std::string> all;
  for (const Result::Asked& each : asked) all.push_back(solution.described(each.quantity).meaning.in(language));
  return all;
}

// Of those cells that are written alike.
std::vector<std::string> cases_of_alike(const std::vector<std::string>& cells,
                                        const std::vector<std::string>& meanings) {
  std::vector<std::string> all(cells.size());
  for (const std::string& cell : std::set<std::string>(cells.begin(), cells.end())) {
    std::vector<std::size_t> places;
    std::vector<std::string> alike;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i] == cell) {
        places.push_back(i);
        alike.push_back(meanings[i]);
      }
    if (places.size() == 1) continue;
    const std::vector<std::string> cases = cases_of(alike);
    for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = cases[k];
  }
  return all;
}

std::vector<std::string> with_captions(std::vector<std::string> cells, const std::vector<std::string>& captions) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!captions[i].empty()) cells[i] += "\n" + captions[i];
  return cells;
}

std::string without_caption(const std::string& cell) { return cell.substr(0, cell.find('\n')); }

drawings::Table answers(const std::vector<std::string>& asked) {
  drawings::Table table{.head = {}, .rows = {}, .to_fill_in = true};
  // Two in a row where they are many, and short enough to leave room for an answer.
  const auto is_short = [](const std::string& text) {
    return drawings::measure(without_caption(text), 3).width < 30;
  };
  // What is explained takes two lines, and in one column would make all letters small.
  const bool is_explained = std::any_of(asked.begin(), asked.end(),
                                        [](const std::string& text) { return text.find('\n') != std::string::npos; });
  const std::size_t most = is_explained ? most_explained_in_one_column : most_in_one_column;
  const bool is_long = asked.size() > most && std::all_of(asked.begin(), asked.end(), is_short);
  const std::size_t rows = is_long ? (asked.size() + 1) / 2 : asked.size();
  for (std::size_t i = 0; i < rows; ++i) {
    table.rows.push_back({asked[i], ""});
    if (!is_long) continue;
    table.rows.back().push_back(rows + i < asked.size() ? asked[rows + i] : "");
    table.rows.back().emplace_back();
  }
  return table;
}

bool column_has_room(const DrawnSheet& onto) {
  std::vector<std::string> conflicts;
  const drawings::Layout parts = drawings::layout(onto.sheet.paper, drawings::title_block_height(onto.sheet));
  drawings::set_column(onto.sheet.column, parts.column, onto.sheet.language, &conflicts);
  return conflicts.empty();
}

}  // namespace

std::vector<std::string> cases_of(const std::vector<std::string>& meanings) {
  const auto begins_case = [](const std::string& meaning, std::size_t at) {
    const std::string_view rest = std::string_view(meaning).substr(at);
    return rest.empty() || rest.starts_with(", ") || rest.starts_with(" (");
  };
  const auto is_end = [&](std::size_t at) {
    return std::all_of(meanings.begin(), meanings.end(), [&](const std::string& each) {
      return each.size() >= at && each.compare(0, at, meanings.front(), 0, at) == 0 && begins_case(each, at);
    });
  };
  std::size_t common = 0;
  for (std::size_t at = 1; at <= meanings.front().size(); ++at)
    if (is_end(at)) common = at;
  std::vector<std::string> all;
  for (const std::string& each : meanings) {
    std::string rest = each.substr(common);
    if (rest.starts_with(", ")) rest.erase(0, 2);
    if (rest.starts_with(" (") && rest.ends_with(")")) rest = rest.substr(2, rest.size() - 3);
    all.push_back(rest);
  }
  return all;
}

Words question_of(const Description& about, const std::string& sheet) {
  const auto spec = std::find_if(about.sheets.begin(), about.sheets.end(),
                                 [&](const SheetSpec& each) { return each.name == sheet; });
  if (!spec->question.empty()) return spec->question;
  if (about.sheets.size() == 1 || about.question.empty()) return about.question;
  return format_words("On this sheet: {}. The whole exercise: {}", "In questa tavola: {}. L'esercizio intero: {}",
                      spec->title, about.question);
}

namespace {

void add_asked(std::vector<drawings::Block>& column, const std::vector<std::string>& cells, Language language) {
  if (cells.empty()) return;
  column.emplace_back(drawings::Heading{Words{"Asked on this sheet", "Richiesto in questa tavola"}.in(language)});
  column.emplace_back(answers(cells));
}

// Below the table: how its answers are told, and whose they are.
std::vector<drawings::Block> after_asked(const Solution& solution, const AskedOnSheet& asked,
                                         const std::string& origin, const SheetRequest& request) {
  const Language language = request.language;
  std::vector<drawings::Block> column;
  if (const Words senses = positive_senses(names_of(asked.asked), solution, origin); !senses.empty())
    column.emplace_back(drawings::Paragraph{senses.in(language)});
  const auto symbols = [&](const std::vector<std::string>& quantities) {
    std::vector<std::string> all;
    for (const std::string& each : quantities) all.push_back(solution.described(each).symbol);
    return all;
  };
  for (const Words& each : sentences_of_not_asked(symbols(asked.without_value), symbols(asked.off_sheet)))
    column.emplace_back(drawings::Paragraph{each.in(language)});
  column.emplace_back(drawings::Heading{Words{"Solved by", "Svolto da"}.in(language)});
  drawings::Table who{.head = {}, .rows = {}, .to_fill_in = true};
  for (const auto& [field, known] : {std::pair{Words{"name", "nome"}, request.solver.name},
                                     {Words{"number", "matricola"}, request.solver.number},
                                     {Words{"date", "data"}, std::string()}})
    who.rows.push_back({field.in(language), drawings::escaped(known)});
  column.emplace_back(who);
  return column;
}

}  // namespace

void add_problem(DrawnSheet& onto, const Words& question, const Solution& solution, const AskedOnSheet& asked,
                 const std::string& origin, const SheetRequest& request) {
  const Language language = request.language;
  auto& column = onto.sheet.column;
  if (!question.empty()) {
    column.emplace_back(drawings::Heading{Words{"Question", "Quesito"}.in(language)});
    column.emplace_back(drawings::Paragraph{question.in(language)});
  }
  const std::vector<std::string> cells = written(asked.asked, solution, language),
                                 meant = meanings(asked.asked, solution, language);
  const auto before = static_cast<std::ptrdiff_t>(column.size());
  const std::vector<drawings::Block> after = after_asked(solution, asked, origin, request);
  for (const auto& captions : {meant, cases_of_alike(cells, meant)}) {
    column.erase(column.begin() + before, column.end());
    add_asked(column, with_captions(cells, captions), language);
    column.insert(column.end(), after.begin(), after.end());
    if (column_has_room(onto)) return;
  }
}

void mark_start(Plot& plot, const Place& at, const std::string& letter) {
  plot.cross(at, Meaning::construction);
  if (!letter.empty()) plot.label(letter, at);
}

}  // namespace epure
