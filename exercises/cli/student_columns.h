// Whose row it is: the columns of rosters, variants, answers and keys that say so.
#pragma once

#include <optional>
#include <string>

#include "exercises/cli/csv_reader.h"

namespace epure {

// "number", "matricola" or "id"; "name", "nome", "student" or "studente"; capitals do not matter.
bool heads_numbers(const std::string& head);
bool heads_names(const std::string& head);

// None: there is no such column. Both throw BadTable when there are several.
std::optional<std::size_t> column_of_numbers(const CsvTable& table);
std::optional<std::size_t> column_of_names(const CsvTable& table);
// Throws BadTable when there is none, too.
std::size_t needed_column_of_numbers(const CsvTable& table);

}  // namespace epure
