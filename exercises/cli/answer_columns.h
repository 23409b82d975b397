// What the columns of a table of answers, or of a key, stand for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"
#include "exercises/cli/harmless_cell.h"

namespace epure {

// A given or a quantity that has a column.
struct AskedColumn {
  std::size_t column;
  std::string name, unit;  // as the column has it; empty: the own one

  // A cell of it with the unit of the column, when it has none itself.
  std::string with_unit(const std::string& cell) const;
  std::string text(const CsvRow& row) const { return with_unit(text_of_cell(row.cells[column])); }
};

// A student, a scale, or what is not read: no given and no quantity of this name would be found under it.
bool heads_something_else(const std::string& head);

enum class TableRole { key, answers };

struct AnswerColumns {
  // A name that both a given and a quantity have is in a key the given, unless a quantity stands to its left; in
  // answers the quantity, unless it stands there twice: then the first is the given. Throws BadTable for two columns
  // of one thing, a unit that is none of it, and a column whose name is near one of a quantity or given: what is
  // marked must not hang on a slip of the finger.
  AnswerColumns(const Exercise& exercise, const CsvTable& table, TableRole role);

  std::optional<std::size_t> numbers = {};
  std::vector<std::size_t> scales = {};
  std::vector<AskedColumn> givens = {}, quantities = {};
  std::vector<AskedColumn> sheets = {};    // of a key: at which scale they were drawn, 0.2 for 1 : 5
  std::vector<std::string> left_out = {};  // the heads of what is none of all this
};

}  // namespace epure
