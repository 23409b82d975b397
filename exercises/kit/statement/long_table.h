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

// By RFC 4180: a header "t (s),v_bezout (m/s)", then a record for each row; each line ends in CR LF.
std::string csv(const LongTable& table);

}  // namespace epure
