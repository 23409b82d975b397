#include "bench/sheets/table.h"

#include "drawings/text/text.h"

namespace epure::bench {
namespace {

constexpr double line_height = 1.75;                  // of the size of the letters
constexpr double below_head = 0.5, above_foot = 0.6;  // of the size of the letters
constexpr double between_columns = 2;                 // mm

// Letters that continue a character of several bytes.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::string cut(std::string text, double size, double width) {
  if (drawings::measure(text, size).width <= width) return text;
  do {
    do {
      text.pop_back();
    } while (!text.empty() && continues(text.back()));
    // The first byte of a character whose rest is gone.
    if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xC0) text.pop_back();
  } while (!text.empty() && drawings::measure(text + "…", size).width > width);
  return text + "…";
}

}  // namespace

double height_of_table(const std::vector<std::vector<std::string>>& rows, double size) {
  return (line_height * static_cast<double>(rows.size()) + below_head + above_foot) * size;
}

double draw_table(drawings::Figure& figure, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<SheetColumn>& columns, drawings::Point corner, double size) {
  double width = 0;
  for (const SheetColumn& column : columns) width += column.width;
  const auto rule = [&](double y) {
    figure.marks.push_back(
        drawings::Line{drawings::segment({corner.x, y}, {corner.x + width, y}), drawings::Meaning::dimension});
  };
  double y = corner.y;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    y -= line_height * size;
    double left = corner.x;
    for (std::size_t i = 0; i < rows[row].size() && i < columns.size(); ++i) {
      const std::string text = cut(rows[row][i], size, columns[i].width - between_columns);
      const double own = text.empty() ? 0 : drawings::measure(text, size).width;
      const double x =
          columns[i].to_the_right ? left + columns[i].width - between_columns / 2 - own : left + between_columns / 2;
      if (!text.empty()) figure.marks.push_back(drawings::Writing{text, {x, y}, size});
      left += columns[i].width;
    }
    if (row == 0) {
      y -= below_head * size;
      rule(y);
    }
  }
  y -= above_foot * size;
  rule(y);
  return y;
}

}  // namespace epure::bench
