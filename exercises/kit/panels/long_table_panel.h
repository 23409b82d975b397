// A page of a long table, its numbers in line at their decimal sign, with the heads on each page.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/statement/long_table.h"

namespace epure {

// How many rows of so many columns stand on a page of this paper: as it has room for, and an SVG of 100 kB.
std::size_t rows_of_a_page(drawings::Paper paper, std::size_t columns);

class LongTablePanel : public Panel {
 public:
  // Rows from `first` on, as many as a page takes. Throws DoesNotFit when its columns are too wide.
  LongTablePanel(const LongTable& table, std::size_t first, const SheetRequest& request);

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language) const override;
  // The heads, and the first column, by which rows are told.
  void draw_given(Plot& plot, const drawings::Box& room, Language) const override;

 private:
  struct Column {
    std::vector<std::string> cells;  // letters, unit, numbers
    double width = 0;                // mm, at the size of the letters
  };
  void measure(double size);
  double width() const;
  double line_height() const;
  void draw(Plot& plot, const drawings::Box& room, bool is_empty) const;

  std::vector<Column> columns_;
  double size_ = 0, gap_ = 0, line_room_ = 0;  // mm
  std::size_t lines_ = 0;
};

}  // namespace epure
