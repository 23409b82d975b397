#include "exercises/cli/student_columns.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "exercises/cli/harmless_cell.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

// "Last_name" as "last name", "N. matricola" as "n matricola".
std::string in_plain_words(const std::string& head) {
  std::string words;
  for (const char c : lower_case(head)) {
    const bool is_letter = std::string_view(" ._-").find(c) == std::string_view::npos;
    if (is_letter)
      words += c;
    else if (!words.empty() && words.back() != ' ')
      words += ' ';
  }
  if (words.ends_with(' ')) words.pop_back();
  return words;
}

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, const std::string& head) {
  return std::find(names.begin(), names.end(), in_plain_words(head)) != names.end();
}

bool heads_whole_names(const std::string& head) {
  return is_one_of(std::array<std::string_view, 9>{"name", "nome", "student", "studente", "full name",
                                                   "nome completo", "nominativo", "cognome e nome", "nome e cognome"},
                   head);
}
bool heads_surnames(const std::string& head) {
  return is_one_of(std::array<std::string_view, 5>{"surname", "last name", "lastname", "family name", "cognome"},
                   head);
}
// "name" and "nome" beside a surname.
bool heads_first_names(const std::string& head) {
  return is_one_of(std::array<std::string_view, 7>{"first name", "firstname", "given name", "forename", "name",
                                                   "nome", "nome proprio"},
                   head);
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
  return is_one_of(
      std::array<std::string_view, 13>{"number", "numero", "matricola", "id", "id number", "student id",
                                       "student number", "n matricola", "nr matricola", "numero matricola",
                                       "numero di matricola", "numero id", "codice identificativo"},
      head);
}
bool heads_names(const std::string& head) {
  return heads_whole_names(head) || heads_surnames(head) || heads_first_names(head);
}

std::optional<std::size_t> column_of_numbers(const CsvTable& table) { return only_column(table, heads_numbers); }

std::size_t needed_column_of_numbers(const CsvTable& table) {
  if (const auto found = column_of_numbers(table)) return *found;
  throw BadTable(format_words("{}: a column \"number\" (or \"matricola\") is missing; there are {}",
                              "{}: manca una colonna \"number\" (o \"matricola\"); ci sono {}", table.file,
                              alternatives(table.header)));
}

NameColumns::NameColumns(const CsvTable& table) {
  const auto surname = only_column(table, heads_surnames);
  const auto first_name =
      surname ? only_column(table, heads_first_names) : only_column(table, [](const std::string& head) {
        return heads_whole_names(head) || heads_first_names(head);
      });
  for (const auto& column : {surname, first_name})
    if (column) columns_.push_back(*column);
  std::sort(columns_.begin(), columns_.end());
}

std::string NameColumns::name_in(const CsvRow& row) const {
  std::string name;
  for (const std::size_t column : columns_) {
    const std::string part = text_of_cell(row.cells[column]);
    name += (name.empty() || part.empty() ? "" : " ") + part;
  }
  return name;
}

}  // namespace epure
