#include "exercises/cli/answers.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/request.h"
#include "exercises/cli/student_columns.h"
#include "exercises/cli/symbol.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

bool has_no_unit(const std::string& text) {
  const char last = text.empty() ? '0' : text.back();
  return (last >= '0' && last <= '9') || last == '.' || last == ',';
}

std::string trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

// "v_B [cm/s]", taken apart.
struct HeadedBy {
  std::string name, unit;
};
HeadedBy heading_of(const std::string& column) {
  const auto open = column.find('[');
  if (open == std::string::npos || !column.ends_with(']')) return {column, {}};
  return {trimmed(column.substr(0, open)), trimmed(column.substr(open + 1, column.size() - open - 2))};
}

// A given or a quantity that has a column.
struct AskedColumn {
  std::size_t column;
  std::string name, unit;  // as the column has it; empty: the own one

  // The cell with the unit of its column, when it has none itself.
  std::string text(const CsvRow& row) const {
    const std::string& cell = row.cells[column];
    return cell.empty() || unit.empty() || !has_no_unit(cell) ? cell : cell + " " + unit;
  }
};

enum class Role { key, answers };

// What the columns of a table stand for.
class Columns {
 public:
  Columns(const Exercise& exercise, const CsvTable& table, Role role)
      : about_(exercise.about()), table_(table), role_(role), given_names_(given_names(exercise)) {
    for (const Quantity& each : about_.quantities)
      quantity_names_.push_back({each.name, unicode_symbol(each.symbol)});
    numbers = column_of_numbers(table);
    names = column_of_names(table);
    table.column("date");
    for (std::size_t i = 0; i < table.header.size(); ++i) add(i);
  }

  std::optional<std::size_t> numbers, names;
  std::vector<std::size_t> scales;
  std::vector<AskedColumn> givens, quantities;

 private:
  static bool stands_in(const std::vector<AskedColumn>& all, const std::string& name) {
    return std::any_of(all.begin(), all.end(), [&](const AskedColumn& each) { return each.name == name; });
  }
  const Quantity* quantity(const std::string& name) const {
    const auto found = std::find_if(about_.quantities.begin(), about_.quantities.end(),
                                    [&](const Quantity& each) { return each.name == name; });
    return found == about_.quantities.end() ? nullptr : &*found;
  }
  const GivenSpec* given(const std::string& name) const {
    const std::size_t i = index_of(about_.givens, ascii_name(name, given_names_));
    return i == about_.givens.size() ? nullptr : &about_.givens[i];
  }

  // Of a name that a given and a quantity have. A key's givens have their units in the cells, not in the heading.
  bool means_given(const HeadedBy& heading, const GivenSpec& spec, std::size_t column) const {
    if (stands_in(givens, spec.symbol)) return false;
    if (role_ == Role::key) return quantities.empty() && heading.unit.empty();
    return std::any_of(table_.header.begin() + static_cast<std::ptrdiff_t>(column) + 1, table_.header.end(),
                       [&](const std::string& later) { return heading_of(later).name == heading.name; });
  }

  void add(std::size_t column) {
    const std::string& typed = table_.header[column];
    if (heads_numbers(typed) || heads_names(typed) || typed == "date") return;
    if (role_ == Role::answers && (typed == "scale" || typed.starts_with("scale_"))) {
      scales.push_back(column);
      return;
    }
    const HeadedBy heading = heading_of(typed);
    const GivenSpec* as_given = given(heading.name);
    const Quantity* as_quantity = quantity(ascii_name(heading.name, quantity_names_));
    if (as_given && as_quantity && !means_given(heading, *as_given, column)) as_given = nullptr;
    if (!as_given && !as_quantity) refuse(typed, heading.name);
    const std::string& found = as_given ? as_given->symbol : as_quantity->name;
    if (stands_in(as_given ? givens : quantities, found))
      throw BadTable(
          format_words("{}: there are two columns for {}", "{}: ci sono due colonne per {}", table_.file, found));
    demand_unit(typed, heading.unit, as_given ? as_given->unit : as_quantity->unit);
    (as_given ? givens : quantities).push_back({column, found, heading.unit});
  }

  void demand_unit(const std::string& column, const std::string& unit, const std::string& own) const {
    if (unit.empty() || unit == own) return;
    try {
      read_measured("1 " + unit, own);
    } catch (const geometry::BadGiven& wrong) {
      throw BadTable(
          format_words("{}, column \"{}\": {}", "{}, colonna \"{}\": {}", table_.file, column, wrong.words()));
    }
  }

  [[noreturn]] void refuse(const std::string& typed, const std::string& name) const {
    std::vector<std::string> known = {"number", "name", "scale"};
    for (const Quantity& each : about_.quantities) known.push_back(each.name);
    for (const GivenSpec& each : about_.givens) known.push_back(each.symbol);
    throw BadTable(format_words("{}: column \"{}\" is no quantity and no given of {}; {}",
                                "{}: la colonna \"{}\" non è una grandezza né un dato di {}; {}", table_.file, typed,
                                about_.id, did_you_mean(name, known)));
  }

  const Description& about_;
  const CsvTable& table_;
  Role role_;
  std::vector<NameAndLetters> given_names_, quantity_names_;
};

// The givens of a row; a remark, and none, when they cannot be.
void set_row(Student& student, const std::vector<AskedColumn>& columns, const CsvRow& row, const Givens& otherwise) {
  try {
    Givens givens = otherwise;
    for (const AskedColumn& each : columns)
      if (const std::string text = each.text(row); !text.empty()) givens.set(each.name + "=" + text);
    student.givens = givens;
  } catch (const BadGivens& wrong) {
    student.remarks.push_back(
        format_words("not marked, because of the givens: {}", "non valutato, per i dati: {}", wrong.words()));
  }
}

