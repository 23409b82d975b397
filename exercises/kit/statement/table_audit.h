// A table that the source printed, held row by row against what its scheme gives, column by column: which rows are
// right, which were rounded on the way, which stand in the wrong row, which are wrong; and the simplest mistake that
// explains a block of them.
//
//   const PrintedColumn v{.name = "v", .printed = {"0,00", "0,02", ...}, .right = {0, Rational(79, 10000), ...},
//                         .mistakes = {{{"the first strip is missing", "manca la prima striscia"}, {0, 0, ...}}}};
//   Description{..., .audit = [] { return audit({"the table", "la tabella"}, {"0,0", "0,1", ...}, {v, ...}); }};
//
// check tells it while the givens are the source's own, in a few lines and in its JSON as "audit".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/numbers/number.h"
#include "words/words.h"

namespace epure {

struct PrintedColumn {
  // What comes out when the scheme is carried out with a mistake: as many rows, or as many as it concerns.
  struct Mistake {
    Words sentence;
    std::vector<geometry::Rational> values;
  };
  std::string name;                       // "v_bezout"
  std::vector<std::string> printed;       // with a decimal comma or point; empty: nothing in this row
  std::vector<geometry::Rational> right;  // in the unit of print
  std::vector<Mistake> mistakes = {};     // the simplest first
};

enum class RowVerdict { right, rounded, shifted, wrong };
std::string name(RowVerdict verdict);

// Rows that have one explanation: the table's own scheme, or a mistake.
struct AuditedBlock {
  std::size_t first, last;
  RowVerdict verdict = RowVerdict::right;  // of the block; of rows that are right some may be rounded
  Words mistake = {};                      // of wrong and shifted ones; empty: none was found
  std::size_t rounded = 0;                 // rows that are off by one in their last digit
  std::size_t right = 0;                   // rows that are right all the same
};

struct AuditedColumn {
  std::string name;
  std::vector<RowVerdict> rows;  // each for itself
  std::vector<AuditedBlock> blocks;
};

struct TableAudit {
  Words table;
  std::vector<std::string> rows;  // their names, as printed
  std::vector<AuditedColumn> columns;
};

AuditedColumn audit(const PrintedColumn& column);
TableAudit audit(const Words& table, const std::vector<std::string>& rows, const std::vector<PrintedColumn>& columns);

// The words of a printed table, row by row; blanks, tabs and line ends divide. Empty rows are left out.
std::vector<std::vector<std::string>> read_printed_table(const std::string& text);
std::vector<std::string> column_of(const std::vector<std::vector<std::string>>& table, std::size_t column);

}  // namespace epure
