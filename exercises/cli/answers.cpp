#include "exercises/cli/answers.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "exercises/cli/answer_columns.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/key_rows.h"
#include "exercises/cli/request.h"
#include "exercises/cli/student_columns.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

std::string trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

// What stands for no answer: nothing, dashes, "n.d.", "don't know".
bool stands_for_nothing(const std::string& answer) {
  static const std::array<std::string_view, 16> words{"-",      "--",         "---",     "–",     "—",    "/",
                                                      "?",      "n.d.",       "nd",      "n/a",   "#n/d", "#n/a",
                                                      "non so", "don't know", "assente", "absent"};
  const std::string said = lower_case(trimmed(answer));
  return said.empty() || std::find(words.begin(), words.end(), said) != words.end();
}

// "3.2 m/s" of "circa 3.2 m/s", "ca. 3.2 m/s", "~3.2 m/s" and "3.2? m/s"; the text itself of one without doubt.
std::string without_doubt(const std::string& answer) {
  static const std::array<std::string_view, 11> about{
      "circa ", "ca. ", "ca ", "c.a ", "about ", "approx. ", "approx ", "approximately ", "≈", "~", "∼"};
  std::string text = trimmed(answer);
  if (text.find_first_of("0123456789") == std::string::npos) return text;
  for (const std::string_view word : about)
    if (lower_case(text).starts_with(word)) text = trimmed(std::string_view(text).substr(word.size()));
  for (const std::string_view after : {" circa", " (circa)", " (about)"})
    if (lower_case(text).ends_with(after)) text.resize(text.size() - after.size());
  std::erase(text, '?');
  return trimmed(text);
}

// The answer to a quantity; none where the cell says nothing.
std::string answer_in(const CsvRow& row, const AskedColumn& asked, Student& student) {
  const std::string& cell = row.cells[asked.column];
  if (stands_for_nothing(cell)) return {};
  const std::string sure = without_doubt(cell);
  if (sure != trimmed(cell))
    student.remarks.push_back(asked.name + format_words(": \"{}\" is read as {}", ": \"{}\" è letto come {}",
                                                        cell.substr(0, 60), sure.substr(0, 60)));
  return asked.with_unit(sure);
}

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

// Not found in the key; with what stands there, has no answers, and is written nearly so.
Words not_in_key(const std::string& number, const std::vector<std::string>& silent) {
  const std::vector<std::string> near = near_names(number, silent);
  return Words{"not marked: the key has no such number", "non valutato: la chiave non ha questo numero"} +
         (near.empty() ? Words{}
                       : format_words("; {} stands there, without answers", "; vi sta {}, senza risposte",
                                      alternatives(near)));
}

// "4, 7, 9 and 12 more".
Words some_of(const std::vector<std::string>& all) {
  constexpr std::size_t most_named = 3;
  std::string named;
  for (std::size_t i = 0; i < std::min(all.size(), most_named); ++i) named += (i == 0 ? "" : ", ") + all[i];
  if (all.size() <= most_named) return {named, named};
  return format_words("{} and {} more", "{} e altri {}", named, all.size() - most_named);
}

// What a key says of each student's givens.
class Key {
 public:
  Key(const Exercise& exercise, const CsvTable& table, const CsvTable& answers,
      const std::vector<std::string>& answered)
      : columns_(exercise, table, TableRole::key),
        names_(table),
        rows_(table, answered),
        table_(table),
        answers_(answers) {
    const std::size_t known = columns_.givens.size() + columns_.quantities.size();
    if (columns_.left_out.size() > known)
      throw BadTable(
          format_words("{} is no key of {}: {} of its columns are no given and no quantity of it, such as "
                       "\"{}\"",
                       "{} non è una chiave di {}: {} delle sue colonne non ne sono dati né grandezze, come "
                       "\"{}\"",
                       table.file, exercise.about().id, columns_.left_out.size(), columns_.left_out.front()));
    if (known == 0)
      throw BadTable(format_words("{} is no key: no column is a given or a quantity of {}",
                                  "{} non è una chiave: nessuna colonna è un dato o una grandezza di {}", table.file,
                                  exercise.about().id));
  }

  void state(Student& student, const Givens& otherwise) {
    const CsvRow* const row = rows_.row_of(student.number);
    if (!row) {
      student.remarks.push_back(not_in_key(student.number, rows_.silent()));
      missing_.push_back(student.number);
      return;
    }
    ++found_;
    if (const std::string number = rows_.number_of(student.number); number != student.number) {
      without_zeros_.push_back(student.number);
      if (number.size() > student.number.size()) student.number = number;
    }
    for (const AskedColumn& each : columns_.sheets) set_scale(student, each, *row);
    set_row(student, columns_.givens, *row, otherwise);
    for (const AskedColumn& each : columns_.quantities)
      if (const std::string text = each.text(*row); !text.empty())
        student.key.push_back({each.name, text, row->line});
  }

  std::vector<Student> absent() const {
    std::vector<Student> all;
    for (const std::string& number : rows_.silent())
      all.push_back({.number = number, .name = names_.name_in(*rows_.row_of(number))});
    return all;
  }
  std::vector<std::string> sheets() const {
    std::vector<std::string> all;
    for (const AskedColumn& each : columns_.sheets) all.push_back(each.name);
    return all;
  }
  const std::vector<std::string>& left_out() const { return columns_.left_out; }