void read_scales(Student& student, const std::vector<std::size_t>& columns, const CsvRow& row) {
  for (const std::size_t column : columns) {
    const std::string& text = row.cells[column];
    if (text.empty()) continue;
    const auto leave_out = [&](const Words& why) {
      student.remarks.push_back(
          format_words("scale \"{}\" is left out: {}", "la scala \"{}\" è tralasciata: {}", text.substr(0, 60), why));
    };
    try {
      student.scales.push_back(read_paper_scale(text));
    } catch (const geometry::BadGiven& wrong) {
      leave_out(wrong.words());
    } catch (const WrongUsage& wrong) {
      leave_out(wrong.words());
    }
  }
}

// Rows by the student's number.
class Key {
 public:
  Key(const Exercise& exercise, const CsvTable& table) : columns_(exercise, table, Role::key) {
    const std::size_t number = needed_column_of_numbers(table);
    table.demand_distinct(number);
    for (const CsvRow& row : table.rows) rows_.emplace(text_of_cell(row.cells[number]), &row);
  }

  void state(Student& student, const Givens& otherwise) {
    const auto found = rows_.find(student.number);
    if (found == rows_.end()) {
      student.remarks.push_back(
          {"not marked: the key has no such number", "non valutato: la chiave non ha questo numero"});
      return;
    }
    const CsvRow& row = *found->second;
    answered_.push_back(student.number);
    set_row(student, columns_.givens, row, otherwise);
    for (const AskedColumn& each : columns_.quantities)
      if (const std::string text = each.text(row); !text.empty()) student.key.push_back({each.name, text, row.line});
  }

  std::vector<std::string> silent() {
    std::sort(answered_.begin(), answered_.end());
    std::vector<std::string> numbers;
    for (const auto& [number, row] : rows_)
      if (!std::binary_search(answered_.begin(), answered_.end(), number)) numbers.push_back(number);
    return numbers;
  }

 private:
  Columns columns_;
  std::map<std::string, const CsvRow*> rows_;
  std::vector<std::string> answered_;
};

// "2 m/s", in SI units.
PaperScale worth_of_a_millimetre(const std::string& worth, const std::string& paper) {
  const bool is_one = !paper.empty() && (paper.front() < '0' || paper.front() > '9');
  const Rational mm = geometry::parse_given((is_one ? "1" : "") + paper, "mm");
  const std::size_t end = std::min(worth.find_first_not_of("0123456789.,/ "), worth.size());
  const std::string symbol = worth.substr(end);
  const auto unit = geometry::find_unit(symbol);
  const auto dimension = dimension_of(symbol);
  if (!unit || !dimension)
    throw geometry::BadGiven(format_words("\"{}\" has no unit that is known", "\"{}\" non ha un'unità nota", worth));
  const geometry::InUnit read = geometry::read_given(worth, symbol);
  const Rational si = unit->counts_turns ? Rational(geometry::to_double(geometry::angle_of(read))) : in_si(read);
  if (si > 0 && mm > 0) return {*dimension, si / mm};
  throw geometry::BadGiven(
      format_words("\"{}\" of a scale must be positive", "\"{}\" di una scala deve essere positivo", worth));
}

}  // namespace

PaperScale read_paper_scale(const std::string& text) {
  for (const std::string_view equal : {"=", "≙"})
    if (const auto at = text.find(equal); at != std::string::npos)
      return worth_of_a_millimetre(trimmed(text.substr(at + equal.size())), trimmed(text.substr(0, at)));
  for (const std::string_view per : {" per ", " al "})
    if (const auto at = text.find(per); at != std::string::npos)
      return worth_of_a_millimetre(trimmed(text.substr(0, at)), trimmed(text.substr(at + per.size())));
  std::string ratio = text;
  std::erase(ratio, ' ');
  return {*dimension_of("m"), 1 / (1000 * scale_of_lengths(ratio))};
}

Answers read_answers(const Exercise& exercise, const CsvTable& answers, const CsvTable* key,
                     const Givens& otherwise) {
  const Columns columns(exercise, answers, Role::answers);
  if (columns.quantities.empty())
    throw BadTable(format_words("{}: no column is a quantity of {} (epure list {} shows them)",
                                "{}: nessuna colonna è una grandezza di {} (epure list {} le mostra)", answers.file,
                                exercise.about().id, exercise.about().id));
  if (answers.rows.empty())
    throw BadTable(format_words("{}: a header and no row: nobody answered",
                                "{}: un'intestazione e nessuna riga: nessuno ha risposto", answers.file));
  if (key || answers.rows.size() > 1) answers.demand_distinct(needed_column_of_numbers(answers));
  std::optional<Key> rows_of_key;
  if (key) rows_of_key.emplace(exercise, *key);

  Answers all;
  for (const AskedColumn& each : columns.quantities)
    all.asked.push_back(*std::find_if(exercise.about().quantities.begin(), exercise.about().quantities.end(),
                                      [&](const Quantity& spec) { return spec.name == each.name; }));
  for (const CsvRow& row : answers.rows) {
    Student student{.number = columns.numbers ? text_of_cell(row.cells[*columns.numbers]) : "",
                    .name = columns.names ? text_of_cell(row.cells[*columns.names]) : ""};
    if (rows_of_key)
      rows_of_key->state(student, otherwise);
    else
      set_row(student, columns.givens, row, otherwise);
    read_scales(student, columns.scales, row);
    for (const AskedColumn& each : columns.quantities) student.answers.push_back(each.text(row));
    all.students.push_back(std::move(student));
  }
  if (rows_of_key) all.silent = rows_of_key->silent();
  return all;
}

}  // namespace epure
