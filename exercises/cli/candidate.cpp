#include "exercises/cli/candidate.h"

#include <algorithm>
#include <map>
#include <set>

#include "drawings/text/text.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/student_columns.h"
#include "exercises/cli/utf8.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

// No path, no hidden file, nothing that a shell or another system would read otherwise.
std::string fit_for_file(const std::string& number) {
  std::string file;
  for (const char c : number) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    file += is_plain || (c == '-' && !file.empty()) ? c : '_';
  }
  return file;
}

void demand_line(const CsvTable& table, const CsvRow& row, const std::string& text) {
  constexpr std::size_t longest = 80;
  const std::size_t length = count_characters(text);
  if (length > longest)
    throw BadTable(format_words("{}, line {}: \"{}\" has {} characters, and a sheet has room for {}",
                                "{}, riga {}: \"{}\" ha {} caratteri, e una tavola ne tiene {}", table.file, row.line,
                                text, length, longest));
  if (printable(text) != text)
    throw BadTable(format_words("{}, line {}: \"{}\" holds characters that cannot be printed",
                                "{}, riga {}: \"{}\" contiene caratteri non stampabili", table.file, row.line, text));
  if (!drawings::can_write(text))
    throw BadTable(
        format_words("{}, line {}: \"{}\" has letters that epure's fonts have not (these are Latin, Greek "
                     "and Cyrillic)",
                     "{}, riga {}: \"{}\" ha lettere che i caratteri di epure non hanno (ne hanno di latine, "
                     "greche e cirilliche)",
                     table.file, row.line, text));
}

void demand_files_apart(const CsvTable& table, const std::vector<Candidate>& students) {
  std::map<std::string, std::string> seen;
  for (const Candidate& each : students)
    if (const auto [other, is_new] = seen.try_emplace(lower_case(each.file), each.number); !is_new)
      throw BadTable(format_words("{}: the numbers \"{}\" and \"{}\" would name the same files",
                                  "{}: i numeri \"{}\" e \"{}\" darebbero il nome agli stessi file", table.file,
                                  other->second, each.number));
}

std::vector<Candidate> students_in(const CsvTable& table, bool needs_number) {
  const auto number = needs_number ? needed_column_of_numbers(table) : column_of_numbers(table);
  const NameColumns names(table);
  if (number) table.demand_distinct(*number);
  std::vector<Candidate> students;
  for (const CsvRow& row : table.rows) {
    Candidate each{
        number ? text_of_cell(row.cells[*number]) : std::to_string(students.size() + 1), names.name_in(row), {}};
    demand_line(table, row, each.number);
    demand_line(table, row, each.name);
    each.file = fit_for_file(each.number);
    students.push_back(std::move(each));
  }
  if (students.empty())
    throw BadTable(needs_number
                       ? format_words("{}: there is no student in it", "{}: non contiene alcuno studente", table.file)
                       : format_words("{}: there is no row below its header",
                                      "{}: non c'è alcuna riga sotto l'intestazione", table.file));
  demand_files_apart(table, students);
  return students;
}

}  // namespace

std::vector<Candidate> candidates_of(const CsvTable& roster) { return students_in(roster, true); }

std::vector<Candidate> variants_of(const CsvTable& table, const std::vector<const Exercise*>& exercises) {
  std::vector<Candidate> students = students_in(table, false);
  for (std::size_t i = 0; i < students.size(); ++i)
    students[i].place = format_words("{}, line {}", "{}, riga {}", table.file, table.rows[i].line);
  std::set<std::string> headed;
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    const std::string& head = table.header[column];
    if (heads_numbers(head) || heads_names(head)) continue;
    const auto symbol = given_meant(head, exercises);
    if (!symbol)
      throw BadTable(format_words("{}: the column \"{}\" is no given of {}; {}",
                                  "{}: la colonna \"{}\" non è un dato di {}; {}", table.file, head,
                                  names_of(exercises), did_you_mean(head, symbols_of(exercises))));
    if (!headed.insert(*symbol).second)
      throw BadTable(
          format_words("{}: there are two columns for {}", "{}: ci sono due colonne per {}", table.file, *symbol));
    for (std::size_t i = 0; i < students.size(); ++i)
      if (const std::string cell = text_of_cell(table.rows[i].cells[column]); !cell.empty())
        students[i].assignments.push_back(*symbol + "=" + cell);
  }
  return students;
}

std::vector<Candidate> numbered_candidates(std::size_t count) {
  std::vector<Candidate> students;
  for (std::size_t i = 1; i <= count; ++i) students.push_back({std::to_string(i), "", std::to_string(i)});
  return students;
}

}  // namespace epure
