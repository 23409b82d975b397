// A table of more rows than a page has room for: columns of numbers, each the double nearest to the true value.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "words/words.h"

namespace epure {

struct LongTable {
  static constexpr std::size_t head_lines = 2;  // of a page: letters and units

  struct Column {
    std::string name;     // ASCII, as quantities are named: "v_bezout"
    std::string letters;  // rich text: "$v_{B}$"
    std::string unit;     // SI: "m/s"
    int decimals;         // as sheets print it
    std::vector<double> values;
  };
  std::vector<Column> columns;  // all of one length
  // The same values in the same order, found by a route that shares no formula with theirs: asked for by check alone.
  std::function<std::vector<std::vector<double>>()> by_another_route;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

// By RFC 4180: a header "t (s),v_bezout (m/s)", then a record for each row; each line ends in CR LF.
std::string csv(const LongTable& table);

}  // namespace epure
