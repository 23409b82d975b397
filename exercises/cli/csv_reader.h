// Tables that others wrote: rosters, answers and keys, out of any spreadsheet.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exercises/cli/catalogue.h"

namespace epure {

// A file that cannot be read as a table; the sentence names it, and the line (exit code 2).
struct BadTable : WrongUsage {
  using WrongUsage::WrongUsage;
};

struct CsvRow {
  std::size_t line;  // of the file, where it begins; from 1
  std::vector<std::string> cells;
};

struct CsvTable {
  std::string file;  // as it was named
  std::vector<std::string> header;
  std::vector<CsvRow> rows;  // each with as many cells as the header
  Words remark = {};         // on how the file was read

  // The place of the column with this name; none: there is no such column. Throws BadTable when there are several.
  std::optional<std::size_t> column(const std::string& name) const;
  // Throws BadTable when there is none.
  std::size_t needed_column(const std::string& name) const;
  // Throws BadTable when two rows have the same text in this column, or one has none.
  void demand_distinct(std::size_t column) const;
};

// "sep=;", which a spreadsheet reads or writes before a table.
bool names_separator(std::string_view line);

// By RFC 4180, and as spreadsheets write it: UTF-8 with or without a byte order mark, lines that end in LF, CR LF or
// CR, fields divided by what divides those of the header (comma, semicolon or tabulator), quotes doubled inside of
// quotes; also quotes in a field that does not begin with one, which stand for themselves. Blanks around a field
// without quotes are left out, and so are lines of nothing and columns without name and content. Throws BadTable for
// bytes that are no UTF-8, a NUL, a quote that does not close or is followed by something, rows of more or fewer
// fields than the header, a column without a name, more than 100,000 rows, a row of more than a million bytes, and no
// header at all.
CsvTable read_csv(const std::string& bytes, const std::string& file);

// The same of a file; one in Windows-1252, as Excel writes "CSV" in Western Europe, is read as that, with a remark.
// Throws BadTable when it cannot be read, or holds more than 256 MB.
CsvTable read_csv_file(const std::string& path);

// A file of text, without a byte order mark. Throws BadTable as these do for what cannot be read, bytes that are no
// UTF-8, and a NUL.
std::string read_text_file(const std::string& path);

// Why a line of a file cannot be understood.
[[noreturn]] void refuse_line(const std::string& file, std::size_t line, const Words& why);

}  // namespace epure
