// The rows of a key, found by students' numbers as spreadsheets leave them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"

namespace epure {

// A spreadsheet takes 0123456 for a number and writes 123456. Such a number is found all the same where only one of
// the key and one of the answers is equal to it as an integer.
class KeyRows {
 public:
  // `answered`: all numbers that answers have. `key` must outlive it. Throws BadTable: no column of numbers, a number
  // that is missing or there twice.
  KeyRows(const CsvTable& key, const std::vector<std::string>& answered);

  // Null: the key has not this number.
  const CsvRow* row_of(const std::string& answered) const;
  // The number as the key has it; empty: it has none.
  std::string number_of(const std::string& answered) const;

  // Numbers that nobody answered under, in order.
  const std::vector<std::string>& silent() const { return silent_; }

 private:
  std::map<std::string, const CsvRow*> rows_;
  std::map<std::string, std::string> without_zeros_;  // the key's number, by the answers' one
  std::vector<std::string> silent_;
};

}  // namespace epure
