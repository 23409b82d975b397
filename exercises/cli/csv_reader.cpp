#include "exercises/cli/csv_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <map>
#include <string_view>

#include "drawings/files/system_words.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/utf8.h"
#include "exercises/cli/windows_1252.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

constexpr std::size_t most_rows = 100000;
constexpr std::size_t longest_row = 1000000;
constexpr std::size_t largest_file = 256000000;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = character(bytes, at).second;
    if (length == 0) return false;
    at += length;
  }
  return true;
}

void demand_text(std::string_view bytes, const std::string& file) {
  std::size_t line = 1;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto [code, length] = character(bytes, at);
    if (length == 0)
      refuse_line(file, line,
                  {"is not UTF-8; save the table as CSV UTF-8", "non è UTF-8; salvare la tabella come CSV UTF-8"});
    if (code == 0)
      refuse_line(file, line, {"holds a NUL byte; this is no text", "contiene un byte NUL; non è testo"});
    if (code == '\n') ++line;
    at += length;
  }
}

std::string_view without_outer_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// What divides the fields of the header, the first line that is not empty: what stands most often outside of its
// quotes; where a comma stands as often, as in "l,max", the other.
char separator_of(std::string_view text) {
  const std::string_view all = ";\t,";
  std::array<int, 3> counts = {};
  bool is_quoted = false;
  text.remove_prefix(std::min(text.find_first_not_of(" \r\n"), text.size()));
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (c == '\n' || c == '\r') break;
    if (const auto which = all.find(c); which != std::string_view::npos) ++counts.at(which);
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? ',' : all[static_cast<std::size_t>(most - counts.begin())];
}

// Takes rows off the front of a text.
class Records {
 public:
  Records(std::string_view text, const std::string& file) : rest_(text), file_(file), separator_(separator_of(text)) {
    take_line_of_separator();
  }

  bool is_at_end() const { return rest_.empty(); }

  CsvRow next() {
    CsvRow row{line_, {}};
    const std::size_t before = rest_.size();
    do {
      row.cells.push_back(rest_.starts_with('"') ? quoted_field(row.line) : plain_field());
      if (before - rest_.size() > longest_row)
        refuse_line(file_, row.line, format_words("is longer than {} bytes", "è più lunga di {} byte", longest_row));
    } while (take(separator_));
    end_line();
    return row;
  }

 private:
  void take_line_of_separator() {
    const std::string_view line = rest_.substr(0, std::min(rest_.find_first_of("\r\n"), rest_.size()));
    if (!names_separator(line)) return;
    separator_ = line.back();
    rest_.remove_prefix(line.size());
    end_line();
  }
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool is_at_line_end() const { return rest_.empty() || rest_.front() == '\n' || rest_.front() == '\r'; }
  void end_line() {
    take('\r');
    take('\n');
    ++line_;
  }

  std::string plain_field() {
    const std::array<char, 4> ends = {separator_, '\n', '\r', '\0'};  // the text holds no NUL
    const std::size_t end = std::min(rest_.find_first_of(ends.data()), rest_.size());
    const std::string field(without_outer_blanks(rest_.substr(0, end)));
    rest_.remove_prefix(end);
    return field;
  }

  std::string quoted_field(std::size_t line_of_row) {
    const std::size_t line_of_quote = line_;
    take('"');
    std::string field;
    for (std::size_t end = rest_.find('"');; end = rest_.find('"')) {
      if (end == std::string_view::npos)
        refuse_line(file_, line_of_quote,
                    {"a quote is opened and not closed", "un campo tra virgolette non è chiuso"});
      field += rest_.substr(0, end);
      rest_.remove_prefix(end + 1);
      if (!take('"')) break;
      field += '"';
    }
    line_ += static_cast<std::size_t>(std::count(field.begin(), field.end(), '\n'));
    while (take(' ')) {
    }
    if (!is_at_line_end() && !rest_.starts_with(separator_))
      refuse_line(file_, line_of_row,
                  {"something follows a closing quote; a quote within quotes is written twice",
                   "qualcosa segue la chiusura delle virgolette; virgolette tra virgolette si scrivono doppie"});
    return field;
  }

  std::string_view rest_;
  const std::string& file_;
  char separator_;
  std::size_t line_ = 1;
};

bool is_blank_row(const CsvRow& row) {
  return std::all_of(row.cells.begin(), row.cells.end(), [](const std::string& cell) { return cell.empty(); });
}

