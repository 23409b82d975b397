#include "exercises/cli/answer_columns.h"

#include <algorithm>
#include <array>

#include "exercises/cli/student_columns.h"
#include "exercises/kit/proof/measured.h"
#include "exercises/kit/statement/bare_number.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

// "v_B [cm/s]" or "v_B (cm/s)", taken apart.
struct HeadedBy {
  std::string name, unit;
};
HeadedBy heading_of(const std::string& column) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    const auto at = column.find(open);
    if (at == std::string::npos || !column.ends_with(close)) continue;
    const auto end = column.find_last_not_of(' ', at == 0 ? 0 : at - 1);
    return {column.substr(0, at == 0 || end == std::string::npos ? 0 : end + 1),
            column.substr(at + 1, column.size() - at - 2)};
  }
  return {column, {}};
}

constexpr std::size_t scale_and_blank = 6;  // "scale ", "scala "
bool heads_scale(const std::string& typed) {
  const std::array<std::string_view, 2> names{"scale", "scala"};
  const std::string head = lower_case(typed);
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return head == name || head.starts_with(std::string(name) + "_") || head.starts_with(std::string(name) + " ");
  });
}

// What stands in tables of ours, or of any teacher's, and is nothing to be marked.
bool is_of_no_account(const std::string& head) {
  const std::array<std::string_view, 4> names{"date", "data", "remarks", "osservazioni"};
  return std::find(names.begin(), names.end(), lower_case(head)) != names.end();
}

// Lowered digits as digits: "ω₃" as "ω3".
std::string raised(std::string letters) {
  const std::string before = "\xE2\x82";  // U+2080 and the nine after it
  for (auto at = letters.find(before); at != std::string::npos; at = letters.find(before, at + 1)) {
    const auto digit = at + 2 < letters.size() ? static_cast<unsigned char>(letters[at + 2]) - 0x80 : -1;
    if (digit >= 0 && digit <= 9) letters.replace(at, 3, 1, static_cast<char>('0' + digit));
  }
  return letters;
}

// Letters and digits alone: "vB" and "v_B" as "vb", "ω₃" and "ω_3" as "ω3".
std::string bones(const std::string& name) {
  std::string all;
  for (const char c : lower_case(raised(name)))
    if (static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) all += c;
  return all;
}

// "distanza P0A" has the name in it. (A lone letter is a word of its own in many a heading.)
bool has_word(const std::string& head, const std::string& name) {
  return name.size() > 2 && (" " + head + " ").find(" " + name + " ") != std::string::npos;
}

// "v_B misurata" begins with v_B, "number" does not begin with n.
bool begins_with(const std::string& head, const std::string& name) {
  return head.size() > name.size() && head.starts_with(name) && bones(head.substr(name.size(), 1)).empty() &&
         head[name.size()] != '_';
}

class ColumnReader {
 public:
  ColumnReader(const Exercise& exercise, const CsvTable& table, TableRole role, AnswerColumns& found)
      : about_(exercise.about()),
        table_(table),
        role_(role),
        found_(found),
        given_names_(given_names(exercise)),
        quantity_names_(quantity_names(about_.quantities())) {}

  void read() {
    found_.numbers = column_of_numbers(table_);
    table_.column("date");
    for (std::size_t i = 0; i < table_.header.size(); ++i) add(i);
  }

 private:
  static bool stands_in(const std::vector<AskedColumn>& all, const std::string& name) {
    return std::any_of(all.begin(), all.end(), [&](const AskedColumn& each) { return each.name == name; });
  }
  const Quantity* quantity(const std::string& name) const {
    const auto found = std::find_if(about_.quantities().begin(), about_.quantities().end(),
                                    [&](const Quantity& each) { return each.name == name; });
    return found == about_.quantities().end() ? nullptr : &*found;
  }
  const GivenSpec* given(const std::string& name) const {
    const std::size_t i = index_of(about_.givens, ascii_name(name, given_names_));
    return i == about_.givens.size() ? nullptr : &about_.givens[i];
  }

  // That of "scale poles".
  const SheetSpec* sheet_to_scale(const std::string& head) const {
    if (!heads_scale(head) || head.size() < scale_and_blank) return nullptr;
    const auto found = std::find_if(about_.sheets.begin(), about_.sheets.end(),
                                    [&](const SheetSpec& each) { return each.name == head.substr(scale_and_blank); });
    return found == about_.sheets.end() ? nullptr : &*found;
  }

