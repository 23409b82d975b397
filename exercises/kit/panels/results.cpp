#include "exercises/kit/panels/results.h"

#include <fmt/format.h>

#include <algorithm>

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/workshop_unit.h"

namespace epure {

namespace {

constexpr int significant = 4;

}  // namespace

std::string written_unit(const std::string& unit, Language language) {
  if (unit == "deg") return "°";
  if (unit == "rpm") return Words{"rpm", "giri/min"}.in(language);
  if (unit == "um") return "µm";
  std::string text = unit == "1" ? "" : unit;
  std::replace(text.begin(), text.end(), '*', ' ');
  for (const auto& [power, raised] : {std::pair{"^2", "²"}, {"^3", "³"}, {"^4", "⁴"}})
    for (auto at = text.find(power); at != std::string::npos; at = text.find(power))
      text = text.substr(0, at) + raised + text.substr(at + std::string_view(power).size());
  return text;
}

std::string unit_after_number(const std::string& unit, Language language) {
  std::string written = written_unit(unit, language);
  for (auto at = written.find(' '); at != std::string::npos; at = written.find(' ')) written.replace(at, 1, "\u00a0");
  return (written.empty() || written == "°" ? "" : "\u00a0") + written;
}

Result::Result(Tell tell, const std::vector<std::string>& asked, bool in_workshop_units) : tell_(std::move(tell)) {
  for (const std::string& name : asked) asked_.push_back({name, in_workshop_units});
}

Result components(const VectorQuantity& quantity) {
  const auto tell = [quantity](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    const auto x = solution.value(quantity.x().name), y = solution.value(quantity.y().name),
               length = solution.value(quantity.length().name);
    if (!x || !y || !length) return {};
    const std::string unit = written_unit(quantity.unit, language);
    return drawings::Paragraph{fmt::format("{} = ({}; {}) {},  {} = {} {}", quantity.arrow(),
                                           figures(*x, significant, language), figures(*y, significant, language),
                                           unit, quantity.length().symbol, figures(*length, significant, language),
                                           unit)};
  };
  return {tell, {quantity.x().name, quantity.y().name, quantity.length().name}};
}

Result coordinates(const std::string& name) {
  const auto tell = [name](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    const std::optional<Place> P = solution.point(name);
    if (!P) return {};
    return drawings::Paragraph{fmt::format("${}$ = ({}; {}) m", point_letters(name),
                                           figures(P->x, significant, language),
                                           figures(P->y, significant, language))};
  };
  return {tell, {name + "_x", name + "_y"}};
}

Result coordinates(const std::vector<std::pair<std::string, std::string>>& points) {
  const auto tell = [=](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    drawings::Table table{{"", "$x$ (m)", "$y$ (m)"}, {}};
    for (const auto& [letters, name] : points) {
      const std::optional<Place> P = solution.point(name);
      table.rows.push_back(
          {letters, P ? figures(P->x, significant, language) : "∞", P ? figures(P->y, significant, language) : "∞"});
    }
    return table;
  };
  std::vector<std::string> asked;
  for (const auto& point : points)
    for (const char* axis : {"_x", "_y"}) asked.push_back(point.second + axis);
  return {tell, asked};
}

namespace {

// Values that exist, each after its symbol. `in_unit` says how a quantity's value is written.
Result values_written(const std::vector<std::string>& names,
                      std::pair<double, std::string> (*in_unit)(const Quantity& quantity, double value,
                                                                Language language),
                      bool in_workshop_units) {
  const auto tell = [=](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    std::string line;
    for (const std::string& name : names) {
      const auto value = solution.value(name);
      if (!value) continue;
      const Quantity& quantity = solution.described(name);
      const auto [number, unit] = in_unit(quantity, *value, language);
      line += fmt::format("{}{}\u00a0=\u00a0{}{}{}", line.empty() ? "" : ",  ", quantity.symbol,
                          figures(number, significant, language), unit.empty() || unit == "°" ? "" : "\u00a0", unit);
    }
    return line.empty() ? std::nullopt : std::optional<drawings::Block>(drawings::Paragraph{line});
  };
  return {tell, names, in_workshop_units};
}

std::pair<double, std::string> in_si(const Quantity& quantity, double value, Language language) {
  return {value, written_unit(quantity.unit, language)};
}
std::pair<double, std::string> in_workshop_unit(const Quantity& quantity, double value, Language language) {
  const auto unit = workshop_unit(quantity.unit);
  return unit ? std::pair{unit->per_si * value, std::string(unit->symbol)} : in_si(quantity, value, language);
}

}  // namespace

Result values(const std::vector<std::string>& names) { return values_written(names, in_si, false); }
Result workshop_values(const std::vector<std::string>& names) {
  return values_written(names, in_workshop_unit, true);
}

std::string unit_told(const Quantity& quantity, bool in_workshop_unit_too, Language language) {
  return (in_workshop_unit_too ? in_workshop_unit : in_si)(quantity, 0, language).second;
}

Result value_as(const std::string& symbol, const std::string& name) {
  const auto tell = [=](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    const auto value = solution.value(name);
    if (!value) return {};
    return drawings::Paragraph{fmt::format("{} = {} {}", symbol, figures(*value, significant, language),
                                           written_unit(solution.described(name).unit, language))};
  };
  return {tell, {name}};
}

Result by_point(const std::vector<std::string>& points, const std::vector<Column>& columns) {
  const auto tell = [=](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    drawings::Table table{{"$X$"}, {}};
    for (const Column& column : columns) table.head.push_back(column.head);
    for (const std::string& X : points) {
      table.rows.push_back({"$" + point_letters(X) + "$"});
      for (const Column& column : columns) {
        const auto value = solution.value(fmt::format(fmt::runtime(column.name), X));
        table.rows.back().push_back(value ? figures(*value, significant, language) : "∞");
      }
    }
    return table;
  };
  std::vector<std::string> asked;
  for (const std::string& X : points)
    for (const Column& column : columns) asked.push_back(fmt::format(fmt::runtime(column.name), X));
  return {tell, asked};
}

Result table(const std::vector<std::string>& heads, const std::vector<Row>& rows, int significant) {
  const auto tell = [=](const Solution& solution, Language language) -> std::optional<drawings::Block> {
    drawings::Table table{heads, {}};
    for (const Row& row : rows) {
      table.rows.push_back({row.head});
      for (const std::string& name : row.names) {
        const auto value = name.empty() ? std::nullopt : solution.value(name);
        if (!value) {
          table.rows.back().push_back(row.where_none);
          continue;
        }
        const auto in_unit = row.is_in_workshop_units ? in_workshop_unit : in_si;
        table.rows.back().push_back(
            figures(in_unit(solution.described(name), *value, language).first, significant, language));
      }
    }
    return table;
  };
  std::vector<Result::Asked> asked;
  for (const Row& row : rows)
    for (const std::string& name : row.names)
      if (!name.empty()) asked.push_back({name, row.is_in_workshop_units});
  return {tell, asked};
}

Result remark(const std::string& words) {
  return [words](const Solution&, Language) -> std::optional<drawings::Block> {
    if (words.empty()) return {};
    return drawings::Paragraph{words};
  };
}

}  // namespace epure
