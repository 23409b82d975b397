// Tables with thin rules: words to the left, numbers in line at their decimal sign.
#include <algorithm>
#include <cctype>
#include <numeric>

#include "drawings/sheet/column.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

constexpr double room_to_write = 0.9, width_to_write = 8;  // of the letters' size, above the line; where nothing is

// What stands left of the decimal sign, and the rest with sign and unit; no number: no value.
struct Numeral {
  std::string before, rest;
};

std::optional<Numeral> as_numeral(const std::string& cell) {
  const bool framed = cell.size() > 2 && cell.front() == '$' && cell.back() == '$';
  const std::string text = framed ? cell.substr(1, cell.size() - 2) : cell;
  std::size_t i = 0;
  const std::string minus = "−";
  if (text.starts_with(minus))
    i = minus.size();
  else if (!text.empty() && (text[0] == '-' || text[0] == '+'))
    i = 1;
  const auto digit = [&](std::size_t k) {
    return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k]));
  };
  if (!digit(i)) return std::nullopt;
  while (digit(i)) ++i;
  // Inside mathematics only the digits before the sign can be measured apart from the rest.
  return Numeral{text.substr(0, i), text.substr(i)};
}

// A cell of a table to be filled in may have a caption after a line break: it stands in small letters above the text.
struct Captioned {
  std::string text, caption;
};
Captioned parts_of(const std::string& cell) {
  const auto end = cell.find('\n');
  return end == std::string::npos ? Captioned{cell, {}} : Captioned{cell.substr(0, end), cell.substr(end + 1)};
}

struct TableColumn {
  bool numeric = false;
  double before = 0, after = 0;  // widest parts of its numbers on both sides of the decimal sign
  double body = 0, width = 0;
  std::vector<std::string> head;  // broken into lines
};

double cell_width(const std::string& cell, double size) { return cell.empty() ? 0 : measure(cell, size).width; }

TableColumn measure_column(const Table& table, std::size_t index, double size) {
  TableColumn column;
  std::size_t numbers = 0, filled = 0;
  for (const auto& row : table.rows) {
    if (index >= row.size() || row[index].empty()) continue;
    ++filled;
    column.body = std::max(column.body, cell_width(parts_of(row[index]).text, size));
    const auto numeral = as_numeral(row[index]);
    if (!numeral) continue;
    ++numbers;
    const double before = cell_width(numeral->before, size);
    column.before = std::max(column.before, before);
    column.after = std::max(column.after, cell_width(row[index], size) - before);
  }
  if (table.to_fill_in && filled == 0) column.body = width_to_write * size;
  // A dash or "?" among numbers does not make them words.
  column.numeric = numbers > 0 && 2 * numbers > filled;
  if (column.numeric) column.body = std::max(column.body, column.before + column.after);
  return column;
}

void break_head(TableColumn& column, const std::string& head, double size, double room) {
  column.head = head.empty() ? std::vector<std::string>{} : wrap(head, size, std::max(room, column.body));
  column.width = column.body;
  for (const std::string& line : column.head) column.width = std::max(column.width, cell_width(line, size));
}

double total_width(const std::vector<TableColumn>& columns) {
  return std::accumulate(columns.begin(), columns.end(), 0.0,
                         [](double sum, const auto& c) { return sum + c.width; });
}

std::vector<TableColumn> measure_columns(const Table& table, double size, double room) {
  std::size_t count = table.head.size();
  for (const auto& row : table.rows) count = std::max(count, row.size());
  std::vector<TableColumn> columns;
  for (std::size_t i = 0; i < count; ++i) columns.push_back(measure_column(table, i, size));
  const double gaps = size * static_cast<double>(count > 0 ? count - 1 : 0);
  // Heads on one line when there is room, else broken as narrow as the numbers below allow.
  for (const double head_room : {room, 0.0}) {
    for (std::size_t i = 0; i < count; ++i)
      break_head(columns[i], i < table.head.size() ? table.head[i] : std::string{}, size, head_room);
    if (total_width(columns) + gaps <= room) break;
  }
  return columns;
}

double cell_left(const TableColumn& column, const std::string& cell, double x, double size) {
  if (!column.numeric) return x;
  const double right = x + column.width;
  if (const auto numeral = as_numeral(cell)) return right - column.after - cell_width(numeral->before, size);
  return right - cell_width(cell, size);
}

