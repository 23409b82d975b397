#include "exercises/cli/key_rows.h"

#include <algorithm>
#include <set>

#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/student_columns.h"

namespace epure {
namespace {

// "123456" of "0123456"; the text itself where it is no whole number.
std::string without_leading_zeros(const std::string& number) {
  if (number.find_first_not_of("0123456789") != std::string::npos) return number;
  return number.substr(std::min(number.find_first_not_of('0'), number.size() - 1));
}

using ByInteger = std::map<std::string, std::vector<std::string>>;
ByInteger by_integer(const std::vector<std::string>& numbers) {
  ByInteger all;
  for (const std::string& each : numbers)
    if (!each.empty()) all[without_leading_zeros(each)].push_back(each);
  return all;
}

}  // namespace

KeyRows::KeyRows(const CsvTable& key, const std::vector<std::string>& answered) {
  const std::size_t column = needed_column_of_numbers(key);
  key.demand_distinct(column);
  std::vector<std::string> numbers;
  for (const CsvRow& row : key.rows) {
    numbers.push_back(text_of_cell(row.cells[column]));
    rows_.emplace(numbers.back(), &row);
  }
  const ByInteger in_key = by_integer(numbers), in_answers = by_integer(answered);
  std::set<std::string> found;
  for (const std::string& each : answered) {
    if (rows_.contains(each)) {
      found.insert(each);
      continue;
    }
    const auto equal = in_key.find(without_leading_zeros(each));
    if (equal == in_key.end() || equal->second.size() != 1 || in_answers.at(equal->first).size() != 1) continue;
    without_zeros_.emplace(each, equal->second.front());
    found.insert(equal->second.front());
  }
  for (const auto& [number, row] : rows_)
    if (!found.contains(number)) silent_.push_back(number);
}

std::string KeyRows::number_of(const std::string& answered) const {
  if (rows_.contains(answered)) return answered;
  const auto equal = without_zeros_.find(answered);
  return equal == without_zeros_.end() ? "" : equal->second;
}

const CsvRow* KeyRows::row_of(const std::string& answered) const {
  const auto found = rows_.find(number_of(answered));
  return found == rows_.end() ? nullptr : found->second;
}

}  // namespace epure
