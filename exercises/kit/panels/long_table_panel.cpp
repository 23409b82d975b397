#include "exercises/kit/panels/long_table_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "drawings/text/text.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double least_line = 3.8, highest_line = 5.2, under_heads = 1.5, table_air = 4;  // mm
constexpr double largest_size = 2.6, smallest_size = 1.8;                                 // mm, of the letters
constexpr double least_gap = 1.6, widest_gap = 5;                                         // mm, between columns
constexpr std::size_t most_cells = 400;                                                   // of a page

// Whether a column's decimals suit its numbers, none of which is longer than that, and the greatest of which they
// show.
bool suits(const LongTable::Column& column) {
  constexpr double longest = 1e7;
  double greatest = 0;
  for (const double value : column.values) greatest = std::max(greatest, std::abs(value));
  return greatest == 0 || (greatest < longest && greatest >= 10 * std::pow(10.0, -column.decimals));
}

std::string written(double value, std::optional<int> decimals, Language language) {
  constexpr int significant = 4;
  if (!decimals) return figures(value, significant, language);
  std::string text = fmt::format("{:.{}f}", value, *decimals);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  if (text.starts_with('-')) text.replace(0, 1, is_zero ? "" : "−");
  if (const auto point = text.find('.'); language == Language::italian && point != std::string::npos)
    text[point] = ',';
  return text;
}

double width_of(const std::string& cell, double size) {
  return cell.empty() ? 0 : drawings::measure(cell, size).width;
}

double room_for_lines(drawings::Paper paper) {
  return drawings::drawing_area(paper).height() - 4 * table_air - under_heads;
}

}  // namespace

std::size_t rows_of_a_page(drawings::Paper paper, std::size_t columns) {
  const auto room = static_cast<std::size_t>(room_for_lines(paper) / least_line) - LongTable::head_lines;
  return std::min(room, most_cells / std::max<std::size_t>(1, columns));
}

LongTablePanel::LongTablePanel(const LongTable& table, std::size_t first, const SheetRequest& request) {
  const std::size_t rows = rows_of_a_page(request.paper, table.columns.size()),
                    last = std::min(table.rows(), first + rows);
  lines_ = LongTable::head_lines + last - first;
  line_room_ =
      std::min(highest_line, room_for_lines(request.paper) / static_cast<double>(LongTable::head_lines + rows));
  for (const LongTable::Column& column : table.columns) {
    const std::string unit = written_unit(column.unit, request.language);
    columns_.push_back({{column.letters, unit.empty() ? "" : "(" + unit + ")"}});
    const std::optional<int> decimals = suits(column) ? std::optional(column.decimals) : std::nullopt;
    for (std::size_t row = first; row < last; ++row)
      columns_.back().cells.push_back(written(column.values[row], decimals, request.language));
  }
  const double room = figure_area(request).width() - 5 * table_air;
  const double gaps = static_cast<double>(columns_.size() - 1);
  for (size_ = largest_size;; size_ *= 0.97) {
    if (size_ < smallest_size)
      throw DoesNotFit("the numbers of the table are too long for the paper",
                       "i numeri della tabella sono troppo lunghi per la carta");
    measure(size_);
    gap_ = least_gap;
    if (width() <= room) break;
  }
  gap_ = std::clamp((room - (width() - gaps * gap_)) / std::max(gaps, 1.0), least_gap, widest_gap);
}

void LongTablePanel::measure(double size) {
  for (Column& column : columns_) {
    column.width = 0;
    for (const std::string& cell : column.cells) column.width = std::max(column.width, width_of(cell, size));
  }
}

double LongTablePanel::width() const {
  double all = gap_ * static_cast<double>(columns_.size() - 1);
  for (const Column& column : columns_) all += column.width;
  return all;
}

// Whole thousandths of the letters' size, in which a file may count: its rows are all alike.
double LongTablePanel::line_height() const {
  const double thousandth = size_ / 1000;
  return thousandth * std::floor(line_room_ / thousandth);
}

drawings::Box LongTablePanel::extent(const Scale&, const Scale&) const {
  return {{0, 0},
          {width() + 2 * table_air, line_height() * static_cast<double>(lines_) + under_heads + 2 * table_air}};
}

std::vector<drawings::Block> LongTablePanel::draw(Plot& plot, const drawings::Box& room, Language) const {
  draw(plot, room, false);
  return {};
}

void LongTablePanel::draw_given(Plot& plot, const drawings::Box& room, Language) const { draw(plot, room, true); }

// From the top of the room, so that all pages begin alike.
void LongTablePanel::draw(Plot& plot, const drawings::Box& room, bool is_empty) const {
  const double left = (room.low.x + room.high.x - width()) / 2, top = room.high.y - table_air;
  const auto rule = [&](double y) {
    plot.mark(drawings::Line{drawings::segment({left, y}, {left + width(), y}), Meaning::construction, {}});
  };
  const auto foot = [&](std::size_t line) {
    return top - line_height() * static_cast<double>(line + 1) - (line < LongTable::head_lines ? 0 : under_heads);
  };
  for (std::size_t line = 0; line < lines_; ++line) {
    double right = left;
    for (const Column& column : columns_) {
      const std::string& cell = column.cells[line];
      right += column.width;
      const drawings::Point at{right - width_of(cell, size_), foot(line) + 0.3 * line_height()};
      if (!is_empty || line < LongTable::head_lines || &column == &columns_.front())
        plot.mark(drawings::Writing{.text = cell, .baseline = at, .size = size_, .row = line, .anchor = 1});
      right += gap_;
    }
  }
  rule(top);
  rule(foot(LongTable::head_lines - 1) - under_heads / 2);
  rule(foot(lines_ - 1) - under_heads / 2);
}

}  // namespace epure