  // Throws BadTable when it has none of the numbers.
  std::vector<Words> remarks() const {
    if (found_ == 0)
      throw BadTable(
          format_words("none of the {} numbers in {}, such as {}, stands in {}: is it the key of another "
                       "class?",
                       "dei {} numeri di {}, come {}, nessuno sta in {}: è la chiave di un'altra classe?",
                       missing_.size(), answers_.file, missing_.front(), table_.file));
    std::vector<Words> all;
    if (!without_zeros_.empty())
      all.push_back(format_words("{}: numbers found in {} with zeros before them, which a spreadsheet takes away: {}",
                                 "{}: numeri trovati in {} con zeri davanti, che un foglio di calcolo toglie: {}",
                                 answers_.file, table_.file, some_of(without_zeros_)));
    if (!missing_.empty())
      all.push_back(
          format_words("{}: not in {}: {} ({} of {} students)", "{}: non in {}: {} ({} di {} studenti)",
                       answers_.file, table_.file, some_of(missing_), missing_.size(), missing_.size() + found_) +
          (missing_.size() > found_ ? Words{"; is it the key of another class?", "; è la chiave di un'altra classe?"}
                                    : Words{}));
    return all;
  }

 private:
  static void set_scale(Student& student, const AskedColumn& sheet, const CsvRow& row) {
    const std::string& text = row.cells[sheet.column];
    if (text.empty()) return;
    try {
      student.sheets.emplace(sheet.name, scale_of_lengths(text));
    } catch (const WrongUsage& wrong) {
      student.remarks.push_back(format_words("the key's scale of sheet {} is left out: {}",
                                             "la scala della tavola {} nella chiave è tralasciata: {}", sheet.name,
                                             wrong.words()));
    }
  }

  AnswerColumns columns_;
  NameColumns names_;
  KeyRows rows_;
  const CsvTable &table_, &answers_;
  std::size_t found_ = 0;
  std::vector<std::string> missing_, without_zeros_;
};

// Whether the answers' own givens are others than those that count.
bool states_other_givens(const Student& student, const std::vector<AskedColumn>& columns, const CsvRow& row) {
  if (!student.givens) return false;
  try {
    Givens stated = *student.givens;
    for (const AskedColumn& each : columns)
      if (const std::string text = each.text(row); !text.empty()) stated.set(each.name + "=" + text);
    return std::any_of(columns.begin(), columns.end(), [&](const AskedColumn& each) {
      const auto own = stated.reading(each.name), counting = student.givens->reading(each.name);
      return own && counting && (own->number != counting->number || own->unit.symbol != counting->unit.symbol);
    });
  } catch (const BadGivens&) {
    return true;
  }
}

Words left_out(const std::vector<std::string>& columns, const std::string& file, const std::string& exercise) {
  std::string names;
  for (std::size_t i = 0; i < columns.size(); ++i) names += (i == 0 ? "\"" : ", \"") + columns[i] + "\"";
  return columns.size() == 1
             ? format_words("{}: the column {} is no quantity and no given of {} and is left out",
                            "{}: la colonna {} non è una grandezza né un dato di {} ed è tralasciata", file, names,
                            exercise)
             : format_words("{}: the columns {} are no quantities and no givens of {} and are left out",
                            "{}: le colonne {} non sono grandezze né dati di {} e sono tralasciate", file, names,
                            exercise);
}

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
  const AnswerColumns columns(exercise, answers, TableRole::answers);
  const NameColumns names(answers);
  if (columns.quantities.empty())
    throw BadTable(format_words("{}: no column is a quantity of {} (epure list {} shows them)",
                                "{}: nessuna colonna è una grandezza di {} (epure list {} le mostra)", answers.file,
                                exercise.about().id, exercise.about().id));
  if (answers.rows.empty())
    throw BadTable(format_words("{}: a header and no row: nobody answered",
                                "{}: un'intestazione e nessuna riga: nessuno ha risposto", answers.file));
  if (key || answers.rows.size() > 1) answers.demand_distinct(needed_column_of_numbers(answers));

  Answers all;
  for (const AskedColumn& each : columns.quantities)
    all.asked.push_back(*std::find_if(exercise.about().quantities().begin(), exercise.about().quantities().end(),
                                      [&](const Quantity& spec) { return spec.name == each.name; }));
  std::vector<std::string> numbers;
  for (const CsvRow& row : answers.rows)
    numbers.push_back(columns.numbers ? text_of_cell(row.cells[*columns.numbers]) : "");
  std::optional<Key> rows_of_key;
  if (key) rows_of_key.emplace(exercise, *key, answers, numbers);
  std::vector<std::string> of_other_givens;
  for (std::size_t i = 0; i < answers.rows.size(); ++i) {
    const CsvRow& row = answers.rows[i];
    Student student{.number = numbers[i], .name = names.name_in(row)};
    if (rows_of_key) {
      rows_of_key->state(student, otherwise);
      if (states_other_givens(student, columns.givens, row)) of_other_givens.push_back(student.number);
    } else {
      set_row(student, columns.givens, row, otherwise);
    }
    read_scales(student, columns.scales, row);
    for (const AskedColumn& each : columns.quantities) student.answers.push_back(answer_in(row, each, student));
    all.students.push_back(std::move(student));
  }
  if (!columns.left_out.empty()) all.remarks.push_back(left_out(columns.left_out, answers.file, exercise.about().id));
  if (!rows_of_key) return all;
  if (!rows_of_key->left_out().empty())
    all.remarks.push_back(left_out(rows_of_key->left_out(), key->file, exercise.about().id));
  for (Words& each : rows_of_key->remarks()) all.remarks.push_back(std::move(each));
  if (!of_other_givens.empty())
    all.remarks.push_back(format_words("{} states other givens than {}, which count: {}",
                                       "{} dà altri dati di {}, che valgono: {}", answers.file, key->file,
                                       some_of(of_other_givens)));
  all.absent = rows_of_key->absent();
  all.sheets = rows_of_key->sheets();
  return all;
}

}  // namespace epure