// A spreadsheet writes a column whose cells were only touched: without name and content it is left out.
void demand_names(CsvTable& table, std::size_t line) {
  for (std::size_t i = table.header.size(); i-- > 0;) {
    if (!table.header[i].empty()) continue;
    if (std::any_of(table.rows.begin(), table.rows.end(), [&](const CsvRow& row) { return !row.cells[i].empty(); }))
      refuse_line(
          table.file, line,
          format_words("column {} of the header has no name", "la colonna {} dell'intestazione non ha nome", i + 1));
    const auto erase_cell = [i](std::vector<std::string>& cells) {
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
    };
    erase_cell(table.header);
    for (CsvRow& row : table.rows) erase_cell(row.cells);
  }
}

std::string bytes_of(const std::string& path) {
  errno = 0;
  std::ifstream in(path == "-" ? "/dev/stdin" : path, std::ios::binary);
  std::string bytes;
  std::array<char, 65536> block = {};
  while (in && bytes.size() <= largest_file) {
    in.read(block.data(), block.size());
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (bytes.size() > largest_file)
    throw BadTable(format_words("{} is larger than {} bytes", "{} è più grande di {} byte", path, largest_file));
  if (in.eof()) return bytes;
  throw BadTable(format_words("cannot read {}", "impossibile leggere {}", path) +
                 (errno == 0 ? Words{} : ": " + drawings::system_words(errno)));
}

}  // namespace

bool names_separator(std::string_view line) {
  return line.size() == 5 && line.starts_with("sep=") && std::string_view(";,\t").find(line.back()) < 3;
}

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
  const auto first = std::find(header.begin(), header.end(), name);
  if (first == header.end()) return std::nullopt;
  if (std::find(first + 1, header.end(), name) != header.end())
    throw BadTable(format_words("{}: there are two columns \"{}\"", "{}: ci sono due colonne \"{}\"", file, name));
  return static_cast<std::size_t>(first - header.begin());
}

std::size_t CsvTable::needed_column(const std::string& name) const {
  if (const auto found = column(name)) return *found;
  throw BadTable(format_words("{}: there is no column \"{}\"; {}", "{}: manca la colonna \"{}\"; {}", file, name,
                              did_you_mean(name, header)));
}

void CsvTable::demand_distinct(std::size_t column) const {
  std::map<std::string, std::size_t> lines;
  for (const CsvRow& row : rows) {
    const std::string& cell = row.cells[column];
    if (cell.empty()) refuse_line(file, row.line, format_words("there is no \"{}\"", "manca \"{}\"", header[column]));
    const auto [known, is_new] = lines.emplace(text_of_cell(cell), row.line);
    if (!is_new)
      refuse_line(file, row.line,
                  format_words("{} {} stands in line {} already", "{} {} è già nella riga {}", header[column], cell,
                               known->second));
  }
}

CsvTable read_csv(const std::string& bytes, const std::string& file) {
  demand_text(bytes, file);
  std::string_view text = bytes;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Records records(text, file);
  CsvTable table{.file = file, .header = {}, .rows = {}};
  std::size_t line_of_header = 0;
  while (!records.is_at_end()) {
    CsvRow row = records.next();
    if (is_blank_row(row)) continue;
    if (table.header.empty()) {
      table.header = std::move(row.cells);
      line_of_header = row.line;
      continue;
    }
    if (row.cells.size() != table.header.size())
      refuse_line(file, row.line,
                  format_words("fields: {}, but the header has {}", "campi: {}, ma l'intestazione ne ha {}",
                               row.cells.size(), table.header.size()));
    if (table.rows.size() == most_rows)
      refuse_line(file, row.line, format_words("more than {} rows", "più di {} righe di dati", most_rows));
    table.rows.push_back(std::move(row));
  }
  if (table.header.empty())
    throw BadTable(format_words("{} is empty; a table begins with the names of its columns",
                                "{} è vuoto; una tabella comincia coi nomi delle colonne", file));
  demand_names(table, line_of_header);
  return table;
}

CsvTable read_csv_file(const std::string& path) {
  const std::string bytes = bytes_of(path);
  const auto converted = is_utf8(bytes) ? std::nullopt : from_windows_1252(bytes);
  if (!converted) return read_csv(bytes, path);
  CsvTable table = read_csv(*converted, path);
  table.remark =
      format_words("{} is not UTF-8 and was read as Windows-1252, in which Excel saves CSV: look at the names",
                   "{} non è UTF-8 ed è stato letto come Windows-1252, in cui Excel salva il CSV: "
                   "controllare i nomi",
                   path);
  return table;
}

std::string read_text_file(const std::string& path) {
  std::string text = bytes_of(path);
  demand_text(text, path);
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

void refuse_line(const std::string& file, std::size_t line, const Words& why) {
  throw BadTable(format_words("{}, line {}: {}", "{}, riga {}: {}", file, line, why));
}

}  // namespace epure
