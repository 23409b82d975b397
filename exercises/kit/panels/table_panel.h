// A table as a part of the drawing, where the column is too narrow for it: words to the left, numbers in line at
// their decimal sign.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

class TablePanel : public Panel {
 public:
  // Cells are rich text. The first column holds words.
  TablePanel(std::vector<std::string> heads, std::vector<std::vector<std::string>> rows);

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;

 private:
  struct Column {
    double before = 0, after = 0;  // mm, of its widest cell, on both sides of the decimal sign
    double width = 0;
  };
  double width() const;

  std::vector<std::string> heads_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<Column> columns_;
};

}  // namespace epure
