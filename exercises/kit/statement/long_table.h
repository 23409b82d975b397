// A table of more rows than a page has room for: columns of numbers, each the double nearest to the true value.
#pragma once

#include <string>
#include <vector>

#include "words/words.h"

namespace epure {

struct LongTable {
  struct Column {
    std::string name;     // ASCII, as quantities are named: "v_bezout"
    std::string letters;  // rich text: "$v_{B}$"
    std::string unit;     // SI: "m/s"
    int decimals;         // as sheets print it
    std::vector<double> values;
  };
  std::vector<Column> columns;  // all of one length

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

// What stands between two commas by RFC 4180: a text, in quotes where it holds what divides fields; a number with a
// decimal point and as few digits as read back as the same double; a column's name with its unit, "t (s)".
std::string csv_field(const std::string& text);
std::string csv_field(double value);
std::string csv_head(const std::string& name, const std::string& unit);

// By RFC 4180: a header "t (s),v_bezout (m/s)", then a record for each row; each line ends in CR LF.
std::string csv(const LongTable& table);

}  // namespace epure
