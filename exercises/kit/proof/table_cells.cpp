#include "exercises/kit/proof/table_cells.h"

#include <fmt/format.h>

#include <cmath>

#include "drawings/text/text.h"
#include "exercises/kit/proof/told_numbers.h"
#include "exercises/kit/statement/decimal.h"

namespace epure {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// The cells of a page's table row by row, heads too.
Rows rows_on(const drawings::Sheet& page) {
  Rows rows;
  for (const drawings::Mark& mark : page.figure.marks)
    if (const auto* cell = std::get_if<drawings::Writing>(&mark); cell && cell->row) {
      if (rows.size() <= *cell->row) rows.resize(*cell->row + 1);
      rows[*cell->row].push_back(cell->text);
    }
  return rows;
}

// Of all pages, without the heads.
Rows rows_of_pages(const DrawnSheet& drawn) {
  Rows all;
  const auto add = [&](const drawings::Sheet& page) {
    const Rows rows = rows_on(page);
    for (std::size_t i = LongTable::head_lines; i < rows.size(); ++i) all.push_back(rows[i]);
  };
  add(drawn.sheet);
  for (const drawings::Sheet& page : drawn.further) add(page);
  return all;
}

bool are_neighbours(double a, double b) { return a == b || std::nextafter(a, b) == b; }

}  // namespace

std::optional<Words> wrong_table(const std::string& sheet, const DrawnSheet& drawn, const LongTable& table) {
  const Rows rows = rows_of_pages(drawn);
  if (rows.size() != table.rows())
    return format_words("sheet {}: its pages show {} of the {} rows of its table",
                        "tavola {}: le sue pagine mostrano {} delle {} righe della tabella", sheet, rows.size(),
                        table.rows());
  const auto other = table.by_another_route();
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double value = table.columns[c].values[row], expected = other.at(c).at(row);
      const std::string& cell = rows[row].at(c);
      if (is_rounding_of(cell, expected) && are_neighbours(value, expected)) continue;
      return format_words(
          "sheet {}: in row {} of its table {} is {} (in full {}), but {} by another route",
          "tavola {}: nella riga {} della sua tabella {} vale {} (per intero {}), ma {} per altra via", sheet,
          row + 1, table.columns[c].name, drawings::plain(cell), decimal(fmt::format("{}", value)),
          decimal(fmt::format("{}", expected)));
    }
  return std::nullopt;
}

}  // namespace epure
