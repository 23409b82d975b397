// How a CSV file stands that epure writes: for programs, or for the spreadsheets of a country with decimal commas.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exercises/kit/statement/long_table.h"

namespace epure {

struct CsvStyle {
  // False: RFC 4180, decimal points, in English. True: semicolons, decimal commas and a byte order mark, as Excel and
  // LibreOffice read a file without asking there; its words are in the reader's language.
  bool is_for_spreadsheet = false;

  // What a file begins with.
  std::string_view begin() const { return is_for_spreadsheet ? "\xEF\xBB\xBF" : ""; }
  // In quotes where it holds what divides fields or records.
  std::string field(std::string_view text) const;
  // With as few digits as read back as the same double.
  std::string number(double value) const;
  // A number as it is typed, with its unit: "0.19m" as "0,19m".
  std::string typed(std::string number) const;
  // A column's name with its unit: "t (s)".
  std::string head(const std::string& name, const std::string& unit) const;
  // Fields as they stand, and the record's end.
  std::string record(const std::vector<std::string>& fields) const;
  Language language(Language asked) const { return is_for_spreadsheet ? asked : Language::english; }
};

std::string csv(const LongTable& table, const CsvStyle& style);

}  // namespace epure