  // Of a name that a given and a quantity have. A key's givens have their units in the cells, not in the heading.
  bool means_given(const HeadedBy& heading, const GivenSpec& spec, std::size_t column) const {
    if (stands_in(found_.givens, spec.symbol)) return false;
    if (role_ == TableRole::key) return found_.quantities.empty() && heading.unit.empty();
    return std::any_of(table_.header.begin() + static_cast<std::ptrdiff_t>(column) + 1, table_.header.end(),
                       [&](const std::string& later) { return heading_of(later).name == heading.name; });
  }

  void add(std::size_t column) {
    const std::string& typed = table_.header[column];
    if (heads_numbers(typed) || heads_names(typed) || is_of_no_account(typed)) return;
    if (role_ == TableRole::answers && heads_scale(typed)) {
      found_.scales.push_back(column);
      return;
    }
    if (const SheetSpec* sheet = role_ == TableRole::key ? sheet_to_scale(typed) : nullptr) {
      found_.sheets.push_back({column, sheet->name, ""});
      return;
    }
    // Letters may end in parentheses of their own, "x(13 s)".
    const Quantity* as_quantity = quantity(ascii_name(typed, quantity_names_));
    const HeadedBy heading = as_quantity ? HeadedBy{typed, {}} : heading_of(typed);
    if (!as_quantity) as_quantity = quantity(ascii_name(heading.name, quantity_names_));
    const GivenSpec* as_given = given(heading.name);
    if (as_given && as_quantity && !means_given(heading, *as_given, column)) as_given = nullptr;
    if (!as_given && !as_quantity) {
      demand_far(typed, heading.name);
      found_.left_out.push_back(typed);
      return;
    }
    const std::string& name = as_given ? as_given->symbol : as_quantity->name;
    if (stands_in(as_given ? found_.givens : found_.quantities, name))
      throw BadTable(
          format_words("{}: there are two columns for {}", "{}: ci sono due colonne per {}", table_.file, name));
    demand_unit(typed, heading.unit, as_given ? as_given->unit : as_quantity->unit);
    (as_given ? found_.givens : found_.quantities).push_back({column, name, heading.unit});
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

  // What nearly is the name of something that is asked is no column of something else.
  void demand_far(const std::string& typed, const std::string& name) const {
    std::vector<std::string> known, meant;
    for (const Quantity& each : about_.quantities()) known.push_back(each.name);
    for (const GivenSpec& each : about_.givens) known.push_back(each.symbol);
    for (const std::string& each : known)
      if (bones(each) == bones(name) || begins_with(name, each) || has_word(name, each)) meant.push_back(each);
    if (meant.empty())
      for (const auto& [each, letters] : quantity_names_)
        if (bones(letters) == bones(name)) meant.push_back(each);
    if (meant.empty()) meant = near_names(name, known);
    if (meant.empty()) return;
    const Words what_to_do =
        role_ == TableRole::key
            ? Words{"Or is it the key of another exercise?", "O è la chiave di un altro esercizio?"}
            : Words{"(Rename the column, or take it out.)", "(Rinominare la colonna, o toglierla.)"};
    throw BadTable(format_words("{}: column \"{}\" is no quantity and no given of {}; did you mean {}? {}",
                                "{}: la colonna \"{}\" non è una grandezza né un dato di {}; si intendeva {}? {}",
                                table_.file, typed, about_.id, alternatives(meant), what_to_do));
  }

  const Description& about_;
  const CsvTable& table_;
  TableRole role_;
  AnswerColumns& found_;
  std::vector<NameAndLetters> given_names_, quantity_names_;
};

}  // namespace

bool heads_something_else(const std::string& head) {
  return heads_numbers(head) || heads_names(head) || is_of_no_account(head) || heads_scale(head);
}

std::string AskedColumn::with_unit(const std::string& cell) const {
  return cell.empty() || unit.empty() || !has_no_unit(cell) ? cell : cell + " " + unit;
}

AnswerColumns::AnswerColumns(const Exercise& exercise, const CsvTable& table, TableRole role) {
  ColumnReader(exercise, table, role, *this).read();
}

}  // namespace epure
