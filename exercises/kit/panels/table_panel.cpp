#include "exercises/kit/panels/table_panel.h"

#include <algorithm>

#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr double letter_size = 3.2;                                             // mm, of the letters
constexpr double row_height = 2 * letter_size, column_gap = 2.2 * letter_size;  // rows, columns
constexpr double under_head = 0.6 * letter_size;

double cell_width(const std::string& text) { return text.empty() ? 0 : drawings::measure(text, letter_size).width; }

// What stands left of the decimal sign; all of a whole number or a word. A number in mathematics has its power of ten
// after the sign.
std::string before_sign(const std::string& cell) {
  const std::string text = cell.starts_with("$") ? cell.substr(1) : cell;
  return text.substr(0, text.find_first_of(".,·"));
}

drawings::Writing written(const std::string& text, double x, double y) { return {text, {x, y}, letter_size}; }

}  // namespace

TablePanel::TablePanel(std::vector<std::string> heads, std::vector<std::vector<std::string>> rows)
    : heads_(std::move(heads)), rows_(std::move(rows)), columns_(heads_.size()) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    for (const auto& row : rows_) {
      const double before = i == 0 ? cell_width(row[i]) : cell_width(before_sign(row[i]));
      column.before = std::max(column.before, before);
      column.after = std::max(column.after, cell_width(row[i]) - before);
    }
    column.width = std::max(cell_width(heads_[i]), column.before + column.after);
  }
}

double TablePanel::width() const {
  double all = column_gap * static_cast<double>(columns_.size() - 1);
  for (const Column& column : columns_) all += column.width;
  return all;
}

drawings::Box TablePanel::extent(const Scale&, const Scale&) const {
  constexpr double air = 4;  // mm
  return {{0, 0}, {width() + 2 * air, row_height * static_cast<double>(rows_.size() + 1) + under_head + 2 * air}};
}

std::vector<drawings::Block> TablePanel::draw(Plot& plot, const drawings::Box& room, Language) const {
  const double left = (room.low.x + room.high.x - width()) / 2;
  double y = (room.low.y + room.high.y + row_height * static_cast<double>(rows_.size()) + under_head) / 2;
  const auto rule = [&](double at) {
    plot.mark(drawings::Line{drawings::segment({left, at}, {left + width(), at}), Meaning::construction, {}});
  };
  const auto set = [&](const std::vector<std::string>& cells, bool is_head) {
    double x = left;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Column& column = columns_[i];
      const double right = x + column.width;
      const double at = i == 0    ? x
                        : is_head ? right - cell_width(cells[i])
                                  : right - column.after - cell_width(before_sign(cells[i]));
      if (!cells[i].empty()) plot.mark(written(cells[i], at, y));
      x = right + column_gap;
    }
    y -= row_height;
  };
  set(heads_, true);
  rule(y + row_height - 0.5 * letter_size);
  y -= under_head;
  for (const auto& row : rows_) set(row, false);
  rule(y + row_height - 0.6 * letter_size);
  return {};
}

}  // namespace epure
