#include "exercises/cli/student_columns.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, const std::string& head) {
  return std::find(names.begin(), names.end(), lower_case(head)) != names.end();
}

std::optional<std::size_t> only_column(const CsvTable& table, bool (*is_meant)(const std::string&)) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    if (!is_meant(table.header[i])) continue;
    if (found)
      throw BadTable(format_words("{}: the columns \"{}\" and \"{}\" mean the same; keep one of them",
                                  "{}: le colonne \"{}\" e \"{}\" vogliono dire lo stesso; tenerne una", table.file,
                                  table.header[*found], table.header[i]));
    found = i;
  }
  return found;
}

}  // namespace

bool heads_numbers(const std::string& head) {
  return is_one_of(std::array<std::string_view, 3>{"number", "matricola", "id"}, head);
}
bool heads_names(const std::string& head) {
  return is_one_of(std::array<std::string_view, 4>{"name", "nome", "student", "studente"}, head);
}

std::optional<std::size_t> column_of_numbers(const CsvTable& table) { return only_column(table, heads_numbers); }
std::optional<std::size_t> column_of_names(const CsvTable& table) { return only_column(table, heads_names); }

std::size_t needed_column_of_numbers(const CsvTable& table) {
  if (const auto found = column_of_numbers(table)) return *found;
  throw BadTable(format_words("{}: a column \"number\" (or \"matricola\") is missing; there are {}",
                              "{}: manca una colonna \"number\" (o \"matricola\"); ci sono {}", table.file,
                              alternatives(table.header)));
}

}  // namespace epure