void set_head(Galley& galley, const std::vector<TableColumn>& columns, double gap, double right) {
  std::size_t lines = 0;
  for (const TableColumn& column : columns) lines = std::max(lines, column.head.size());
  if (lines == 0) return;
  const double size = galley.size();
  for (std::size_t line = 0; line < lines; ++line) {
    double x = galley.left();
    for (const TableColumn& column : columns) {
      // Heads stand on the rule: short ones begin lower.
      const std::size_t skip = lines - column.head.size();
      if (line >= skip) {
        const std::string& text = column.head[line - skip];
        const double left = column.numeric ? x + column.width - cell_width(text, size) : x;
        galley.text(text, {left, galley.baseline()}, size);
      }
      x += column.width + gap;
    }
    galley.down(1.2 * size);
  }
  galley.down(0.1 * size);
  galley.rule(galley.top(), galley.left(), right, fine);
  galley.down(0.25 * size);
}

// Each as wide as there is room before the next one; whether there are any.
bool set_captions(Galley& galley, const std::vector<std::string>& row, const std::vector<TableColumn>& columns,
                  double gap, double right) {
  constexpr double small = 2.2, line = 1.12 * small;  // mm
  std::size_t most = 0;
  double x = galley.left();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string caption = parts_of(row[i]).caption;
    if (!caption.empty()) {
      double end = x + columns[i].width;
      for (std::size_t k = i + 1; k < row.size() && row[k].empty(); ++k) end += gap + columns[k].width;
      const auto lines = wrap(caption, small, std::min(end, right) - x);
      for (std::size_t k = 0; k < lines.size(); ++k)
        galley.text(lines[k], {x, galley.top() - 1.25 * small - line * static_cast<double>(k)}, small,
                    Weight::regular, grey);
      most = std::max(most, lines.size());
    }
    x += columns[i].width + gap;
  }
  if (most > 0) galley.down(0.25 * small + line * static_cast<double>(most));
  return most > 0;
}

void set_row(Galley& galley, const std::vector<std::string>& row, const std::vector<TableColumn>& columns, double gap,
             double room_above) {
  const double size = galley.size();
  double above = room_above;
  for (const std::string& cell : row)
    if (!cell.empty()) above = std::max(above, measure(parts_of(cell).text, size).ascent - 0.78 * size);
  galley.down(above);
  double x = galley.left();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i < row.size() && !row[i].empty()) {
      const std::string text = parts_of(row[i]).text;
      galley.text(text, {cell_left(columns[i], text, x, size), galley.baseline()}, size);
    }
    x += columns[i].width + gap;
  }
  galley.down((1.18 + 0.16 * galley.air()) * size);
}

// What is to be filled in is narrower where words leave less room.
void narrow_blanks(std::vector<TableColumn>& columns, double size, double room) {
  constexpr double narrowest = 4;  // of the letters' size
  constexpr double hair = 0.01;    // mm to spare, so that what is narrowed to fit is not too wide by a rounding
  const auto is_blank = [&](const TableColumn& column) { return column.width == width_to_write * size; };
  const auto blanks = static_cast<double>(std::count_if(columns.begin(), columns.end(), is_blank));
  const double beyond = total_width(columns) + size * static_cast<double>(columns.size() - 1) - room + hair;
  if (blanks == 0 || beyond <= 0) return;
  for (TableColumn& column : columns)
    if (is_blank(column)) column.width = std::max(narrowest * size, column.width - beyond / blanks);
}

}  // namespace

void set_block(Galley& galley, const Table& table, Language) {
  const double size = galley.size();
  std::vector<TableColumn> columns = measure_columns(table, size, galley.width());
  if (columns.empty()) return;
  if (table.to_fill_in) narrow_blanks(columns, size, galley.width());
  const auto gaps = static_cast<double>(columns.size() - 1);
  const double spare = galley.width() - total_width(columns);
  if (spare < size * gaps)
    galley.complaints.push_back("a table is wider than the column: " +
                                (table.head.empty() ? std::string{} : plain(table.head.front())));
  // As wide as the column, but never so wide that the eye loses the row on its way.
  const double gap = gaps > 0 ? std::clamp(spare / gaps, 0.5 * size, 5 * size) : 0;
  const double right = galley.left() + total_width(columns) + gap * gaps;
  galley.down(0.3 * size * galley.air());
  galley.rule(galley.top(), galley.left(), right, narrow);
  galley.down(0.25 * size);
  set_head(galley, columns, gap, right);
  for (const auto& row : table.rows) {
    double room_above = 0;
    if (table.to_fill_in)  // below a caption, which is seldom as long as the row, there is room already
      room_above = (set_captions(galley, row, columns, gap, right) ? 0.7 : 1) * room_to_write * size;
    set_row(galley, row, columns, gap, room_above);
    if (table.to_fill_in && &row != &table.rows.back()) galley.rule(galley.top(), galley.left(), right, fine);
  }
  galley.rule(galley.top(), galley.left(), right, narrow);
  galley.down(0.7 * size * galley.air());
}

}  // namespace epure::drawings
