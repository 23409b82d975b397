// Whose row it is: the columns of rosters, variants, answers and keys that say so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"

namespace epure {

// "number", "matricola", "id" and what else registers call it; "name" or "studente", or a surname ("cognome") and a
// first name in columns of their own. Capitals, blanks, dots and underscores do not matter.
bool heads_numbers(const std::string& head);
bool heads_names(const std::string& head);

// None: there is no such column. Throws BadTable when there are several.
std::optional<std::size_t> column_of_numbers(const CsvTable& table);
// Throws BadTable when there is none, too.
std::size_t needed_column_of_numbers(const CsvTable& table);

// The columns whose cells make a name: one, or the surname's and the first name's in the order of the table; none: it
// names nobody. Throws BadTable when several mean the same.
class NameColumns {
 public:
  explicit NameColumns(const CsvTable& table);
  std::string name_in(const CsvRow& row) const;

 private:
  std::vector<std::size_t> columns_;
};

}  // namespace epure
