// What `sweep` is asked for, understood.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"
#include "exercises/cli/variation.h"

namespace epure {

// Positions first to end - 1, counted from 0.
struct PartOfRows {
  std::uint64_t first, end;
  bool is_first;  // of the parts, which alone has a header
  bool is_whole;  // nobody asked for a part
  std::uint64_t size() const { return end - first; }
};

struct SweepStudy {
  const Exercise* exercise;
  Givens givens;                     // with what is set
  std::vector<Variation> over;       // the last one changes with every row
  std::vector<Quantity> quantities;  // in the order asked for

  std::uint64_t size() const;
  // The place of each variation in this row.
  std::vector<std::uint64_t> places(std::uint64_t row) const;
  // Throws BadGivens.
  Givens givens_at(std::uint64_t row) const;
  std::vector<std::string> quantity_names() const;
};

// All throw WrongUsage.
SweepStudy sweep_study(const Catalogue& exercises, const Options& options);

// --part 3/40: of so many contiguous parts, as equal as can be, the third.
PartOfRows part_of_rows(const Options& options, std::uint64_t rows);

enum class RowFormat { csv, json, html };  // html: a page of all rows
// From --format, or the ending of the file -o names, else CSV.
RowFormat row_format(const Options& options);

}  // namespace epure
